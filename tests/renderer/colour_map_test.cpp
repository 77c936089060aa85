// Colour maps against Open Image IO's, and against what makes one readable.
#include "renderer/colour_map.h"

#include "renderer/srgb_table.h"

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;

constexpr int places = 256;

float share(int i) { return static_cast<float>(i) / (places - 1); }

int byte(float linear) { return SrgbTable::shared().byte(linear); }

TEST(ColourMaps, are_found_by_their_names_and_end_where_they_should)
{
    struct Ends {
        const char* name;
        int low[3], high[3];
    };
    for (const Ends& ends : {Ends{"viridis", {0x44, 0x01, 0x54}, {0xfd, 0xe7, 0x25}},
                             Ends{"inferno", {0x00, 0x00, 0x04}, {0xfc, 0xff, 0xa4}},
                             Ends{"cividis", {0x00, 0x22, 0x4e}, {0xfe, 0xe8, 0x38}},
                             Ends{"turbo", {0x30, 0x12, 0x3b}, {0x7a, 0x04, 0x03}}}) {
        ColourMap map = colour_map_from_name(ends.name).value();
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(byte(map_colour(map, 0)[k]), ends.low[k]) << ends.name;
            EXPECT_EQ(byte(map_colour(map, 1)[k]), ends.high[k]) << ends.name;
            EXPECT_EQ(map_colour(map, -1)[k], map_colour(map, 0)[k]);
            EXPECT_EQ(map_colour(map, 7)[k], map_colour(map, 1)[k]);
        }
        EXPECT_FALSE(colour_map_help(map).empty());
    }
    EXPECT_EQ(colour_map_names().size(), 4u);
    EXPECT_FALSE(colour_map_from_name("jet"));
}

TEST(ColourMaps, agree_with_open_image_io_within_two_of_255)
{
    OIIO::ImageBuf ramp(OIIO::ImageSpec(places, 1, 1, OIIO::TypeFloat));
    for (int i = 0; i < places; ++i) {
        float value = share(i);
        ramp.setpixel(i, 0, 0, &value, 1);
    }
    for (const char* name : {"viridis", "inferno", "turbo"}) {
        OIIO::ImageBuf theirs = OIIO::ImageBufAlgo::color_map(ramp, 0, name);
        ASSERT_FALSE(theirs.has_error()) << theirs.geterror();
        for (int i = 0; i < places; ++i) {
            float linear[3];
            theirs.getpixel(i, 0, 0, linear, 3);
            glm::vec3 ours = map_colour(*colour_map_from_name(name), share(i));
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(byte(ours[k]), byte(linear[k]), 2) << name << " at " << i << ", channel " << k;
        }
    }
}

TEST(ColourMaps, but_the_rainbow_grow_ever_lighter)
{
    for (const char* name : {"viridis", "inferno", "cividis"}) {
        float before = -1;
        for (int i = 0; i < places; ++i) {
            glm::vec3 colour = map_colour(*colour_map_from_name(name), share(i));
            float luminance = glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f));
            ASSERT_GT(luminance, before) << name << " at " << i;
            before = luminance;
        }
    }
}

}  // namespace
}  // namespace fieldwright::tests
