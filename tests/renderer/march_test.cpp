// How rays walk: methods, step scales, normals, cone ratios and occlusion, against closed forms.
#include "tests/renderer/ray_walk.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using glm::vec3;

Scene ball(float radius = 1)
{
    Scene s;
    s.show(s.node("sphere", {{"radius", radius}}));
    return s;
}

constexpr vec3 eye{0, 0, 4}, ahead{0, 0, -1};

// Where a ray from the eye at an angle meets a ball of radius 1.
float ball_distance(const vec3& direction)
{
    float along = -glm::dot(eye, direction);
    return along - std::sqrt(along * along - (glm::dot(eye, eye) - 1));
}

vec3 tilted(float slope) { return glm::normalize(vec3(slope, 0, -1)); }

TEST(March, both_methods_find_the_ball_to_the_tolerance)
{
    for (bool constant_steps : {false, true}) {
        Scene s = ball();
        s.document.march.constant_steps = constant_steps;
        s.document.march.constant_step = 0.17f;
        RayWalk walk(s.program());
        for (float slope : {0.0f, 0.05f, 0.15f, 0.2f}) {
            walk.from(eye, tilted(slope));
            ASSERT_FALSE(walk.missed()) << slope;
            float steepness = glm::dot(glm::normalize(eye + walk.t() * tilted(slope)), -tilted(slope));
            EXPECT_NEAR(walk.t(), ball_distance(tilted(slope)), 2.5f * s.document.march.tolerance / steepness) << slope;
        }
        walk.from(eye, tilted(0.5f));
        EXPECT_TRUE(walk.missed());
    }
}

TEST(March, constant_steps_pass_through_what_is_thinner_than_a_step)
{
    Scene s;
    s.show(s.node("box", {{"half_size", vec3(1, 1, 0.02f)}}));
    RayWalk traced(s.program());
    traced.from(eye + vec3(0, 0, 0.01f), ahead);
    EXPECT_FALSE(traced.missed());
    s.document.march.constant_steps = true;
    s.document.march.constant_step = 0.3f;
    RayWalk stepped(s.program());
    stepped.from(eye + vec3(0, 0, 0.01f), ahead);
    EXPECT_TRUE(stepped.missed());
}

TEST(March, the_least_cone_ratio_is_that_of_the_tangent_cone)
{
    Scene s = ball();
    RayWalk walk(s.program());
    // Beside the ball: the cone about the ray that touches it has the sine of the angle between ray and tangent.
    for (float slope : {0.28f, 0.3f, 0.4f, 0.6f}) {
        walk.from(eye, tilted(slope));
        ASSERT_TRUE(walk.missed());
        float closed_form = std::sin(std::atan(slope) - std::asin(1 / eye.z));
        EXPECT_GE(walk.cone_ratio(), closed_form - 1e-4f) << slope;
        EXPECT_LE(walk.cone_ratio(), 1.2f * closed_form + 1e-3f) << "steps beside it come close enough: " << slope;
    }
}

float degrees_between(const vec3& a, const vec3& b)
{
    return glm::degrees(std::acos(std::min(glm::dot(glm::normalize(a), glm::normalize(b)), 1.0f)));
}

TEST(March, normals_of_both_kinds_are_the_balls_and_central_ones_stay_closer_as_the_step_grows)
{
    const vec3 way = glm::normalize(vec3(0.1f, 0.14f, -1));
    float apart[2] = {0, 0};
    for (bool central : {false, true}) {
        for (float step : {0.0f, 0.2f}) {
            Scene s = ball();
            s.document.march.central_normals = central;
            s.document.march.normal_step = step;
            RayWalk walk(s.program());
            walk.from(eye, way);
            ASSERT_FALSE(walk.missed());
            EXPECT_NEAR(glm::length(walk.gradient()), 1, step > 0 ? 0.1f : 0.01f);
            float degrees = degrees_between(walk.gradient(), eye + walk.t() * way);
            if (step > 0) apart[central] = degrees;
            else EXPECT_LT(degrees, 0.2f);
        }
    }
    // Four taps leave the mixed second derivatives in: the error grows with the step, that of six with its square.
    EXPECT_GT(apart[0], 1.0f);
    EXPECT_LT(apart[1], 0.25f * apart[0]);
}

// Rays down onto the floor beside a wall at x = 0; `away` from it.
float openness_beside_a_wall(bool smallest, float away, float strength = 1, int samples = 5)
{
    Scene s;
    NodeId wall =
        s.node("translate", {{"d", s.node("box", {{"half_size", vec3(1, 4, 9)}})}, {"offset", vec3(-1, 0, 0)}});
    s.show(s.node("union", {{"a", s.node("plane")}, {"b", wall}}));
    s.document.occlusion = {.strength = strength, .radius = 0.5f, .samples = samples, .smallest_ratio = smallest};
    RayWalk walk(s.program());
    walk.from({away, 2, 0}, {0, -1, 0});
    return walk.openness();
}

TEST(Occlusion, is_the_mean_or_the_least_of_distance_and_height)
{
    // Heights 0.1 to 0.5 at 0.2 from the wall: ratios 1, 1, 2/3, 1/2, 2/5.
    EXPECT_NEAR(openness_beside_a_wall(false, 0.2f), (1 + 1 + 2 / 3.0f + 0.5f + 0.4f) / 5, 0.01f);
    // Steps of the distance where that is farther: heights 0.1, 0.2 and 0.4.
    EXPECT_NEAR(openness_beside_a_wall(true, 0.2f), 0.5f, 0.01f);
    EXPECT_NEAR(openness_beside_a_wall(true, 0.2f, 0.5f), 0.75f, 0.01f);
    for (bool smallest : {false, true}) {
        EXPECT_NEAR(openness_beside_a_wall(smallest, 5), 1, 0.01f);
        EXPECT_EQ(openness_beside_a_wall(smallest, 0.2f, 0), 1);
        EXPECT_LT(openness_beside_a_wall(smallest, 0.02f, 1, 32), openness_beside_a_wall(smallest, 0.2f, 1, 32));
    }
}

// A strongly twisted bar in front of the camera.
Scene twisted()
{
    Scene s;
    NodeId bar = s.node("box", {{"half_size", vec3(0.9f, 1.2f, 0.25f)}});
    NodeId output = s.show(s.node("twist", {{"d", bar}, {"turn", 180.0f}}));
    s.wire(s.node("perspective", {{"position", vec3(0, 1, 5)}, {"target", vec3(0)}}), output, "camera");
    s.node("sun");
    return s;
}

TEST(StepScale, of_ones_own_stands_for_the_derived_constants)
{
    Scene derived = twisted(), own = twisted();
    own.document.march.own_step_scale = true;
    renderer::Picture good = picture_of(derived, renderer::View::depth);
    own.document.march.step_scale = 1;
    EXPECT_GT(share_apart(good, picture_of(own, renderer::View::depth)), 0.02) << "steps pass through: stripes";
    own.document.march.step_scale = 0.2f;
    own.document.march.step_limit = 2000;
    EXPECT_LT(share_apart(good, picture_of(own, renderer::View::depth)), 0.01);
}

}  // namespace
}  // namespace fieldwright::tests
