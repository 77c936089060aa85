// One ray of a picture, step by step: what the marcher saw on its way.
#pragma once

#include "renderer/frame.h"

namespace fieldwright::renderer {

struct RayStep {
    float t, distance;  // m: along the ray, and what the field said there
    float cone_ratio;   // distance / t: how wide a cone around the ray is empty there
};

struct WorldRay {
    glm::vec3 origin{0}, direction{0, 0, -1};  // unit
    bool operator==(const WorldRay&) const = default;
};

struct RayWalk {
    enum class End { hit, missed, out_of_steps };

    WorldRay ray;
    std::vector<RayStep> steps;
    End end = End::missed;
    float t_end = 0;  // m
};

// Of the pixel's centre, from the top left; of one eye, as the request says.
WorldRay ray_of_pixel(const graph::Program& program, const FrameRequest& request, glm::ivec2 pixel);
// By the marcher's own functions, with the program's settings. Failure{1} when a node is not compiled into this program.
RayWalk walk_ray(const graph::Program& program, float time_s, const WorldRay& ray);

}  // namespace fieldwright::renderer
