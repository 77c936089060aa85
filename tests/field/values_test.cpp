// Value nodes: the numbers they give.
#include "tests/support/fields.h"

#include <gtest/gtest.h>
#include <numeric>

namespace fieldwright::tests {
namespace {

using glm::vec3;
using Settings = std::initializer_list<Scene::Setting>;

// The number as the height of a plane, seen from the origin.
float shown(Scene& scene, NodeId number)
{
    NodeId plane = scene.node("plane", {{"height", number}});
    scene.show(plane);
    return -Field(scene.program({.root = plane})).at(std::vector<vec3>{vec3(0)})[0];
}

float number_of(std::string_view type, Settings settings)
{
    Scene scene;
    return shown(scene, scene.node(type, settings));
}

vec3 vector_of(std::string_view type, Settings settings)
{
    vec3 result;
    for (int i = 0; i < 3; ++i) {
        Scene scene;
        NodeId vector = scene.node(type, settings);
        const char* axes[] = {"x", "y", "z"};
        result[i] = shown(scene, scene.node("component", {{"vector", vector}, {"axis", std::string(axes[i])}}));
    }
    return result;
}

void expect_near(vec3 found, vec3 expected)
{
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-5f) << "component " << i;
}

TEST(Values, arithmetic_is_that_of_school)
{
    EXPECT_EQ(number_of("minus", {{"first", 5.0f}, {"second", 2.0f}}), 3);
    EXPECT_EQ(number_of("divide", {{"first", 5.0f}, {"second", 2.0f}}), 2.5f);
    EXPECT_EQ(number_of("minimum", {{"first", 5.0f}, {"second", -2.0f}}), -2);
    EXPECT_EQ(number_of("maximum", {{"first", 5.0f}, {"second", -2.0f}}), 5);
    EXPECT_EQ(number_of("absolute", {{"x", -2.5f}}), 2.5f);
    EXPECT_EQ(number_of("round_down", {{"x", -2.5f}}), -3);
    EXPECT_EQ(number_of("fraction", {{"x", -2.25f}}), 0.75f);
    EXPECT_EQ(number_of("modulo", {{"x", -1.0f}, {"period", 3.0f}}), 2);
    EXPECT_NEAR(number_of("power", {{"x", 2.0f}, {"exponent", 3.0f}}), 8, 1e-5f);
    EXPECT_NEAR(number_of("square_root", {{"x", 6.25f}}), 2.5f, 1e-6f);
}

TEST(Values, what_has_no_answer_gives_zero)
{
    EXPECT_EQ(number_of("divide", {{"first", 5.0f}, {"second", 0.0f}}), 0);
    EXPECT_EQ(number_of("power", {{"x", -2.0f}, {"exponent", 0.5f}}), 0);
    EXPECT_EQ(number_of("power", {{"x", 0.0f}, {"exponent", -2.0f}}), 0);
    EXPECT_EQ(number_of("square_root", {{"x", -1.0f}}), 0);
    expect_near(vector_of("normalise", {{"vector", vec3(0)}}), vec3(0));
}

TEST(Values, angles_are_degrees_in_documents)
{
    EXPECT_NEAR(number_of("cosine", {{"angle", 60.0f}}), 0.5f, 1e-6f);
    EXPECT_NEAR(number_of("sine_of_angle", {{"angle", 30.0f}}), 0.5f, 1e-6f);
    EXPECT_NEAR(number_of("angle", {{"x", -1.0f}, {"y", 1.0f}}), 2.3561945f, 1e-6f);
    EXPECT_NEAR(number_of("angle", {{"x", -1.0f}, {"y", -1.0f}}), -2.3561945f, 1e-6f);
}

TEST(Values, ranges_are_kept_and_carried_over)
{
    EXPECT_EQ(number_of("clamp", {{"x", 3.0f}}), 1);
    EXPECT_EQ(number_of("clamp", {{"x", -3.0f}}), 0);
    EXPECT_EQ(number_of("step", {{"x", 0.49f}}), 0);
    EXPECT_EQ(number_of("step", {{"x", 0.5f}}), 1);
    EXPECT_NEAR(number_of("smoothstep", {{"x", 0.25f}}), 0.15625f, 1e-6f);
    EXPECT_NEAR(number_of("smoothstep", {{"x", 0.25f}, {"start", 1.0f}, {"end", 0.0f}}), 0.84375f, 1e-6f);
    Settings range = {{"x", 15.0f}, {"from_low", 10.0f}, {"from_high", 12.0f}, {"to_low", 0.0f}, {"to_high", 4.0f}};
    EXPECT_EQ(number_of("remap", range), 4);
    EXPECT_EQ(number_of("remap", {{"x", 15.0f}, {"from_high", 10.0f}, {"to_high", 4.0f}, {"limited", false}}), 6);
}

TEST(Values, waves_begin_as_a_sine_does)
{
    for (float turns : {0.1f, 0.3f, 0.6f, 0.9f, 3.2f}) {
        SCOPED_TRACE(turns);
        float share = turns - std::floor(turns);
        float triangle = share < 0.25f ? 4 * share : share < 0.75f ? 2 - 4 * share : 4 * share - 4;
        Settings at = {{"x", turns}, {"frequency", 1.0f}};
        EXPECT_NEAR(number_of("triangle_wave", at), triangle, 1e-5f);
        EXPECT_EQ(number_of("square_wave", at), share < 0.5f ? 1 : -1);
        EXPECT_NEAR(number_of("saw_wave", at), 2 * share - 1, 1e-5f);
    }
}

TEST(Values, conditions_choose)
{
    EXPECT_EQ(number_of("compare", {{"first", 1.0f}, {"second", 2.0f}}), 1);
    EXPECT_EQ(number_of("compare", {{"first", 1.0f}, {"second", 2.0f}, {"comparison", std::string("greater")}}), 0);
    EXPECT_EQ(number_of("compare", {{"first", 2.0005f}, {"second", 2.0f}, {"comparison", std::string("equal")}}), 1);
    EXPECT_EQ(number_of("choose", {{"choice", 0.4f}, {"first", 7.0f}, {"second", 9.0f}}), 7);
    EXPECT_EQ(number_of("choose", {{"choice", 0.5f}, {"first", 7.0f}, {"second", 9.0f}}), 9);
}

TEST(Values, vectors_follow_the_right_hand)
{
    vec3 a(1, 2, 3), b(-2, 0.5f, 4);
    EXPECT_NEAR(number_of("length", {{"vector", a}}), glm::length(a), 1e-5f);
    EXPECT_NEAR(number_of("dot_product", {{"first", a}, {"second", b}}), glm::dot(a, b), 1e-5f);
    EXPECT_NEAR(number_of("distance_between", {{"first", a}, {"second", b}}), glm::distance(a, b), 1e-5f);
    expect_near(vector_of("cross_product", {{"first", a}, {"second", b}}), glm::cross(a, b));
    expect_near(vector_of("vector_add", {{"first", a}, {"second", b}}), a + b);
    expect_near(vector_of("vector_subtract", {{"first", a}, {"second", b}}), a - b);
    expect_near(vector_of("vector_multiply", {{"first", a}, {"second", b}}), a * b);
    expect_near(vector_of("vector_scale", {{"vector", a}, {"factor", -2.0f}}), a * -2.0f);
    expect_near(vector_of("vector_mix", {{"first", a}, {"second", b}, {"amount", 0.25f}}), glm::mix(a, b, 0.25f));
    expect_near(vector_of("normalise", {{"vector", a}}), glm::normalize(a));
}

TEST(Values, colours_are_made_of_hue_and_stops)
{
    expect_near(vector_of("combine_colour", {{"red", 0.1f}, {"green", 0.2f}, {"blue", 0.3f}}), {0.1f, 0.2f, 0.3f});
    Settings green = {{"hue", 1.0f / 3}, {"saturation", 1.0f}, {"brightness", 0.5f}};
    expect_near(vector_of("hsv_colour", green), {0, 0.5f, 0});
    vec3 black(0), red(1, 0, 0), white(1);
    auto ramp = [&](float x, float hardness) {
        return vector_of("colour_ramp",
                         {{"x", x}, {"first", black}, {"second", red}, {"third", white}, {"hardness", hardness}});
    };
    expect_near(ramp(0.25f, 0), {0.5f, 0, 0});
    expect_near(ramp(0.75f, 0), {1, 0.5f, 0.5f});
    expect_near(ramp(0.24f, 1), black);
    expect_near(ramp(0.26f, 1), red);
    expect_near(ramp(2, 0.5f), white);
    EXPECT_NEAR(number_of("brightness", {{"colour", vec3(0, 1, 0)}}), 0.7152f, 1e-6f);
}

// The noise as the height of a plane: read back at many places.
std::vector<float> noise_at(std::string_view type, const std::vector<vec3>& points, Settings settings = {})
{
    Scene scene;
    NodeId plane = scene.node("plane", {{"height", scene.node(type, settings)}});
    scene.show(plane);
    Field field(scene.program({.root = plane}));
    std::vector<float> heights = field.at(points);
    for (std::size_t i = 0; i < points.size(); ++i) heights[i] = points[i].y - heights[i] * field.lipschitz();
    return heights;
}

TEST(Values, noise_stays_in_its_range_and_fills_most_of_it)
{
    for (const char* type : {"value_noise", "gradient_noise", "cellular_noise", "fractal_noise"}) {
        SCOPED_TRACE(type);
        Random random(4);
        std::vector<vec3> points;
        for (int i = 0; i < 20000; ++i) points.push_back(random.in_cube(20));
        std::vector<float> found = noise_at(type, points);
        auto [low, high] = std::minmax_element(found.begin(), found.end());
        float mean = std::accumulate(found.begin(), found.end(), 0.0f) / static_cast<float>(found.size());
        EXPECT_GE(*low, -1e-4f);
        EXPECT_LE(*high, 1 + 1e-4f);
        EXPECT_LT(*low, 0.2f);
        EXPECT_GT(*high, 0.8f);
        EXPECT_NEAR(mean, 0.5f, 0.06f);
        EXPECT_NE(found, noise_at(type, points, {{"seed", 1}}));
    }
}

TEST(Values, noise_has_no_jumps)
{
    for (const char* type : {"value_noise", "gradient_noise", "cellular_noise", "fractal_noise"}) {
        Random random(5);
        std::vector<vec3> points, beside;
        for (int i = 0; i < 20000; ++i) {
            points.push_back(0.5f * glm::floor(random.in_cube(8)) + random.in_cube(i % 2 ? 1e-3f : 0.5f));
            beside.push_back(points.back() + 1e-3f * random.direction());
        }
        std::vector<float> here = noise_at(type, points), there = noise_at(type, beside);
        for (std::size_t i = 0; i < points.size(); ++i) ASSERT_LE(std::abs(here[i] - there[i]), 0.02f) << type;
    }
}

}  // namespace
}  // namespace fieldwright::tests
