// A grouped scene prints as the scene written out by hand, and drags of what is exposed leave the text.
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using codegen::Placement;

struct Printed {
    std::string text;
    std::vector<float> block;
};

Printed printed(const graph::Document& document, const std::shared_ptr<const graph::Library>& library)
{
    graph::Program program = graph::lower(document, library);
    EXPECT_TRUE(program.problems.empty());
    std::vector<float> block = field::evaluate_frame(program, 0);
    return {codegen::print_fragment_shader(program, block, Placement::buffer), block};
}

// Two balls of one group, one of them moved.
struct GroupText : testing::Test {
    GroupText()
    {
        ball = scene.node("sphere");
        shell = scene.node("shell", {{"d", ball}});
        moved = scene.node("translate", {{"d", shell}});
        both = scene.node("union", {{"a", moved}});
        scene.show(both);
    }

    graph::Document grouped()
    {
        graph::Document document = scene.document;
        graph::Placed first = graph::group_nodes(document, *scene.library, {ball, shell}, "Ball");
        EXPECT_EQ(first.refusal, std::nullopt);
        EXPECT_EQ(graph::expose(document, *graph::with_groups(*scene.library, document), "Ball", ball, "radius"),
                  std::nullopt);
        library = graph::with_groups(*scene.library, document);
        second = graph::add_node(document, *library, "group:Ball");
        EXPECT_EQ(graph::connect(document, *library, second, both, "b"), std::nullopt);
        EXPECT_EQ(graph::set_parameter(document, *library, second, "radius", 0.3f), std::nullopt);
        return document;
    }

    Scene scene;
    std::shared_ptr<const graph::Library> library;
    NodeId ball, shell, moved, both, second;
};

TEST_F(GroupText, is_that_of_the_scene_written_by_hand)
{
    graph::Document groups = grouped();
    graph::Document flat = scene.document;
    // The copies have the ids after the last: 8 and 9 of the first ball, 10 and 11 of the second.
    auto copy = [&](NodeId of, std::int64_t id, float radius, std::int64_t inner) {
        graph::Node node = *scene.document.root.find(of);
        node.id = {id};
        if (of == ball) node.parameters[0].second = radius;
        if (inner) node.inputs[0].second = {inner};
        flat.root.nodes.push_back(node);
    };
    ASSERT_EQ(groups.next_id, 8);
    std::erase_if(flat.root.nodes, [&](const graph::Node& node) { return node.id == ball || node.id == shell; });
    copy(ball, 8, 1.0f, 0);
    copy(shell, 9, 0, 8);
    copy(ball, 10, 0.3f, 0);
    copy(shell, 11, 0, 10);
    flat.next_id = 12;
    ASSERT_EQ(graph::connect(flat, *scene.library, NodeId{9}, moved, "d"), std::nullopt);
    ASSERT_EQ(graph::connect(flat, *scene.library, NodeId{11}, both, "b"), std::nullopt);
    Printed by_group = printed(groups, library), by_hand = printed(flat, scene.library);
    EXPECT_EQ(by_group.text, by_hand.text);
    EXPECT_EQ(by_group.block, by_hand.block);
}

TEST_F(GroupText, is_left_by_a_drag_of_what_is_exposed)
{
    graph::Document document = grouped();
    Printed before = printed(document, library);
    ASSERT_EQ(graph::set_parameter(document, *library, second, "radius", 0.45f), std::nullopt);
    Printed after = printed(document, library);
    EXPECT_EQ(before.text, after.text);
    EXPECT_NE(before.block, after.block);
}

TEST_F(GroupText, of_an_export_calls_copies_like_the_originals)
{
    graph::Document document = grouped();
    graph::enter_group(document, "Ball");
    ASSERT_EQ(graph::rename_node(document, ball, "Rubber ball"), std::nullopt);
    graph::leave_group(document);
    graph::Program program = graph::lower(document, library);
    std::string text = codegen::print_export(program, document, field::evaluate_frame(program, 0), "glsl");
    EXPECT_NE(text.find("rubber_ball"), std::string::npos);
}

}  // namespace
}  // namespace fieldwright::tests
