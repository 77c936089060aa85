// Letters as outlines: unions of contours, and what a text becomes.
#include "assets/outlines.h"
#include "assets/contour_union.h"
#include "assets/font_file.h"
#include "assets/typesetting.h"
#include "graph/contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace fieldwright::tests {
namespace {

using assets::Contour;
using assets::Outlines;
using assets::Writing;
using glm::dvec2;

const std::vector<unsigned char>& inter()
{
    static const std::vector<unsigned char> bytes = assets::find_font("Inter").bytes;
    return bytes;
}

Outlines written(Writing writing) { return assets::outlines_of(writing, inter()); }

Contour square(dvec2 centre, double half)
{
    return {centre + dvec2(-half, -half), centre + dvec2(half, -half), centre + dvec2(half, half),
            centre + dvec2(-half, half)};
}

Contour reversed(Contour contour) { return {contour.rbegin(), contour.rend()}; }

double area(const std::vector<Contour>& contours)
{
    double sum = 0;
    for (const Contour& c : contours)
        for (std::size_t i = 0; i < c.size(); ++i) {
            dvec2 a = c[i], b = c[(i + 1) % c.size()];
            sum += 0.5 * (a.x * b.y - a.y * b.x);
        }
    return sum;
}

int winding(const std::vector<Contour>& contours, dvec2 p)
{
    int sum = 0;
    for (const Contour& c : contours)
        for (std::size_t i = 0; i < c.size(); ++i) {
            dvec2 a = c[i], b = c[(i + 1) % c.size()];
            if ((a.y > p.y) == (b.y > p.y)) continue;
            double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            if (b.y > a.y ? side > 0 : side < 0) sum += b.y > a.y ? 1 : -1;
        }
    return sum;
}

std::vector<Contour> contours_of(const graph::PointList& points)
{
    std::vector<Contour> contours;
    for (const glm::vec4& point : points) {
        if (point.z > 0.5f || contours.empty()) contours.emplace_back();
        contours.back().emplace_back(point.x, point.y);
    }
    return contours;
}

struct Extent {
    dvec2 low{1e9}, high{-1e9};
};

Extent extent(const graph::PointList& points)
{
    Extent box;
    for (const glm::vec4& p : points)
        box.low = glm::min(box.low, dvec2(p.x, p.y)), box.high = glm::max(box.high, dvec2(p.x, p.y));
    return box;
}

TEST(ContourUnion, joins_what_overlaps_and_keeps_what_does_not)
{
    auto joined = assets::contour_union({square({0, 0}, 1), square({1, 1}, 1), square({5, 0}, 0.5)});
    EXPECT_EQ(joined.size(), 2u);
    EXPECT_NEAR(area(joined), 4 + 4 - 1 + 1, 1e-9);
}

TEST(ContourUnion, of_squares_that_share_a_side_or_lie_on_each_other_has_no_inner_side)
{
    auto beside = assets::contour_union({square({-1, 0}, 1), square({1, 0}, 1)});
    ASSERT_EQ(beside.size(), 1u);
    EXPECT_EQ(beside[0].size(), 4u);
    EXPECT_NEAR(area(beside), 8, 1e-9);
    auto twice = assets::contour_union({square({0, 0}, 1), square({0, 0}, 1)});
    EXPECT_NEAR(area(twice), 4, 1e-9);
    EXPECT_EQ(twice.size(), 1u);
}

TEST(ContourUnion, keeps_holes_and_fills_what_is_wound_around_twice)
{
    auto ring = assets::contour_union({square({0, 0}, 2), reversed(square({0, 0}, 1))});
    EXPECT_NEAR(area(ring), 16 - 4, 1e-9);
    auto full = assets::contour_union({square({0, 0}, 2), square({0, 0}, 1)});
    EXPECT_EQ(full.size(), 1u);
    EXPECT_NEAR(area(full), 16, 1e-9);
    auto clockwise = assets::contour_union({reversed(square({0, 0}, 2)), square({0, 0}, 1)});
    EXPECT_NEAR(area(clockwise), 12, 1e-9);
}

TEST(ContourUnion, covers_what_random_contours_wind_around)
{
    std::mt19937 random(4);
    auto number = [&] { return std::uniform_real_distribution(-1.0, 1.0)(random); };
    for (int round = 0; round < 60; ++round) {
        std::vector<Contour> contours(1 + round % 4);
        for (Contour& contour : contours)
            for (int i = 3 + round % 7; i > 0; --i) contour.emplace_back(number(), number());
        auto joined = assets::contour_union(contours);
        int apart = 0;
        for (int i = 0; i < 500; ++i) {
            dvec2 p(number(), number());
            int covered = winding(joined, p);
            EXPECT_TRUE(covered == 0 || covered == 1) << round;
            apart += (winding(contours, p) != 0) != (covered != 0);
        }
        EXPECT_EQ(apart, 0) << round;
    }
}

TEST(Outlines, of_capitals_are_centred_on_the_origin)
{
    Outlines letters = written({.text = "HI"});
    EXPECT_TRUE(letters.problem.empty()) << letters.problem;
    EXPECT_EQ(letters.contours.size(), 12u + 4u);
    Extent box = extent(letters.contours);
    EXPECT_NEAR(box.low.y, -box.high.y, 1e-3);
    EXPECT_NEAR(box.low.x, -box.high.x, 0.02);
    EXPECT_NEAR(box.high.y - box.low.y, 0.727, 0.02);
}

TEST(Outlines, are_kerned)
{
    auto width = [](const char* text) {
        Extent box = extent(written({.text = text}).contours);
        return box.high.x - box.low.x;
    };
    EXPECT_LT(width("AV"), width("AI") - width("II") + width("IV") - 0.01);
}

TEST(Outlines, of_letters_with_more_space_between_are_wider_by_just_that)
{
    Extent narrow = extent(written({.text = "HIH"}).contours);
    Extent wide = extent(written({.text = "HIH", .letter_spacing = 0.25f}).contours);
    EXPECT_NEAR((wide.high.x - wide.low.x) - (narrow.high.x - narrow.low.x), 0.5, 1e-4);
}

TEST(Outlines, of_letters_pushed_into_each_other_are_one)
{
    EXPECT_EQ(contours_of(written({.text = "HHH"}).contours).size(), 3u);
    EXPECT_EQ(contours_of(written({.text = "II", .letter_spacing = -0.2f}).contours).size(), 1u);
}

TEST(Outlines, of_lines_stand_below_each_other_and_meet_where_they_are_aligned)
{
    auto box = [](float alignment) {
        std::vector<Contour> contours = contours_of(written({.text = "HHH\nI", .alignment = alignment}).contours);
        const Contour* lowest = &contours[0];
        for (const Contour& contour : contours)
            if (contour[0].y < (*lowest)[0].y) lowest = &contour;
        double middle = 0;
        for (dvec2 p : *lowest) middle += p.x / static_cast<double>(lowest->size());
        return middle;
    };
    EXPECT_LT(box(0), -0.5);
    EXPECT_NEAR(box(0.5f), 0, 0.02);
    EXPECT_GT(box(1), 0.5);
    Extent one = extent(written({.text = "H"}).contours), two = extent(written({.text = "H\nH"}).contours);
    Extent loose = extent(written({.text = "H\nH", .line_spacing = 2}).contours);
    double step = (two.high.y - two.low.y) - (one.high.y - one.low.y);
    EXPECT_NEAR(step, 1.21, 0.05);
    EXPECT_NEAR((loose.high.y - loose.low.y) - (two.high.y - two.low.y), step, 1e-4);
}

// Every corner lies on the curve, so the middle of every side is where a chord is farthest from it.
TEST(Outlines, follow_curves_within_the_tolerance)
{
    for (const char* font : {"Inter", "DejaVu Sans"}) {
        assets::FontFile file = assets::find_font(font);
        if (!file.error.empty()) continue;
        assets::Typesetter typesetter(file.bytes, file.face);
        auto coarse = typesetter.set({.text = "Oags8&"}, 0.01), fine = typesetter.set({.text = "Oags8&"}, 0.00002);
        ASSERT_EQ(coarse.size(), fine.size());
        double worst = 0;
        for (std::size_t i = 0; i < coarse.size(); ++i)
            for (dvec2 p : fine[i]) {
                double nearest = 1e9;
                for (std::size_t k = 0; k < coarse[i].size(); ++k) {
                    dvec2 a = coarse[i][k], along = coarse[i][(k + 1) % coarse[i].size()] - a;
                    double share = glm::clamp(glm::dot(p - a, along) / std::max(glm::dot(along, along), 1e-12), 0., 1.);
                    nearest = std::min(nearest, glm::distance(p, a + share * along));
                }
                worst = std::max(worst, nearest);
            }
        EXPECT_LE(worst, 0.0101) << font;
        EXPECT_GT(worst, 0.001) << font << ": the coarse outlines are finer than they need be";
    }
}

TEST(Outlines, of_long_texts_are_coarser_and_of_too_long_ones_a_sentence)
{
    Outlines few = written({.text = "gas"}), many = written({.text = "sphinx of quartz"});
    EXPECT_EQ(few.tolerance, 0.001);
    EXPECT_TRUE(many.problem.empty()) << many.problem;
    EXPECT_GT(many.tolerance, 0.001);
    EXPECT_LE(many.contours.size(), graph::contour_side_limit);
    Outlines book = written({.text = std::string(400, 'g')});
    EXPECT_TRUE(book.contours.empty());
    EXPECT_NE(book.problem.find("at most 512 fit"), std::string::npos);
}

TEST(Outlines, of_nothing_and_of_spaces_are_empty_without_a_problem)
{
    for (const char* text : {"", "  ", "\n\n"}) {
        Outlines outlines = written({.text = text});
        EXPECT_TRUE(outlines.contours.empty());
        EXPECT_TRUE(outlines.problem.empty());
    }
}

TEST(Outlines, of_a_font_that_is_missing_or_none_are_one_sentence)
{
    EXPECT_EQ(written({.text = "a", .font = "No Such Font"}).problem,
              "the font `No Such Font` is not installed; the saved outlines are shown: choose another font to edit the "
              "text");
    EXPECT_NE(written({.text = "a", .font = "gone/font.ttf"}).problem.find("is not there"), std::string::npos);
    std::string path = testing::TempDir() + "no_font.otf";
    std::ofstream(path) << "OTTO this is no font";
    EXPECT_NE(written({.text = "a", .font = path}).problem.find("is no font that can be read"), std::string::npos);
    std::filesystem::remove(path);
}

TEST(Outlines, of_any_bytes_as_text_do_no_harm)
{
    std::mt19937 random(1);
    for (int round = 0; round < 30; ++round) {
        std::string text;
        for (int i = 0; i < 12; ++i) text += static_cast<char>(random() % 255 + 1);
        Outlines outlines = written({.text = text});
        EXPECT_TRUE(outlines.problem.empty() || outlines.contours.empty());
    }
}

}  // namespace
}  // namespace fieldwright::tests
