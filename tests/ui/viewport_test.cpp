// The hands on the viewport: the eye, clicks, menus.
#include "ui/viewport.h"

#include "tests/support/scene.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"
#include "ui/scene_camera.h"
#include "ui/slice_frame.h"
#include "ui/viewport_overlay.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

using graph::NodeId;
using tests::Driver;
using tests::Scene;
using ui::ViewCamera;

void expect_near(glm::vec3 a, glm::vec3 b, float tolerance)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

// A sphere seen by a camera.
struct Sight {
    Sight() : sphere(scene.node("sphere")), output(scene.show(sphere)), camera(scene.node("perspective"))
    {
        scene.wire(camera, output, "camera");
    }
    Scene scene;
    NodeId sphere, output, camera;
};

class ViewportTest : public testing::Test, protected Sight {
protected:
    ViewportTest() : driver(scene.document)
    {
        driver.readings.has_camera = true;
        driver.readings.bounds_of = [this](NodeId node) -> std::optional<ui::Measured> {
            if (node == camera) return std::nullopt;
            return ui::Measured{{0, 0, 0}, {1, 1, 1}};
        };
        driver.frames(2);
    }

    // An empty place of the pane.
    glm::vec2 empty() const
    {
        ui::WidgetRect pane = *driver.editor.rects.find("viewport");
        return glm::ceil(pane.low + glm::vec2(0.4f, 0.7f) * (pane.high - pane.low));
    }
    void show_picture()
    {
        driver.readings.picture.texture = reinterpret_cast<ImTextureID>(1);
        driver.readings.picture.width = 200;
        driver.readings.picture.height = 100;
    }
    void hold(int modifier, bool down = true)
    {
        driver.queue.push({.kind = ui::InputEvent::Kind::key, .code = modifier, .down = down});
        driver.run_until_quiet();
    }
    // What a command is given, between frames.
    template <typename Act>
    std::string command(const Act& act)
    {
        ui::Draft draft{driver.document, *driver.library, {}, {}};
        std::vector<ui::Request> requests;
        ui::FrameContext frame{draft, view(), driver.readings, requests, theme, driver.editor.rects};
        act(driver.editor.viewport(), frame);
        driver.frames(20);
        return draft.refusal.empty() ? draft.step : draft.refusal;
    }
    ui::ViewState& view() { return driver.editor.view; }
    ViewCamera& eye() { return driver.editor.view.camera; }

    Driver driver;
    ui::Theme theme;
};

TEST_F(ViewportTest, leaving_the_scenes_camera_does_not_jump)
{
    ASSERT_TRUE(view().through_camera);
    driver.move(empty());
    driver.press();
    driver.move(empty() + glm::vec2(2, 0));
    EXPECT_TRUE(view().through_camera) << "2 px are no drag";
    driver.release();
    EXPECT_TRUE(view().through_camera);
    command([](ui::Viewport& viewport, ui::FrameContext& frame) { viewport.look_through_camera(frame); });
    EXPECT_FALSE(view().through_camera);
    expect_near(eye().position(), {4, 3, 6}, 1e-4f);
    expect_near(eye().pivot, {0, 0, 0}, 1e-4f);
    EXPECT_NEAR(eye().field_of_view_rad, glm::radians(45.0f), 1e-5f);
    EXPECT_EQ(driver.document, scene.document);
}

TEST_F(ViewportTest, a_drag_orbits_from_where_the_camera_was)
{
    driver.drag(empty(), empty() + glm::vec2(60, 20));
    EXPECT_FALSE(view().through_camera);
    ViewCamera left = ui::scene_camera(driver.document)->eye;
    EXPECT_NEAR(eye().distance, left.distance, 1e-4f);
    EXPECT_LT(eye().yaw_rad, left.yaw_rad - 0.2f);
    EXPECT_GT(eye().pitch_rad, left.pitch_rad + 0.05f);
    expect_near(eye().pivot, left.pivot, 1e-4f);
    EXPECT_EQ(driver.steps.size(), 1u) << "a view is no step";
}

TEST_F(ViewportTest, the_hands_of_other_programs_work)
{
    view().through_camera = false;
    struct Way {
        int button, modifier;
        bool orbits, pans, dollies;
    };
    constexpr Way ways[] = {{2, 0, true, false, false},
                            {2, ui::key::left_shift, false, true, false},
                            {2, ui::key::left_control, false, false, true},
                            {0, ui::key::left_shift, false, true, false},
                            {0, ui::key::left_alt, true, false, false},
                            {2, ui::key::left_alt, false, true, false},
                            {1, ui::key::left_alt, false, false, true},
                            {1, 0, false, false, false}};
    for (const Way& way : ways) {
        eye() = {};
        if (way.modifier) hold(way.modifier);
        driver.drag(empty(), empty() + glm::vec2(40, -30), way.button);
        if (way.modifier) hold(way.modifier, false);
        ViewCamera start;
        EXPECT_EQ(eye().yaw_rad != start.yaw_rad, way.orbits) << way.button << " " << way.modifier;
        EXPECT_EQ(eye().pivot != start.pivot, way.pans) << way.button << " " << way.modifier;
        EXPECT_EQ(eye().distance != start.distance, way.dollies) << way.button << " " << way.modifier;
    }
    driver.move(empty());
    eye() = {};
    driver.wheel(1);
    EXPECT_FLOAT_EQ(eye().distance, 5.4f);
}

TEST_F(ViewportTest, panning_keeps_the_pivot_under_the_hand)
{
    view().through_camera = false;
    ui::WidgetRect pane = *driver.editor.rects.find("viewport");
    glm::vec3 held = eye().pivot;
    hold(ui::key::left_shift);
    driver.drag(pane.centre(), pane.centre() + glm::vec2(80, -50));
    glm::vec2 at = pane.low + *eye().project(held, pane.high - pane.low);
    EXPECT_LT(glm::distance(at, pane.centre() + glm::vec2(80, -50)), 0.1f);
}

TEST_F(ViewportTest, a_click_selects_what_made_the_surface_under_it)
{
    show_picture();
    glm::ivec2 asked{-1, -1};
    NodeId hit = sphere;
    driver.readings.node_at = [&](int x, int y) {
        asked = {x, y};
        return hit;
    };
    driver.click(empty());
    EXPECT_EQ(asked, glm::ivec2(80, 70)) << "a pixel of the picture, not of the pane";
    EXPECT_EQ(view().selection.nodes(), std::vector{sphere});
    hit = output;
    hold(ui::key::left_shift);
    driver.click(empty());
    EXPECT_EQ(view().selection.nodes(), (std::vector{sphere, output}));
    hold(ui::key::left_shift, false);
    hold(ui::key::left_control);
    driver.click(empty());
    EXPECT_EQ(view().selection.nodes(), std::vector{sphere});
    hit = {};
    driver.click(empty());
    EXPECT_EQ(view().selection.nodes(), std::vector{sphere}) << "control adds or takes, it never clears";
    hold(ui::key::left_control, false);
    driver.click(empty());
    EXPECT_TRUE(view().selection.empty());
}

TEST_F(ViewportTest, a_drag_selects_nothing)
{
    show_picture();
    driver.readings.node_at = [&](int, int) { return sphere; };
    driver.drag(empty(), empty() + glm::vec2(30, 0));
    EXPECT_TRUE(view().selection.empty());
}

TEST_F(ViewportTest, losing_the_window_in_a_drag_ends_it_where_it_was)
{
    view().through_camera = false;
    show_picture();
    driver.readings.node_at = [&](int, int) { return sphere; };
    hold(ui::key::left_shift);
    driver.move(empty());
    driver.press();
    driver.queue.push({.kind = ui::InputEvent::Kind::focus, .down = false});
    driver.run_until_quiet();
    EXPECT_EQ(eye(), ViewCamera{});
    EXPECT_TRUE(view().selection.empty()) << "no click either";
    EXPECT_FALSE(driver.editor.viewport().busy());
    driver.move(empty());
    driver.press();
    driver.move(empty() + glm::vec2(50, 0));
    ViewCamera before = eye();
    driver.queue.push({.kind = ui::InputEvent::Kind::focus, .down = false});
    driver.run_until_quiet();
    EXPECT_EQ(eye(), before);
}

TEST_F(ViewportTest, the_hint_names_what_is_under_the_mouse_and_goes_with_it)
{
    show_picture();
    driver.readings.node_at = [&](int, int) { return sphere; };
    driver.move(empty());
    EXPECT_NE(view().hint.find("Sphere"), std::string::npos) << view().hint;
    driver.move({1200, 700});
    EXPECT_EQ(view().hint.find("Sphere"), std::string::npos) << view().hint;
}

TEST_F(ViewportTest, axis_balls_look_along_and_orbiting_gives_the_perspective_back)
{
    view().through_camera = false;
    driver.frames(2);
    driver.click("viewport/axis/x");
    driver.frames(20);
    EXPECT_TRUE(eye().looks_along(0, 1));
    EXPECT_TRUE(eye().orthographic);
    driver.click("viewport/axis/x");
    driver.frames(20);
    EXPECT_TRUE(eye().looks_along(0, -1)) << "the same ball again is the other side";
    driver.drag(empty(), empty() + glm::vec2(50, 0));
    EXPECT_FALSE(eye().orthographic);
    EXPECT_GT(eye().rays_from, 10);
}

TEST_F(ViewportTest, the_axis_gizmo_can_be_dragged)
{
    view().through_camera = false;
    ViewCamera before = eye();
    driver.frames(2);
    glm::vec2 from = driver.place("viewport/axis/x");
    driver.drag(from, from + glm::vec2(-80, 30));
    EXPECT_NE(eye().yaw_rad, before.yaw_rad);
    EXPECT_FALSE(eye().orthographic);
}

TEST_F(ViewportTest, moving_the_eye_takes_150_ms_and_none_with_reduced_motion)
{
    view().through_camera = false;
    ViewCamera start = eye();
    driver.frame();
    ui::Viewport& viewport = driver.editor.viewport();
    command([](ui::Viewport& v, ui::FrameContext& frame) { v.frame_all(frame); });
    expect_near(eye().pivot, {0, 0, 0}, 1e-5f);
    EXPECT_FALSE(viewport.moving());

    eye() = start;
    driver.click("viewport/axis/z");
    EXPECT_TRUE(viewport.moving());
    EXPECT_FALSE(eye().looks_along(2, 1));
    driver.frames(10);
    EXPECT_FALSE(viewport.moving());
    EXPECT_TRUE(eye().looks_along(2, 1));

    view().reduced_motion = true;
    driver.click("viewport/axis/x");
    EXPECT_FALSE(viewport.moving());
    EXPECT_TRUE(eye().looks_along(0, 1));
}

TEST_F(ViewportTest, framing_leaves_out_what_has_no_end)
{
    Scene wide;
    NodeId ball = wide.node("sphere"), ground = wide.node("plane");
    NodeId moved = wide.node("translate", {{"d", ball}, {"offset", glm::vec3(5, 0, 0)}});
    wide.show(wide.node("union", {{"a", ground}, {"b", moved}}));
    driver.document = wide.document;
    driver.readings.bounds_of = [&](NodeId node) -> std::optional<ui::Measured> {
        if (node == ball) return ui::Measured{{0, 0, 0}, {1, 1, 1}};
        if (node == moved) return ui::Measured{{5, 0, 0}, {1, 1, 1}};
        return ui::Measured{{0, 0, 0}, {ui::unbounded, 1, ui::unbounded}};
    };
    driver.frames(2);
    command([](ui::Viewport& v, ui::FrameContext& frame) { v.frame_all(frame); });
    expect_near(eye().pivot, {5, 0, 0}, 1e-4f);
    EXPECT_LT(eye().distance, 10);
    view().selection.only(ball);
    eye() = {};
    command([](ui::Viewport& v, ui::FrameContext& frame) { v.frame_selected(frame); });
    expect_near(eye().pivot, {5, 0, 0}, 1e-4f);
    view().selection.only(ground);
    command([](ui::Viewport& v, ui::FrameContext& frame) { v.frame_selected(frame); });
    expect_near(eye().pivot, {0, 0, 0}, 1e-4f);
    EXPECT_LT(eye().distance, 50);
}

TEST_F(ViewportTest, setting_the_camera_from_the_view_is_a_step_that_does_not_jump)
{
    view().through_camera = false;
    ViewCamera seen = eye();
    EXPECT_EQ(command([](ui::Viewport& v, ui::FrameContext& frame) { v.set_camera_from_view(frame); }),
              "Set camera from view");
    EXPECT_TRUE(view().through_camera);
    ViewCamera set = ui::scene_camera(driver.document)->eye;
    expect_near(set.position(), seen.position(), 1e-4f);
    expect_near(set.pivot, seen.pivot, 1e-4f);
    EXPECT_NEAR(set.field_of_view_rad, seen.field_of_view_rad, 1e-5f);
}

TEST_F(ViewportTest, says_so_when_there_is_no_camera_to_look_through)
{
    Scene bare;
    bare.show(bare.node("sphere"));
    driver.document = bare.document;
    driver.readings.has_camera = false;
    driver.frames(2);
    std::string said = command([](ui::Viewport& v, ui::FrameContext& frame) { v.look_through_camera(frame); });
    EXPECT_NE(said.find("no camera"), std::string::npos) << said;
    EXPECT_FALSE(view().through_camera);
}

TEST_F(ViewportTest, the_menus_choose_the_view_and_the_stereo)
{
    for (const ui::ViewChoice& choice : driver.readings.views) {
        driver.click("viewport/view");
        driver.click("viewport/view/" + choice.name);
        EXPECT_EQ(view().view, choice.name);
    }
    view().view = "beauty";
    driver.click("viewport/stereo");
    driver.click("viewport/stereo/dubois");
    EXPECT_EQ(view().stereo, "dubois");
    driver.click("viewport/through_camera");
    EXPECT_FALSE(view().through_camera);
    driver.click("viewport/through_camera");
    EXPECT_TRUE(view().through_camera);
    driver.click("viewport/gizmo");
    EXPECT_FALSE(view().gizmo);
    EXPECT_EQ(driver.steps.size(), 1u);
}

TEST_F(ViewportTest, the_legend_belongs_to_views_of_numbers)
{
    EXPECT_FALSE(driver.shows("viewport/legend"));
    view().view = "steps";
    driver.frames(1);
    EXPECT_TRUE(driver.shows("viewport/legend"));
    view().view = "gradient";
    driver.frames(1);
    EXPECT_TRUE(driver.shows("viewport/legend")) << "and to every view of numbers";
    view().view = "depth";
    driver.frames(1);
    EXPECT_FALSE(driver.shows("viewport/legend"));
}

TEST_F(ViewportTest, converges_on_what_is_clicked_and_only_once)
{
    show_picture();
    driver.readings.depth_at = [](int x, int) { return x < 100 ? std::optional(2.5f) : std::nullopt; };
    driver.editor.run("stereo.converge");
    driver.frames(2);
    glm::vec2 low = driver.editor.rects.find("viewport")->low, size = driver.editor.rects.find("viewport")->high - low;
    driver.click(low + glm::vec2(0.8f, 0.6f) * size);
    EXPECT_EQ(view().click, ui::Click::converge) << "there is only sky";
    EXPECT_EQ(view().convergence, 5);
    driver.click(low + glm::vec2(0.3f, 0.6f) * size);
    EXPECT_EQ(view().convergence, 2.5f);
    EXPECT_EQ(view().click, ui::Click::select);
}

TEST_F(ViewportTest, asks_for_the_ray_that_is_clicked_until_escape)
{
    show_picture();
    driver.editor.run("field.inspect_ray");
    driver.frames(2);
    ui::WidgetRect pane = *driver.editor.rects.find("viewport");
    driver.click(pane.low + glm::vec2(0.25f, 0.75f) * (pane.high - pane.low));
    ASSERT_EQ(driver.requests.size(), 1u);
    const auto* ray = std::get_if<ui::InspectRay>(&driver.requests[0]);
    ASSERT_TRUE(ray);
    EXPECT_NEAR(ray->x, 50, 1);
    EXPECT_NEAR(ray->y, 75, 1);
    EXPECT_EQ(view().panel, ui::Panel::field);
    driver.key(ui::key::escape);
    EXPECT_EQ(view().click, ui::Click::select);
}

TEST_F(ViewportTest, the_divider_is_dragged_and_does_not_turn_the_eye)
{
    show_picture();
    view().stereo = "dubois";
    driver.frames(1);
    EXPECT_FALSE(driver.shows("viewport/divider"));
    driver.editor.run("stereo.split");
    driver.frames(2);
    ViewCamera before = eye();
    glm::vec2 from = driver.place("viewport/divider");
    ui::WidgetRect pane = *driver.editor.rects.find("viewport");
    driver.drag(from, {pane.low.x + 0.25f * (pane.high.x - pane.low.x), from.y});
    EXPECT_NEAR(view().eyes.divider, 0.25f, 0.01f);
    EXPECT_EQ(eye(), before);
    view().stereo = "side-by-side";
    driver.frames(2);
    EXPECT_FALSE(driver.shows("viewport/divider"));
}

TEST_F(ViewportTest, a_slice_is_moved_and_zoomed_about_the_mouse)
{
    show_picture();
    view().view = "slice";
    driver.frames(2);
    ui::WidgetRect pane = *driver.editor.rects.find("viewport");
    glm::vec2 size = pane.high - pane.low, at = glm::floor(pane.low + glm::vec2(0.4f, 0.7f) * size);
    ViewCamera before = eye();
    auto under = [&](glm::vec2 place) {
        return ui::slice_frame(view(), driver.readings).point(place - pane.low, size);
    };
    glm::vec3 held = under(at);
    driver.drag(at, at + glm::vec2(60, -30));
    expect_near(under(at + glm::vec2(60, -30)), held, 1e-3f);
    driver.move(at);
    held = under(at);
    float height = view().slice.height;
    driver.wheel(3);
    EXPECT_LT(view().slice.height, height);
    expect_near(under(at), held, 1e-3f);
    EXPECT_EQ(eye(), before);
}

TEST(SliceFrame, finds_back_where_a_point_lies)
{
    ui::ViewState view;
    ui::Readings readings;
    auto ray = std::make_shared<ui::RayReading>();
    ray->origin = {1, 2, 3};
    ray->direction = glm::normalize(glm::vec3(1, -0.5f, -2));
    readings.ray = ray;
    for (const char* plane : {"xy", "yz", "zx", "ray"}) {
        view.slice = {.plane = plane, .offset = 0.7f, .centre = {0.3f, -0.2f}, .height = 3};
        ui::SliceFrame frame = ui::slice_frame(view, readings);
        glm::vec2 at(123, 45), size(640, 360);
        EXPECT_NEAR(glm::distance(frame.place(frame.point(at, size), size), at), 0, 1e-2f) << plane;
        EXPECT_NEAR(frame.above(frame.point(at, size)), 0, 1e-5f) << plane;
    }
    ui::SliceFrame frame = ui::slice_frame(view, readings);
    for (float t : {0.0f, 5.0f}) EXPECT_NEAR(frame.above(ray->at(t)), 0, 1e-5f) << "the ray lies in its plane";
}

TEST_F(ViewportTest, says_that_views_of_data_have_no_stereo)
{
    show_picture();
    view().statistics = false;
    view().stereo = "dubois";
    driver.frames(1);
    EXPECT_FALSE(driver.shows("viewport/statistics"));
    view().view = "depth";
    driver.frames(1);
    EXPECT_TRUE(driver.shows("viewport/statistics"));
}

TEST_F(ViewportTest, a_scene_that_shows_nothing_says_why_and_helps)
{
    show_picture();
    driver.frames(1);
    EXPECT_FALSE(driver.shows("viewport/nothing"));
    driver.document.root.find(sphere)->muted = true;
    driver.frames(1);
    EXPECT_TRUE(driver.shows("viewport/nothing"));
    EXPECT_FALSE(driver.shows("viewport/nothing/help")) << "nobody knows which one is meant";
    driver.document.root.find(sphere)->muted = false;
    ASSERT_FALSE(graph::remove_node(driver.document, output));
    driver.frames(1);
    driver.click("viewport/nothing/help");
    driver.frames(2);
    EXPECT_EQ(driver.steps.back().second, "Add output");
    EXPECT_FALSE(driver.shows("viewport/nothing"));
    driver.document = {};
    driver.frames(2);
    driver.click("viewport/nothing/help");
    driver.frames(2);
    EXPECT_TRUE(driver.shows("add_menu/search"));
}

TEST_F(ViewportTest, statistics_stay_inside_the_pane_and_can_be_hidden)
{
    show_picture();
    driver.readings.picture.device = "gpu with a name that is longer than any pane";
    driver.readings.picture.compiling = true;
    for (float width : {380.0f, 600.0f, 800.0f}) {
        view().panes.side_width = width;
        driver.frames(2);
        ui::WidgetRect line = *driver.editor.rects.find("viewport/statistics");
        EXPECT_LE(line.high.x, driver.editor.rects.find("viewport")->high.x - 8) << width;
    }
    driver.readings.picture.compiling = false;
    view().statistics = false;
    driver.frames(2);
    EXPECT_FALSE(driver.shows("viewport/statistics"));
}

TEST_F(ViewportTest, the_toolbar_fits_a_narrow_pane)
{
    view().panes.side_width = 2000;  // as far as it goes
    driver.frames(2);
    ui::WidgetRect pane = *driver.editor.rects.find("viewport");
    ASSERT_LT(pane.high.x - pane.low.x, 330);
    float axes_low = driver.editor.rects.find("viewport/projection")->low.x;
    for (std::string_view name : {"viewport/view", "viewport/stereo", "viewport/through_camera", "viewport/gizmo"})
        EXPECT_LE(driver.editor.rects.find(name)->high.x, axes_low) << name;
}

TEST_F(ViewportTest, play_is_offered_when_something_depends_on_time)
{
    EXPECT_FALSE(driver.shows("viewport/play"));
    Scene swinging;
    NodeId radius = swinging.node("sine", {{"x", swinging.node("time")}});
    swinging.show(swinging.node("sphere", {{"radius", radius}}));
    driver.document = swinging.document;
    driver.readings.program = std::make_shared<graph::Program>(graph::lower(swinging.document, driver.library));
    driver.frames(2);
    driver.click("viewport/play");
    EXPECT_TRUE(view().playing);
}

TEST_F(ViewportTest, the_pane_is_hovered_under_the_toolbar_too_but_not_elsewhere)
{
    driver.move(driver.place("viewport/view"));
    EXPECT_TRUE(driver.editor.viewport().hovered());
    driver.move({1200, 700});
    EXPECT_FALSE(driver.editor.viewport().hovered());
}

TEST_F(ViewportTest, a_press_on_the_toolbar_at_once_chooses_no_node_below_it)
{
    view().selection.only(output);
    show_picture();
    driver.readings.node_at = [this](int, int) { return sphere; };
    driver.move(empty());
    // Faster than a frame.
    driver.queue.push({.kind = ui::InputEvent::Kind::move, .at = driver.place("viewport/view")});
    driver.queue.push({.kind = ui::InputEvent::Kind::button, .code = 0, .down = true});
    driver.release();
    EXPECT_TRUE(driver.shows("viewport/view/steps"));
    EXPECT_EQ(view().selection.active(), output);
}

TEST(Statistics, are_one_line_in_plain_words)
{
    ui::PictureReading picture;
    picture.width = 1280;
    picture.height = 720;
    picture.device = "cpu";
    picture.draw_ms = 24.2f;
    picture.mean_steps = 31.4f;
    picture.max_steps = 256;
    picture.exhausted_share = 0.002f;
    EXPECT_EQ(ui::statistics_text(picture),
              "1280 × 720 · cpu · 24.2 ms · 31.4 steps mean, 256 max · 0.200 % out of steps");
}

}  // namespace
}  // namespace fieldwright
