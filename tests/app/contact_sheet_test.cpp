// The contact sheet shows what its colours mean, in words that are whole.
#include "app/contact_sheet.h"

#include "assets/lettering.h"
#include "ui/font_files.h"
#include "ui/legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace fieldwright::tests {
namespace {

using Colour = std::array<unsigned char, 3>;

renderer::Picture sheet_of(int width, int height, renderer::Display display = {})
{
    return app::contact_sheet(renderer::Frame(width, height, true), 200, display);
}

// Of a view of a frame in which all numbers are this one.
Colour colour_of(renderer::Display display, renderer::View view, float number)
{
    renderer::Frame frame(1, 1, true);
    frame.steps[0] = frame.layers->shadow_steps[0] = static_cast<int>(number);
    frame.layers->minimum_cone_ratio[0] = number;
    display.view = view;
    renderer::Picture picture = renderer::picture(frame, frame, display, 200);
    return {picture.rgb[0], picture.rgb[1], picture.rgb[2]};
}

int count(const renderer::Picture& picture, Colour colour)
{
    int found = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
        found += std::equal(colour.begin(), colour.end(), &picture.rgb[i]);
    return found;
}

// Four views are shown by a colour map, and their bars are at least 6 px high: the colour of the scale's end, which no
// pixel of an empty frame has, stands at the end of each.
TEST(ContactSheet, shows_the_end_of_every_scale)
{
    renderer::Picture sheet = sheet_of(160, 90);
    EXPECT_GE(count(sheet, colour_of({}, renderer::View::steps, 200)), 4 * 6);
    EXPECT_GE(count(sheet, colour_of({}, renderer::View::steps, 100)), 1) << "and what lies between";
    EXPECT_GE(count(sheet, {255, 0, 255}), 9) << "a mark for rays that ran out of steps";
}

TEST(ContactSheet, takes_the_colour_map_and_the_full_scale)
{
    renderer::Display display{.colour_map = renderer::ColourMap::turbo, .full_scale = 50};
    renderer::Picture sheet = sheet_of(160, 90, display);
    EXPECT_GE(count(sheet, colour_of(display, renderer::View::steps, 50)), 4 * 6);
    EXPECT_EQ(count(sheet, colour_of({}, renderer::View::steps, 200)), 0) << "none of viridis";
    EXPECT_TRUE(sheet.rgb != sheet_of(160, 90, {.colour_map = renderer::ColourMap::turbo}).rgb) << "other numbers";
}

TEST(ContactSheet, writes_numbers_without_digits_that_say_nothing)
{
    EXPECT_EQ(ui::scale_text(0.1f), "0.1");
    EXPECT_EQ(ui::scale_text(2), "2");
    EXPECT_EQ(ui::scale_text(12.5), "12.5");
    EXPECT_EQ(ui::scale_text(60000), "60,000");
}

TEST(ContactSheet, cuts_no_word_of_small_pictures)
{
    int widest = 0;
    for (const renderer::ViewKind& kind : renderer::views())
        widest = std::max(widest, assets::lettering(kind.title, 11, ui::inter_regular()).width);
    EXPECT_GE(sheet_of(16, 9).width, 5 * widest);
    EXPECT_EQ(sheet_of(400, 225).width % 400, sheet_of(500, 225).width % 500) << "large ones stand side by side";
}

}  // namespace
}  // namespace fieldwright::tests
