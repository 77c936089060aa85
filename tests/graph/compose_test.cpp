// Compound edits: what they make of a scene, what they refuse, and that a refusal changes nothing.
#include "graph/compose.h"

#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace fieldwright::graph {
namespace {

class Compose : public testing::Test {
protected:
    NodeId source(NodeId node, std::string_view socket) { return document.root.find(node)->input(socket); }
    const Node& node(NodeId id) { return *document.root.find(id); }
    NodeId only(std::string_view type)
    {
        NodeId found;
        for (const Node& one : document.root.nodes)
            if (one.type == type) {
                EXPECT_FALSE(found) << "more than one " << type;
                found = one.id;
            }
        EXPECT_TRUE(found) << "no " << type;
        return found;
    }
    std::size_t count() { return document.root.nodes.size(); }

    NodeId done(const Placed& placed)
    {
        EXPECT_EQ(placed.refusal, std::nullopt);
        EXPECT_TRUE(document.root.find(placed.node));
        EXPECT_EQ(validate(document, library), std::nullopt);
        return placed.node;
    }
    void done(const Refusal& refusal)
    {
        EXPECT_EQ(refusal, std::nullopt);
        EXPECT_EQ(validate(document, library), std::nullopt);
    }

    static Refusal reason(const Placed& placed)
    {
        EXPECT_FALSE(placed.node);
        return placed.refusal;
    }
    static Refusal reason(const Refusal& refusal) { return refusal; }
    template <typename Edit>
    std::string refused(Edit edit)
    {
        Document before = document;
        Refusal refusal = reason(edit());
        EXPECT_EQ(document, before);
        return refusal.value_or("accepted");
    }

    // A node of a type from the future that reads `from`, as the file reader keeps it.
    NodeId placeholder(NodeId from)
    {
        Node stranger;
        stranger.id = {document.next_id++};
        stranger.type = "warp";
        stranger.unknown_source = "{\"type\": \"warp\", \"inputs\": {\"d\": " + std::to_string(from.number) + "}}";
        stranger.inputs = {{"d", from}};
        document.root.nodes.push_back(stranger);
        return stranger.id;
    }

    tests::Scene scene;
    Document& document = scene.document;
    const Library& library = *scene.library;
};

TEST_F(Compose, the_first_shape_makes_the_output_and_is_wired_to_it)
{
    NodeId box = done(add_primitive_to_output(document, library, "box", {100, 50}));
    EXPECT_EQ(source(only("output"), "d"), box);
    EXPECT_EQ(node(box).position, glm::vec2(100, 50));
    EXPECT_EQ(count(), 2u);
    EXPECT_TRUE(scene.program().problems.empty());
}

TEST_F(Compose, a_second_shape_is_joined_by_a_union)
{
    NodeId box = done(add_primitive_to_output(document, library, "box", {0, 0}));
    NodeId torus = done(add_primitive_to_output(document, library, "torus", {0, 200}));
    NodeId both = only("union");
    EXPECT_EQ(source(only("output"), "d"), both);
    EXPECT_EQ(source(both, "a"), box);
    EXPECT_EQ(source(both, "b"), torus);
    EXPECT_EQ(count(), 4u);
    EXPECT_GE(node(both).position.x, node(box).position.x + column_px);
    EXPECT_GE(node(only("output")).position.x, node(both).position.x + column_px);
}

TEST_F(Compose, a_free_side_of_a_union_is_used_unless_something_else_reads_the_union)
{
    NodeId box = scene.node("box");
    NodeId inner = scene.node("union", {{"a", box}});
    NodeId outer = scene.node("union", {{"a", inner}, {"b", box}});
    NodeId output = scene.show(outer);
    NodeId ball = done(add_primitive_to_output(document, library, "sphere", {0, 0}));
    EXPECT_EQ(source(inner, "b"), ball);
    EXPECT_EQ(count(), 5u);
    done(disconnect(document, inner, "b"));
    NodeId other = scene.node("round", {{"d", inner}});
    done(add_primitive_to_output(document, library, "sphere", {0, 0}));
    EXPECT_EQ(source(inner, "b"), NodeId{}) << other.number;
    EXPECT_NE(source(output, "d"), outer);
}

TEST_F(Compose, a_muted_union_is_not_joined_because_it_would_hide_the_shape)
{
    NodeId both = scene.node("union", {{"a", scene.node("box")}});
    NodeId output = scene.show(both);
    set_muted(document, both, true);
    done(add_primitive_to_output(document, library, "sphere", {0, 0}));
    EXPECT_NE(source(output, "d"), both);
    EXPECT_EQ(source(both, "b"), NodeId{});
}

TEST_F(Compose, a_shape_with_a_place_is_translated_and_a_flat_one_extruded)
{
    NodeId star = done(add_primitive_to_output(document, library, "star", {0, 0}, glm::vec3(1, 2, 3)));
    NodeId translate = only("translate"), extrude = only("extrude");
    EXPECT_EQ(source(only("output"), "d"), translate);
    EXPECT_EQ(source(translate, "d"), extrude);
    EXPECT_EQ(source(extrude, "d"), star);
    EXPECT_EQ(std::get<glm::vec3>(*node(translate).parameter("offset")), glm::vec3(1, 2, 3));
    done(add_primitive_to_output(document, library, "box", {0, 0}, glm::vec3(0)));
    EXPECT_EQ(only("translate"), translate) << "nothing is moved by zero";
}

TEST_F(Compose, adding_to_the_output_refuses_what_is_no_shape_or_out_of_range)
{
    scene.show(scene.node("box"));
    auto add = [&](std::string_view type, glm::vec2 at, std::optional<glm::vec3> place = {}) {
        return refused([&] { return add_primitive_to_output(document, library, type, at, place); });
    };
    EXPECT_EQ(add("no_such", {0, 0}), "there is no node type `no_such`");
    EXPECT_NE(add("union", {0, 0}).find("“Union” is not a shape"), std::string::npos);
    EXPECT_NE(add("sun", {0, 0}).find("is not a shape"), std::string::npos);
    EXPECT_NE(add("output", {0, 0}).find("is not a shape"), std::string::npos);
    EXPECT_NE(add("box", {std::numeric_limits<float>::infinity(), 0}).find("finite"), std::string::npos);
    EXPECT_NE(add("box", {0, 0}, glm::vec3(1e9f, 0, 0)).find("must lie between"), std::string::npos);
}

TEST_F(Compose, a_sky_is_wired_to_the_output_and_a_second_output_refused)
{
    NodeId output = scene.show(scene.node("box"));
    NodeId sky = done(add_to_output(document, library, "gradient", {0, 0}));
    EXPECT_EQ(source(output, "sky"), sky);
    NodeId camera = done(add_to_output(document, library, "orthographic", {0, 0}));
    EXPECT_EQ(source(output, "camera"), camera);
    EXPECT_NE(refused([&] {
                  return add_to_output(document, library, "box", {0, 0});
              }).find("“Box”"),
              std::string::npos);
    EXPECT_NE(refused([&] {
                  return add_alone(document, library, "output", {0, 0});
              }).find("one output"),
              std::string::npos);
}

TEST_F(Compose, an_operator_goes_between_a_node_and_all_its_readers)
{
    NodeId box = scene.node("box");
    NodeId both = scene.node("union", {{"a", box}, {"b", box}});
    NodeId round = scene.node("round", {{"d", box}});
    NodeId twist = done(insert_after(document, library, "twist", box));
    EXPECT_EQ(source(twist, "d"), box);
    EXPECT_EQ(source(both, "a"), twist);
    EXPECT_EQ(source(both, "b"), twist);
    EXPECT_EQ(source(round, "d"), twist);
    EXPECT_EQ(count(), 4u);
}

TEST_F(Compose, an_inserted_operator_pushes_what_follows_and_nothing_else)
{
    NodeId box = scene.node("box"), far = scene.node("sphere");
    NodeId round = scene.node("round", {{"d", box}});
    NodeId output = scene.show(round);
    move_node(document, round, {column_px, 0});
    move_node(document, output, {2 * column_px, 0});
    move_node(document, far, {column_px, 300});
    NodeId twist = done(insert_after(document, library, "twist", box));
    EXPECT_EQ(node(twist).position, glm::vec2(column_px, 0));
    EXPECT_EQ(node(round).position, glm::vec2(2 * column_px, 0));
    EXPECT_EQ(node(output).position, glm::vec2(3 * column_px, 0));
    EXPECT_EQ(node(far).position, glm::vec2(column_px, 300));
    move_node(document, round, {5 * column_px, 0});
    done(insert_after(document, library, "bend", twist));
    EXPECT_EQ(node(round).position, glm::vec2(5 * column_px, 0)) << "there was room";
}

TEST_F(Compose, insert_after_refuses_what_does_not_fit)
{
    NodeId box = scene.node("box"), circle = scene.node("circle"), sun = scene.node("sun");
    NodeId solid = scene.node("extrude", {{"d", circle}});
    auto insert = [&](std::string_view type, NodeId after) {
        return refused([&] { return insert_after(document, library, type, after); });
    };
    EXPECT_EQ(insert("sphere", box), "no free input of “Sphere” takes a solid, which “Box” gives");
    EXPECT_NE(insert("extrude", box).find("a solid"), std::string::npos);
    EXPECT_NE(insert("twist", sun).find("light"), std::string::npos);
    EXPECT_EQ(insert("twist", {99}), "there is no node 99");
    EXPECT_EQ(insert("no_such", box), "there is no node type `no_such`");
    EXPECT_NE(insert("revolve", circle).find("gives a solid and cannot feed “Shape” of “Extrude”"), std::string::npos)
        << solid.number;
}

TEST_F(Compose, an_operator_after_the_output_goes_before_it)
{
    NodeId box = scene.node("box"), output = scene.show(box);
    NodeId twist = done(insert_after(document, library, "twist", output));
    EXPECT_EQ(source(output, "d"), twist);
    EXPECT_EQ(source(twist, "d"), box);
    EXPECT_NE(refused([&] { return insert_after(document, library, "sun", output); }).find("nothing reads"),
              std::string::npos);
}

TEST_F(Compose, nodes_of_unknown_type_keep_what_they_read)
{
    NodeId box = scene.node("box"), stranger = placeholder(box);
    NodeId round = scene.node("round", {{"d", box}});
    NodeId twist = done(insert_after(document, library, "twist", box));
    EXPECT_EQ(source(stranger, "d"), box);
    EXPECT_EQ(source(round, "d"), twist);
}

TEST_F(Compose, combining_two_nodes_replaces_the_union_that_joined_them)
{
    NodeId box = done(add_primitive_to_output(document, library, "box", {0, 0}));
    NodeId torus = done(add_primitive_to_output(document, library, "torus", {0, 200}));
    NodeId cut = done(combine(document, library, "subtract", box, torus));
    EXPECT_EQ(source(cut, "a"), box);
    EXPECT_EQ(source(cut, "b"), torus);
    EXPECT_EQ(source(only("output"), "d"), cut);
    EXPECT_EQ(count(), 4u) << "the union is gone";
}

TEST_F(Compose, combining_keeps_order_and_every_reader_outside)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere"), torus = scene.node("torus");
    NodeId inner = scene.node("union", {{"a", ball}, {"b", torus}});
    NodeId outer = scene.node("union", {{"a", inner}, {"b", box}});
    scene.show(outer);
    NodeId cut = done(combine(document, library, "subtract", box, ball));
    EXPECT_EQ(source(cut, "a"), box);
    EXPECT_EQ(source(cut, "b"), ball);
    EXPECT_EQ(source(inner, "a"), cut) << "the cutter is not left over";
    EXPECT_EQ(source(outer, "b"), cut);
}

TEST_F(Compose, combining_a_node_with_what_is_made_of_it_makes_no_cycle)
{
    NodeId box = scene.node("box"), twist = scene.node("twist", {{"d", box}}), output = scene.show(twist);
    NodeId morph = done(combine(document, library, "morph", box, twist));
    EXPECT_EQ(source(twist, "d"), box);
    EXPECT_EQ(source(output, "d"), morph);
}

TEST_F(Compose, combine_refuses_one_node_twice_mixed_dimensions_and_types_of_one_input)
{
    NodeId box = scene.node("box"), circle = scene.node("circle"), ball = scene.node("sphere");
    auto both = [&](std::string_view type, NodeId a, NodeId b) {
        return refused([&] { return combine(document, library, type, a, b); });
    };
    EXPECT_NE(both("union", box, box).find("two different nodes"), std::string::npos);
    EXPECT_NE(both("union", box, circle).find("flat shape"), std::string::npos);
    EXPECT_EQ(both("twist", box, ball), "“Twist” does not combine two shapes");
    EXPECT_EQ(both("union", box, {99}), "there is no node 99");
    EXPECT_EQ(both("no_such", box, ball), "there is no node type `no_such`");
}

TEST_F(Compose, the_add_menu_does_what_the_selection_asks_for)
{
    auto add = [&](std::string_view type, std::vector<NodeId> selection) {
        return done(add_from_menu(document, library, type, {0, 0}, selection));
    };
    NodeId box = add("box", {}), torus = add("torus", {box});
    EXPECT_EQ(source(only("union"), "b"), torus) << "a shape joins the output whatever is selected";
    NodeId twist = add("twist", {box});
    EXPECT_EQ(source(only("union"), "a"), twist);
    NodeId blend = add("smooth_union", {twist, torus});
    EXPECT_EQ(source(only("output"), "d"), blend);
    NodeId number = add("number", {box}), alone = add("round", {}), sun = add("sun", {box});
    EXPECT_TRUE(node(number).inputs.empty() && node(alone).inputs.empty() && node(sun).inputs.empty());
    NodeId paint = add("paint", {blend});
    EXPECT_EQ(source(only("output"), "d"), paint);
}

TEST_F(Compose, a_combiner_put_on_a_shape_just_added_takes_the_place_of_its_union)
{
    NodeId box = done(add_from_menu(document, library, "box", {0, 0}, {}));
    NodeId torus = done(add_from_menu(document, library, "torus", {0, 200}, {}));
    NodeId cut = done(add_from_menu(document, library, "smooth_subtract", {0, 0}, {torus}));
    EXPECT_EQ(source(only("output"), "d"), cut);
    EXPECT_EQ(source(cut, "a"), box);
    EXPECT_EQ(source(cut, "b"), torus) << "the selected shape is what is taken away";
    EXPECT_EQ(count(), 4u) << "no union is left";
    NodeId blend = done(add_from_menu(document, library, "smooth_union", {0, 0}, {cut}));
    EXPECT_EQ(source(blend, "a"), cut) << "in no union: it goes after the node";
    EXPECT_FALSE(source(blend, "b"));
}

TEST_F(Compose, a_node_dropped_on_a_wire_is_wired_into_it)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere"), output = scene.show(box);
    NodeId both = scene.node("union", {{"a", ball}});
    done(insert_on_wire(document, library, both, output, "d"));
    EXPECT_EQ(source(both, "a"), ball);
    EXPECT_EQ(source(both, "b"), box) << "the first free input";
    EXPECT_EQ(source(output, "d"), both);
}

TEST_F(Compose, insert_on_wire_refuses_with_the_reason)
{
    NodeId box = scene.node("box"), output = scene.show(box), ball = scene.node("sphere"), sun = scene.node("sun");
    NodeId slice = scene.node("slice"), full = scene.node("round", {{"d", ball}}), inner = scene.node("round");
    NodeId outer = scene.node("twist", {{"d", inner}}), stranger = placeholder(ball);
    auto insert = [&](NodeId which, NodeId target, std::string_view socket) {
        return refused([&] { return insert_on_wire(document, library, which, target, socket); });
    };
    EXPECT_EQ(insert(sun, output, "d"), "no free input of “Sun” takes a solid, which “Box” gives");
    EXPECT_NE(insert(full, output, "d").find("no free input"), std::string::npos);
    EXPECT_NE(insert(box, output, "d").find("an end of this wire"), std::string::npos);
    EXPECT_EQ(insert(slice, output, "sky"), "nothing is wired to “Sky” of “Output”");
    EXPECT_EQ(insert({99}, output, "d"), "there is no node 99");
    EXPECT_EQ(insert(slice, {99}, "d"), "there is no node 99");
    EXPECT_NE(insert(slice, outer, "d").find("gives a flat shape and cannot feed"), std::string::npos);
    EXPECT_NE(insert(stranger, output, "d").find("type this version does not know"), std::string::npos);
    NodeId last = scene.node("union", {{"a", outer}});
    EXPECT_NE(insert(last, outer, "d").find("cycle"), std::string::npos);
}

TEST_F(Compose, dissolving_reconnects_through_rows_of_nodes)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere");
    NodeId first = scene.node("round", {{"d", box}}), second = scene.node("twist", {{"d", first}});
    NodeId both = scene.node("union", {{"a", second}, {"b", ball}}), output = scene.show(both);
    done(dissolve(document, library, {first, second}));
    EXPECT_EQ(source(both, "a"), box);
    done(dissolve(document, library, {both}));
    EXPECT_EQ(source(output, "d"), box) << "its first field input";
    done(dissolve(document, library, {box}));
    EXPECT_EQ(source(output, "d"), NodeId{});
}

TEST_F(Compose, dissolving_passes_over_unwired_sides_and_other_kinds)
{
    NodeId ball = scene.node("sphere"), number = scene.node("number"), height = scene.node("number");
    NodeId both = scene.node("union", {{"b", ball}}), output = scene.show(both);
    NodeId sum = scene.node("add", {{"second", number}});
    scene.wire(sum, ball, "radius");
    NodeId vector = scene.node("vector", {{"x", height}});
    NodeId part = scene.node("component", {{"vector", vector}});
    NodeId round = scene.node("round", {{"radius", part}});
    done(dissolve(document, library, {both, sum, part}));
    EXPECT_EQ(source(output, "d"), ball);
    EXPECT_EQ(source(ball, "radius"), number);
    EXPECT_EQ(source(round, "radius"), NodeId{}) << "a vector does not stand for its component";
}

TEST_F(Compose, dissolve_refuses_what_cannot_be_reconnected)
{
    NodeId circle = scene.node("circle"), solid = scene.node("extrude", {{"d", circle}});
    scene.node("twist", {{"d", solid}});
    EXPECT_NE(refused([&] { return dissolve(document, library, {solid}); }).find("put an extrude"), std::string::npos);
    EXPECT_EQ(refused([&] { return dissolve(document, library, {circle, {99}}); }), "there is no node 99");
    EXPECT_EQ(refused([&] { return dissolve(document, library, {}); }), "nothing is selected");
}

TEST_F(Compose, removing_many_takes_their_wires_and_refuses_all_for_one_missing)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere"), both = scene.node("union", {{"a", box}, {"b", ball}});
    EXPECT_EQ(refused([&] { return remove_nodes(document, {box, {99}}); }), "there is no node 99");
    done(remove_nodes(document, {box, ball}));
    EXPECT_TRUE(node(both).inputs.empty());
    EXPECT_EQ(count(), 1u);
}

TEST_F(Compose, wires_are_made_all_or_none)
{
    NodeId box = scene.node("box"), a = scene.node("union"), b = scene.node("union", {{"a", a}});
    auto wire = [&](const std::vector<Wire>& wires) {
        return refused([&] { return connect_all(document, library, wires); });
    };
    EXPECT_NE(wire({{box, a, "a"}, {b, a, "b"}}).find("cycle"), std::string::npos);
    EXPECT_NE(wire({{box, a, "a"}, {box, a, "no_such"}}).find("has no input “No such”"), std::string::npos);
    EXPECT_EQ(wire({{box, a, "a"}, {{99}, a, "b"}}), "there is no node 99");
    EXPECT_EQ(wire({{box, a, "a"}, {box, {99}, "b"}}), "there is no node 99");
    done(connect_all(document, library, {{box, a, "a"}, {a, b, "b"}, {{}, b, "a"}}));
    EXPECT_EQ(source(b, "a"), NodeId{});
    EXPECT_EQ(source(b, "b"), a);
    // The wires between may form a cycle, the result not.
    done(connect_all(document, library, {{b, a, "a"}, {{}, b, "b"}}));
    EXPECT_EQ(source(a, "a"), b);
}

TEST_F(Compose, swapping_exchanges_the_sides_and_of_values_the_numbers)
{
    NodeId box = scene.node("box"), cut = scene.node("subtract", {{"b", box}}), number = scene.node("number");
    NodeId mix = scene.node("mix", {{"first", number}, {"second", Value(7.0f)}});
    done(swap_inputs(document, library, cut));
    EXPECT_EQ(source(cut, "a"), box);
    EXPECT_EQ(source(cut, "b"), NodeId{});
    done(swap_inputs(document, library, mix));
    EXPECT_EQ(source(mix, "second"), number);
    EXPECT_EQ(std::get<float>(*node(mix).parameter("first")), 7.0f);
    auto swap = [&](NodeId id) { return refused([&] { return swap_inputs(document, library, id); }); };
    EXPECT_NE(swap(box).find("has no two inputs of one kind"), std::string::npos);
    EXPECT_NE(swap(scene.node("perspective")).find("has no two inputs"), std::string::npos);
    EXPECT_EQ(swap({99}), "there is no node 99");
}

TEST_F(Compose, a_set_is_muted_unless_all_of_it_is)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere"), stranger = placeholder(box);
    set_muted(document, box, true);
    done(toggle_muted(document, {box, ball, stranger}));
    EXPECT_TRUE(node(box).muted && node(ball).muted && !node(stranger).muted);
    done(toggle_muted(document, {box, ball, stranger}));
    EXPECT_FALSE(node(box).muted || node(ball).muted);
    EXPECT_NE(refused([&] { return toggle_muted(document, {stranger}); }).find("kept as they are"), std::string::npos);
    EXPECT_EQ(refused([&] { return toggle_muted(document, {box, {99}}); }), "there is no node 99");
    EXPECT_EQ(refused([&] { return toggle_muted(document, {}); }), "nothing is selected");
}

TEST_F(Compose, a_set_moves_together_or_not_at_all)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere");
    move_node(document, ball, {3e38f, 0});
    EXPECT_NE(refused([&] { return move_nodes(document, {box, ball}, {3e38f, 0}); }).find("finite"), std::string::npos);
    move_node(document, ball, {10, 0});
    done(move_nodes(document, {box, ball}, {5, -5}));
    EXPECT_EQ(node(box).position, glm::vec2(5, -5));
    EXPECT_EQ(node(ball).position, glm::vec2(15, -5));
    EXPECT_EQ(refused([&] { return move_nodes(document, {box, {99}}, {1, 1}); }), "there is no node 99");
}

// Whether a type is offered; and that everything offered can be wired.
bool offered(const Document& document, const Library& library, const LooseEnd& end, std::string_view type)
{
    bool found = false;
    for (const Fit& fit : fits(document, library, end)) {
        Document copy = document;
        Placed placed = add_wired(copy, library, fit.type->name, {0, 0}, end);
        EXPECT_EQ(placed.refusal, std::nullopt) << fit.type->name;
        EXPECT_EQ(validate(copy, library), std::nullopt);
        found = found || fit.type->name == type;
    }
    return found;
}

TEST_F(Compose, a_loose_end_is_offered_exactly_what_fits)
{
    NodeId box = scene.node("box"), circle = scene.node("circle"), output = scene.show(box),
           number = scene.node("number");
    NodeId flat = scene.node("union", {{"a", circle}}), open = scene.node("union", {{"a", box}});
    for (const LooseEnd& end :
         {LooseEnd{box, ""}, LooseEnd{circle, ""}, LooseEnd{number, ""}, LooseEnd{output, "d"}, LooseEnd{output, "sky"},
          LooseEnd{box, "half_size"}, LooseEnd{flat, "b"}, LooseEnd{flat, "a"}, LooseEnd{open, "b"}}) {
        for (const NodeType* type : library.types()) {
            bool fits_somewhere = false;
            std::vector<std::string> sockets = {end.socket};
            if (end.socket.empty()) {
                sockets.clear();
                for (const Socket& socket : type->inputs) sockets.push_back(socket.name);
            }
            for (const std::string& socket : sockets) {
                Document copy = document;
                NodeId added = add_node(copy, library, type->name);
                fits_somewhere |= end.socket.empty() ? !connect(copy, library, end.node, added, socket)
                                                     : !connect(copy, library, added, end.node, socket);
            }
            if (type->category == "output") fits_somewhere = false;
            EXPECT_EQ(offered(document, library, end, type->name), fits_somewhere)
                << type->name << " at " << end.node.number << " " << end.socket;
        }
    }
}

TEST_F(Compose, a_dropped_wire_adds_a_wired_node)
{
    NodeId box = scene.node("box"), output = scene.show(box);
    NodeId paint = done(add_wired(document, library, "paint", {30, 40}, {box, ""}));
    EXPECT_EQ(source(paint, "d"), box);
    EXPECT_EQ(node(paint).position, glm::vec2(30, 40));
    EXPECT_EQ(source(output, "d"), box) << "other readers stay";
    NodeId ball = done(add_wired(document, library, "sphere", {0, 0}, {output, "d"}));
    EXPECT_EQ(source(output, "d"), ball);
    auto add = [&](std::string_view type, const LooseEnd& end) {
        return refused([&] { return add_wired(document, library, type, {0, 0}, end); });
    };
    EXPECT_EQ(add("sphere", {box, ""}), "“Sphere” cannot be wired to “Box”");
    EXPECT_EQ(add("sun", {output, "d"}), "“Sun” cannot be wired to “Shape” of “Output”");
    EXPECT_EQ(add("sphere", {output, "no_such"}), "“Sphere” cannot be wired to “No such” of “Output”");
    EXPECT_EQ(add("sphere", {{99}, ""}), "there is no node 99");
    EXPECT_TRUE(fits(document, library, {{99}, ""}).empty());
}

}  // namespace
}  // namespace fieldwright::graph
