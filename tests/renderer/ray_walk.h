// One ray of a program, walked with the marcher's own functions as the CPU device calls them.
#pragma once

#include "renderer/cpu_scene.h"
#include "tests/support/scene.h"

namespace fieldwright::tests {

class RayWalk {
public:
    explicit RayWalk(const graph::Program& program)
        : library_(*program.library), scene_(program, {}), workspace_(scene_.distance), probe_(scene_.lanes.probe)
    {
    }

    // From the eye; direction is a unit vector.
    void from(const glm::vec3& origin, const glm::vec3& direction)
    {
        renderer::Rows ray(scene_.lanes.ray);
        for (int k = 0; k < 3; ++k) {
            ray.fill(k, origin[k]);
            ray.fill(3 + k, direction[k]);
        }
        scene_.eye_probe(probe_, 1, ray, scene_.march, scene_.budget);
        walk();
    }

    bool missed() const { return member("phase") == missed_phase; }
    float t() const { return member("t"); }
    int steps() const { return static_cast<int>(member("steps")); }
    float cone_ratio() const { return member("cone_ratio"); }
    float openness() const { return member("openness"); }
    glm::vec3 gradient() const { return probe_.vec3(renderer::member_lane(library_, "Probe", "gradient"), 0); }

private:
    static constexpr float missed_phase = 65;

    float member(std::string_view name) const { return probe_.lane(renderer::member_lane(library_, "Probe", name))[0]; }

    void walk()
    {
        renderer::Rows point(3), d(1), done(1), next(scene_.lanes.probe), narrowed(scene_.lanes.probe);
        while (true) {
            scene_.probe_done(done, 1, probe_);
            if (done.lane(0)[0] > 0.5f) return;
            scene_.probe_point(point, 1, probe_, scene_.march);
            for (int k = 0; k < 3; ++k) workspace_.input(k)[0] = point.lane(k)[0];
            scene_.distance.evaluate(workspace_, scene_.block, 1);
            d.lane(0)[0] = workspace_.result(0)[0];
            scene_.advance(next, 1, probe_, d, scene_.march);
            scene_.narrowed(narrowed, 1, probe_, next, d, scene_.march);
            std::swap(probe_, narrowed);
        }
    }

    const graph::Library& library_;
    renderer::CpuScene scene_;
    field::Evaluator::Workspace workspace_;
    renderer::Rows probe_;
};

}  // namespace fieldwright::tests
