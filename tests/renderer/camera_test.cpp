// Cameras: which ray belongs to which place of the picture, and to which place of the lens.
#include "field/evaluator.h"
#include "renderer/rows.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec2;
using glm::vec3;

struct TestRay {
    vec3 origin, direction, forward, right;
};

// Of a camera of that type at z = 5 that looks at the origin.
class Rays {
public:
    explicit Rays(const char* type, std::initializer_list<Scene::Setting> settings = {})
    {
        NodeId camera = scene_.node(type, settings);
        scene_.set(camera, "position", vec3(0, 0, 5));
        scene_.set(camera, "target", vec3(0));
        scene_.wire(camera, scene_.show(scene_.node("sphere")), "camera");
        program_ = scene_.program();
    }

    TestRay at(vec2 uv, vec2 lens = vec2(0)) const
    {
        field::Evaluator evaluator(program_, program_.ray);
        field::Evaluator::Workspace workspace(evaluator);
        const float inputs[] = {uv.x, uv.y, lens.x, lens.y};
        for (int k = 0; k < 4; ++k) workspace.input(k)[0] = inputs[k];
        evaluator.evaluate(workspace, field::evaluate_frame(program_, 0), 1);
        auto vector = [&](const char* member) {
            int lane = member_lane(*program_.library, "Ray", member);
            return vec3(workspace.result(lane)[0], workspace.result(lane + 1)[0], workspace.result(lane + 2)[0]);
        };
        return {vector("origin"), vector("direction"), vector("forward"), vector("right")};
    }

private:
    Scene scene_;
    graph::Program program_;
};

float angle_deg(vec3 a, vec3 b) { return glm::degrees(std::acos(glm::clamp(glm::dot(a, b), -1.0f, 1.0f))); }

TEST(Cameras, of_perspective_have_their_angle_from_the_lower_to_the_upper_edge)
{
    Rays rays("perspective", {{"field_of_view", 50.0f}});
    EXPECT_NEAR(angle_deg(rays.at({0, 1}).direction, vec3(0, 0, -1)), 25, 1e-3);
    EXPECT_NEAR(angle_deg(rays.at({0, -1}).direction, rays.at({0, 1}).direction), 50, 1e-3);
    EXPECT_GT(rays.at({0, 1}).direction.y, 0) << "v points up";
    EXPECT_GT(rays.at({1, 0}).direction.x, 0) << "u points right";
}

// Seed 002, section 2.1: NDC = (pixel + 0.5) / size; screen x = (2 NDC - 1) aspect, y = 1 - 2 NDC.
TEST(Cameras, see_through_the_centres_of_pixels)
{
    // A wall that faces up and towards the camera: its depth grows with the height in the picture.
    Scene s;
    NodeId output = s.show(s.node("plane", {{"normal", vec3(0, 1, 1)}}));
    NodeId camera = s.node("orthographic", {{"position", vec3(0, 0, 5)}, {"target", vec3(0)}, {"height", 2.0f}});
    s.wire(camera, output, "camera");
    Frame tall = render_on_cpu(s.program(), {.width = 8, .height = 4});
    for (int y = 0; y < 4; ++y) {
        float ndc = (static_cast<float>(y) + 0.5f) / 4;
        EXPECT_NEAR(tall.depth[static_cast<std::size_t>(8 * y + 3)], 5 + (1 - 2 * ndc), 2e-3f);
    }
    Scene t;
    output = t.show(t.node("plane", {{"normal", vec3(1, 0, 1)}}));
    t.wire(t.node("orthographic", {{"position", vec3(0, 0, 5)}, {"target", vec3(0)}, {"height", 2.0f}}), output,
           "camera");
    Frame wide = render_on_cpu(t.program(), {.width = 8, .height = 4});
    for (int x = 0; x < 8; ++x) {
        float ndc = (static_cast<float>(x) + 0.5f) / 8;
        EXPECT_NEAR(wide.depth[static_cast<std::size_t>(8 + x)], 5 + 2 * (2 * ndc - 1), 2e-3f);
    }
}

TEST(Cameras, of_equal_angle_turn_by_equal_angles)
{
    Rays rays("equal_angle", {{"field_of_view", 80.0f}});
    for (float u : {-1.5f, -0.75f, 0.0f, 0.75f, 1.5f}) {
        vec3 across = rays.at({u, 0}).direction, up = rays.at({0, u}).direction;
        EXPECT_NEAR(glm::degrees(std::atan2(across.x, -across.z)), 40 * u, 1e-3);
        EXPECT_NEAR(glm::degrees(std::atan2(up.y, -up.z)), 40 * u, 1e-3);
    }
    // tan(angle x), tan(angle y), as in seed 003.
    vec3 corner = rays.at({1, -0.5f}).direction;
    EXPECT_NEAR(corner.x / -corner.z, std::tan(glm::radians(40.0f)), 1e-4);
    EXPECT_NEAR(corner.y / -corner.z, -std::tan(glm::radians(20.0f)), 1e-4);
    EXPECT_LT(rays.at({9, 0}).direction.z, 0) << "it never looks behind itself";
}

TEST(Cameras, of_fisheye_see_behind_themselves)
{
    Rays rays("fisheye", {{"field_of_view", 270.0f}});
    vec3 forward(0, 0, -1);
    EXPECT_NEAR(angle_deg(rays.at({0, 0}).direction, forward), 0, 0.03);
    EXPECT_NEAR(angle_deg(rays.at({0.6f, 0}).direction, forward), 81, 0.01);
    EXPECT_NEAR(angle_deg(rays.at({0.6f, 0.8f}).direction, forward), 135, 0.01);
    EXPECT_GT(rays.at({0, 0.5f}).direction.y, 0);
    Scene s;
    NodeId output = s.show(s.node("invert", {{"d", s.node("sphere", {{"radius", 3.0f}})}}));
    s.wire(s.node("fisheye", {{"position", vec3(0)}, {"target", vec3(0, 0, -1)}, {"field_of_view", 360.0f}}), output,
           "camera");
    Frame frame = render_on_cpu(s.program(), {.width = 16, .height = 16});
    for (float depth : frame.depth) EXPECT_NEAR(depth, 3, 2e-3f) << "the distance, ahead and behind";
}

TEST(Lens, keeps_what_lies_in_the_plane_of_focus_sharp)
{
    Rays rays("perspective", {{"aperture", 0.5f}, {"focus_distance", 4.0f}});
    vec2 uv(0.4f, -0.3f);
    auto in_focus = [&](vec2 lens) {
        TestRay ray = rays.at(uv, lens);
        return ray.origin + ray.direction * (4.0f / glm::dot(ray.direction, ray.forward));
    };
    for (vec2 lens : {vec2(1, 0), vec2(0, -1), vec2(-0.6f, 0.5f)}) {
        EXPECT_NEAR(glm::distance(rays.at(uv, lens).origin, vec3(0, 0, 5)), 0.25f * glm::length(lens), 1e-5f);
        EXPECT_LT(glm::distance(in_focus(lens), in_focus(vec2(0))), 1e-5f);
    }
    Rays pinhole("perspective");
    EXPECT_EQ(pinhole.at(uv, {1, 0}).origin, pinhole.at(uv).origin);
    EXPECT_EQ(pinhole.at(uv, {1, 0}).direction, pinhole.at(uv).direction);
}

}  // namespace
}  // namespace fieldwright::tests
