// Walking the ray anew.
#include "app/inspected_ray.h"

namespace fieldwright::app {
namespace {

ui::RayReading reading_of(const renderer::RayWalk& walk)
{
    ui::RayReading reading{.origin = walk.ray.origin, .direction = walk.ray.direction, .t_end = walk.t_end};
    for (const renderer::RayStep& step : walk.steps) reading.steps.push_back({step.t, step.distance, step.cone_ratio});
    using End = renderer::RayWalk::End;
    reading.end = walk.end == End::hit      ? ui::RayReading::End::hit
                  : walk.end == End::missed ? ui::RayReading::End::missed
                                            : ui::RayReading::End::out_of_steps;
    return reading;
}

}  // namespace

void InspectedRay::choose(const graph::Program& program, const renderer::FrameRequest& request, glm::ivec2 pixel)
{
    ray_ = renderer::ray_of_pixel(program, request, pixel);
    program_ = nullptr;
}

void InspectedRay::follow(const std::shared_ptr<const graph::Program>& program, float time_s)
{
    if (!ray_ || (program_ == program && time_s_ == time_s)) return;
    program_ = program;
    time_s_ = time_s;
    reading_ = nullptr;
    try {
        reading_ = std::make_shared<const ui::RayReading>(reading_of(renderer::walk_ray(*program, time_s, *ray_)));
    } catch (const graph::Failure&) {  // a node that only a GPU has: nothing to show until it is gone
    }
}

void InspectedRay::forget()
{
    ray_.reset();
    reading_ = nullptr;
}

}  // namespace fieldwright::app
