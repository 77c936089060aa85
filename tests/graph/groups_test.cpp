// Groups: what they are as node types, what they expand to, what edits of them keep, and what files of them must hold.
#include "graph/adapt.h"
#include "graph/expansion.h"
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "graph/history.h"
#include "graph/image_request.h"
#include "graph/scene_file.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace fieldwright::graph {
namespace {

using tests::Random;
using tests::Scene;

std::string bits_of(const Value& value)
{
    std::string text = std::to_string(value.index()) + ":";
    if (auto* number = std::get_if<float>(&value)) text += std::to_string(*number);
    if (auto* vector = std::get_if<glm::vec3>(&value))
        for (int i = 0; i < 3; ++i) text += std::to_string((*vector)[i]) + ",";
    if (auto* word = std::get_if<std::string>(&value)) text += *word;
    return text;
}

// What a node means, whatever the ids are.
std::string meaning(const Graph& graph, NodeId id, std::map<NodeId, std::string>& known)
{
    if (auto found = known.find(id); found != known.end()) return found->second;
    const Node& node = *graph.find(id);
    std::string text = node.type + (node.muted ? "!" : "") + "(";
    for (const auto& [name, value] : node.parameters) text += name + "=" + bits_of(value) + ";";
    for (const auto& [socket, source] : node.inputs) text += socket + "<" + meaning(graph, source, known) + ";";
    return known[id] = std::to_string(std::hash<std::string>()(text + ")"));
}

std::vector<std::string> meanings(const Graph& graph)
{
    std::map<NodeId, std::string> known;
    std::vector<std::string> all;
    for (const Node& node : graph.nodes) all.push_back(meaning(graph, node.id, known));
    std::sort(all.begin(), all.end());
    return all;
}

std::string meaning_of_output(const Document& document)
{
    std::map<NodeId, std::string> known;
    for (const Node& node : document.root.nodes)
        if (node.type == "output") return meaning(document.root, node.id, known);
    return {};
}

// A tyre and a hub, moved and shown: translate(union(torus, cylinder)).
struct Cart : testing::Test {
    Cart()
    {
        hub = scene.node("cylinder");
        tyre = scene.node("torus", {{"minor", 0.2f}});
        both = scene.node("union", {{"a", tyre}, {"b", hub}});
        moved = scene.node("translate", {{"d", both}, {"offset", glm::vec3(1, 0, 0)}});
        scene.show(moved);
    }

    NodeId grouped(std::string_view name = "Wheel")
    {
        Placed placed = group_nodes(document, *library, {hub, tyre, both}, name);
        EXPECT_EQ(placed.refusal, std::nullopt);
        library = with_groups(*library, document);
        return placed.node;
    }

    NodeId second(const std::string& type = "group:Wheel")
    {
        NodeId node = add_node(document, *library, type);
        NodeId pair = add_node(document, *library, "union");
        EXPECT_FALSE(connect(document, *library, moved, pair, "a"));
        EXPECT_FALSE(connect(document, *library, node, pair, "b"));
        EXPECT_FALSE(connect(document, *library, pair, output(), "d"));
        return node;
    }

    NodeId output() const
    {
        for (const Node& node : document.root.nodes)
            if (node.type == "output") return node.id;
        return {};
    }

    void expect_valid() const { EXPECT_EQ(validate(document, *scene.library), std::nullopt); }
    void settle() { library = settle_groups(document, *library); }
    const Node& node(NodeId id) const { return *document.root.find(id); }
    const Group& wheel() const { return *find_group(document, "Wheel"); }

    Scene scene;
    Document& document = scene.document;
    std::shared_ptr<const Library> library = scene.library;
    NodeId hub, tyre, both, moved;
};

TEST_F(Cart, a_group_expands_to_the_scene_it_was_made_of)
{
    Document flat = document;
    NodeId wheel_node = grouped();
    expect_valid();
    EXPECT_EQ(document.root.nodes.size(), 3u);
    Expansion expansion = expanded(document, *library);
    EXPECT_EQ(meanings(expansion.document.root), meanings(flat.root));
    EXPECT_EQ(validate(expansion.document, *scene.library), std::nullopt);
    EXPECT_EQ(path_of(expansion.copies, expansion.stand_ins.at(tyre)), (std::vector<NodeId>{wheel_node, tyre}));
    EXPECT_EQ(path_of(expansion.copies, expansion.stand_ins.at(wheel_node)), (std::vector<NodeId>{wheel_node, both}));
}

TEST_F(Cart, an_expansion_is_the_document_written_by_hand)
{
    grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    NodeId other = second();
    ASSERT_FALSE(set_parameter(document, *library, other, "minor", 0.4f));
    Expansion expansion = expanded(document, *library);
    Scene by_hand;
    NodeId hand_moved = by_hand.node("translate", {{"offset", glm::vec3(1, 0, 0)}});
    NodeId end = by_hand.node("output"), pair = by_hand.node("union", {{"a", hand_moved}});
    by_hand.wire(pair, end, "d");
    for (float minor : {0.2f, 0.4f}) {
        NodeId a = by_hand.node("torus", {{"minor", minor}}), b = by_hand.node("cylinder");
        NodeId hand_wheel = by_hand.node("union", {{"a", a}, {"b", b}});
        if (minor < 0.3f) by_hand.wire(hand_wheel, hand_moved, "d");
        else by_hand.wire(hand_wheel, pair, "b");
    }
    EXPECT_EQ(meanings(expansion.document.root), meanings(by_hand.document.root));
}

TEST_F(Cart, the_type_of_a_group_is_that_of_what_it_exposes)
{
    grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    ASSERT_FALSE(describe_exposed(document, "Wheel", "minor", "How thick the tyre is."));
    settle();
    const NodeType& type = *library->type("group:Wheel");
    const Parameter& inner = *library->type("torus")->parameter("minor");
    ASSERT_EQ(type.parameters.size(), 1u);
    EXPECT_EQ(type.parameters[0].unit, inner.unit);
    EXPECT_EQ(type.parameters[0].maximum, inner.maximum);
    EXPECT_EQ(type.parameters[0].initial, Value(0.2f));
    EXPECT_EQ(type.parameters[0].help, "How thick the tyre is.");
    EXPECT_EQ(type.output, SocketKind::field3d);
    EXPECT_EQ(type.title, "Wheel");
}

TEST_F(Cart, what_crosses_the_border_of_a_selection_is_exposed)
{
    NodeId beat = scene.node("number");
    scene.wire(beat, tyre, "minor");
    Document flat = document;
    Placed placed = group_nodes(document, *library, {both, tyre}, "Half");
    ASSERT_EQ(placed.refusal, std::nullopt);
    expect_valid();
    EXPECT_EQ(node(placed.node).input("minor"), beat);
    EXPECT_EQ(node(placed.node).input("second_shape"), hub);
    EXPECT_EQ(meaning_of_output(expanded(document, *library).document), meaning_of_output(flat));
}

TEST_F(Cart, refused_groups_say_why_and_change_nothing)
{
    Document before = document;
    auto reason = [&](std::set<NodeId> nodes) {
        Placed placed = group_nodes(document, *library, nodes);
        EXPECT_EQ(document, before);
        return placed.refusal.value_or("done");
    };
    EXPECT_NE(reason({}).find("nothing is selected"), std::string::npos);
    EXPECT_NE(reason({hub, tyre}).find("gives one result"), std::string::npos);
    EXPECT_NE(reason({hub, moved}).find("lies between"), std::string::npos);
    NodeId ring = scene.node("torus"), pair = scene.node("union", {{"a", ring}, {"b", moved}});
    scene.wire(pair, output(), "d");
    before = document;
    EXPECT_NE(reason({both, hub, tyre, pair}).find("lies between"), std::string::npos);
    EXPECT_NE(reason({both, output()}).find("the output stays"), std::string::npos);
}

TEST_F(Cart, ungrouping_gives_back_what_was_grouped)
{
    Document flat = document;
    NodeId group_node = grouped();
    Pasted inner = ungroup(document, group_node);
    ASSERT_EQ(inner.refusal, std::nullopt);
    EXPECT_EQ(inner.nodes.size(), 3u);
    EXPECT_TRUE(document.groups.empty());
    EXPECT_EQ(meanings(document.root), meanings(flat.root));
    expect_valid();
}

TEST(Groups, any_part_of_any_scene_can_be_grouped_and_ungrouped_without_a_change)
{
    Random random(4);
    int done = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        Scene scene = tests::RandomGraph(seed, Library::embedded()).take();
        Document document = scene.document;
        std::set<NodeId> chosen;
        std::map<NodeId, std::string> known;
        for (const Node& node : document.root.nodes)
            if (random.chance(0.4f) && node.type != "output") chosen.insert(node.id);
        Placed placed = group_nodes(document, *scene.library, chosen, "Part");
        if (placed.refusal) {
            ASSERT_EQ(document, scene.document) << seed;
            continue;
        }
        ++done;
        ASSERT_EQ(validate(document, *scene.library), std::nullopt) << seed;
        ASSERT_EQ(read_scene(write_scene(document, *scene.library), *scene.library), document) << seed;
        Expansion expansion = expanded(document, *scene.library);
        ASSERT_EQ(validate(expansion.document, *scene.library), std::nullopt) << seed;
        ASSERT_EQ(meaning_of_output(expansion.document), meaning_of_output(scene.document)) << seed;
        ASSERT_EQ(ungroup(document, placed.node).refusal, std::nullopt);
        ASSERT_EQ(meanings(document.root), meanings(scene.document.root)) << seed;
    }
    EXPECT_GT(done, 20);
}

TEST_F(Cart, a_value_outside_is_a_value_of_the_inner_node)
{
    NodeId first = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    NodeId other = second();
    ASSERT_FALSE(set_parameter(document, *library, first, "minor", 0.3f));
    ASSERT_FALSE(set_parameter(document, *library, other, "minor", 0.1f));
    std::vector<float> thicknesses;
    for (const Node& copy : expanded(document, *library).document.root.nodes)
        if (copy.type == "torus") thicknesses.push_back(std::get<float>(*copy.parameter("minor")));
    EXPECT_EQ(thicknesses, (std::vector<float>{0.3f, 0.1f}));
}

TEST_F(Cart, a_wire_from_outside_takes_the_place_of_one_inside)
{
    NodeId first = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    NodeId number = add_node(document, *library, "number");
    ASSERT_FALSE(connect(document, *library, number, first, "minor"));
    for (const Node& copy : expanded(document, *library).document.root.nodes)
        if (copy.type == "torus") {
            EXPECT_EQ(copy.input("minor"), number);
        }
}

// A control that moves nothing is none; the socket stays, as a wire from outside counts.
TEST_F(Cart, what_is_wired_inside_has_no_value_outside)
{
    NodeId first = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    const NodeType& before = *library->type("group:Wheel");
    ASSERT_TRUE(before.parameter("minor") && before.input("minor"));
    {
        Entered entered(document, "Wheel");
        NodeId number = add_node(document, *library, "number");
        ASSERT_FALSE(connect(document, *library, number, tyre, "minor"));
    }
    settle();
    const NodeType& wired = *library->type("group:Wheel");
    EXPECT_EQ(wired.parameter("minor"), nullptr);
    EXPECT_NE(wired.input("minor"), nullptr);
    EXPECT_EQ(node(first).parameter("minor"), nullptr);
    expect_valid();
    {
        Entered entered(document, "Wheel");
        ASSERT_FALSE(disconnect(document, tyre, "minor"));
    }
    settle();
    ASSERT_NE(node(first).parameter("minor"), nullptr);
    EXPECT_EQ(*node(first).parameter("minor"), Value(0.2f)) << "that of the inner node";
}

TEST(GroupPictures, are_asked_for_as_each_node_of_the_group_has_them)
{
    Scene scene;
    NodeId image = scene.node("image", {{"picture", std::string("inside.png")}});
    NodeId one = group_nodes(scene.document, *scene.library, {image}, "Stamp").node;
    scene.library = settle_groups(scene.document, *scene.library);
    for (const char* name : {"picture", "detail"})
        ASSERT_FALSE(expose(scene.document, *scene.library, "Stamp", image, name));
    scene.library = settle_groups(scene.document, *scene.library);
    NodeId other = scene.node("group:Stamp");
    scene.set(one, "picture", std::string("one.png"));
    scene.set(other, "picture", std::string("other.png"));
    scene.set(other, "detail", 64);
    std::map<std::string, int> details;
    for (const ImageRequest& request : image_requests(scene.document, *scene.library))
        details[request.path] = request.detail;
    EXPECT_EQ(details, (std::map<std::string, int>{{"inside.png", 256}, {"one.png", 256}, {"other.png", 64}}));
    for (const Node& copy : expanded(scene.document, *scene.library).document.root.nodes) {
        const Value& path = *copy.parameter("picture");
        EXPECT_TRUE(path == Value(std::string("one.png")) || path == Value(std::string("other.png")));
    }
}

TEST_F(Cart, groups_nest_and_values_pass_through_both)
{
    NodeId inner = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    Placed outer = group_nodes(document, *library, {inner, moved}, "Axle");
    ASSERT_EQ(outer.refusal, std::nullopt);
    settle();
    ASSERT_FALSE(expose(document, *library, "Axle", inner, "minor"));
    settle();
    ASSERT_FALSE(set_parameter(document, *library, outer.node, "minor", 0.33f));
    expect_valid();
    Expansion expansion = expanded(document, *library);
    const Node& copy = *expansion.document.root.find(expansion.stand_ins.at(tyre));
    EXPECT_EQ(*copy.parameter("minor"), Value(0.33f));
    EXPECT_EQ(path_of(expansion.copies, copy.id), (std::vector<NodeId>{outer.node, inner, tyre}));
    EXPECT_EQ(read_scene(write_scene(document, *scene.library), *scene.library), document);
    // Renaming what is exposed inside carries through.
    ASSERT_FALSE(rename_exposed(document, "Wheel", "minor", "thickness"));
    expect_valid();
    settle();
    Expansion renamed = expanded(document, *library);
    EXPECT_EQ(*renamed.document.root.find(renamed.stand_ins.at(tyre))->parameter("minor"), Value(0.33f));
}

TEST_F(Cart, a_group_cannot_contain_itself)
{
    NodeId inner = grouped();
    ASSERT_EQ(group_nodes(document, *library, {inner, moved}, "Axle").refusal, std::nullopt);
    settle();
    Document before = document;
    enter_group(document, "Wheel");
    for (const char* type : {"group:Wheel", "group:Axle"}) {
        Placed placed = add_alone(document, *library, type, {0, 0});
        EXPECT_EQ(placed.refusal, "a group cannot contain itself") << type;
    }
    EXPECT_EQ(add_alone(document, *library, "output", {0, 0}).refusal.value_or("").substr(0, 17), "a group gives wha");
    leave_group(document);
    EXPECT_EQ(document, before);
}

TEST_F(Cart, the_interface_is_renamed_reordered_and_hidden_with_all_nodes_of_the_group)
{
    NodeId first = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "major"));
    settle();
    NodeId other = second();
    ASSERT_FALSE(set_parameter(document, *library, other, "minor", 0.05f));
    ASSERT_FALSE(rename_exposed(document, "Wheel", "minor", "Thickness"));
    settle();
    ASSERT_FALSE(move_exposed(document, *library, "Wheel", "Thickness", 1));
    settle();
    expect_valid();
    EXPECT_EQ(node(other).parameters[1], (std::pair<std::string, Value>("Thickness", 0.05f)));
    EXPECT_EQ(node(first).parameters[0].first, "major");
    ASSERT_FALSE(hide(document, *library, "Wheel", "major"));
    settle();
    expect_valid();
    EXPECT_EQ(node(first).parameters.size(), 1u);
    Document before = document;
    EXPECT_TRUE(rename_exposed(document, "Wheel", "Thickness", ""));
    EXPECT_TRUE(rename_exposed(document, "Wheel", "none", "x"));
    EXPECT_TRUE(hide(document, *library, "Wheel", "none"));
    EXPECT_TRUE(move_exposed(document, *library, "Wheel", "Thickness", 1));
    EXPECT_TRUE(expose(document, *library, "Wheel", tyre, "minor"));    // exposed already
    EXPECT_TRUE(expose(document, *library, "Wheel", both, "a"));        // wired inside
    EXPECT_TRUE(expose(document, *library, "Wheel", tyre, "nothing"));  // not there
    EXPECT_TRUE(delete_group(document, "Wheel"));                       // in use
    EXPECT_TRUE(rename_group(document, "Wheel", "root"));
    EXPECT_EQ(document, before);
}

TEST_F(Cart, a_renamed_group_renames_the_type_of_its_nodes)
{
    NodeId first = grouped();
    Document before = document;
    enter_group(document, "Wheel");
    ASSERT_FALSE(rename_group(document, "Wheel", "Big wheel"));
    EXPECT_EQ(document.entered, "Big wheel");
    leave_group(document);
    EXPECT_EQ(node(first).type, "group:Big wheel");
    expect_valid();
    EXPECT_EQ(meanings(expanded(document, *scene.library).document.root),
              meanings(expanded(before, *scene.library).document.root));
}

TEST_F(Cart, a_unique_copy_changes_alone)
{
    NodeId first = grouped();
    EXPECT_TRUE(make_group_unique(document, first).refusal);
    NodeId other = second();
    ASSERT_EQ(make_group_unique(document, other).refusal, std::nullopt);
    EXPECT_EQ(node(other).type, "group:Wheel 2");
    expect_valid();
    enter_group(document, "Wheel 2");
    for (const Node& inner : document.root.nodes)
        if (inner.type == "torus") {
            ASSERT_FALSE(set_parameter(document, *library, inner.id, "minor", 0.5f));
        }
    leave_group(document);
    EXPECT_EQ(*wheel().graph.find(tyre)->parameter("minor"), Value(0.2f));
}

TEST_F(Cart, an_unused_group_can_be_deleted)
{
    NodeId first = grouped();
    ASSERT_FALSE(remove_node(document, first));
    ASSERT_FALSE(delete_group(document, "Wheel"));
    EXPECT_TRUE(document.groups.empty());
    expect_valid();
}

TEST_F(Cart, edits_inside_reach_every_node_of_the_group)
{
    grouped();
    second();
    enter_group(document, "Wheel");
    ASSERT_EQ(insert_after(document, *library, "shell", both).refusal, std::nullopt);
    leave_group(document);
    settle();
    expect_valid();
    int shells = 0;
    for (const Node& copy : expanded(document, *library).document.root.nodes) shells += copy.type == "shell";
    EXPECT_EQ(shells, 2);
}

TEST_F(Cart, a_shape_added_inside_is_united_with_what_the_group_gives)
{
    grouped();
    enter_group(document, "Wheel");
    Placed added = add_from_menu(document, *library, "sphere", {0, 0}, {});
    ASSERT_EQ(added.refusal, std::nullopt);
    leave_group(document);
    settle();
    expect_valid();
    const Node& output_node = *wheel().graph.find(wheel().output);
    EXPECT_EQ(output_node.type, "union");
    EXPECT_EQ(output_node.input("b"), added.node);
}

TEST_F(Cart, what_is_deleted_inside_is_exposed_no_more_and_something_else_is_the_output)
{
    NodeId first = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    enter_group(document, "Wheel");
    ASSERT_FALSE(remove_nodes(document, {tyre, both}));
    leave_group(document);
    settle();
    expect_valid();
    EXPECT_TRUE(wheel().exposed.empty());
    EXPECT_EQ(wheel().output, hub);
    EXPECT_EQ(node(moved).input("d"), first);
}

TEST_F(Cart, a_muted_group_passes_its_first_shape_on)
{
    Placed placed = group_nodes(document, *library, {both, tyre}, "Ring");  // the hub stays outside
    ASSERT_EQ(placed.refusal, std::nullopt);
    library = with_groups(*library, document);
    ASSERT_FALSE(set_muted(document, placed.node, true));
    Expansion expansion = expanded(document, *library);
    EXPECT_EQ(expansion.document.root.find(moved)->input("d"), hub);
}

TEST_F(Cart, undo_and_redo_step_over_groups)
{
    Document before = document;
    History history(document);
    NodeId first = grouped();
    Document after = document;
    ASSERT_TRUE(history.record(document, "Group"));
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    ASSERT_TRUE(history.record(document, "Expose"));
    history.undo();
    EXPECT_EQ(history.current(), after);
    history.undo();
    EXPECT_EQ(history.current(), before);
    history.redo();
    EXPECT_EQ(history.current(), after);
    EXPECT_TRUE(history.current().root.find(first));
}

TEST_F(Cart, copies_bring_their_groups_along)
{
    NodeId first = grouped();
    ASSERT_FALSE(expose(document, *library, "Wheel", tyre, "minor"));
    settle();
    ASSERT_FALSE(set_parameter(document, *library, first, "minor", 0.31f));
    std::string text = copy_nodes(document, *library, {first});
    // Into the same scene: the group is shared.
    Document same = document;
    Pasted pasted = paste_nodes(same, *library, text, {0, 0});
    ASSERT_EQ(pasted.refusal, std::nullopt);
    EXPECT_EQ(same.groups, document.groups);
    EXPECT_EQ(*same.root.find(pasted.nodes[0])->parameter("minor"), Value(0.31f));
    // Into another scene.
    Document other;
    pasted = paste_nodes(other, *scene.library, text, {0, 0});
    ASSERT_EQ(pasted.refusal, std::nullopt);
    EXPECT_EQ(validate(other, *scene.library), std::nullopt);
    ASSERT_EQ(other.groups.size(), 1u);
    EXPECT_EQ(*other.root.find(pasted.nodes[0])->parameter("minor"), Value(0.31f));
    // Into one that has another group of that name.
    Document third = document;
    ASSERT_FALSE(set_parameter(third, *library, first, "minor", 0.2f));
    enter_group(third, "Wheel");
    ASSERT_FALSE(remove_nodes(third, {hub}));
    leave_group(third);
    pasted = paste_nodes(third, *library_of(third, *library), text, {0, 0});
    ASSERT_EQ(pasted.refusal, std::nullopt);
    EXPECT_EQ(third.root.find(pasted.nodes[0])->type, "group:Wheel 2");
    EXPECT_EQ(validate(third, *scene.library), std::nullopt);
}

TEST_F(Cart, too_many_copies_are_left_out_with_one_sentence)
{
    grouped("Level 0");
    std::string name = "Level 0";
    for (int level = 1; level < 20; ++level) {
        library = with_groups(*library, document);
        NodeId a = add_node(document, *library, group_type_name(name)),
               b = add_node(document, *library, group_type_name(name));
        NodeId pair = add_node(document, *library, "union");
        ASSERT_FALSE(connect(document, *library, a, pair, "a"));
        ASSERT_FALSE(connect(document, *library, b, pair, "b"));
        name = "Level " + std::to_string(level);
        ASSERT_EQ(group_nodes(document, *library, {a, b, pair}, name).refusal, std::nullopt);
    }
    library = with_groups(*library, document);
    Expansion expansion = expanded(document, *library);
    EXPECT_LE(expansion.document.root.nodes.size(), 20000u);
    ASSERT_EQ(expansion.problems.size(), 1u);
    EXPECT_NE(expansion.problems[0].sentence.find("20000"), std::string::npos);
    EXPECT_TRUE(document.root.find(expansion.problems[0].node));
    lower(document, library);
}

TEST_F(Cart, problems_inside_are_told_of_the_group_node)
{
    NodeId first = grouped();
    enter_group(document, "Wheel");
    NodeId ring = add_node(document, *library, "number");
    ASSERT_FALSE(connect(document, *library, ring, tyre, "minor"));
    Node& strange = *document.root.find(ring);
    strange.type = "future";
    strange.unknown_source = "{\"type\": \"future\"}";
    strange.parameters.clear();
    leave_group(document);
    Program program = lower(document, library);
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].node, first);
    EXPECT_EQ(program.problems[0].inside, std::vector<NodeId>{ring});
}

TEST_F(Cart, a_group_of_an_unknown_name_is_a_placeholder_that_saves_as_it_was)
{
    grouped();
    std::string text = write_scene(document, *scene.library);
    std::size_t at = text.find("\"group:Wheel\"");
    text.replace(at, 13, "\"group:Gone!\"");
    Document opened = read_scene(text, *scene.library);
    EXPECT_EQ(write_scene(opened, *scene.library), text);
    EXPECT_EQ(validate(opened, *scene.library), std::nullopt);
    EXPECT_EQ(lower(opened, scene.library).problems.size(), 1u);
}

TEST_F(Cart, another_scenes_groups_are_not_known_when_a_scene_is_opened)
{
    grouped();
    std::string text = write_scene(document, *library);
    std::size_t from = text.find("    \"Wheel\": {");
    ASSERT_NE(from, std::string::npos);
    // The same scene, its group's definition cut out.
    Document without = read_scene(text, *library);
    without.groups.clear();
    Document opened = read_scene(write_scene(without, *scene.library), *library);
    EXPECT_FALSE(opened.root.find(NodeId{opened.next_id - 1})->unknown_source.empty());
}

std::string refused(const std::string& graphs)
{
    try {
        read_scene(R"({"format": "fieldwright", "version": 1, "graphs": )" + graphs + "}", *Library::embedded());
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "accepted";
}

TEST(GroupFiles, bad_groups_are_refused_with_the_place)
{
    std::string root = R"("root": {"nodes": {}})";
    auto expect = [](const std::string& graphs, const std::string& path, const std::string& words) {
        std::string reason = refused("{" + graphs + "}");
        EXPECT_NE(reason.find(path), std::string::npos) << reason;
        EXPECT_NE(reason.find(words), std::string::npos) << reason;
    };
    expect(root + R"(, "A": {})", "$.graphs.A", "nodes");
    expect(root + R"(, "": {"nodes": {}})", "$.graphs", "must not be empty");
    expect(root + R"(, "A": {"nodes": {"1": {"type": "group:A"}}})", "$.graphs.A", "contains itself");
    expect(root + R"(, "A": {"nodes": {"1": {"type": "group:B"}}}, "B": {"nodes": {"2": {"type": "group:A"}}})",
           "$.graphs.A", "contains itself");
    expect(root + R"(, "A": {"nodes": {}, "output": 7})", "$.graphs.A.output", "no node 7");
    expect(root + R"(, "A": {"nodes": {}, "exposed": [{"name": "r", "node": 7, "socket": "radius"}]})",
           "$.graphs.A.exposed[0]", "no node 7");
    expect(
        root + R"(, "A": {"nodes": {"1": {"type": "sphere"}}, "exposed": [{"name": "r", "node": 1, "socket": "x"}]})",
        "$.graphs.A.exposed[0]", "no parameter or input `x`");
    expect(root + R"(, "A": {"nodes": {"1": {"type": "sphere"}}, "exposed": [
               {"name": "r", "node": 1, "socket": "radius"}, {"name": "r", "node": 1, "socket": "radius"}]})",
           "$.graphs.A.exposed[1]", "another entry");
    expect(R"("root": {"nodes": {"1": {"type": "sphere"}}}, "A": {"nodes": {"1": {"type": "sphere"}}})", "nodes.1",
           "another graph");
    expect(root + R"(, "A": {"nodes": {}, "colour": 1})", "$.graphs.A.colour", "not known here");
    std::string deep = root;
    for (int i = 0; i < 40; ++i) {
        std::string n = std::to_string(i + 1);
        deep += ", \"" + n + R"(": {"nodes": {")" + n + R"(": {"type": "group:)" + std::to_string(i + 2) + "\"}}}";
    }
    expect(deep + R"(, "41": {"nodes": {}})", "$.graphs", "32 groups deep");
}

TEST_F(Cart, a_library_that_lost_a_type_keeps_the_group_and_gets_it_back)
{
    grouped();
    std::map<std::string, std::string> texts = embedded_texts();
    texts.erase("nodes/primitive/torus.glsl");
    auto poor = Library::from_texts(texts, embedded_texts());
    Document without = adapted(document, *poor);
    EXPECT_EQ(validate(without, *poor), std::nullopt);
    EXPECT_EQ(write_scene(without, *poor), write_scene(document, *scene.library));
    EXPECT_EQ(adapted(without, *scene.library), document);
}

}  // namespace
}  // namespace fieldwright::graph
