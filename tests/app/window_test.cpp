// Where a new window fits.
#include "app/window.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

TEST(FittingSize, leaves_alone_what_fits)
{
    EXPECT_EQ(app::fitting_size({1440, 900}, {1920, 1080}, {1, 1}), glm::ivec2(1440, 900));
    EXPECT_EQ(app::fitting_size({1440, 900}, {3840, 2160}, {2, 2}), glm::ivec2(1440, 900));
}

TEST(FittingSize, keeps_window_and_title_bar_on_the_screen)
{
    glm::ivec2 small = app::fitting_size({1440, 900}, {1280, 720}, {1, 1});
    EXPECT_EQ(small.x, 1280);
    EXPECT_LT(small.y, 720);
    EXPECT_GT(small.y, 600);
    // At 200 % half as many units are there.
    glm::ivec2 doubled = app::fitting_size({1440, 900}, {1600, 1000}, {2, 2});
    EXPECT_EQ(doubled.x, 800);
    EXPECT_LT(doubled.y, 500);
    EXPECT_GT(doubled.y, 400);
    EXPECT_EQ(app::fitting_size({1440, 900}, {1, 1}, {2, 2}), glm::ivec2(1, 1));
}

}  // namespace
}  // namespace fieldwright
