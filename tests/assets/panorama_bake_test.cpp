// What skies get of a picture: its light, and what a matt surface gathers of it.
#include "assets/panorama_bake.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::assets {
namespace {

template <typename Colour>
Pixels picture(int width, int height, const Colour& colour)
{
    Pixels pixels{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec3 rgb = colour(x, y);
            pixels.rgba.insert(pixels.rgba.end(), {rgb.r, rgb.g, rgb.b, 1.0f});
        }
    return pixels;
}

// The two maps of the list.
struct Maps {
    explicit Maps(const graph::BakedImage& image) : list(image.list), head(list.at(0))
    {
        EXPECT_EQ(image.sentence, "");
        EXPECT_EQ(list.size(), 1 + static_cast<std::size_t>(head.x * head.y + head.z * head.w));
    }
    float sharp(int x, int y) const
    {
        return list.at(static_cast<std::size_t>(1 + x + y * static_cast<int>(head.x))).x;
    }
    // Columns and rows as shares.
    float gathered(float across, float down) const
    {
        int first = 1 + static_cast<int>(head.x * head.y);
        int x = static_cast<int>(across * head.z), y = static_cast<int>(down * head.w);
        return list.at(static_cast<std::size_t>(first + x + y * static_cast<int>(head.z))).x;
    }
    const graph::PointList& list;
    glm::vec4 head;
};

TEST(Panorama, keeps_the_light_of_every_pixel)
{
    graph::BakedImage image = panorama(picture(8, 4, [](int x, int y) { return glm::vec3(float(10 * y + x), 0, 0); }));
    Maps maps(image);
    EXPECT_EQ(maps.head.x, 8);
    EXPECT_EQ(maps.head.y, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(maps.sharp(x, y), static_cast<float>(10 * y + x));
}

TEST(Panorama, gathers_what_a_matt_surface_sees)
{
    graph::BakedImage even = panorama(picture(90, 45, [](int, int) { return glm::vec3(0.7f); }));
    for (float down : {0.1f, 0.5f, 0.9f}) EXPECT_NEAR(Maps(even).gathered(0.3f, down), 0.7f, 1e-3f);
    // The upper half shines: all of what a level surface sees, half of what an upright one does.
    graph::BakedImage upper = panorama(picture(90, 46, [](int, int y) { return glm::vec3(y < 23 ? 2.0f : 0.0f); }));
    EXPECT_NEAR(Maps(upper).gathered(0.5f, 0.0f), 2, 0.05f);
    EXPECT_NEAR(Maps(upper).gathered(0.5f, 0.99f), 0, 0.05f);
    EXPECT_NEAR(0.5f * (Maps(upper).gathered(0.2f, 0.49f) + Maps(upper).gathered(0.2f, 0.51f)), 1, 0.05f);
    // One bright direction at +x: the cosine to it.
    graph::BakedImage lamp = panorama(
        picture(64, 32, [](int x, int y) { return glm::vec3(x == 48 && (y == 15 || y == 16) ? 100.0f : 0.0f); }));
    float facing = Maps(lamp).gathered(0.75f, 0.5f);
    EXPECT_GT(facing, 0);
    EXPECT_NEAR(Maps(lamp).gathered(0.625f, 0.5f) / facing, std::sqrt(0.5f), 0.06f);
    EXPECT_EQ(Maps(lamp).gathered(0.25f, 0.5f), 0);
}

TEST(Panorama, survives_pictures_of_one_pixel_and_what_files_claim)
{
    graph::BakedImage single = panorama(picture(1, 1, [](int, int) { return glm::vec3(0.5f); }));
    Maps one(single);
    EXPECT_EQ(one.head.x, 2);
    EXPECT_EQ(one.head.y, 2);
    graph::BakedImage wild = panorama(picture(4, 2, [](int x, int) { return glm::vec3(x ? 1e30f : -5.0f); }));
    for (const glm::vec4& entry : wild.list) {
        EXPECT_GE(entry.x, 0);
        EXPECT_LE(entry.x, 1e6f);
    }
}

}  // namespace
}  // namespace fieldwright::assets
