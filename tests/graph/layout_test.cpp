// Automatic layout: columns follow the wires, nothing overlaps, the same graph always gets the same picture.
#include "graph/layout.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

glm::vec2 uneven_size(NodeId id) { return {140 + 10 * (id.number % 9), 40 + 17 * (id.number % 11)}; }

class Layout : public testing::Test {
protected:
    glm::vec2 position(NodeId id) { return document.root.find(id)->position; }

    tests::Scene scene;
    Document& document = scene.document;
};

void expect_apart(const std::map<NodeId, glm::vec2>& places)
{
    for (auto a = places.begin(); a != places.end(); ++a)
        for (auto b = std::next(a); b != places.end(); ++b) {
            glm::vec2 a_end = a->second + uneven_size(a->first), b_end = b->second + uneven_size(b->first);
            bool beside = a_end.x + layout_gap_x_px <= b->second.x || b_end.x + layout_gap_x_px <= a->second.x;
            bool below = a_end.y + layout_gap_y_px - 1 <= b->second.y || b_end.y + layout_gap_y_px - 1 <= a->second.y;
            EXPECT_TRUE(beside || below) << a->first.number << " and " << b->first.number;
        }
}

TEST_F(Layout, random_graphs_flow_to_the_right_without_overlaps)
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Graph graph = tests::RandomGraph(seed, scene.library).take().document.root;
        std::map<NodeId, glm::vec2> places = layout(graph, {}, uneven_size);
        ASSERT_EQ(places.size(), graph.nodes.size());
        expect_apart(places);
        for (const Node& node : graph.nodes)
            for (const auto& [socket, source] : node.inputs)
                EXPECT_LE(places[source].x + uneven_size(source).x + layout_gap_x_px, places[node.id].x);
    }
}

TEST_F(Layout, a_chain_is_a_straight_line_and_the_column_is_the_longest_way)
{
    auto size = [](NodeId) { return glm::vec2(100, 50); };
    NodeId box = scene.node("box"), round = scene.node("round", {{"d", box}}), output = scene.show(round);
    ASSERT_EQ(arrange(document, {}, size), std::nullopt);
    EXPECT_EQ(position(box), glm::vec2(0, 0));
    EXPECT_EQ(position(round), glm::vec2(140, 0));
    EXPECT_EQ(position(output), glm::vec2(280, 0));
    NodeId both = scene.node("union", {{"a", box}, {"b", round}});
    scene.wire(both, output, "d");
    ASSERT_EQ(arrange(document, {}, size), std::nullopt);
    EXPECT_EQ(position(box).x, 0);
    EXPECT_EQ(position(round).x, 140) << "box is before round though the union reads it too";
    EXPECT_EQ(position(both).x, 280);
}

TEST_F(Layout, inputs_stand_in_the_order_of_their_sockets)
{
    NodeId low = scene.node("box"), high = scene.node("sphere");
    NodeId both = scene.node("union", {{"a", high}, {"b", low}});
    scene.show(both);
    ASSERT_EQ(arrange(document, {}, uneven_size), std::nullopt);
    EXPECT_LT(position(high).y, position(low).y);
}

TEST_F(Layout, crossings_are_swept_away)
{
    // In the order of sockets box would stand above ball, and its wire to `lower` would cross ball's.
    NodeId box = scene.node("box"), ball = scene.node("sphere");
    NodeId upper = scene.node("union", {{"a", box}, {"b", ball}}), lower = scene.node("round", {{"d", box}});
    scene.show(scene.node("union", {{"a", upper}, {"b", lower}}));
    ASSERT_EQ(arrange(document, {}, uneven_size), std::nullopt);
    EXPECT_LT(position(upper).y, position(lower).y);
    EXPECT_LT(position(ball).y, position(box).y);
}

TEST_F(Layout, a_selection_stays_where_it_is_and_the_rest_untouched)
{
    NodeId box = scene.node("box"), round = scene.node("round", {{"d", box}}), output = scene.show(round);
    move_node(document, box, {500, 300});
    move_node(document, round, {450, 350});
    move_node(document, output, {-50, -60});
    ASSERT_EQ(arrange(document, {box, round}, uneven_size), std::nullopt);
    EXPECT_EQ(glm::min(position(box), position(round)), glm::vec2(450, 300));
    EXPECT_LT(position(box).x, position(round).x);
    EXPECT_EQ(position(output), glm::vec2(-50, -60));
    Document before = document;
    EXPECT_EQ(arrange(document, {box, {99}}, uneven_size), "there is no node 99");
    EXPECT_EQ(document, before);
}

TEST_F(Layout, the_same_graph_always_gets_the_same_places_and_keeps_them)
{
    document = tests::RandomGraph(7, scene.library, 60).take().document;
    ASSERT_EQ(arrange(document, {}, uneven_size), std::nullopt);
    Document once = document;
    ASSERT_EQ(arrange(document, {}, uneven_size), std::nullopt);
    EXPECT_EQ(document, once);
    EXPECT_TRUE(layout({}, {}, uneven_size).empty());
}

TEST_F(Layout, a_heap_is_where_more_than_half_lie_on_another)
{
    EXPECT_FALSE(lies_in_heaps(document.root));
    NodeId first = scene.node("box");
    EXPECT_FALSE(lies_in_heaps(document.root)) << "one lies on nothing";
    NodeId second = scene.node("box"), third = scene.node("box");
    EXPECT_TRUE(lies_in_heaps(document.root));
    ASSERT_FALSE(move_node(document, first, {40, 0}));
    EXPECT_TRUE(lies_in_heaps(document.root));
    NodeId fourth = scene.node("box");
    ASSERT_FALSE(move_node(document, fourth, {80, 0}));
    EXPECT_FALSE(lies_in_heaps(document.root)) << "two of four";
    ASSERT_EQ(arrange(document, {second, third}, uneven_size), std::nullopt);
    EXPECT_FALSE(lies_in_heaps(document.root));
}

TEST_F(Layout, nodes_of_unknown_type_are_left_out)
{
    NodeId box = scene.node("box");
    Node stranger;
    stranger.id = {document.next_id++};
    stranger.type = "warp";
    stranger.unknown_source = "{\"type\": \"warp\"}";
    document.root.nodes.push_back(stranger);
    ASSERT_EQ(arrange(document, {}, uneven_size), std::nullopt);
    EXPECT_EQ(layout(document.root, {}, uneven_size).count(stranger.id), 0u);
    EXPECT_EQ(position(box), glm::vec2(0, 0));
}

}  // namespace
}  // namespace fieldwright::graph
