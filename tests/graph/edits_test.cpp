// Edits: what they do, what they refuse, and that a refusal changes nothing.
#include "graph/edits.h"
#include "graph/wire_rules.h"

#include "tests/graph/small_library.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace fieldwright::graph {
namespace {

class Edits : public testing::Test {
protected:
    NodeId add(std::string_view type) { return add_node(document, *library, type); }
    Refusal wire(NodeId source, NodeId target, std::string_view socket)
    {
        return connect(document, *library, source, target, socket);
    }

    // The refusal's sentence, after checking that the document is as it was.
    template <typename Edit>
    std::string refused(Edit edit)
    {
        Document before = document;
        Refusal refusal = edit();
        EXPECT_EQ(document, before);
        EXPECT_EQ(validate(document, *library), std::nullopt);
        return refusal.value_or("accepted");
    }
    std::string wire_refused(NodeId source, NodeId target, std::string_view socket)
    {
        return refused([&] { return wire(source, target, socket); });
    }

    std::shared_ptr<const Library> library = small_library();
    Document document;
};

TEST_F(Edits, a_new_node_has_an_id_of_its_own_and_every_parameter)
{
    NodeId first = add("sphere"), second = add("star");
    EXPECT_EQ(remove_node(document, second), std::nullopt);
    NodeId third = add("star");
    EXPECT_EQ(first, NodeId{1});
    EXPECT_EQ(third, NodeId{3});
    EXPECT_EQ(document.root.find(third)->parameters.size(), 9u);
    EXPECT_EQ(std::get<float>(*document.root.find(first)->parameter("radius")), 1.0f);
    EXPECT_FALSE(add("no_such_type"));
    EXPECT_EQ(validate(document, *library), std::nullopt);
}

TEST_F(Edits, a_removed_node_takes_its_wires_along)
{
    NodeId sphere = add("sphere"), both = add("union");
    ASSERT_EQ(wire(sphere, both, "a"), std::nullopt);
    ASSERT_EQ(remove_node(document, sphere), std::nullopt);
    EXPECT_TRUE(document.root.find(both)->inputs.empty());
    EXPECT_EQ(validate(document, *library), std::nullopt);
    EXPECT_EQ(refused([&] { return remove_node(document, sphere); }), "there is no node 1");
}

TEST_F(Edits, connect_refuses_a_cycle)
{
    NodeId first = add("union"), second = add("union"), third = add("union");
    ASSERT_EQ(wire(first, second, "a"), std::nullopt);
    ASSERT_EQ(wire(second, third, "b"), std::nullopt);
    document.root.find(first)->name = "Base";
    EXPECT_EQ(wire_refused(third, first, "a"), "“Union” is made of “Base” itself; this wire would make a cycle");
    EXPECT_NE(wire_refused(first, first, "a").find("cycle"), std::string::npos);
}

TEST_F(Edits, connect_refuses_wrong_kinds_naming_both)
{
    NodeId sphere = add("sphere"), number = add("number"), paint = add("paint"), arrow = add("arrow"),
           star = add("star");
    EXPECT_EQ(
        wire_refused(sphere, sphere, "radius").find("“Sphere” gives a solid and cannot feed “Radius” of “Sphere”"), 0u);
    EXPECT_EQ(wire_refused(number, paint, "material"),
              "“Number” gives a number and cannot feed “Material” of “Paint”, which takes a material");
    EXPECT_NE(wire_refused(number, paint, "d").find("“Shape” of “Paint”, which takes a shape"), std::string::npos);
    EXPECT_NE(wire_refused(arrow, sphere, "radius").find("gives three numbers"), std::string::npos);
    EXPECT_NE(wire_refused(arrow, star, "size").find("takes two numbers"), std::string::npos);
    EXPECT_EQ(wire_refused(number, star, "corners"), "“Star” has no input “Corners”");
    EXPECT_EQ(wire_refused(number, {99}, "a"), "there is no node 99");
    EXPECT_EQ(wire_refused({99}, sphere, "radius"), "there is no node 99");
}

TEST_F(Edits, connect_lets_numbers_fill_vectors_and_colours_be_directions)
{
    NodeId number = add("number"), arrow = add("arrow"), star = add("star"), matte = add("matte"), paint = add("paint");
    for (const char* socket : {"size", "offset", "turn", "lean", "tint"})
        EXPECT_EQ(wire(number, star, socket), std::nullopt);
    EXPECT_EQ(wire(arrow, matte, "colour"), std::nullopt);
    EXPECT_EQ(wire(matte, paint, "material"), std::nullopt);
    EXPECT_EQ(validate(document, *library), std::nullopt);
}

TEST_F(Edits, connect_refuses_2d_into_3d_and_says_what_to_put_between)
{
    NodeId circle = add("circle"), output = add("output"), sphere = add("sphere"), extrude = add("extrude");
    EXPECT_EQ(wire_refused(circle, output, "d"),
              "“Circle” gives a flat shape and cannot feed “Shape” of “Output”, which takes a solid; "
              "put an extrude or a revolve between");
    EXPECT_NE(wire_refused(sphere, extrude, "d").find("put a slice between"), std::string::npos);
    EXPECT_EQ(wire(circle, extrude, "d"), std::nullopt);
    EXPECT_EQ(wire(extrude, output, "d"), std::nullopt);
}

TEST_F(Edits, a_combiner_adopts_the_dimension_of_what_it_is_wired_to)
{
    NodeId circle = add("circle"), sphere = add("sphere"), inner = add("union"), outer = add("union"),
           output = add("output");
    EXPECT_EQ(field_dimension(document, *library, inner), 0);
    ASSERT_EQ(wire(inner, outer, "a"), std::nullopt);
    EXPECT_EQ(field_dimension(document, *library, outer), 0);
    ASSERT_EQ(wire(circle, outer, "b"), std::nullopt);
    EXPECT_EQ(field_dimension(document, *library, inner), 2) << "from its consumer's other input";
    EXPECT_NE(wire_refused(sphere, inner, "a").find("put a slice between"), std::string::npos);
    EXPECT_NE(wire_refused(outer, output, "d").find("put an extrude or a revolve between"), std::string::npos);
    EXPECT_EQ(wire(sphere, outer, "b"), std::nullopt) << "replacing the wire that decided is fine";
    EXPECT_EQ(field_dimension(document, *library, inner), 3);
    EXPECT_EQ(wire(outer, output, "d"), std::nullopt);
    EXPECT_EQ(validate(document, *library), std::nullopt);
}

TEST_F(Edits, a_wire_replaces_the_one_before_and_inputs_stay_sorted)
{
    NodeId first = add("sphere"), second = add("sphere"), both = add("union");
    ASSERT_EQ(wire(first, both, "b"), std::nullopt);
    ASSERT_EQ(wire(first, both, "a"), std::nullopt);
    ASSERT_EQ(wire(second, both, "a"), std::nullopt);
    std::vector<std::pair<std::string, NodeId>> expected = {{"a", second}, {"b", first}};
    EXPECT_EQ(document.root.find(both)->inputs, expected);
    EXPECT_EQ(disconnect(document, both, "a"), std::nullopt);
    EXPECT_EQ(refused([&] { return disconnect(document, both, "a"); }), "nothing is wired to `a` of “union”");
}

TEST_F(Edits, parameters_refuse_wrong_kinds_ranges_and_names)
{
    NodeId sphere = add("sphere"), star = add("star");
    auto set = [&](NodeId node, std::string_view name, Value value) {
        return refused([&] { return set_parameter(document, *library, node, name, value); });
    };
    EXPECT_EQ(set(sphere, "radius", 11.0f), "“Radius” of “Sphere” must lie between 0.01 and 10 m");
    EXPECT_EQ(set(sphere, "radius", std::numeric_limits<float>::quiet_NaN()),
              "“Radius” of “Sphere” must be a finite number");
    EXPECT_EQ(set(sphere, "radius", 1), "“Radius” of “Sphere” must be a number");
    EXPECT_EQ(set(sphere, "radios", 1.0f), "“Sphere” has no parameter `radios`; its parameters are `radius`");
    EXPECT_EQ(set(star, "style", std::string("oval")), "“Style” of “Star” must be one of: sharp, round");
    EXPECT_EQ(set_parameter(document, *library, star, "style", std::string("sharp")), std::nullopt);
    EXPECT_EQ(std::get<std::string>(*document.root.find(star)->parameter("style")), "sharp");
}

TEST_F(Edits, names_positions_and_settings_are_checked)
{
    NodeId sphere = add("sphere");
    EXPECT_EQ(rename_node(document, sphere, "B\xC3\xA4r"), std::nullopt);
    EXPECT_EQ(move_node(document, sphere, {3, 4}), std::nullopt);
    EXPECT_EQ(set_muted(document, sphere, true), std::nullopt);
    EXPECT_TRUE(document.root.find(sphere)->muted);
    EXPECT_EQ(refused([&] { return rename_node(document, sphere, "\xFF"); }), "a node's name must be UTF-8 text");
    EXPECT_NE(refused([&] { return rename_node(document, sphere, std::string(257, 'x')); }), "accepted");
    EXPECT_NE(refused([&] { return move_node(document, sphere, {INFINITY, 0}); }), "accepted");
    MarchSettings march;
    march.step_limit = 0;
    EXPECT_EQ(refused([&] { return set_march(document, march); }), "“Step limit” must lie between 1 and 60000");
    march = {};
    march.far = march.near;
    EXPECT_EQ(refused([&] { return set_march(document, march); }), "“Near” must be smaller than far");
    EXPECT_EQ(refused([&] { return set_occlusion(document, {NAN, 1}); }), "“Strength” must lie between 0 and 1");
    EXPECT_EQ(set_occlusion(document, {0.5f, 1}), std::nullopt);
    EXPECT_EQ(refused([&] { return set_fog(document, {.density = -1}); }), "“Density” must lie between 0 and 1000");
    EXPECT_EQ(refused([&] { return set_bounces(document, 9); }), "“Bounces” must lie between 0 and 8");
    EXPECT_EQ(set_fog(document, {.density = 0.1f}), std::nullopt);
    EXPECT_EQ(set_bounces(document, 8), std::nullopt);
}

TEST_F(Edits, validate_finds_every_broken_promise)
{
    NodeId sphere = add("sphere"), both = add("union"), other = add("union");
    ASSERT_EQ(wire(sphere, both, "a"), std::nullopt);
    const Document good = document;
    auto broken = [&](auto change) {
        document = good;
        change();
        return validate(document, *library).value_or("valid");
    };
    auto node = [&](NodeId id) -> Node& { return *document.root.find(id); };
    EXPECT_EQ(broken([] {}), "valid");
    EXPECT_NE(broken([&] { document.next_id = 3; }), "valid");
    EXPECT_NE(broken([&] { std::swap(document.root.nodes[0], document.root.nodes[1]); }), "valid");
    EXPECT_NE(broken([&] { node(sphere).type = "ball"; }), "valid");
    EXPECT_NE(broken([&] { node(sphere).parameters.clear(); }), "valid");
    EXPECT_NE(broken([&] { node(sphere).parameters[0].second = 99.0f; }), "valid");
    EXPECT_NE(broken([&] { node(both).inputs[0].second = {77}; }), "valid");
    EXPECT_NE(broken([&] { node(both).inputs.push_back(node(both).inputs[0]); }), "valid");
    EXPECT_NE(broken([&] { document.march.tolerance = NAN; }), "valid");
    EXPECT_EQ(broken([&] {
                  node(other).inputs = {{"a", both}};
                  node(both).inputs = {{"b", other}};
              }),
              "the wires 3 -> 2 -> 3 make a cycle; remove one of them");
}

TEST_F(Edits, a_chain_of_20000_nodes_is_built_and_checked_quickly)
{
    auto begin = std::chrono::steady_clock::now();
    NodeId last = add("sphere");
    for (int i = 1; i < 20'000; ++i) {
        NodeId next = add("union");
        document.root.nodes.back().inputs = {{"a", last}};
        last = next;
    }
    EXPECT_FALSE(add("sphere")) << "the limit";
    EXPECT_EQ(validate(document, *library), std::nullopt);
    EXPECT_EQ(field_dimension(document, *library, last), 3);
    EXPECT_NE(wire_refused(last, {2}, "b").find("cycle"), std::string::npos);
    document.root.find({2})->inputs = {{"a", last}};
    EXPECT_EQ(find_cycle(document.root).size(), 19'999u);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

}  // namespace
}  // namespace fieldwright::graph
