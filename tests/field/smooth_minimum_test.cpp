// The smooth minimum of the first seed: a (1 - h) + b h - k h (1 - h) with h = 1/2 + (a - b) / 2k, where the larger of
// two distances far apart must not be the result: the document has these two cases swapped.
#include "tests/support/fields.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using glm::vec3;

constexpr float k = 0.5f;

float smin(float a, float b)
{
    if (a - b > k) return b;
    if (a - b < -k) return a;
    float h = 0.5f + (a - b) / (2 * k);
    return a * (1 - h) + b * h - k * h * (1 - h);
}

struct Pair {
    float a, b;
};

std::vector<Pair> pairs()
{
    std::vector<Pair> all;
    for (float a = -1; a <= 1; a += 0.05f)
        for (float b = -1; b <= 1; b += 0.05f) all.push_back({a, b});
    return all;
}

// Two half spaces: the point (a, b, 0) is a from one and b from the other.
std::vector<float> smooth_unions(const std::vector<Pair>& pairs)
{
    Scene scene;
    NodeId a = scene.node("plane", {{"normal", vec3(1, 0, 0)}}), b = scene.node("plane", {{"normal", vec3(0, 1, 0)}});
    NodeId both = scene.node("smooth_union", {{"a", a}, {"b", b}, {"smoothness", k}});
    std::vector<vec3> points;
    for (const Pair& pair : pairs) points.emplace_back(pair.a, pair.b, 0);
    return Field(scene.program({.root = both})).at(points);
}

TEST(SmoothMinimum, is_the_seeds_with_its_cases_the_right_way_round)
{
    std::vector<Pair> all = pairs();
    std::vector<float> found = smooth_unions(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_NEAR(found[i], smin(all[i].a, all[i].b), 1e-6f) << all[i].a << " " << all[i].b;
}

TEST(SmoothMinimum, is_the_smaller_one_where_both_are_far_apart)
{
    EXPECT_NEAR(smooth_unions({{1, 0.25f}})[0], 0.25f, 1e-6f);
    EXPECT_NEAR(smooth_unions({{0.25f, 1}})[0], 0.25f, 1e-6f);
}

TEST(SmoothMinimum, dips_by_a_quarter_of_its_size_where_both_are_equal)
{
    EXPECT_NEAR(smooth_unions({{0.3f, 0.3f}})[0], 0.3f - 0.25f * k, 1e-6f);
}

// Without the third term, as in the seed's figure 7b, the slope would jump by one half there.
TEST(SmoothMinimum, has_no_kink_where_the_blend_begins)
{
    constexpr float step = 1e-2f;
    std::vector<float> around = smooth_unions({{0, k - step}, {0, k}, {0, k + step}});
    float before = (around[1] - around[0]) / step, after = (around[2] - around[1]) / step;
    EXPECT_NEAR(before, after, 0.02f);
}

}  // namespace
}  // namespace fieldwright::tests
