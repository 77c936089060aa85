// What a device draws: one frame of buffers, top-down rows, and the request for it.
#pragma once

#include "graph/program.h"

#include <functional>
#include <limits>
#include <vector>

namespace fieldwright::renderer {

enum class Eye { centre, left, right };

float eye_side(Eye eye);                          // -1 left, 0 centre, 1 right
int shadow_count(const graph::Program& program);  // lights that cast shadows; they come first

struct FrameRequest {
    int width = 640, height = 360;  // px
    float time = 0;                 // s
    Eye eye = Eye::centre;
    float interaxial = 0.065f;  // m
    float convergence = 5.0f;   // m, along the view axis
};

// Sample 0 of each pixel. Row 0 is the top. All rows have width * height elements.
struct Frame {
    Frame() = default;
    Frame(int width, int height);

    int width = 0, height = 0;
    std::vector<glm::vec3> colour;          // linear Rec.709, before tone mapping
    std::vector<float> depth;               // m along the view axis; +inf where nothing was hit
    std::vector<glm::vec3> normal;          // world space; 0 on a miss
    std::vector<int> node_id, material_id;  // 0 on a miss
    std::vector<int> steps;                 // of the eye ray
    std::vector<unsigned char> exhausted;   // 1 where the step budget or limit ran out
};

using Progress = std::function<void(float fraction)>;

}  // namespace fieldwright::renderer
