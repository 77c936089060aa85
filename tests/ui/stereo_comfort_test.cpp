// Parallax of eyes against rays, and what is comfortable.
#include "ui/stereo_comfort.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace ui;

// Where an eye beside an off-axis camera sees a point of that depth straight ahead, as a share of the picture's width
// from its middle. side: -1 left, 1 right.
double seen_by(const Eyes& eyes, const SeenWidth& width, double depth, int side)
{
    double shift = 0.5 * side * static_cast<double>(eyes.interaxial), convergence = eyes.convergence;
    // The eye's picture plane lies at the convergence depth, around the camera's axis.
    double at_plane = width.parallel > 0 ? 0 : shift * (1 - convergence / depth);
    if (width.parallel > 0) at_plane = shift * (depth / convergence - 1);
    double plane_width = width.parallel > 0 ? width.parallel : width.per_metre * eyes.convergence;
    return at_plane / plane_width;
}

TEST(Parallax, is_what_both_eyes_see_apart)
{
    for (SeenWidth width : {SeenWidth{.per_metre = 1.3f}, SeenWidth{.parallel = 6}})
        for (float depth : {1.5f, 4.0f, 5.0f, 20.0f}) {
            Eyes eyes{0.08f, 4};
            double apart = seen_by(eyes, width, depth, 1) - seen_by(eyes, width, depth, -1);
            EXPECT_NEAR(parallax_share(eyes, width, depth), apart, 1e-6) << depth;
        }
}

TEST(Parallax, is_none_in_the_screen_and_approaches_the_eyes_distance_far_away)
{
    Eyes eyes{0.065f, 5};
    SeenWidth width{.per_metre = 1};
    EXPECT_EQ(parallax_share(eyes, width, 5), 0);
    EXPECT_NEAR(parallax_share(eyes, width, 1e6f), 0.065f / 5, 1e-6f);
    EXPECT_LT(parallax_share(eyes, width, 2), 0);
}

TEST(Parallax, is_millimetres_and_an_angle_on_a_screen)
{
    StereoView screen{.screen_width = 0.5f, .viewing_distance = 0.5f};
    Parallax parallax = parallax_on(screen, 0.02f);
    EXPECT_NEAR(parallax.mm, 10, 1e-4f);
    EXPECT_NEAR(parallax.degrees, 1.14576f, 1e-4f);
}

TEST(Comfort, ends_at_two_and_four_percent_and_where_eyes_would_turn_outwards)
{
    StereoView desk{.screen_width = 0.6f, .viewing_distance = 0.7f}, cinema{.screen_width = 9, .viewing_distance = 12};
    EXPECT_EQ(comfort_of(parallax_on(desk, 0.019f)), Comfort::good);
    EXPECT_EQ(comfort_of(parallax_on(desk, -0.03f)), Comfort::strong);
    EXPECT_EQ(comfort_of(parallax_on(desk, 0.041f)), Comfort::painful);
    EXPECT_EQ(comfort_of(parallax_on(cinema, 0.01f)), Comfort::painful) << "90 mm behind the screen";
    EXPECT_EQ(comfort_of(parallax_on(cinema, -0.01f)), Comfort::good);
}

TEST(ComfortableEyes, show_the_range_evenly_around_the_screen)
{
    StereoView desk{.screen_width = 0.6f, .viewing_distance = 0.7f};
    for (SeenWidth width : {SeenWidth{.per_metre = 1.3f}, SeenWidth{.parallel = 8}}) {
        DepthRange range{4, 9};
        Eyes eyes = comfortable_eyes(range, width, desk);
        float nearest = parallax_share(eyes, width, range.near), farthest = parallax_share(eyes, width, range.far);
        EXPECT_NEAR(nearest, -farthest, 1e-5f);
        EXPECT_LE(farthest, 0.01f + 1e-5f);
        EXPECT_GT(farthest, 0.005f);
        EXPECT_LE(eyes.interaxial, range.near / 30 + 1e-6f);
    }
}

TEST(ComfortableEyes, keep_eyes_from_turning_outwards_and_live_with_flat_scenes)
{
    StereoView cinema{.screen_width = 12, .viewing_distance = 15};
    Eyes eyes = comfortable_eyes({4, 9}, {.per_metre = 1.3f}, cinema);
    EXPECT_LE(parallax_on(cinema, parallax_share(eyes, {.per_metre = 1.3f}, 9)).mm, 63.01f);
    Eyes flat = comfortable_eyes({5, 5}, {.per_metre = 1.3f}, cinema);
    EXPECT_TRUE(std::isfinite(flat.interaxial));
    EXPECT_LE(flat.interaxial, 5.0f / 30 + 1e-6f);
    EXPECT_NEAR(flat.convergence, 5, 0.01f);
}

}  // namespace
}  // namespace fieldwright::tests
