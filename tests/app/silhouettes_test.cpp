// Solids of three drawings held to what each drawing shows.
#include "app/silhouettes.h"
#include "graph/drawing.h"
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <chrono>

namespace fieldwright::tests {
namespace {

using app::Silhouettes;
using graph::Drawing;

struct Views {
    Scene scene;
    NodeId solid = scene.node("three_extrusions");

    NodeId draw(const char* socket, const Drawing& drawing)
    {
        NodeId node = scene.node("drawn_profile", {{"rectangles", drawing.rectangles()}, {"cells", drawing.side()}});
        scene.wire(node, solid, socket);
        return node;
    }
    Silhouettes compared() const { return app::compare_silhouettes(scene.document, scene.library, false); }
};

Drawing block(int x0, int y0, int x1, int y1)
{
    Drawing drawing(16);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) drawing.fill(x, y, true);
    return drawing;
}

TEST(Silhouettes, of_drawings_that_agree_miss_nothing)
{
    Views views;
    views.draw("a", block(2, 2, 14, 14));
    views.draw("b", block(4, 2, 12, 14));
    views.draw("c", block(2, 4, 14, 12));
    EXPECT_TRUE(views.compared().notes.empty());
    EXPECT_TRUE(views.compared().missed.empty());
}

TEST(Silhouettes, mark_the_cells_that_the_other_views_leave_nothing_behind)
{
    Views views;
    NodeId front = views.draw("a", block(2, 2, 14, 14));
    NodeId right = views.draw("b", block(4, 5, 12, 14));  // nothing below row 5
    views.draw("c", block(2, 4, 14, 12));
    Silhouettes found = views.compared();
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_EQ(found.notes[0].node, views.solid);
    EXPECT_EQ(found.notes[0].severity, graph::Problem::Severity::note);
    EXPECT_TRUE(found.notes[0].sentence.starts_with("the front view misses 36 of 144 cells"))
        << found.notes[0].sentence;
    ASSERT_EQ(found.missed.count(front), 1u);
    EXPECT_EQ(found.missed.count(right), 0u);
    for (glm::ivec2 cell : found.missed.at(front)) EXPECT_LT(cell.y, 5);
}

// Seen from the right, the front of the solid is on the left; from above, it is below.
TEST(Silhouettes, look_along_each_view_the_right_way_around)
{
    Views views;
    NodeId right = views.draw("b", block(0, 0, 16, 16));
    NodeId above = views.draw("c", block(0, 0, 16, 4));  // a strip in front
    Silhouettes found = views.compared();
    ASSERT_EQ(found.missed.count(right), 1u);
    EXPECT_EQ(found.missed.at(right).size(), 12u * 16u);
    for (glm::ivec2 cell : found.missed.at(right)) EXPECT_GE(cell.x, 4);
    EXPECT_EQ(found.missed.count(above), 0u);
}

// The mark is on the drawing where it is painted, the note on the group's node with the way to the solid.
TEST(Silhouettes, are_compared_inside_of_groups)
{
    Views views;
    NodeId front = views.draw("a", block(2, 2, 14, 14)), right = views.draw("b", block(4, 5, 12, 14));
    views.scene.show(views.solid);
    graph::Placed group =
        graph::group_nodes(views.scene.document, *views.scene.library, {views.solid, front, right}, "Piece");
    ASSERT_EQ(group.refusal, std::nullopt);
    views.scene.library = graph::with_groups(*views.scene.library, views.scene.document);
    Silhouettes found = views.compared();
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_EQ(found.notes[0].node, group.node);
    EXPECT_EQ(found.notes[0].inside, std::vector<NodeId>{views.solid});
    ASSERT_EQ(found.missed.count(front), 1u);
    EXPECT_EQ(found.missed.at(front).size(), 36u);
}

// A drawing that is set from outside is the one that is compared.
TEST(Silhouettes, of_a_group_are_those_of_the_drawing_that_its_node_has)
{
    Views views;
    NodeId front = views.draw("a", block(2, 2, 14, 14)), right = views.draw("b", block(4, 5, 12, 14));
    views.scene.show(views.solid);
    NodeId piece =
        graph::group_nodes(views.scene.document, *views.scene.library, {views.solid, front, right}, "Piece").node;
    auto learn = [&] { views.scene.library = graph::settle_groups(views.scene.document, *views.scene.library); };
    learn();
    ASSERT_EQ(graph::expose(views.scene.document, *views.scene.library, "Piece", right, "rectangles"), std::nullopt);
    learn();
    ASSERT_EQ(views.compared().notes.size(), 1u);
    views.scene.set(piece, "rectangles", block(4, 2, 12, 14).rectangles());
    EXPECT_TRUE(views.compared().notes.empty());
}

TEST(Silhouettes, of_views_switched_off_are_not_compared)
{
    Views views;
    views.draw("a", block(2, 2, 14, 14));
    views.draw("b", block(4, 5, 12, 14));
    ASSERT_EQ(views.compared().notes.size(), 1u);
    views.scene.set(views.solid, "right", false);
    EXPECT_TRUE(views.compared().notes.empty());
}

TEST(Silhouettes, answers_come_from_a_thread_of_their_own_and_go_with_the_solid)
{
    Views views;
    views.draw("a", block(2, 2, 14, 14));
    views.draw("b", block(4, 5, 12, 14));
    app::SilhouetteWatch watch([] {});
    watch.look_at(views.scene.document, views.scene.library);
    for (int wait = 0; wait < 3000 && !watch.take(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(watch.answer().notes.size(), 1u);
    watch.look_at({}, views.scene.library);
    EXPECT_TRUE(watch.take());
    EXPECT_TRUE(watch.answer().notes.empty());
}

TEST(Silhouettes, a_watch_ends_in_the_middle_of_its_work)
{
    Views views;
    for (const char* socket : {"a", "b", "c"}) views.draw(socket, block(0, 0, 16, 16));
    for (int round = 0; round < 20; ++round) {
        app::SilhouetteWatch watch([] {});
        watch.look_at(views.scene.document, views.scene.library);
    }
}

}  // namespace
}  // namespace fieldwright::tests
