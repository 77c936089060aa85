// The hands on the node canvas: each gesture is one step, and undoing it gives the equal document.
#include "tests/ui/driver.h"

#include "ui/canvas_painter.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

#include <random>

namespace fieldwright::tests {
namespace {

using graph::NodeId;

// A scene built node by node, and a window that is mostly canvas.
class CanvasTest : public testing::Test {
protected:
    NodeId add(std::string_view type, glm::vec2 position) { return graph::add_node(start, *library, type, position); }
    void wire(NodeId source, NodeId target, std::string_view socket)
    {
        graph::Refusal refusal = graph::connect(start, *library, source, target, socket);
        ASSERT_FALSE(refusal) << *refusal;
    }
    Driver& open()
    {
        driver.emplace(start);
        driver->editor.view.panes.canvas_share = 0.9f;
        driver->editor.view.canvas = {{20, 20}, 1};
        driver->editor.view.minimap = false;
        driver->frames(2);
        return *driver;
    }
    static std::string name(NodeId id) { return "canvas/node/" + std::to_string(id.number); }
    glm::vec2 header(NodeId id) { return driver->place(name(id) + "/header"); }
    glm::vec2 in(NodeId id, const std::string& socket) { return driver->place(name(id) + "/in/" + socket); }
    glm::vec2 out(NodeId id) { return driver->place(name(id) + "/out"); }
    const graph::Node& node(NodeId id) { return *driver->document.root.find(id); }
    NodeId newest() { return driver->document.root.nodes.back().id; }

    // The gesture made one step of this name, and undoing it leads back to where it began.
    void expect_one_step(std::string_view step_name)
    {
        ASSERT_EQ(driver->steps.size(), 2u);
        EXPECT_EQ(driver->steps[1].second, step_name);
        EXPECT_EQ(driver->document, driver->steps[1].first);
        EXPECT_EQ(driver->steps[0].first, start);
        EXPECT_FALSE(graph::validate(driver->document, *library));
    }
    void expect_no_step()
    {
        EXPECT_EQ(driver->steps.size(), 1u);
        EXPECT_EQ(driver->document, start);
    }

    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    graph::Document start;
    std::optional<Driver> driver;
};

TEST_F(CanvasTest, a_node_that_follows_another_knows_it)
{
    NodeId sky = add("sun_and_sky", {0, 0}), other_sky = add("gradient", {200, 0}), sun = add("sun", {400, 0});
    auto leader = [&](NodeId node) { return ui::CanvasLayout(start.root, *library, {}, {}).find(node)->leader; };
    ASSERT_TRUE(leader(sky));
    EXPECT_EQ(leader(sky)->id, sun);
    EXPECT_FALSE(leader(other_sky));
    EXPECT_FALSE(leader(sun));
    ASSERT_FALSE(graph::set_parameter(start, *library, sky, "follow_sun", false));
    EXPECT_FALSE(leader(sky));
}

TEST_F(CanvasTest, a_wire_is_dragged_from_output_to_input)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {300, 0});
    open().drag(out(sphere), in(output, "d"));
    EXPECT_EQ(node(output).input("d"), sphere);
    expect_one_step("Connect");
}

TEST_F(CanvasTest, a_wire_is_dragged_from_input_to_output)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {300, 0});
    open().drag(in(output, "d"), out(sphere));
    EXPECT_EQ(node(output).input("d"), sphere);
    expect_one_step("Connect");
}

TEST_F(CanvasTest, a_wire_dropped_on_a_node_takes_the_nearest_input_that_fits)
{
    NodeId number = add("number", {0, 0}), torus = add("torus", {300, 0});
    open();
    driver->drag(out(number), in(torus, "minor") + glm::vec2(60, 0));
    EXPECT_EQ(node(torus).input("minor"), number);
    expect_one_step("Connect");
}

TEST_F(CanvasTest, a_new_wire_replaces_the_old_one)
{
    NodeId sphere = add("sphere", {0, 0}), box = add("box", {0, 120}), output = add("output", {300, 0});
    wire(sphere, output, "d");
    open().drag(out(box), in(output, "d"));
    EXPECT_EQ(node(output).input("d"), box);
    expect_one_step("Connect");
}

TEST_F(CanvasTest, a_cycle_is_refused_with_its_reason)
{
    NodeId first = add("round", {0, 0}), second = add("round", {300, 0});
    wire(first, second, "d");
    open();
    driver->move(out(second));
    driver->press();
    driver->move(in(first, "d"));
    const ui::Wiring* wiring = driver->editor.canvas().doing<ui::Wiring>();
    ASSERT_TRUE(wiring);
    EXPECT_NE(wiring->reason.find("cycle"), std::string::npos) << wiring->reason;
    driver->release();
    expect_no_step();
}

TEST_F(CanvasTest, what_does_not_fit_is_refused_with_its_reason)
{
    NodeId sphere = add("sphere", {0, 0}), paint = add("paint", {300, 0});
    open();
    driver->move(out(sphere));
    driver->press();
    driver->move(in(paint, "material"));
    const ui::Wiring* wiring = driver->editor.canvas().doing<ui::Wiring>();
    ASSERT_TRUE(wiring);
    EXPECT_TRUE(wiring->targets.fits(paint, "d"));
    EXPECT_FALSE(wiring->targets.fits(paint, "material"));
    EXPECT_NE(wiring->reason.find("material"), std::string::npos) << wiring->reason;
    driver->release();
    expect_no_step();
}

TEST_F(CanvasTest, a_wire_dropped_on_a_node_where_nothing_fits_says_why)
{
    NodeId number = add("number", {0, 0}), both = add("union", {300, 0}), paint = add("paint", {300, 200});
    open().drag(out(number), header(both));
    EXPECT_EQ(driver->editor.status_text(), "No input of “Union” takes a number, which “Number” gives");
    expect_no_step();
    driver->drag(out(both), header(both));
    EXPECT_EQ(driver->editor.status_text(), "No input of “Union” takes a number, which “Number” gives") << "a slip";
    driver->drag(out(paint), in(paint, "material") + glm::vec2(0, 1));
    EXPECT_NE(driver->editor.status_text().find("“Paint” gives a shape and cannot feed “Material”"), std::string::npos)
        << driver->editor.status_text();
    driver->drag(out(both), in(paint, "material"));
    EXPECT_EQ(driver->editor.status_text(),
              "“Union” gives a shape and cannot feed “Material” of “Paint”, which takes a material; “Shape” takes it");
    expect_no_step();
}

TEST_F(CanvasTest, renaming_a_node_of_unknown_type_says_why_not)
{
    NodeId sphere = add("sphere", {40, 40});
    start.root.find(sphere)->type = "warp";
    start.root.find(sphere)->parameters.clear();
    start.root.find(sphere)->unknown_source = "{\"type\": \"warp\"}";
    open().double_click(header(sphere));
    driver->frames(2);
    EXPECT_EQ(driver->editor.status_text().find("“warp” is of a type this version does not know"), 0u);
    EXPECT_FALSE(driver->shows("canvas/rename"));
    expect_no_step();
}

TEST_F(CanvasTest, a_wire_dragged_off_its_input_is_detached)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {300, 0});
    wire(sphere, output, "d");
    open().drag(in(output, "d"), in(output, "d") + glm::vec2(-60, 200));
    EXPECT_FALSE(node(output).input("d"));
    EXPECT_FALSE(driver->shows("add_menu/search"));
    expect_one_step("Disconnect");
}

TEST_F(CanvasTest, a_detached_wire_moves_to_another_input_in_one_step)
{
    NodeId sphere = add("sphere", {0, 0}), both = add("union", {300, 0});
    wire(sphere, both, "a");
    open().drag(in(both, "a"), in(both, "b"));
    EXPECT_FALSE(node(both).input("a"));
    EXPECT_EQ(node(both).input("b"), sphere);
    expect_one_step("Connect");
}

TEST_F(CanvasTest, a_detached_wire_put_back_changes_nothing)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {300, 0});
    wire(sphere, output, "d");
    open();
    driver->move(in(output, "d"));
    driver->press();
    driver->move(in(output, "d") + glm::vec2(-50, 50));
    driver->move(in(output, "d"));
    driver->release();
    expect_no_step();
}

TEST_F(CanvasTest, escape_lets_a_wire_go)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {300, 0});
    open();
    driver->move(out(sphere));
    driver->press();
    driver->move(in(output, "d"));
    driver->key(ui::key::escape);
    driver->release();
    EXPECT_FALSE(driver->editor.canvas().busy());
    expect_no_step();
}

TEST_F(CanvasTest, a_wire_dropped_into_empty_space_offers_what_fits_and_connects_the_pick)
{
    NodeId sphere = add("sphere", {0, 0});
    open();
    driver->drag(out(sphere), out(sphere) + glm::vec2(250, 60));
    ASSERT_TRUE(driver->shows("add_menu/search"));
    driver->type("phong");
    EXPECT_FALSE(driver->shows("add_menu/item/phong"));
    for (int i = 0; i < 5; ++i) driver->key(ui::key::backspace);
    driver->type("smooth un");
    driver->click("add_menu/item/smooth_union");
    EXPECT_EQ(node(newest()).type, "smooth_union");
    EXPECT_EQ(node(newest()).input("a"), sphere);
    EXPECT_EQ(driver->editor.view.selection.active(), newest());
    expect_one_step("Add smooth union");
}

TEST_F(CanvasTest, escape_in_the_filtered_menu_adds_nothing)
{
    NodeId sphere = add("sphere", {0, 0});
    open().drag(out(sphere), out(sphere) + glm::vec2(250, 60));
    ASSERT_TRUE(driver->shows("add_menu/search"));
    driver->key(ui::key::escape);
    EXPECT_FALSE(driver->shows("add_menu/search"));
    expect_no_step();
}

TEST_F(CanvasTest, a_node_dropped_on_a_wire_is_inserted)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {500, 0}), twist = add("twist", {200, 300});
    wire(sphere, output, "d");
    open();
    glm::vec2 onto = driver->place("canvas/wire/" + std::to_string(output.number) + "/d");
    driver->drag(header(twist), onto);
    EXPECT_EQ(node(twist).input("d"), sphere);
    EXPECT_EQ(node(output).input("d"), twist);
    expect_one_step("Insert into wire");
}

TEST_F(CanvasTest, with_alt_a_node_dropped_on_a_wire_only_moves)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {500, 0}), twist = add("twist", {200, 300});
    wire(sphere, output, "d");
    open();
    glm::vec2 onto = driver->place("canvas/wire/" + std::to_string(output.number) + "/d");
    driver->move(header(twist));
    driver->press();
    driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_alt, .down = true});
    driver->move(onto);
    driver->release();
    EXPECT_EQ(node(output).input("d"), sphere);
    expect_one_step("Move node");
}

TEST_F(CanvasTest, what_does_not_fit_a_wire_only_moves)
{
    NodeId sphere = add("sphere", {0, 0}), output = add("output", {500, 0}), phong = add("phong", {200, 300});
    wire(sphere, output, "d");
    open();
    driver->drag(header(phong), driver->place("canvas/wire/" + std::to_string(output.number) + "/d"));
    EXPECT_EQ(node(output).input("d"), sphere);
    expect_one_step("Move node");
}

TEST_F(CanvasTest, boxed_nodes_move_together_in_one_step)
{
    NodeId sphere = add("sphere", {40, 40}), box = add("box", {40, 160}), far_one = add("cone", {500, 300});
    open();
    driver->drag(header(sphere) + glm::vec2(-110, -30), header(box) + glm::vec2(40, 40));
    EXPECT_EQ(driver->editor.view.selection.as_set(), (std::set<NodeId>{sphere, box}));
    EXPECT_EQ(driver->steps.size(), 1u) << "selecting is no step";
    driver->drag(header(sphere), header(sphere) + glm::vec2(100, 30));
    EXPECT_EQ(node(sphere).position, glm::vec2(140, 70));
    EXPECT_EQ(node(box).position, glm::vec2(140, 190));
    EXPECT_EQ(node(far_one).position, glm::vec2(500, 300));
    expect_one_step("Move 2 nodes");
}

TEST_F(CanvasTest, two_pixels_are_a_click_and_not_a_drag)
{
    NodeId sphere = add("sphere", {40, 40});
    open().drag(header(sphere), header(sphere) + glm::vec2(2, 0));
    EXPECT_EQ(driver->editor.view.selection.active(), sphere);
    expect_no_step();
}

TEST_F(CanvasTest, escape_puts_dragged_nodes_back)
{
    NodeId sphere = add("sphere", {40, 40});
    open();
    driver->move(header(sphere));
    driver->press();
    driver->move(header(sphere) + glm::vec2(100, 100));
    EXPECT_GT(header(sphere).y, 150) << "it follows the hand";
    driver->key(ui::key::escape);
    driver->release();
    expect_no_step();
}

TEST_F(CanvasTest, clicks_choose_with_shift_and_control)
{
    NodeId sphere = add("sphere", {40, 40}), box = add("box", {40, 160});
    open();
    ui::Selection& selection = driver->editor.view.selection;
    auto hold = [&](int key, bool down) {
        driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = key, .down = down});
    };
    driver->click(header(sphere));
    EXPECT_EQ(selection.nodes(), std::vector<NodeId>{sphere});
    hold(ui::key::left_shift, true);
    driver->click(header(box));
    hold(ui::key::left_shift, false);
    EXPECT_EQ(selection.nodes(), (std::vector<NodeId>{sphere, box}));
    hold(ui::key::left_control, true);
    driver->click(header(sphere));
    hold(ui::key::left_control, false);
    EXPECT_EQ(selection.nodes(), std::vector<NodeId>{box});
    driver->click(header(box) + glm::vec2(300, 0));
    EXPECT_TRUE(selection.empty());
}

TEST_F(CanvasTest, a_click_on_one_of_many_chooses_it_alone)
{
    NodeId sphere = add("sphere", {40, 40});
    add("box", {40, 160});
    open();
    driver->editor.canvas().open_add_menu();
    driver->frames(2);
    driver->key(ui::key::escape);
    for (const graph::Node& one : driver->document.root.nodes) driver->editor.view.selection.add(one.id);
    driver->click(header(sphere));
    EXPECT_EQ(driver->editor.view.selection.nodes(), std::vector<NodeId>{sphere});
}

TEST_F(CanvasTest, a_stroke_with_control_cuts_the_wires_it_crosses)
{
    NodeId sphere = add("sphere", {0, 0}), box = add("box", {0, 150}), both = add("union", {400, 60});
    wire(sphere, both, "a");
    wire(box, both, "b");
    open();
    auto hold = [&](bool down) {
        driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_control, .down = down});
    };
    hold(true);
    driver->drag(out(sphere) + glm::vec2(100, -30), out(box) + glm::vec2(100, 60), 1, 8);
    hold(false);
    EXPECT_TRUE(node(both).inputs.empty());
    expect_one_step("Cut 2 wires");
}

TEST_F(CanvasTest, alt_and_a_click_break_all_wires_of_a_pin)
{
    NodeId sphere = add("sphere", {0, 0}), both = add("union", {400, 60});
    wire(sphere, both, "a");
    wire(sphere, both, "b");
    open();
    driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = ui::key::left_alt, .down = true});
    driver->click(out(sphere));
    EXPECT_TRUE(node(both).inputs.empty());
    expect_one_step("Cut 2 wires");
}

TEST_F(CanvasTest, the_menu_of_a_node_deletes_mutes_and_duplicates)
{
    NodeId sphere = add("sphere", {40, 40});
    open();
    driver->click(header(sphere), 1);
    driver->click("canvas/menu/mute");
    EXPECT_TRUE(node(sphere).muted);
    driver->click(header(sphere), 1);
    driver->click("canvas/menu/duplicate");
    ASSERT_EQ(driver->document.root.nodes.size(), 2u);
    EXPECT_EQ(driver->editor.view.selection.nodes(), std::vector<NodeId>{newest()});
    driver->click(header(newest()), 1);
    driver->click("canvas/menu/delete");
    EXPECT_EQ(driver->document.root.nodes.size(), 1u);
    EXPECT_EQ(driver->steps.size(), 4u);
    EXPECT_EQ(driver->document.root, driver->steps[1].first.root);
}

TEST_F(CanvasTest, a_node_is_renamed_on_its_header)
{
    NodeId sphere = add("sphere", {40, 40});
    open().editor.canvas().begin_rename(sphere);
    driver->frames(3);
    driver->type("Moon");
    EXPECT_EQ(driver->steps.size(), 1u);
    driver->key(ui::key::enter);
    EXPECT_EQ(node(sphere).name, "Moon");
    EXPECT_FALSE(driver->shows("canvas/rename"));
    expect_one_step("Rename sphere");
}

TEST_F(CanvasTest, escape_keeps_the_old_name)
{
    NodeId sphere = add("sphere", {40, 40});
    open().double_click(header(sphere));
    ASSERT_TRUE(driver->shows("canvas/rename"));
    driver->type("Moon");
    driver->key(ui::key::escape);
    EXPECT_FALSE(driver->shows("canvas/rename"));
    expect_no_step();
}

TEST_F(CanvasTest, the_wheel_keeps_what_is_under_the_cursor)
{
    add("sphere", {40, 40});
    open();
    glm::vec2 at = driver->place("canvas") + glm::vec2(-120, 50);
    driver->move(at);
    glm::vec2 before = driver->editor.canvas().cursor_on_canvas();
    driver->wheel(3);
    EXPECT_NEAR(driver->editor.view.canvas.zoom, 1.728f, 1e-4f);
    glm::vec2 after = driver->editor.canvas().cursor_on_canvas();
    EXPECT_NEAR(before.x, after.x, 1e-3f);
    EXPECT_NEAR(before.y, after.y, 1e-3f);
    driver->wheel(-60);
    EXPECT_EQ(driver->editor.view.canvas.zoom, ui::zoom_minimum);
    driver->wheel(60);
    EXPECT_EQ(driver->editor.view.canvas.zoom, ui::zoom_maximum);
}

TEST_F(CanvasTest, text_is_never_enlarged_up_to_the_largest_font)
{
    open();
    ui::Theme theme;
    theme.fonts.canvas.fill(ImGui::GetIO().Fonts->Fonts[0]);
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    int place = 0;
    for (ImFont*& font : theme.fonts.canvas) {
        while (place < fonts.Size &&
               fonts[place]->FontSize !=
                   ui::canvas_font_sizes[static_cast<std::size_t>(&font - theme.fonts.canvas.data())])
            ++place;
        ASSERT_LT(place, fonts.Size);
        font = fonts[place];
    }
    for (float zoom = ui::zoom_minimum; zoom <= ui::zoom_maximum; zoom *= 1.1f)
        EXPECT_LE(ui::canvas_font(theme, 13 * zoom).scale, 1) << "at zoom " << zoom;
}

TEST_F(CanvasTest, dragging_with_the_middle_or_the_right_button_pans)
{
    add("sphere", {40, 40});
    open();
    glm::vec2 middle = driver->place("canvas"), before = driver->editor.view.canvas.pan_px;
    driver->drag(middle, middle + glm::vec2(70, -30), 2);
    EXPECT_EQ(driver->editor.view.canvas.pan_px, before + glm::vec2(70, -30));
    driver->drag(middle, middle + glm::vec2(-70, 30), 1);
    EXPECT_EQ(driver->editor.view.canvas.pan_px, before);
    EXPECT_FALSE(driver->shows("add_menu/search"));
    expect_no_step();
}

TEST_F(CanvasTest, framing_shows_every_node_after_a_glide)
{
    add("sphere", {-3000, 0});
    NodeId last = add("output", {3000, 900});
    open();
    driver->editor.canvas().frame_all();
    driver->frame();
    driver->frame();
    float on_the_way = driver->editor.view.canvas.zoom;
    driver->frames(12);
    EXPECT_LT(driver->editor.view.canvas.zoom, on_the_way);
    ui::WidgetRect pane = *driver->editor.rects.find("canvas"), box = *driver->editor.rects.find(name(last));
    EXPECT_GT(box.low.x, pane.low.x);
    EXPECT_LT(box.high.x, pane.high.x);
    EXPECT_LT(box.high.y, pane.high.y);
}

TEST_F(CanvasTest, framing_is_at_once_with_reduced_motion)
{
    add("sphere", {-3000, 0});
    add("output", {3000, 900});
    open();
    driver->editor.view.reduced_motion = true;
    driver->editor.canvas().frame_all();
    driver->frames(2);
    float zoom = driver->editor.view.canvas.zoom;
    driver->frames(12);
    EXPECT_EQ(driver->editor.view.canvas.zoom, zoom);
    EXPECT_LT(zoom, 1);
}

TEST_F(CanvasTest, the_selected_are_framed)
{
    add("sphere", {-3000, 0});
    NodeId last = add("output", {3000, 900});
    open();
    driver->editor.view.selection.only(last);
    driver->editor.canvas().frame_selected();
    driver->frames(15);
    EXPECT_EQ(driver->editor.view.canvas.zoom, 1);
    glm::vec2 away = driver->place(name(last)) - driver->place("canvas");
    EXPECT_LT(glm::length(away), 2);
}

TEST_F(CanvasTest, a_click_on_the_minimap_goes_there)
{
    add("sphere", {-3000, 0});
    NodeId last = add("output", {3000, 900});
    open();
    driver->editor.view.minimap = true;
    driver->frames(2);
    ui::WidgetRect map = *driver->editor.rects.find("canvas/minimap");
    glm::vec2 before = driver->place(name(last));
    driver->click({map.high.x - 12, map.centre().y});
    EXPECT_LT(std::abs(driver->place(name(last)).x - driver->place("canvas").x),
              std::abs(before.x - driver->place("canvas").x));
    EXPECT_TRUE(driver->editor.view.selection.empty());
    expect_no_step();
}

TEST_F(CanvasTest, an_empty_canvas_adds_a_sphere_that_is_seen)
{
    open().click("canvas/empty/sphere");
    NodeId shape = driver->editor.view.selection.active();
    ASSERT_TRUE(shape);
    EXPECT_EQ(node(shape).type, "sphere");
    bool seen = false;
    for (const graph::Node& one : driver->document.root.nodes)
        seen = seen || (one.type == "output" && one.input("d") == shape);
    EXPECT_TRUE(seen);
    EXPECT_FALSE(driver->shows("canvas/empty/sphere"));
    expect_one_step("Add sphere");
}

TEST_F(CanvasTest, a_thousand_small_nodes_are_a_few_vertices_each)
{
    NodeId before = add("sphere", {0, 0});
    for (int i = 1; i < 1000; ++i) {
        NodeId next = add("round", {220.0f * static_cast<float>(i % 40), 100.0f * static_cast<float>(i / 40)});
        wire(before, next, "d");
        before = next;
    }
    open();
    driver->editor.view.canvas = {{10, 10}, 0.1f};
    driver->frames(2);
    EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, 80'000);
    driver->editor.view.canvas = {{10, 10}, 1};
    driver->frames(2);
    EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, 60'000) << "what is out of sight is not drawn";
}

TEST_F(CanvasTest, a_node_with_a_problem_has_a_badge)
{
    NodeId sphere = add("sphere", {0, 0}), box = add("box", {0, 150});
    open();
    EXPECT_FALSE(driver->shows(name(sphere) + "/problem"));
    driver->readings.problems = {{sphere, "this sphere is too round"}};
    driver->frames(2);
    EXPECT_TRUE(driver->shows(name(sphere) + "/problem"));
    EXPECT_FALSE(driver->shows(name(box) + "/problem"));
}

// Presses, drags, wheels and keys anywhere: documents keep their promises, and gestures end.
TEST_F(CanvasTest, random_hands_break_nothing)
{
    NodeId sphere = add("sphere", {0, 0}), both = add("union", {300, 60}), output = add("output", {560, 60});
    wire(sphere, both, "a");
    wire(both, output, "d");
    open();
    std::mt19937 random(7);
    auto up_to = [&](int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random); };
    auto somewhere = [&] {
        std::vector<glm::vec2> widgets;
        for (const auto& [widget, rect] : driver->editor.rects.all())
            if (widget.starts_with("canvas/") || widget.starts_with("add_menu/")) widgets.push_back(rect.centre());
        ui::WidgetRect pane = *driver->editor.rects.find("canvas");
        glm::vec2 share{static_cast<float>(up_to(1000)), static_cast<float>(up_to(1000))};
        if (widgets.empty() || up_to(4) == 0) return pane.low + (pane.high - pane.low) * (share / 1000.0f);
        return widgets[static_cast<std::size_t>(up_to(static_cast<int>(widgets.size())))];
    };
    constexpr int keys[] = {ui::key::escape, ui::key::enter, ui::key::down};
    constexpr int modifiers[] = {ui::key::left_alt, ui::key::left_control, ui::key::left_shift};
    for (int i = 0; i < 250; ++i) {
        int modifier = up_to(4) ? 0 : modifiers[up_to(3)];
        if (modifier) driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = modifier, .down = true});
        int what = up_to(10);
        if (what < 5) driver->drag(somewhere(), somewhere(), up_to(5) ? 0 : 1 + up_to(2), 2);
        else if (what < 8) driver->click(somewhere(), up_to(2));
        else if (what < 9) driver->key(keys[up_to(3)]);
        else driver->wheel(up_to(2) ? 1.0f : -1.0f);
        if (modifier) driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = modifier, .down = false});
        if (i % 20 == 0) driver->editor.canvas().frame_all();
        graph::Refusal broken = graph::validate(driver->document, *library);
        ASSERT_FALSE(broken) << "after gesture " << i << ": " << *broken;
    }
    driver->queue.push({.kind = ui::InputEvent::Kind::focus, .down = false});
    driver->run_until_quiet();
    EXPECT_FALSE(driver->editor.canvas().busy());
    EXPECT_GT(driver->steps.size(), 20u) << "the hands did something";
}

TEST_F(CanvasTest, a_gesture_that_its_window_loses_is_given_up)
{
    NodeId sphere = add("sphere", {40, 40});
    open();
    driver->move(header(sphere));
    driver->press();
    driver->move(header(sphere) + glm::vec2(60, 60));
    driver->queue.push({.kind = ui::InputEvent::Kind::focus, .down = false});
    driver->run_until_quiet();
    EXPECT_FALSE(driver->editor.canvas().busy());
}

}  // namespace
}  // namespace fieldwright::tests
