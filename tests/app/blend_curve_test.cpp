// The plot of a smooth combiner is what its own function computes.
#include "app/blend_curve.h"

#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::tests {
namespace {

std::optional<ui::BlendCurve> curve_of(std::string_view type, std::initializer_list<Scene::Setting> settings = {},
                                       bool wired_to_time = false)
{
    Scene scene;
    NodeId node = scene.node(type, settings);
    scene.wire(scene.node("sphere"), node, "a");
    scene.wire(scene.node("box"), node, "b");
    if (wired_to_time) scene.wire(scene.node("time"), node, "smoothness");
    scene.show(node);
    return app::blend_curve(scene.program(), scene.type(node), node, 0.25f);
}

std::size_t middle(const ui::BlendCurve& curve) { return curve.across.size() / 2; }

TEST(BlendCurve, of_a_quadratic_blend_is_a_parabola_of_its_size)
{
    auto curve = curve_of("smooth_union", {{"smoothness", 0.4f}});
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->size, 0.4f);
    EXPECT_FALSE(curve->of_sum);
    EXPECT_NEAR(curve->result[middle(*curve)], -0.1f, 1e-6f) << "a quarter of the size below where both meet";
    for (std::size_t i = 0; i < curve->across.size(); ++i) {
        EXPECT_NEAR(curve->a[i] - curve->b[i], curve->across[i], 1e-6f);
        float d = curve->across[i], melt = std::max(0.4f - std::abs(d), 0.0f);
        EXPECT_NEAR(curve->result[i], std::min(curve->a[i], curve->b[i]) - melt * melt * 0.25f / 0.4f, 1e-6f);
    }
    EXPECT_NEAR(curve->slope.front(), 1, 1e-3f);
    EXPECT_NEAR(curve->slope[middle(*curve)], 0, 1e-3f);
    EXPECT_NEAR(curve->slope.back(), -1, 1e-3f);
}

TEST(BlendCurve, only_the_linear_kernel_breaks_the_slope)
{
    for (const char* kernel : {"linear", "cubic", "circular", "exponential"}) {
        auto curve = curve_of("blended_union", {{"smoothness", 0.5f}, {"kernel", std::string(kernel)}});
        ASSERT_TRUE(curve) << kernel;
        float largest_jump = 0;
        for (std::size_t i = 2; i < curve->slope.size(); ++i)
            if (std::abs(curve->across[i]) > 0.1f)
                largest_jump = std::max(largest_jump, std::abs(curve->slope[i] - curve->slope[i - 2]));
        bool breaks = std::string(kernel) == "linear";
        EXPECT_EQ(largest_jump > 0.5f, breaks) << kernel << " " << largest_jump;
    }
}

TEST(BlendCurve, of_a_subtraction_runs_over_the_sum)
{
    auto curve = curve_of("smooth_subtract", {{"smoothness", 0.2f}});
    ASSERT_TRUE(curve);
    EXPECT_TRUE(curve->of_sum);
    EXPECT_NEAR(curve->result[middle(*curve)], 0.05f, 1e-6f);
    EXPECT_NEAR(curve->result.front(), -curve->a.front(), 1e-6f) << "far inside a: b's turned distance";
}

TEST(BlendCurve, follows_what_is_wired)
{
    auto curve = curve_of("smooth_union", {}, true);
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->size, 0.25f);
}

TEST(BlendCurve, is_of_smooth_combiners_only)
{
    EXPECT_FALSE(curve_of("union"));
    EXPECT_FALSE(curve_of("chamfer_union"));
    for (const char* type : {"smooth_intersect", "smooth_exclusive_or", "blended_intersect", "blended_subtract"})
        EXPECT_TRUE(curve_of(type)) << type;
    Scene scene;
    NodeId lonely = scene.node("smooth_union");
    scene.show(lonely);
    EXPECT_FALSE(app::blend_curve(scene.program(), scene.type(lonely), lonely, 0)) << "nothing is blended";
}

}  // namespace
}  // namespace fieldwright::tests
