// Distances made of pixels: where the edge is found, how far it is from everywhere, and what is inside.
#include "assets/image_bake.h"
#include "assets/image_outline.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <random>

namespace fieldwright::assets {
namespace {

// Grey and alpha at the middle of every pixel.
Pixels painted(int width, int height, const std::function<glm::vec2(glm::vec2)>& paint)
{
    Pixels pixels{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec2 grey_alpha = paint(glm::vec2(x, y) + 0.5f);
            pixels.rgba.insert(pixels.rgba.end(), {grey_alpha.x, grey_alpha.x, grey_alpha.x, grey_alpha.y});
        }
    return pixels;
}

// Black on white, with the edge a pixel wide that drawing programs make.
Pixels disc(int side, glm::vec2 centre, float radius)
{
    return painted(side, side, [=](glm::vec2 p) {
        return glm::vec2(std::clamp(0.5f + glm::distance(p, centre) - radius, 0.0f, 1.0f), 1);
    });
}

struct Samples {
    explicit Samples(const graph::BakedImage& image) : list(image.list) {}
    int columns() const { return static_cast<int>(list[0].x); }
    int rows() const { return static_cast<int>(list[0].y); }
    float at(int x, int y) const
    {
        int i = y * columns() + x;
        return list[static_cast<std::size_t>(2 + i / 4)][i % 4];
    }
    const graph::PointList& list;
};

TEST(ImageBake, agrees_with_the_circle_that_was_drawn)
{
    constexpr int side = 120;
    constexpr float radius = 37.3f;
    const glm::vec2 centre(60.4f, 55.2f);  // from the upper left corner
    for (int per_pixel : {1, 2}) {
        graph::BakedImage image = baked(disc(side, centre, radius), {.detail = (side + 1) * per_pixel}, "it");
        Samples samples(image);
        ASSERT_EQ(samples.columns(), (side + 1) * per_pixel + 1);
        float worst = 0, scale = image.list[0].w * side;
        for (int y = 0; y < samples.rows(); ++y)
            for (int x = 0; x < samples.columns(); ++x) {
                // The first sample is the middle of a pixel outside the lower left corner.
                glm::vec2 p(scale * static_cast<float>(x) - 0.5f, side + 0.5f - scale * static_cast<float>(y));
                float error = scale * samples.at(x, y) - (glm::distance(p, centre) - radius);
                if (glm::distance(p, centre) > 10) worst = std::max(worst, std::abs(error));  // but for the cone's tip
            }
        EXPECT_LT(worst, 0.12f) << per_pixel;  // of a pixel
        EXPECT_NEAR(scale, 1 / static_cast<float>(per_pixel), 1e-6f);
        EXPECT_NEAR(image.list[1].x * scale, centre.x + 0.5f, 0.1f);
        EXPECT_NEAR(image.list[1].y * scale, side - centre.y + 0.5f, 0.1f);
        EXPECT_NEAR(image.list[1].z * scale, radius, 1.2f);
    }
}

TEST(ImageBake, finds_a_smooth_edge_where_pixels_are_to_spare)
{
    graph::BakedImage image = baked(disc(200, {100.3f, 99.6f}, 63.2f), {.detail = 100}, "it");
    Samples samples(image);
    float worst = 0, scale = image.list[0].w * 200;
    for (int y = 0; y < samples.rows(); ++y)
        for (int x = 0; x < samples.columns(); ++x) {
            glm::vec2 from_middle(static_cast<float>(x) - 0.5f * static_cast<float>(samples.columns() - 1),
                                  static_cast<float>(y) - 0.5f * static_cast<float>(samples.rows() - 1));
            glm::vec2 p = scale * from_middle + 100.0f;
            float circle = glm::distance(p, {100.3f, 100.4f}) - 63.2f;
            if (std::abs(circle) < 2.5f) worst = std::max(worst, std::abs(scale * samples.at(x, y) - circle));
        }
    EXPECT_LT(worst, 0.06f);  // of a pixel
    EXPECT_LT(image.list[0].z, 1.25f);
}

TEST(ImageBake, keeps_the_middle_of_the_picture_whatever_the_detail)
{
    for (int detail : {16, 23, 50, 211}) {
        graph::BakedImage image = baked(disc(90, {45, 45}, 30), {.detail = detail}, "it");
        glm::vec4 head = image.list[0], box = image.list[1];
        EXPECT_LE(std::max(head.x, head.y), static_cast<float>(detail) + 1) << detail;
        EXPECT_NEAR(box.x, 0.5f * (head.x - 1), 0.02f) << detail;
        EXPECT_NEAR((box.z - 1) * head.w * 90, 30, 0.15f) << detail;
    }
}

TEST(ImageBake, states_how_steep_its_interpolation_is)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> grey(0, 1);
    Pixels noise = painted(40, 30, [&](glm::vec2) { return glm::vec2(grey(random), 1); });
    graph::BakedImage image = baked(noise, {.detail = 40}, "it");
    Samples samples(image);
    float stated = image.list[0].z, steepest = 0;
    for (int y = 0; y + 1 < samples.rows(); ++y)
        for (int x = 0; x + 1 < samples.columns(); ++x)
            for (float u : {0.0f, 0.3f, 1.0f})
                for (float v : {0.0f, 0.6f, 1.0f}) {
                    float a = samples.at(x, y), b = samples.at(x + 1, y), c = samples.at(x + 1, y + 1),
                          d = samples.at(x, y + 1);
                    glm::vec2 slope((1 - v) * (b - a) + v * (c - d), (1 - u) * (d - a) + u * (c - b));
                    steepest = std::max(steepest, glm::length(slope));
                }
    EXPECT_LE(steepest, stated);
    EXPECT_GT(steepest, 0.99f * stated);
    EXPECT_LE(stated, 1.4143f);
}

TEST(ImageBake, takes_the_part_that_is_asked_for)
{
    // From left to right: black, white, transparent black.
    Pixels stripes = painted(30, 10, [](glm::vec2 p) { return glm::vec2(p.x < 10 || p.x > 20 ? 0 : 1, p.x < 20); });
    auto inside = [&](const char* part, int x) {
        graph::BakedImage image = baked(stripes, {.part = part, .detail = 30}, "it");
        return Samples(image).at(x + 1, 5) < 0;
    };
    using Three = std::array<bool, 3>;
    auto which = [&](const char* part) { return Three{inside(part, 5), inside(part, 15), inside(part, 25)}; };
    EXPECT_EQ(which("dark"), (Three{true, false, false}));
    EXPECT_EQ(which("bright"), (Three{false, true, false}));
    EXPECT_EQ(which("opaque"), (Three{true, true, false}));
    EXPECT_EQ(which("transparent"), (Three{false, false, true}));
}

TEST(ImageBake, moves_the_edge_with_the_level)
{
    // Grey grows from black at the left to white at the right.
    Pixels slope = painted(101, 9, [](glm::vec2 p) { return glm::vec2((p.x - 0.5f) / 100, 1); });
    for (int level : {10, 50, 90}) {
        graph::BakedImage image = baked(slope, {.level = level, .detail = 101}, "it");
        glm::vec4 head = image.list[0], box = image.list[1];
        float right = box.x + box.z - 1;  // the box leaves a sample around
        float right_px = 50.5f + (right - 0.5f * (head.x - 1)) * head.w * 9;
        EXPECT_NEAR(right_px, static_cast<float>(level) + 0.5f, 0.01f);
    }
}

TEST(ImageBake, closes_what_reaches_the_border)
{
    Pixels black = painted(8, 8, [](glm::vec2) { return glm::vec2(0, 1); });
    graph::BakedImage image = baked(black, {.detail = 18}, "it");
    Samples samples(image);
    EXPECT_LT(samples.at(samples.columns() / 2, samples.rows() / 2), 0);
    for (int x = 0; x < samples.columns(); ++x) EXPECT_GT(samples.at(x, 0), 0);
    EXPECT_NEAR(samples.at(0, samples.rows() / 2), 1, 0.01f);  // half a pixel, which is one spacing
}

TEST(ImageBake, says_that_there_is_nothing)
{
    Pixels white = painted(8, 8, [](glm::vec2) { return glm::vec2(1, 1); });
    graph::BakedImage image = baked(white, {}, "the picture x");
    EXPECT_TRUE(image.list.empty());
    EXPECT_EQ(image.sentence, "the picture x has nothing dark at this level; change the part or the level");
}

TEST(ImageBake, stays_within_its_limits)
{
    for (int side : {1, 7, graph::image_detail_limit}) {
        Pixels black = painted(side, side, [](glm::vec2) { return glm::vec2(0, 1); });
        EXPECT_LE(baked(black, {.detail = graph::image_detail_limit}, "it").list.size(), 65536u) << side;
    }
}

// No side changes nearer than the distance, and one does right behind it.
TEST(ImageOutline, is_as_far_away_as_it_says)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1), along(0, 1);
    NumberGrid grid{24, 17, {}};
    for (int i = 0; i < 24 * 17; ++i) grid.numbers.push_back(number(random) + (i % 24 < 8 ? 2.0f : 0.0f));
    ImageOutline outline(grid, 0.2f);
    ASSERT_FALSE(outline.empty());
    for (int round = 0; round < 300; ++round) {
        glm::vec2 p(23 * along(random), 16 * along(random));
        float distance = outline.distance(p, 100);
        bool changes = false;
        for (int i = 0; i < 1440; ++i) {
            float angle = 6.2831853f * static_cast<float>(i) / 1440;
            glm::vec2 direction(std::cos(angle), std::sin(angle));
            auto within = [](glm::vec2 q) { return q.x >= 0 && q.y >= 0 && q.x <= 23 && q.y <= 16; };
            glm::vec2 before = p + (0.999f * along(random) * distance) * direction;
            ASSERT_TRUE(!within(before) || outline.inside(before) == outline.inside(p)) << p.x << ", " << p.y;
            glm::vec2 behind = p + (distance + 0.01f) * direction;
            changes = changes || (within(behind) && outline.inside(behind) != outline.inside(p));
        }
        EXPECT_TRUE(changes) << p.x << ", " << p.y << " at " << distance;
    }
}

}  // namespace
}  // namespace fieldwright::assets
