// Hands on the inspector: one gesture is one named step that changes what was meant and nothing else.
#include "graph/scene_file.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"
#include "ui/number_text.h"
#include "ui/srgb.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

namespace fieldwright::tests {
namespace {

using graph::NodeId;
using graph::Value;

// One node of a type, selected.
struct OneNode {
    explicit OneNode(std::string_view type, glm::vec2 size_px = {1280, 1000}) : driver(graph::Document{}, size_px)
    {
        driver.editor.view.panes.inspector_share = 0.85f;
        become(type);
    }
    // Starts again with a node of another type.
    void become(std::string_view type)
    {
        driver.document = {};
        id = graph::add_node(driver.document, *driver.library, type);
        driver.steps = {{driver.document, "start"}};
        driver.step = 0;
        driver.editor.view.selection.only(id);
        driver.frames(2);
    }

    const graph::Node& node() const { return *driver.document.root.find(id); }
    template <typename T>
    T value(std::string_view name) const
    {
        return std::get<T>(*node().parameter(name));
    }
    // What the document would be with one other value.
    graph::Document with(std::string_view name, Value value) const
    {
        graph::Document document = driver.steps.front().first;
        EXPECT_EQ(graph::set_parameter(document, *driver.library, id, name, std::move(value)), std::nullopt);
        return document;
    }
    void type_into(std::string_view widget, std::string_view text)
    {
        driver.move(driver.place(widget));
        driver.queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_control, .down = true});
        driver.press();
        driver.release();
        driver.queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_control, .down = false});
        driver.run_until_quiet();
        driver.type(text);
    }
    void enter() { driver.key(ui::key::enter); }

    Driver driver;
    NodeId id;
};

void drag_right(Driver& driver, std::string_view widget, float px)
{
    glm::vec2 from = driver.place(widget);
    driver.drag(from, from + glm::vec2(px, 0));
}

TEST(Inspector, a_picture_is_chosen_from_a_file)
{
    OneNode image("image");
    image.driver.click("inspector/picture");
    ASSERT_EQ(image.driver.requests.size(), 1u);
    const auto* asked = std::get_if<ui::ChooseFile>(&image.driver.requests[0]);
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->then, ui::ChooseFile::Then::picture);
    EXPECT_EQ(asked->node, image.id);
    EXPECT_EQ(image.driver.document, image.driver.steps.front().first);
}

TEST(Inspector, dragging_a_number_is_one_step_and_changes_nothing_else)
{
    OneNode torus("torus");
    drag_right(torus.driver, "inspector/minor", 60);
    ASSERT_EQ(torus.driver.steps.size(), 2u);
    EXPECT_EQ(torus.driver.steps[1].second, "Change torus minor");
    auto minor = torus.value<float>("minor");
    EXPECT_GT(minor, 0.25f);
    EXPECT_EQ(torus.driver.document, torus.with("minor", minor));
}

TEST(Inspector, shift_drags_finely)
{
    OneNode torus("torus");
    drag_right(torus.driver, "inspector/major", 60);
    float coarse = torus.value<float>("major") - 1;
    torus.driver.click("inspector/major/reset");
    torus.driver.queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_shift, .down = true});
    drag_right(torus.driver, "inspector/major", 60);
    float fine = torus.value<float>("major") - 1;
    EXPECT_GT(fine, 0);
    EXPECT_LT(fine, 0.3f * coarse);
}

TEST(Inspector, escape_gives_up_a_drag)
{
    OneNode torus("torus");
    glm::vec2 from = torus.driver.place("inspector/major");
    torus.driver.move(from);
    torus.driver.press();
    torus.driver.move(from + glm::vec2(50, 0));
    EXPECT_NE(torus.value<float>("major"), 1.0f);
    torus.driver.key(ui::key::escape);
    torus.driver.release();
    EXPECT_EQ(torus.value<float>("major"), 1.0f);
    EXPECT_EQ(torus.driver.steps.size(), 1u);
}

TEST(Inspector, a_typed_value_is_one_step)
{
    OneNode torus("torus");
    torus.type_into("inspector/minor", "0.125");
    torus.enter();
    ASSERT_EQ(torus.driver.steps.size(), 2u);
    EXPECT_EQ(torus.driver.document, torus.with("minor", 0.125f));
}

TEST(Inspector, units_may_be_typed)
{
    OneNode torus("torus");
    torus.type_into("inspector/major", "35 cm");
    torus.enter();
    EXPECT_FLOAT_EQ(torus.value<float>("major"), 0.35f);
}

TEST(Inspector, enter_over_a_field_begins_typing)
{
    OneNode torus("torus");
    torus.driver.move(torus.driver.place("inspector/major"));
    torus.enter();
    torus.driver.type("2.5");
    torus.enter();
    EXPECT_EQ(torus.value<float>("major"), 2.5f);
}

TEST(Inspector, a_double_click_begins_typing)
{
    OneNode torus("torus");
    torus.driver.double_click(torus.driver.place("inspector/major"));
    torus.driver.type("3");
    torus.driver.click(glm::vec2(10, 500));  // anywhere else ends it
    EXPECT_EQ(torus.value<float>("major"), 3.0f);
    EXPECT_EQ(torus.driver.steps.size(), 2u);
}

TEST(Inspector, a_typed_value_out_of_range_is_clamped)
{
    OneNode torus("torus");
    torus.type_into("inspector/minor", "5000");
    torus.enter();
    EXPECT_EQ(torus.value<float>("minor"), 100.0f);
    torus.type_into("inspector/minor", "-3");
    torus.enter();
    EXPECT_EQ(torus.value<float>("minor"), 0.001f);
}

TEST(Inspector, typing_and_then_dragging_another_field_are_two_steps)
{
    OneNode torus("torus");
    torus.type_into("inspector/minor", "0.125");
    drag_right(torus.driver, "inspector/major", 40);
    ASSERT_EQ(torus.driver.steps.size(), 3u);
    EXPECT_EQ(torus.driver.steps[1].first, torus.with("minor", 0.125f));
    EXPECT_EQ(torus.driver.steps[2].second, "Change torus major");
}

TEST(Inspector, typed_nonsense_keeps_the_old_value)
{
    OneNode torus("torus");
    torus.type_into("inspector/minor", "7 apples");
    torus.enter();
    EXPECT_EQ(torus.driver.document, torus.driver.steps.front().first);
    EXPECT_EQ(torus.driver.steps.size(), 1u);
}

TEST(Inspector, escape_gives_up_typing)
{
    OneNode torus("torus");
    torus.type_into("inspector/minor", "0.7");
    torus.driver.key(ui::key::escape);
    EXPECT_EQ(torus.value<float>("minor"), 0.25f);
    EXPECT_EQ(torus.driver.steps.size(), 1u);
}

TEST(Inspector, reset_is_offered_only_away_from_the_default_and_restores_it)
{
    OneNode torus("torus");
    EXPECT_FALSE(torus.driver.shows("inspector/major/reset"));
    drag_right(torus.driver, "inspector/major", 40);
    torus.driver.click("inspector/major/reset");
    EXPECT_EQ(torus.value<float>("major"), 1.0f);
    EXPECT_EQ(torus.driver.steps.back().second, "Reset torus major");
    torus.driver.frame();
    EXPECT_FALSE(torus.driver.shows("inspector/major/reset"));
}

TEST(Inspector, a_formula_is_kept_while_it_can_be_read)
{
    OneNode node("expression");
    node.driver.click("inspector/formula");
    node.driver.key(ui::key::a, true);
    node.driver.type("a ");
    node.driver.type("* sin(x");
    EXPECT_EQ(node.value<std::string>("formula"), "a ") << "the last that could be read";
    EXPECT_TRUE(node.driver.shows("inspector/formula/error"));
    node.driver.type(")");
    EXPECT_EQ(node.value<std::string>("formula"), "a * sin(x)");
    EXPECT_FALSE(node.driver.shows("inspector/formula/error"));
    EXPECT_EQ(node.driver.steps.size(), 1u) << "typing is one gesture";
    node.enter();
    ASSERT_EQ(node.driver.steps.size(), 2u);
    EXPECT_EQ(node.driver.document, node.with("formula", std::string("a * sin(x)")));
}

TEST(Inspector, what_is_typed_of_a_formula_is_not_lost)
{
    OneNode node("implicit");
    auto type_half = [&] {
        node.driver.click("inspector/formula");
        node.driver.key(ui::key::a, true);
        node.driver.type("x^2 + (y");
    };
    type_half();
    node.enter();
    EXPECT_EQ(node.value<std::string>("formula"), "x^2 + (y");
    EXPECT_TRUE(node.driver.shows("inspector/formula/error"));
    node.driver.click("inspector/formula/reset");
    EXPECT_FALSE(node.driver.shows("inspector/formula/error"));
    type_half();
    node.driver.click("inspector/k");
    EXPECT_EQ(node.value<std::string>("formula"), "x^2 + (y") << "a field drawn earlier took the keyboard";
    node.driver.click("inspector/formula/reset");
    std::string before = node.value<std::string>("formula");
    type_half();
    node.driver.key(ui::key::escape);
    EXPECT_EQ(node.value<std::string>("formula"), before);
}

TEST(Inspector, a_text_is_typed_line_by_line)
{
    OneNode node("number");
    std::map<std::string, std::string> texts = graph::embedded_texts();
    texts["nodes/value/words.glsl"] =
        "// Words: what is written.\n// text motto: \"Ag\"  What it says.\n"
        "float words_value(\n    float x)  // 1.0 [0, 9]  A number.\n{\n    return x;\n}\n";
    node.driver.library = graph::Library::from_texts(texts, graph::embedded_texts());
    node.become("words");
    node.driver.click("inspector/motto");
    node.driver.key(ui::key::a, true);
    node.driver.type("one");
    node.enter();
    node.driver.type("two");
    node.driver.click(glm::vec2(10, 500));
    EXPECT_EQ(node.value<std::string>("motto"), "one\ntwo");
    EXPECT_EQ(node.driver.steps.size(), 2u);
}

TEST(Inspector, a_point_of_a_curve_is_dragged_between_its_neighbours)
{
    OneNode curve("curve");
    auto points = curve.value<graph::PointList>("points");
    glm::vec2 from = curve.driver.place("inspector/points/curve/1");
    curve.driver.drag(from, from + glm::vec2(10, -20));
    auto moved = curve.value<graph::PointList>("points");
    ASSERT_EQ(moved.size(), points.size());
    EXPECT_GT(moved[1].x, points[1].x);
    EXPECT_GT(moved[1].y, points[1].y);
    EXPECT_EQ(moved[2], points[2]);
    EXPECT_EQ(curve.driver.steps.size(), 2u);
    curve.driver.drag(curve.driver.place("inspector/points/curve/1"), from + glm::vec2(2000, 0));
    EXPECT_EQ(curve.value<graph::PointList>("points")[1].x, points[2].x) << "no farther than the next point";
}

TEST(Inspector, points_of_a_curve_are_added_by_double_click_and_taken_by_right_click)
{
    OneNode curve("curve");
    glm::vec2 a = curve.driver.place("inspector/points/curve/0"), b = curve.driver.place("inspector/points/curve/1");
    curve.driver.double_click({0.5f * (a.x + b.x), b.y});
    auto points = curve.value<graph::PointList>("points");
    ASSERT_EQ(points.size(), 5u);
    EXPECT_NEAR(points[1].x, 0.175f, 0.01f);
    EXPECT_NEAR(points[1].y, 0.75f, 0.01f);
    curve.driver.click("inspector/points/curve/1", 1);
    ASSERT_EQ(curve.value<graph::PointList>("points").size(), 4u);
    EXPECT_EQ(curve.value<graph::PointList>("points")[1].x, 0.35f);
    EXPECT_EQ(curve.driver.steps.size(), 3u);
}

TEST(Inspector, a_smooth_combiner_shows_its_blend)
{
    OneNode node("smooth_union");
    EXPECT_FALSE(node.driver.shows("inspector/blend"));
    node.driver.readings.blend_of = [&](NodeId id) -> std::optional<ui::BlendCurve> {
        if (id != node.id || node.node().type != "smooth_union") return std::nullopt;
        return ui::BlendCurve{0.5f,      false, {-1, 0, 1}, {-0.5f, 0, 0.5f}, {0.5f, 0, -0.5f}, {-0.5f, -0.1f, -0.5f},
                              {1, 0, -1}};
    };
    node.driver.frames(2);
    EXPECT_TRUE(node.driver.shows("inspector/blend"));
    EXPECT_TRUE(node.driver.shows("inspector/blend/slope"));
    node.become("union");
    EXPECT_FALSE(node.driver.shows("inspector/blend"));
}

TEST(Inspector, a_component_of_a_vector_changes_alone)
{
    OneNode box("box");
    drag_right(box.driver, "inspector/half_size/y", 40);
    auto size = box.value<glm::vec3>("half_size");
    EXPECT_EQ(size.x, 0.5f);
    EXPECT_GT(size.y, 0.5f);
    EXPECT_EQ(size.z, 0.5f);
    EXPECT_EQ(box.driver.steps.size(), 2u);
}

TEST(Inspector, a_choice_is_picked_from_its_words)
{
    OneNode mirror("mirror");
    mirror.driver.click("inspector/axis");
    mirror.driver.click("inspector/axis/choice/z");
    EXPECT_EQ(mirror.driver.document, mirror.with("axis", std::string("z")));
    EXPECT_EQ(mirror.driver.steps.size(), 2u);
}

TEST(Inspector, a_boolean_is_flipped_by_a_click)
{
    OneNode polyline("polyline");
    polyline.driver.click("inspector/closed");
    EXPECT_EQ(polyline.driver.document, polyline.with("closed", true));
    EXPECT_EQ(polyline.driver.steps.size(), 2u);
}

TEST(Inspector, an_angle_is_typed_and_stored_in_degrees)
{
    OneNode sun("sun");
    sun.type_into("inspector/elevation", "30 deg");
    sun.enter();
    EXPECT_EQ(sun.value<float>("elevation"), 30.0f);
}

TEST(Inspector, an_integer_stays_whole)
{
    OneNode polygon("regular_polygon");
    drag_right(polygon.driver, "inspector/sides", 30);
    EXPECT_GT(polygon.value<int>("sides"), 6);
    polygon.type_into("inspector/sides", "7.6");
    polygon.enter();
    EXPECT_EQ(polygon.value<int>("sides"), 8);
}

TEST(Inspector, a_typed_colour_is_kept_linear_and_shown_as_typed)
{
    OneNode phong("phong");
    phong.driver.double_click(phong.driver.place("inspector/albedo/hex"));
    phong.driver.key('A', true);
    phong.driver.type("#3a7bd5");
    phong.enter();
    auto linear = phong.value<glm::vec3>("albedo");
    EXPECT_NEAR(linear.x, 0.0423f, 1e-3f);
    EXPECT_EQ(ui::hex_text(ui::srgb_from_linear(linear)), "#3a7bd5");
    EXPECT_EQ(phong.driver.steps.size(), 2u);
}

TEST(Inspector, dragging_in_the_colour_picker_is_one_step)
{
    OneNode phong("phong");
    phong.driver.click("inspector/albedo");
    ASSERT_TRUE(phong.driver.shows("inspector/albedo/picker"));
    glm::vec2 at = phong.driver.place("inspector/albedo/picker");
    phong.driver.drag(at + glm::vec2(-40, -20), at + glm::vec2(20, 30));
    EXPECT_EQ(phong.driver.steps.size(), 2u);
    EXPECT_NE(phong.driver.document, phong.driver.steps.front().first);
}

TEST(Srgb, every_byte_survives_the_way_to_linear_and_back)
{
    for (int byte = 0; byte < 256; ++byte) {
        float c = static_cast<float>(byte) / 255;
        EXPECT_NEAR(ui::srgb_from_linear(ui::linear_from_srgb(glm::vec3(c))).x, c, 1e-5f);
        EXPECT_EQ(ui::parse_hex(ui::hex_text(glm::vec3(c)))->y, c);
    }
    EXPECT_EQ(ui::parse_hex("#f80"), glm::vec3(1, 136.0f / 255, 0));
    for (const char* nonsense : {"", "#", "#12345", "#gggggg", "red", "#1234567"})
        EXPECT_FALSE(ui::parse_hex(nonsense)) << nonsense;
}

TEST(NumberText, reads_what_people_type)
{
    EXPECT_EQ(ui::parse_number(" 0.25 ", "m"), 0.25);
    EXPECT_EQ(ui::parse_number("-.5", ""), -0.5);
    EXPECT_EQ(ui::parse_number("0,5 m", "m"), 0.5);
    EXPECT_NEAR(*ui::parse_number("65 mm", "m"), 0.065, 1e-12);
    EXPECT_NEAR(*ui::parse_number("0.065 m", "mm"), 65, 1e-9);
    EXPECT_EQ(ui::parse_number("1/4", "m"), 0.25);
    EXPECT_EQ(ui::parse_number("90 deg", "deg"), 90);
    for (const char* nonsense : {"", "m", "1 s", "1..2", "nan", "inf", "1/0", "--1", "1 2"})
        EXPECT_FALSE(ui::parse_number(nonsense, "m")) << nonsense;
}

TEST(NumberText, shows_as_many_decimals_as_the_number_has)
{
    EXPECT_EQ(ui::number_text(1, 2), "1.00");
    EXPECT_EQ(ui::number_text(0.055f, 2), "0.055");
    EXPECT_EQ(ui::number_text(0.0001f, 2), "0.0001");
    EXPECT_EQ(ui::number_text(-0.0f, 2), "0.00");
}

TEST(Inspector, a_wired_parameter_shows_its_source_and_can_be_unwired)
{
    OneNode sphere("sphere");
    NodeId number = graph::add_node(sphere.driver.document, *sphere.driver.library, "number");
    ASSERT_EQ(graph::connect(sphere.driver.document, *sphere.driver.library, number, sphere.id, "radius"),
              std::nullopt);
    sphere.driver.steps = {{sphere.driver.document, "start"}};
    sphere.driver.frames(2);
    sphere.driver.click("inspector/radius");
    EXPECT_EQ(sphere.driver.editor.view.selection.active(), number);
    sphere.driver.editor.view.selection.only(sphere.id);
    sphere.driver.frames(2);
    sphere.driver.click("inspector/radius/unwire");
    EXPECT_FALSE(sphere.node().input("radius"));
    EXPECT_EQ(sphere.driver.steps.back().second, "Unwire sphere radius");
}

TEST(Inspector, a_field_input_shows_its_source)
{
    OneNode move("translate");
    NodeId sphere = graph::add_node(move.driver.document, *move.driver.library, "sphere");
    ASSERT_EQ(graph::connect(move.driver.document, *move.driver.library, sphere, move.id, "d"), std::nullopt);
    move.driver.frames(2);
    move.driver.click("inspector/input/d");
    EXPECT_EQ(move.driver.editor.view.selection.active(), sphere);
}

TEST(Inspector, a_name_is_typed_as_one_step)
{
    OneNode torus("torus");
    torus.driver.click("inspector/name");
    torus.driver.type("Wedding ring");
    torus.enter();
    EXPECT_EQ(torus.node().name, "Wedding ring");
    ASSERT_EQ(torus.driver.steps.size(), 2u);
    EXPECT_TRUE(torus.driver.steps[1].second.starts_with("Rename "));
}

TEST(Inspector, mute_is_a_step)
{
    OneNode torus("torus");
    torus.driver.click("inspector/mute");
    EXPECT_TRUE(torus.node().muted);
    EXPECT_EQ(torus.driver.steps.back().second, "Mute torus");
}

TEST(Inspector, points_are_added_moved_and_deleted)
{
    OneNode line("polyline");
    auto points = [&] { return line.value<graph::PointList>("points"); };
    line.driver.click("inspector/points/add");
    ASSERT_EQ(points().size(), 5u);
    line.driver.click("inspector/points/0/down");
    EXPECT_EQ(points()[1], glm::vec4(-0.7f, -0.4f, 0, 0));
    line.driver.click("inspector/points/1/delete");
    ASSERT_EQ(points().size(), 4u);
    glm::vec2 at = line.driver.place("inspector/points/picture/1");
    graph::PointList before = points();
    line.driver.drag(at, at + glm::vec2(20, -10));
    EXPECT_GT(points()[1].x, before[1].x);
    EXPECT_GT(points()[1].y, before[1].y);
    EXPECT_EQ(points()[0], before[0]);
    EXPECT_EQ(line.driver.steps.size(), 5u);
}

TEST(Inspector, without_a_selection_it_shows_the_scene)
{
    Driver driver(graph::Document{}, {1280, 1600});
    driver.editor.view.panes.inspector_share = 0.85f;
    drag_right(driver, "inspector/scene/occlusion/strength", -50);
    EXPECT_LT(driver.document.occlusion.strength, 1.0f);
    EXPECT_EQ(driver.steps.back().second, "Change strength");
    driver.click("inspector/scene/out_of_steps/hit");
    EXPECT_TRUE(driver.document.march.out_of_steps_hits);
    EXPECT_EQ(driver.steps.size(), 3u);
    drag_right(driver, "inspector/scene/bounces", 60);
    EXPECT_GT(driver.document.bounces, 0);
    EXPECT_EQ(driver.steps.back().second, "Change bounces");
    drag_right(driver, "inspector/scene/fog/density", 40);
    EXPECT_GT(driver.document.fog.density, 0);
}

TEST(Inspector, shows_how_the_scene_becomes_a_picture)
{
    Driver driver(graph::Document{}, {1280, 2400});
    driver.editor.view.panes.inspector_share = 0.85f;
    driver.click("inspector/scene/tone_map/agx");
    EXPECT_EQ(driver.document.picture.tone_map, graph::ToneMap::agx);
    EXPECT_EQ(driver.steps.back().second, "Change tone map");
    EXPECT_FALSE(driver.shows("inspector/scene/backdrop_colour"));
    driver.click("inspector/scene/backdrop/colour");
    EXPECT_EQ(driver.document.picture.backdrop, graph::Backdrop::colour);
    EXPECT_TRUE(driver.shows("inspector/scene/backdrop_colour"));
    drag_right(driver, "inspector/scene/samples", 40);
    EXPECT_GT(driver.document.picture.samples, 16);
    drag_right(driver, "inspector/scene/last_frame", 40);
    EXPECT_GT(driver.document.animation.last_frame, 120);
    EXPECT_EQ(driver.steps.back().second, "Change last frame");
}

TEST(Inspector, shows_the_marching_settings_that_matter)
{
    Driver driver(graph::Document{}, {1280, 1600});
    driver.editor.view.panes.inspector_share = 0.85f;
    EXPECT_TRUE(driver.shows("inspector/scene/minimum_step"));
    EXPECT_FALSE(driver.shows("inspector/scene/constant_step"));
    EXPECT_FALSE(driver.shows("inspector/scene/step_scale"));
    driver.click("inspector/scene/step_scale_from/own");
    EXPECT_TRUE(driver.document.march.own_step_scale);
    EXPECT_EQ(driver.steps.back().second, "Change step scale");
    EXPECT_TRUE(driver.shows("inspector/scene/step_scale"));
    driver.click("inspector/scene/method/constant_steps");
    EXPECT_TRUE(driver.document.march.constant_steps);
    EXPECT_TRUE(driver.shows("inspector/scene/constant_step"));
    EXPECT_FALSE(driver.shows("inspector/scene/minimum_step"));
    driver.click("inspector/scene/normals/central");
    EXPECT_TRUE(driver.document.march.central_normals);
    driver.click("inspector/scene/anti_aliasing/coverage");
    EXPECT_TRUE(driver.document.march.coverage);
    driver.click("inspector/scene/occlusion/kind/smallest_ratio");
    EXPECT_TRUE(driver.document.occlusion.smallest_ratio);
    drag_right(driver, "inspector/scene/occlusion/samples", 60);
    EXPECT_GT(driver.document.occlusion.samples, 5);
    float radius = driver.document.occlusion.radius;
    int samples = driver.document.occlusion.samples;
    drag_right(driver, "inspector/scene/occlusion/step", 40);
    EXPECT_GT(driver.document.occlusion.radius, radius) << "samples as far apart as the step reach as far";
    EXPECT_EQ(driver.document.occlusion.samples, samples);
    EXPECT_EQ(driver.steps.back().second, "Change step");
}

TEST(Inspector, several_selected_edits_the_active_one)
{
    OneNode torus("torus");
    NodeId sphere = graph::add_node(torus.driver.document, *torus.driver.library, "sphere");
    torus.driver.editor.view.selection.add(sphere);
    torus.driver.frames(2);
    EXPECT_TRUE(torus.driver.shows("inspector/several"));
    EXPECT_TRUE(torus.driver.shows("inspector/radius"));
    EXPECT_FALSE(torus.driver.shows("inspector/major"));
}

TEST(Inspector, an_unknown_type_says_that_it_is_kept)
{
    std::string text = R"({"format": "fieldwright", "version": 1, "next_id": 2, "march": {}, "occlusion": {}, "graphs":
        {"root": {"nodes": {"1": {"type": "gyroid_from_the_future", "parameters": {}, "inputs": {}}}}}})";
    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    Driver driver(graph::read_scene(text, *library));
    driver.editor.view.selection.only({1});
    driver.frames(2);
    EXPECT_TRUE(driver.shows("inspector/unknown"));
}

// Drags a number of the node, and back when it stood at its end; expects one step that changed nothing else.
void expect_draggable(OneNode& node, const graph::Parameter& parameter, const std::string& widget)
{
    Driver& driver = node.driver;
    graph::Document before = driver.document;
    std::size_t steps = driver.steps.size();
    drag_right(driver, widget, 40);
    if (driver.document == before) drag_right(driver, widget, -40);
    EXPECT_NE(driver.document, before);
    EXPECT_EQ(driver.steps.size(), steps + 1);
    EXPECT_EQ(graph::validate(driver.document, *driver.library), std::nullopt);
    Value dragged = *node.node().parameter(parameter.name);
    EXPECT_EQ(graph::set_parameter(before, *driver.library, node.id, parameter.name, dragged), std::nullopt);
    EXPECT_EQ(driver.document, before) << "something else changed, too";
}

TEST(Inspector, has_a_row_for_every_parameter_of_every_type_and_every_number_drags)
{
    OneNode node("torus", {1280, 1600});
    for (const graph::NodeType* type : node.driver.library->types()) {
        node.become(type->name);
        for (const graph::Parameter& parameter : type->parameters) {
            SCOPED_TRACE(type->name + "." + parameter.name);
            std::string widget = "inspector/" + parameter.name;
            EXPECT_TRUE(node.driver.shows(widget));
            using Kind = graph::ParameterKind;
            bool vector =
                parameter.kind == Kind::vec2 || parameter.kind == Kind::vec3 || parameter.kind == Kind::angles;
            bool number =
                parameter.kind == Kind::number || parameter.kind == Kind::integer || parameter.kind == Kind::angle;
            if (vector) expect_draggable(node, parameter, widget + "/x");
            if (number) expect_draggable(node, parameter, widget);
        }
    }
}

TEST(Inspector, nothing_is_wider_than_its_column_at_any_width)
{
    OneNode node("torus", {1280, 1600});
    for (float width : {280.0f, 340.0f, 420.0f, 500.0f}) {
        node.driver.editor.view.panes.side_width = width;
        for (const graph::NodeType* type : node.driver.library->types()) {
            node.become(type->name);
            for (const auto& [name, rect] : node.driver.editor.rects.all()) {
                if (!name.starts_with("inspector/") || name.find("/picture/") != std::string::npos) continue;
                EXPECT_GE(rect.low.x, 1280 - width) << type->name << " " << name;
                EXPECT_LE(rect.high.x, 1280) << type->name << " " << name;
            }
        }
    }
}

}  // namespace
}  // namespace fieldwright::tests
