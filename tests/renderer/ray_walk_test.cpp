// A ray step by step: what the marcher that draws does, and no other.
#include "renderer/ray_walk.h"

#include "renderer/devices.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

Scene ball_on_a_floor()
{
    Scene s;
    NodeId ball = s.node("translate", {{"d", s.node("sphere", {{"radius", 0.8f}})}, {"offset", vec3(0, 0.8f, 0)}});
    NodeId output = s.show(s.node("union", {{"a", ball}, {"b", s.node("plane")}}));
    s.wire(s.node("perspective", {{"position", vec3(0, 1.2f, 5)}, {"target", vec3(0, 0.8f, 0)}}), output, "camera");
    return s;
}

TEST(RayWalk, takes_the_steps_of_its_pixel)
{
    graph::Program program = ball_on_a_floor().program();
    FrameRequest request{.width = 64, .height = 36};
    Frame frame = render_on_cpu(program, request);
    for (int y = 1; y < request.height; y += 5)
        for (int x = 1; x < request.width; x += 7) {
            std::size_t i = static_cast<std::size_t>(y * request.width + x);
            RayWalk walk = walk_ray(program, 0, ray_of_pixel(program, request, {x, y}));
            EXPECT_EQ(static_cast<int>(walk.steps.size()), frame.steps[i]) << x << " " << y;
            EXPECT_EQ(walk.end == RayWalk::End::hit, std::isfinite(frame.depth[i])) << x << " " << y;
        }
}

TEST(RayWalk, stops_where_the_surface_is)
{
    Scene s;
    s.show(s.node("sphere", {{"radius", 1.0f}}));
    RayWalk walk = walk_ray(s.program(), 0, {{0.5f, 0, 5}, {0, 0, -1}});
    EXPECT_EQ(walk.end, RayWalk::End::hit);
    EXPECT_NEAR(walk.t_end, 5 - std::sqrt(0.75f), 2e-3f);
    ASSERT_GT(walk.steps.size(), 3u);
    EXPECT_NEAR(walk.steps[0].t, 0.01f, 1e-6f) << "the near limit";
    for (const RayStep& step : walk.steps) {
        vec3 point = walk.ray.origin + step.t * walk.ray.direction;
        EXPECT_NEAR(step.distance, glm::length(point) - 1, 1e-5f) << "the sphere that nothing is in";
        EXPECT_NEAR(step.cone_ratio, step.distance / step.t, 1e-3f * std::abs(step.distance / step.t) + 1e-6f);
    }
}

TEST(RayWalk, says_when_it_misses_and_when_its_steps_run_out)
{
    Scene s;
    s.show(s.node("sphere", {{"radius", 1.0f}}));
    EXPECT_EQ(walk_ray(s.program(), 0, {{0, 3, 5}, {0, 0, -1}}).end, RayWalk::End::missed);
    s.document.march.step_limit = 4;
    RayWalk walk = walk_ray(s.program(), 0, {{1.001f, 0, 5}, {0, 0, -1}});
    EXPECT_EQ(walk.end, RayWalk::End::out_of_steps);
    EXPECT_EQ(walk.steps.size(), 4u);
}

}  // namespace
}  // namespace fieldwright::tests
