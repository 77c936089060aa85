// The translate gizmo moves what it stands on, by as much as the hand moved.
#include "ui/gizmo.h"

#include "tests/support/scene.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"
#include "ui/scene_camera.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

using graph::NodeId;
using tests::Driver;
using tests::Scene;
using ui::ViewCamera;

constexpr float pixel_m = 0.012f;  // the mouse is told in whole pixels

glm::vec3 offset_of(const graph::Document& document, NodeId node)
{
    return std::get<glm::vec3>(*document.root.find(node)->parameter("offset"));
}

NodeId first_of_type(const graph::Document& document, std::string_view type)
{
    for (const graph::Node& node : document.root.nodes)
        if (node.type == type) return node.id;
    return {};
}

void expect_near(glm::vec3 a, glm::vec3 b, float tolerance)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

// A pane of the window, and where the world's points are in it.
class Hands : public Driver {
public:
    Hands(const Scene& scene, NodeId selected) : Driver(scene.document)
    {
        editor.view.through_camera = false;
        editor.view.selection.only(selected);
        frames(2);
    }
    glm::vec2 pane_size() const
    {
        auto pane = *editor.rects.find("viewport");
        return pane.high - pane.low;
    }
    glm::vec2 at(glm::vec3 world) const
    {
        return editor.rects.find("viewport")->low + *editor.view.camera.project(world, pane_size());
    }
};

TEST(AlongAxis, finds_the_point_nearest_to_a_ray)
{
    ViewCamera::Ray ray{{2.5f, 3, 7}, {0, 0, -1}};
    EXPECT_NEAR(*ui::along_axis({1, 0, 0}, {1, 0, 0}, ray), 1.5f, 1e-5f);
    EXPECT_NEAR(*ui::along_axis({1, 0, 0}, {0, 1, 0}, ray), 3, 1e-5f);
    EXPECT_FALSE(ui::along_axis({1, 0, 0}, {0, 0, 1}, ray));
}

TEST(OnPlane, is_where_the_ray_meets_it)
{
    auto met = ui::on_plane({0, 0, 2}, {0, 0, 1}, {{1, 1, 7}, glm::normalize(glm::vec3(1, 0, -1))});
    ASSERT_TRUE(met);
    expect_near(*met, {6, 1, 2}, 1e-5f);
    EXPECT_FALSE(ui::on_plane({0, 0, 2}, {0, 0, 1}, {{1, 1, 7}, {1, 0, 0}}));
}

TEST(TranslateGizmo, dragging_x_moves_the_offset_by_the_projected_way_in_one_step)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    NodeId move = scene.node("translate", {{"d", sphere}, {"offset", glm::vec3(0.5f, 0.25f, -1)}});
    scene.show(move);
    Hands hands(scene, sphere);
    glm::vec3 origin{0.5f, 0.25f, -1};
    hands.drag(hands.at(origin + glm::vec3(0.4f, 0, 0)), hands.at(origin + glm::vec3(1.65f, 0, 0)));
    expect_near(offset_of(hands.document, move), {1.75f, 0.25f, -1}, pixel_m);
    ASSERT_EQ(hands.steps.size(), 2u);
    EXPECT_EQ(hands.steps.back().second, "Move sphere");
    EXPECT_EQ(hands.editor.view.selection.active(), sphere);
}

TEST(TranslateGizmo, keeps_its_length_on_the_screen_however_far_away)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    scene.show(sphere);
    Hands hands(scene, sphere);
    hands.editor.view.camera.look_along(2, 1);
    for (float distance : {3.0f, 30.0f, 300.0f}) {
        hands.editor.view.camera.distance = distance;
        hands.frames(2);
        EXPECT_NEAR(glm::distance(hands.place("viewport/gizmo/x"), hands.place("viewport/gizmo/centre")), 90, 1);
        EXPECT_FALSE(hands.shows("viewport/gizmo/z")) << "an arrow at the eye cannot be dragged";
    }
}

TEST(TranslateGizmo, the_first_drag_inserts_a_translate_as_one_step_and_undo_gives_the_equal_document)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    scene.show(sphere);
    Hands hands(scene, sphere);
    glm::vec2 y = hands.place("viewport/gizmo/y");
    hands.move(y);
    hands.press();
    hands.release();
    EXPECT_EQ(hands.document, scene.document) << "holding it moves nothing";
    hands.drag(y, y - glm::vec2(0, 60));
    NodeId translate = first_of_type(hands.document, "translate");
    ASSERT_TRUE(translate);
    EXPECT_EQ(hands.document.root.find(translate)->input("d"), sphere);
    EXPECT_GT(offset_of(hands.document, translate).y, 0.2f);
    EXPECT_NEAR(offset_of(hands.document, translate).x, 0, 1e-6f);
    EXPECT_EQ(hands.steps.size(), 2u);
    EXPECT_EQ(hands.steps[0].first, scene.document);
}

TEST(TranslateGizmo, the_centre_moves_in_the_plane_of_the_view)
{
    Scene scene;
    NodeId box = scene.node("box");
    NodeId move = scene.node("translate", {{"d", box}, {"offset", glm::vec3(0)}});
    scene.show(move);
    Hands hands(scene, box);
    glm::vec2 from = hands.place("viewport/gizmo/centre"), to = from + glm::vec2(70, 45);
    glm::vec3 backward = hands.editor.view.camera.backward();
    hands.drag(from, to);
    glm::vec3 offset = offset_of(hands.document, move);
    EXPECT_NEAR(glm::dot(offset, backward), 0, 1e-4f);
    EXPECT_NEAR(glm::distance(hands.at(offset), to), 0, 0.2f);
}

TEST(TranslateGizmo, control_snaps_to_a_tenth_of_a_metre_and_shift_is_a_tenth_of_the_way)
{
    Scene scene;
    NodeId box = scene.node("box");
    NodeId move = scene.node("translate", {{"d", box}, {"offset", glm::vec3(0)}});
    scene.show(move);
    Hands hands(scene, box);
    auto drag_with = [&](int modifier) {
        hands.queue.push({.kind = ui::InputEvent::Kind::key, .code = modifier, .down = true});
        hands.run_until_quiet();
        glm::vec3 origin = offset_of(hands.document, move);
        hands.drag(hands.at(origin + glm::vec3(0.5f, 0, 0)), hands.at(origin + glm::vec3(1.243f, 0, 0)));
        hands.queue.push({.kind = ui::InputEvent::Kind::key, .code = modifier, .down = false});
        hands.run_until_quiet();
        return offset_of(hands.document, move).x - origin.x;
    };
    EXPECT_NEAR(drag_with(ui::key::left_control), 0.7f, 1e-5f);
    EXPECT_NEAR(drag_with(ui::key::left_shift), 0.0743f, pixel_m);
}

TEST(TranslateGizmo, escape_gives_the_place_back_and_leaves_no_step)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    scene.show(sphere);
    Hands hands(scene, sphere);
    glm::vec2 x = hands.place("viewport/gizmo/x");
    hands.move(x);
    hands.press();
    hands.move(x + glm::vec2(50, 0));
    EXPECT_NE(hands.document, scene.document);
    hands.key(ui::key::escape);
    EXPECT_EQ(hands.document, scene.document);
    hands.move(x + glm::vec2(90, 0));
    hands.release();
    EXPECT_EQ(hands.document, scene.document);
    EXPECT_EQ(hands.steps.size(), 1u);
}

TEST(TranslateGizmo, below_a_turn_and_a_scale_it_still_moves_along_the_worlds_axes)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    NodeId move = scene.node("translate", {{"d", sphere}, {"offset", glm::vec3(0, 0, 0)}});
    NodeId turn = scene.node("rotate", {{"d", move}, {"angles", glm::vec3(0, 90, 0)}});
    NodeId scale = scene.node("scale", {{"d", turn}, {"factor", 2.0f}});
    NodeId place = scene.node("translate", {{"d", scale}, {"offset", glm::vec3(0, 1, 0)}});
    scene.show(place);
    Hands hands(scene, sphere);
    glm::vec3 origin{0, 1, 0};
    EXPECT_LT(glm::distance(hands.place("viewport/gizmo/centre"), hands.at(origin)), 1);
    hands.drag(hands.at(origin + glm::vec3(0.5f, 0, 0)), hands.at(origin + glm::vec3(1.5f, 0, 0)));
    // Half of it, as it is doubled later; a turn by 90 degrees about y takes z to x.
    expect_near(offset_of(hands.document, move), {0, 0, 0.5f}, pixel_m);
}

TEST(TranslateGizmo, stands_in_the_middle_of_what_is_known_about_the_surface)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    NodeId move = scene.node("translate", {{"d", sphere}, {"offset", glm::vec3(1, 0, 0)}});
    scene.show(move);
    Driver driver(scene.document);
    driver.editor.view.through_camera = false;
    driver.editor.view.selection.only(sphere);
    driver.readings.bounds_of = [&](NodeId node) {
        return node == move ? std::optional(ui::Measured{{1, 2, 0}, {1, 1, ui::unbounded}}) : std::nullopt;
    };
    driver.frames(2);
    auto pane = *driver.editor.rects.find("viewport");
    glm::vec2 wanted = pane.low + *driver.editor.view.camera.project({1, 2, 0}, pane.high - pane.low);
    EXPECT_LT(glm::distance(driver.place("viewport/gizmo/centre"), wanted), 1);
}

TEST(TranslateGizmo, hides_where_it_would_move_wrongly_or_nothing)
{
    Scene scene;
    NodeId bent = scene.node("sphere"), alone = scene.node("box"), seen = scene.node("torus");
    NodeId both = scene.node("union", {{"a", scene.node("box")}, {"b", bent}});
    scene.show(scene.node("union", {{"a", scene.node("bend", {{"d", both}})}, {"b", seen}}));
    Hands hands(scene, seen);
    EXPECT_TRUE(hands.shows("viewport/gizmo/x"));
    for (NodeId hidden : {bent, alone, first_of_type(scene.document, "output")}) {
        hands.editor.view.selection.only(hidden);
        hands.frames(2);
        EXPECT_FALSE(hands.shows("viewport/gizmo/x")) << hidden.number;
    }
    hands.editor.view.selection.only(seen);
    hands.editor.view.gizmo = false;
    hands.frames(2);
    EXPECT_FALSE(hands.shows("viewport/gizmo/x"));
}

TEST(TranslateGizmo, what_is_bent_or_driven_is_moved_as_a_whole_after_that)
{
    for (std::string_view before : {"bend", "translate", "extrude"}) {
        Scene scene;
        NodeId shape = scene.node(before == "extrude" ? "circle" : "sphere");
        NodeId changed = scene.node(before, {{"d", shape}});
        if (before == "translate") scene.wire(scene.node("vector"), changed, "offset");
        scene.show(scene.node("union", {{"a", changed}, {"b", scene.node("box")}}));
        Hands hands(scene, shape);
        glm::vec2 y = hands.place("viewport/gizmo/y");
        hands.drag(y, y - glm::vec2(0, 60));
        const graph::Node& joined = *hands.document.root.find(first_of_type(hands.document, "union"));
        const graph::Node& moved = *hands.document.root.find(joined.input("a"));
        EXPECT_EQ(moved.type, "translate") << before;
        EXPECT_EQ(moved.input("d"), changed) << before;
        EXPECT_GT(offset_of(hands.document, moved.id).y, 0.2f) << before;
        glm::vec2 again = hands.place("viewport/gizmo/y");
        hands.drag(again, again + glm::vec2(0, 60));
        EXPECT_EQ(hands.document.root.nodes.size(), scene.document.root.nodes.size() + 1) << before;
        EXPECT_NEAR(offset_of(hands.document, moved.id).y, 0, pixel_m) << before;
    }
}

TEST(Placement, turns_as_the_rotate_node_does)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    scene.show(scene.node("rotate", {{"d", sphere}, {"angles", glm::vec3(90, 90, 0)}}));
    auto place = ui::placement(scene.document, *scene.library, sphere);
    ASSERT_TRUE(place);
    // About x first: y goes to z; then about y: z goes to x.
    expect_near(place->world_from_node({0, 1, 0}), {1, 0, 0}, 1e-6f);
}

TEST(Placement, muted_nodes_leave_space_as_it_is_and_pass_their_first_input_only)
{
    Scene scene;
    NodeId a = scene.node("sphere"), b = scene.node("box");
    NodeId both = scene.node("union", {{"a", a}, {"b", b}});
    NodeId move = scene.node("translate", {{"d", both}, {"offset", glm::vec3(3, 0, 0)}});
    scene.show(move);
    EXPECT_EQ(ui::placement(scene.document, *scene.library, b)->offset, glm::vec3(3, 0, 0));
    ASSERT_FALSE(graph::set_muted(scene.document, move, true));
    ASSERT_FALSE(graph::set_muted(scene.document, both, true));
    EXPECT_EQ(ui::placement(scene.document, *scene.library, a)->offset, glm::vec3(0));
    EXPECT_FALSE(ui::placement(scene.document, *scene.library, b));
}

TEST(Placement, is_unknown_behind_a_wired_parameter)
{
    Scene scene;
    NodeId sphere = scene.node("sphere");
    scene.show(scene.node("translate", {{"d", sphere}, {"offset", scene.node("vector")}}));
    EXPECT_FALSE(ui::placement(scene.document, *scene.library, sphere));
}

}  // namespace
}  // namespace fieldwright
