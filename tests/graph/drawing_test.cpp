// Drawings and the rectangles they are kept as.
#include "graph/drawing.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::Drawing;
using graph::PointList;

// Blobs, rings, single cells and holes.
Drawing scribble(Random& random)
{
    Drawing drawing(4 + random.below(61));
    for (int count = 1 + random.below(6); count > 0; --count) {
        glm::vec2 centre(random.between(0, 1) * static_cast<float>(drawing.side()),
                         random.between(0, 1) * static_cast<float>(drawing.side()));
        float radius = random.between(0.5f, 0.4f * static_cast<float>(drawing.side()));
        bool on = random.chance(0.7f), round = random.chance(0.5f);
        for (int y = 0; y < drawing.side(); ++y)
            for (int x = 0; x < drawing.side(); ++x) {
                glm::vec2 away = glm::abs(glm::vec2(x, y) - centre);
                if ((round ? glm::length(away) : std::max(away.x, away.y)) < radius) drawing.fill(x, y, on);
            }
    }
    return drawing;
}

bool covers(const glm::vec4& r, glm::vec2 p)
{
    return std::abs(p.x - r.x) < std::abs(r.z) && std::abs(p.y - r.y) < r.w;
}

TEST(Drawing, is_rebuilt_from_its_rectangles)
{
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        Drawing drawing = scribble(random);
        ASSERT_EQ(Drawing(drawing.rectangles(), drawing.side()), drawing) << i;
    }
}

TEST(Drawing, has_every_filled_cell_in_exactly_one_rectangle)
{
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        Drawing drawing = scribble(random);
        PointList rectangles = drawing.rectangles();
        float area = 0;
        for (const glm::vec4& r : rectangles) area += 4 * r.z * r.w;
        EXPECT_EQ(area, static_cast<float>(drawing.count())) << i;
    }
}

TEST(Drawing, takes_few_rectangles)
{
    Drawing square(64), disc(64), line(64), comb(64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            square.fill(x, y, x >= 3 && x < 61 && y >= 5 && y < 50);
            disc.fill(x, y, glm::length(glm::vec2(x - 31.5f, y - 31.5f)) < 32);
            line.fill(x, y, x == 20);
            comb.fill(x, y, x % 2 == 0 || y < 4);
        }
    EXPECT_EQ(Drawing(64).rectangles().size(), 0u);
    EXPECT_EQ(square.rectangles().size(), 1u);
    EXPECT_EQ(line.rectangles().size(), 1u);
    EXPECT_EQ(comb.rectangles().size(), 33u);
    EXPECT_LE(disc.rectangles().size(), 45u);
    EXPECT_LE(graph::with_gaps(disc.rectangles()).size(), 140u);
}

TEST(Drawing, never_takes_more_rectangles_than_its_rows_have_runs)
{
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        Drawing drawing = scribble(random);
        std::size_t runs = 0;
        for (int y = 0; y < drawing.side(); ++y)
            for (int x = 0; x < drawing.side(); ++x) runs += drawing.filled(x, y) && !drawing.filled(x - 1, y);
        EXPECT_LE(drawing.rectangles().size(), runs);
    }
}

TEST(Drawing, gaps_cover_what_is_empty_and_nothing_else)
{
    Random random(4);
    for (int i = 0; i < 30; ++i) {
        Drawing drawing = scribble(random);
        PointList all = graph::with_gaps(drawing.rectangles());
        if (all.size() <= drawing.rectangles().size()) continue;
        for (int y = 0; y < drawing.side(); ++y)
            for (int x = 0; x < drawing.side(); ++x) {
                glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                for (const glm::vec4& r : all) {
                    if (covers(r, centre)) {
                        ASSERT_EQ(r.z > 0, drawing.filled(x, y)) << x << " " << y;
                    }
                }
            }
    }
}

TEST(Drawing, has_no_gaps_between_borders_that_differ_by_rounding)
{
    PointList pair = {{1.01f, 1, 1, 1}, {3.01f, 1, 1, 1}};
    EXPECT_EQ(graph::with_gaps(pair).size(), 2u + 4u);
    for (glm::vec4& r : pair) r.x += 0.013f;
    EXPECT_EQ(graph::with_gaps(pair).size(), 2u + 4u);
}

TEST(Drawing, leaves_the_gaps_out_when_there_are_too_many)
{
    Drawing board(40), fine(20);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) board.fill(x, y, (x + y) % 2 == 0), fine.fill(x, y, (x + y) % 2 == 0);
    EXPECT_EQ(graph::with_gaps(board.rectangles()).size(), graph::drawing_rectangle_limit);
    EXPECT_EQ(board.rectangles().size(), 800u);
    EXPECT_GT(graph::with_gaps(fine.rectangles()).size(), 400u);
}

TEST(Drawing, of_rectangles_that_overlap_or_lie_off_the_grid_covers_whole_cells_by_their_centres)
{
    Drawing drawing({{2, 2, 2, 2}, {3, 3, 2, 1}, {-5, 1, 1, 1}, {7.4f, 6.6f, 0.5f, 0.5f}, {100, 100, 300, 0.1f}}, 8);
    EXPECT_EQ(drawing.count(), 16 + 2 + 1);
    EXPECT_TRUE(drawing.filled(7, 6));
    EXPECT_FALSE(drawing.filled(8, 8));
}

TEST(Drawing, too_large_for_its_loop_is_noted_on_the_node)
{
    Drawing board(40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) board.fill(x, y, (x + y) % 2 == 0);
    Scene scene;
    NodeId node = scene.node("drawn_profile", {{"rectangles", board.rectangles()}, {"cells", 40}});
    scene.show(scene.node("extrude", {{"d", node}}));
    graph::Program program = scene.program();
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].node, node);
    EXPECT_EQ(program.problems[0].severity, graph::Problem::Severity::note);
    EXPECT_NE(program.problems[0].sentence.find("800 rectangles"), std::string::npos);
}

// What makes long lists affordable: short ones cost what they are long.
TEST(Drawing, costs_the_iterations_of_its_own_rectangles)
{
    auto iterations = [](const PointList& rectangles) {
        Scene scene;
        scene.show(scene.node("extrude", {{"d", scene.node("drawn_profile", {{"rectangles", rectangles}})}}));
        return scene.program().loop_iterations;
    };
    EXPECT_EQ(iterations({{8, 8, 4, 4}}), 1 + 4 + 1);  // the square, a gap on each side, and the look that ends it
    EXPECT_EQ(iterations(PointList(4000, glm::vec4(8, 8, 4, 4))), 512);
}

}  // namespace
}  // namespace fieldwright::tests
