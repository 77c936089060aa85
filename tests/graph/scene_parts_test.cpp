// What panels and viewport do to a scene: moving a solid, painting it, setting the camera.
#include "graph/scene_parts.h"

#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

class SceneParts : public testing::Test {
protected:
    NodeId source(NodeId node, std::string_view socket) { return document.root.find(node)->input(socket); }
    template <typename T>
    T value(NodeId node, std::string_view parameter)
    {
        return std::get<T>(*document.root.find(node)->parameter(parameter));
    }
    NodeId nearest(NodeId node) { return nearest_translate(document, library, node); }

    NodeId done(const Placed& placed)
    {
        EXPECT_EQ(placed.refusal, std::nullopt);
        EXPECT_EQ(validate(document, library), std::nullopt);
        return placed.node;
    }
    template <typename Edit>
    std::string refused(Edit edit)
    {
        Document before = document;
        Placed placed = edit();
        EXPECT_EQ(document, before);
        EXPECT_FALSE(placed.node);
        return placed.refusal.value_or("accepted");
    }

    tests::Scene scene;
    Document& document = scene.document;
    const Library& library = *scene.library;
};

TEST_F(SceneParts, the_nearest_translate_is_the_first_before_a_combiner)
{
    NodeId box = scene.node("box"), twist = scene.node("twist", {{"d", box}});
    NodeId near = scene.node("translate", {{"d", twist}}), far = scene.node("translate", {{"d", near}});
    NodeId ball = scene.node("sphere"), both = scene.node("union", {{"a", far}, {"b", ball}});
    NodeId all = scene.node("translate", {{"d", both}});
    scene.show(all);
    EXPECT_EQ(nearest(box), near);
    EXPECT_EQ(nearest(near), near);
    EXPECT_EQ(nearest(far), far);
    EXPECT_EQ(nearest(ball), NodeId{}) << "the one after the union moves others too";
    EXPECT_EQ(nearest(both), all);
    EXPECT_EQ(nearest({99}), NodeId{});
}

TEST_F(SceneParts, muted_and_driven_translates_and_shared_nodes_are_passed_over)
{
    NodeId box = scene.node("box"), muted = scene.node("translate", {{"d", box}});
    NodeId driven = scene.node("translate", {{"d", muted}, {"offset", scene.node("vector")}});
    NodeId last = scene.node("translate", {{"d", driven}});
    set_muted(document, muted, true);
    EXPECT_EQ(nearest(box), last);
    scene.node("round", {{"d", driven}});
    EXPECT_EQ(nearest(box), NodeId{}) << "read by two";
}

TEST_F(SceneParts, a_translate_is_inserted_after_the_node_and_moves_nothing_yet)
{
    NodeId box = scene.node("box"), both = scene.node("union", {{"a", box}});
    scene.show(both);
    NodeId moved = done(insert_translate(document, library, box));
    EXPECT_EQ(source(both, "a"), moved);
    EXPECT_EQ(value<glm::vec3>(moved, "offset"), glm::vec3(0));
    EXPECT_EQ(nearest(box), moved);
}

TEST_F(SceneParts, a_flat_shape_is_moved_where_it_is_solid)
{
    NodeId star = scene.node("star"), turned = scene.node("rotate_2d", {{"d", star}});
    NodeId solid = scene.node("extrude", {{"d", turned}}), output = scene.show(solid);
    NodeId moved = done(insert_translate(document, library, star));
    EXPECT_EQ(source(moved, "d"), solid);
    EXPECT_EQ(source(output, "d"), moved);
    NodeId circle = scene.node("circle");
    scene.node("union", {{"a", circle}});
    auto insert = [&](NodeId id) { return refused([&] { return insert_translate(document, library, id); }); };
    EXPECT_NE(insert(circle).find("is flat where it is combined"), std::string::npos);
    EXPECT_NE(insert(scene.node("sun")).find("is not a shape"), std::string::npos);
    EXPECT_NE(insert(output).find("is not a shape"), std::string::npos);
    EXPECT_EQ(insert({99}), "there is no node 99");
}

TEST_F(SceneParts, a_material_comes_with_a_paint_that_is_used_again)
{
    NodeId box = scene.node("box"), moved = scene.node("translate", {{"d", box}}), output = scene.show(moved);
    NodeId first = done(add_material(document, library, "phong", box));
    NodeId paint = source(moved, "d");
    EXPECT_EQ(document.root.find(paint)->type, "paint");
    EXPECT_EQ(source(paint, "d"), box);
    EXPECT_EQ(source(paint, "material"), first);
    NodeId second = done(add_material(document, library, "checker", paint));
    EXPECT_EQ(source(paint, "material"), second);
    EXPECT_TRUE(document.root.find(first)) << "a material nothing wears stays in the list";
    EXPECT_EQ(assign_material(document, library, first, box), std::nullopt);
    EXPECT_EQ(source(paint, "material"), first);
    NodeId outer = scene.node("paint", {{"d", moved}});
    scene.wire(outer, output, "d");
    done(add_material(document, library, "phong", box));
    EXPECT_NE(source(outer, "material"), NodeId{}) << "the outer paint is the one that shows";
    EXPECT_EQ(source(paint, "material"), first);
}

TEST_F(SceneParts, materials_refuse_what_is_no_field_or_no_material)
{
    NodeId box = scene.node("box"), sun = scene.node("sun");
    auto add = [&](std::string_view type, NodeId id) {
        return refused([&] { return add_material(document, library, type, id); });
    };
    EXPECT_NE(add("phong", sun).find("is not a shape"), std::string::npos);
    EXPECT_EQ(add("sphere", box), "“Sphere” is not a material");
    EXPECT_EQ(add("no_such", box), "there is no node type `no_such`");
    Document before = document;
    EXPECT_NE(assign_material(document, library, sun, box).value_or("").find("takes a material"), std::string::npos);
    EXPECT_EQ(document, before);
}

TEST_F(SceneParts, the_camera_takes_the_view_in_place)
{
    NodeId camera = scene.node("perspective", {{"position", scene.node("vector")}}),
           output = scene.show(scene.node("box"));
    scene.wire(camera, output, "camera");
    set_muted(document, camera, true);
    NodeId same = done(set_scene_camera_from_view(document, library, {{1, 2, 3}, {4, 5, 6}, 60}));
    EXPECT_EQ(same, camera);
    EXPECT_EQ(value<glm::vec3>(camera, "position"), glm::vec3(1, 2, 3));
    EXPECT_EQ(value<glm::vec3>(camera, "target"), glm::vec3(4, 5, 6));
    EXPECT_EQ(value<float>(camera, "field_of_view"), 60.0f);
    EXPECT_EQ(source(camera, "position"), NodeId{}) << "the wire would overrule the view";
    EXPECT_FALSE(document.root.find(camera)->muted);
}

TEST_F(SceneParts, a_camera_of_the_other_kind_is_replaced)
{
    NodeId camera = scene.node("perspective"), output = scene.show(scene.node("box"));
    scene.wire(camera, output, "camera");
    move_node(document, camera, {7, 8});
    NodeId flat =
        done(set_scene_camera_from_view(document, library, {.position = {1, 2, 3}, .target = {}, .height = 5.0f}));
    EXPECT_EQ(source(output, "camera"), flat);
    EXPECT_EQ(document.root.find(flat)->type, "orthographic");
    EXPECT_EQ(document.root.find(flat)->position, glm::vec2(7, 8));
    EXPECT_EQ(value<float>(flat, "height"), 5.0f);
    EXPECT_FALSE(document.root.find(camera));
}

TEST_F(SceneParts, a_scene_without_camera_gets_one_and_a_bad_view_changes_nothing)
{
    EXPECT_NE(refused([&] {
                  return set_scene_camera_from_view(document, library, {{1, 2, 3}, {}, 500});
              }).find("must lie between"),
              std::string::npos);
    NodeId camera = done(set_scene_camera_from_view(document, library, {{1, 2, 3}, {}, 50}));
    EXPECT_EQ(document.root.nodes.size(), 2u);
    EXPECT_EQ(document.root.find(camera)->type, "perspective");
}

TEST_F(SceneParts, the_output_says_why_it_shows_nothing)
{
    auto shown = [&] { return shown_by_output(document, library); };
    scene.node("sun");
    EXPECT_EQ(shown(), Shown::no_shape);
    NodeId box = scene.node("box");
    EXPECT_EQ(shown(), Shown::no_output);
    NodeId output = scene.node("output");
    EXPECT_EQ(shown(), Shown::nothing_wired);
    NodeId both = scene.node("union");
    scene.wire(both, output, "d");
    EXPECT_EQ(shown(), Shown::nothing_made);
    scene.wire(box, both, "b");
    EXPECT_EQ(shown(), Shown::something);
    set_muted(document, both, true);
    EXPECT_EQ(shown(), Shown::nothing_made) << "muted, it passes on its first shape";
    set_muted(document, both, false);
    set_muted(document, box, true);
    EXPECT_EQ(shown(), Shown::nothing_made);
}

TEST_F(SceneParts, what_is_made_of_most_is_shown_first)
{
    scene.node("box");
    NodeId camera = scene.node("perspective");
    NodeId star = scene.node("star"), turned = scene.node("rotate_2d", {{"d", star}});
    NodeId output = done(show_shape(document, library)), solid = source(output, "d");
    EXPECT_EQ(document.root.find(solid)->type, "extrude");
    EXPECT_EQ(source(solid, "d"), turned);
    EXPECT_EQ(source(output, "camera"), camera);
    EXPECT_EQ(shown_by_output(document, library), Shown::something);
    done({{}, disconnect(document, output, "d")});
    EXPECT_EQ(done(show_shape(document, library)), output) << "the same one again";
    EXPECT_EQ(source(output, "d"), solid);
}

}  // namespace
}  // namespace fieldwright::graph
