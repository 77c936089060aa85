// Handles of what has a place or a direction, but no surface: lamps, suns, cameras.
#include "tests/support/scene.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"
#include "ui/sun_handle.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

using graph::NodeId;
using tests::Driver;
using tests::Scene;

template <typename T>
T value_of(const graph::Document& document, NodeId node, std::string_view parameter)
{
    return std::get<T>(*document.root.find(node)->parameter(parameter));
}

class Hands : public Driver {
public:
    Hands(const Scene& scene, NodeId selected) : Driver(scene.document)
    {
        editor.view.through_camera = false;
        editor.view.selection.only(selected);
        frames(2);
    }
    void undo()
    {
        editor.run("edit.undo");
        frames(3);
    }
};

TEST(LampHandles, move_the_lamp_in_one_step_that_undo_takes_back)
{
    Scene scene;
    scene.show(scene.node("sphere"));
    NodeId lamp = scene.node("point", {{"position", glm::vec3(0.5f, 1, 0)}});
    Hands hands(scene, lamp);
    glm::vec2 y = hands.place("viewport/gizmo/y");
    hands.drag(y, y - glm::vec2(0, 50));
    glm::vec3 moved = value_of<glm::vec3>(hands.document, lamp, "position");
    EXPECT_GT(moved.y, 1.1f);
    EXPECT_FLOAT_EQ(moved.x, 0.5f);
    EXPECT_FLOAT_EQ(moved.z, 0);
    ASSERT_EQ(hands.steps.size(), 2u);
    EXPECT_EQ(hands.document.root.nodes.size(), scene.document.root.nodes.size()) << "no translate is needed";
    hands.undo();
    EXPECT_EQ(hands.document, scene.document);
}

TEST(LampHandles, are_not_there_when_a_wire_decides)
{
    Scene scene;
    scene.show(scene.node("sphere"));
    NodeId place = scene.node("vector");
    NodeId lamp = scene.node("point", {{"position", place}});
    EXPECT_FALSE(Hands(scene, lamp).shows("viewport/gizmo/centre"));
}

TEST(CameraHandles, move_what_it_looks_at_while_another_eye_watches)
{
    Scene scene;
    scene.show(scene.node("sphere"));
    NodeId camera = scene.node("perspective", {{"target", glm::vec3(0, 0.5f, 0)}});
    Hands hands(scene, camera);
    glm::vec3 position = value_of<glm::vec3>(hands.document, camera, "position");
    glm::vec2 x = hands.place("viewport/gizmo/x"), middle = hands.place("viewport/gizmo/centre");
    hands.drag(x, x + 0.7f * (x - middle));
    EXPECT_GT(value_of<glm::vec3>(hands.document, camera, "target").x, 0.2f);
    EXPECT_EQ(value_of<glm::vec3>(hands.document, camera, "position"), position);
    EXPECT_EQ(hands.steps.size(), 2u);
    hands.editor.view.through_camera = true;
    hands.frames(2);
    EXPECT_FALSE(hands.shows("viewport/gizmo/centre")) << "its target lies in the middle of its own picture";
}

class SunHandles : public testing::Test {
protected:
    SunHandles()
    {
        scene.show(scene.node("sphere"));
        sun = scene.node("sun", {{"elevation", 30.0f}, {"azimuth", 20.0f}});
        hands.emplace(scene, sun);
        hands->editor.view.camera.look_along(2, 1);  // from +z: x to the right, y up
        hands->frames(2);
    }
    float elevation() { return value_of<float>(hands->document, sun, "elevation"); }
    float azimuth() { return value_of<float>(hands->document, sun, "azimuth"); }
    Scene scene;
    NodeId sun;
    std::optional<Hands> hands;
};

TEST_F(SunHandles, stand_where_the_sun_is_seen)
{
    glm::vec3 direction = ui::sun_direction(30, 20);
    glm::vec2 pane = hands->place("viewport"), ball = hands->place("viewport/gizmo/sun");
    EXPECT_NEAR(ball.x - pane.x, 110 * direction.x, 1.5f);
    EXPECT_NEAR(ball.y - pane.y, -110 * direction.y, 1.5f);
}

TEST_F(SunHandles, the_ball_follows_the_hand_and_the_turn_is_one_step)
{
    glm::vec2 ball = hands->place("viewport/gizmo/sun"), to = ball + glm::vec2(-60, -20);
    hands->drag(ball, to);
    EXPECT_LT(glm::distance(hands->place("viewport/gizmo/sun"), to), 2);
    EXPECT_LT(azimuth(), 0) << "to the left of the middle";
    EXPECT_GT(elevation(), 30);
    ASSERT_EQ(hands->steps.size(), 2u);
    EXPECT_EQ(hands->steps[1].second, "Turn sun");
    hands->undo();
    EXPECT_EQ(hands->document, scene.document);
}

TEST_F(SunHandles, beside_the_sphere_it_goes_along_the_rim)
{
    glm::vec2 ball = hands->place("viewport/gizmo/sun"), pane = hands->place("viewport");
    hands->drag(ball, pane + glm::vec2(190, 0));
    EXPECT_NEAR(elevation(), 0, 1);
    EXPECT_NEAR(azimuth(), 90, 1);
}

TEST_F(SunHandles, escape_gives_the_sun_back_and_control_snaps)
{
    glm::vec2 ball = hands->place("viewport/gizmo/sun");
    hands->move(ball);
    hands->press();
    hands->move(ball + glm::vec2(-40, 0));
    EXPECT_NE(azimuth(), 20);
    hands->key(ui::key::escape);
    hands->release();
    EXPECT_EQ(hands->document, scene.document);
    hands->queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_control, .down = true});
    hands->drag(ball, ball + glm::vec2(-37, -13));
    EXPECT_EQ(std::fmod(azimuth(), 5.0f), 0);
    EXPECT_EQ(std::fmod(elevation(), 5.0f), 0);
}

}  // namespace
}  // namespace fieldwright
