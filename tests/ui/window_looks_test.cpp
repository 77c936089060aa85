// What the window owes to eyes: tooltips, readable openings, a beginning where there is nothing, workspaces.
#include "graph/scene_file.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cstring>
#include <filesystem>

namespace fieldwright::tests {
namespace {

using graph::NodeId;

std::string example_path(const std::string& name)
{
    return std::string(FIELDWRIGHT_SOURCE_DIR) + "/examples/" + name + ".scene.json";
}

graph::Document example(const std::string& name)
{
    return graph::open_scene(example_path(name), *graph::Library::embedded());
}

NodeId first_of_type(const graph::Document& document, std::string_view type)
{
    for (const graph::Node& node : document.root.nodes)
        if (node.type == type) return node.id;
    return {};
}

bool tooltip_shows()
{
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if ((window->Flags & ImGuiWindowFlags_Tooltip) && window->Active && !window->Hidden) return true;
    return false;
}

// A square of one row, or one of the few buttons with an icon that are not square.
bool is_icon_button(const std::string& name, const ui::WidgetRect& rect)
{
    for (const char* wide : {"viewport/view", "viewport/stereo", "viewport/through_camera", "viewport/gizmo",
                             "viewport/play", "menu/palette", "browser/up", "browser/home", "browser/new_folder"})
        if (name == wide) return true;
    if (name.starts_with("canvas/") || name.starts_with("viewport/")) return false;
    glm::vec2 size = rect.high - rect.low;
    return size == glm::vec2(24, 24);
}

// Whether the mouse, in the middle of a widget of the inspector, is over another pane: the widget is scrolled away.
bool is_scrolled_away(const std::string& name)
{
    const ImGuiWindow* window = ImGui::GetCurrentContext()->HoveredWindow;
    return name.starts_with("inspector/") && (!window || !std::strstr(window->Name, "inspector"));
}

// Names of icon buttons that were pointed at, in this and earlier states of the window.
void expect_tooltips(Driver& driver, std::set<std::string>& seen)
{
    std::vector<std::string> names;
    for (const auto& [name, rect] : driver.editor.rects.all())
        if (is_icon_button(name, rect) && !seen.contains(name)) names.push_back(name);
    for (const std::string& name : names) {
        if (!driver.shows(name)) continue;  // it went with the mouse
        seen.insert(name);
        driver.move(driver.place(name));
        driver.frame_s = 0.5f;
        driver.frames(3);
        EXPECT_TRUE(tooltip_shows() || is_scrolled_away(name)) << name;
        driver.frame_s = 1.0f / 60.0f;
    }
}

TEST(IconButtons, each_has_a_tooltip)
{
    Driver driver(example("profiles"), {1600, 1000});
    std::set<std::string> seen;
    for (const char* panel :
         {"materials", "lights", "camera", "cost", "field", "stereo", "shader", "problems", "history"}) {
        driver.editor.run(std::string("panel.") + panel);
        driver.frames(3);
        expect_tooltips(driver, seen);
    }
    std::set<std::string> types;
    for (const graph::Node& node : driver.document.root.nodes) {
        if (!types.insert(node.type).second) continue;
        driver.editor.view.selection.only(node.id);
        driver.editor.run(node.type == "sun" ? "panel.lights" : "panel.materials");
        driver.frames(3);
        expect_tooltips(driver, seen);
    }
    driver.editor.browse({ui::ChooseFile::Then::open, {}}, std::filesystem::path(example_path("first")).parent_path(),
                         "");
    driver.frames(3);
    expect_tooltips(driver, seen);
    EXPECT_TRUE(seen.contains("inspector/mute")) << "the walk finds the buttons it is for";
    EXPECT_TRUE(seen.contains("browser/up"));
    EXPECT_TRUE(seen.contains("viewport/through_camera"));
    EXPECT_GE(seen.size(), 15u);
}

class Opening : public testing::TestWithParam<std::string> {};

TEST_P(Opening, has_words_large_enough_to_read_and_nothing_on_its_last_nodes)
{
    for (glm::vec2 size : {glm::vec2(1600, 1000), glm::vec2(1280, 720)}) {
        Driver driver(example(GetParam()), size);
        driver.editor.canvas().frame_opening();
        driver.frames(3);
        EXPECT_GE(driver.editor.view.canvas.zoom, 0.9f);
        ui::WidgetRect pane = *driver.editor.rects.find("canvas");
        NodeId output = first_of_type(driver.document, "output");
        // Nothing reaches there when it is not shown.
        ui::WidgetRect map = driver.editor.rects.find("canvas/minimap").value_or(ui::WidgetRect{pane.high, pane.high});
        ui::WidgetRect end = *driver.editor.rects.find("canvas/node/" + std::to_string(output.number));
        for (const graph::Node& node : driver.document.root.nodes) {
            ui::WidgetRect rect = *driver.editor.rects.find("canvas/node/" + std::to_string(node.id.number));
            bool seen = rect.low.x < pane.high.x && rect.low.y < pane.high.y;
            // Of a column that is too high to stand above the map with the output, the end is below it.
            bool room = rect.high.y - end.low.y < map.low.y - pane.low.y - 45;
            EXPECT_FALSE(seen && room && rect.high.x > map.low.x && rect.high.y > map.low.y)
                << node.name << " lies under the minimap at " << size.x;
            bool whole = rect.low.y >= pane.low.y && rect.high.x <= pane.high.x && rect.high.y <= pane.high.y;
            EXPECT_TRUE(whole || node.type != "output");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, Opening,
                         testing::Values("first", "booleans", "smooth_blends", "repetition", "twist_and_bend",
                                         "profiles", "pulse", "orthographic_room"));

class EmptyCanvas : public testing::Test {
protected:
    EmptyCanvas() : driver({}, {1600, 1000})
    {
        for (const char* name : {"one", "two", "three", "four"})
            driver.readings.examples.push_back({name, std::string("Example ") + name, "Shows something.", nullptr});
        driver.frames(2);
    }
    const ui::OpenExample* asked()
    {
        return driver.requests.empty() ? nullptr : std::get_if<ui::OpenExample>(&driver.requests.back());
    }
    Driver driver;
};

TEST_F(EmptyCanvas, offers_examples_and_asks_for_the_one_that_is_clicked)
{
    driver.click("canvas/empty/example/three");
    ASSERT_TRUE(asked());
    EXPECT_EQ(asked()->name, "three");
}

TEST_F(EmptyCanvas, asks_about_unsaved_changes_before_an_example_opens)
{
    driver.readings.dirty = true;
    driver.click("canvas/empty/example/one");
    EXPECT_FALSE(asked());
    driver.click("dialog/discard");
    ASSERT_TRUE(asked());
    EXPECT_EQ(asked()->name, "one");
}

TEST_F(EmptyCanvas, has_at_least_three_examples_in_the_smallest_usual_window_and_none_in_a_slit)
{
    ImGui::GetIO().DisplaySize = {1280, 720};
    driver.frames(3);
    for (const char* name : {"one", "two", "three"})
        EXPECT_TRUE(driver.shows(std::string("canvas/empty/example/") + name)) << name;
    driver.editor.view.panes.canvas_share = 0.1f;
    driver.frames(3);
    EXPECT_FALSE(driver.shows("canvas/empty/example/one"));
}

TEST_F(EmptyCanvas, its_examples_are_in_the_file_menu_as_well)
{
    driver.editor.run("file.example.two");
    driver.frames(2);
    ASSERT_TRUE(asked());
    EXPECT_EQ(asked()->name, "two");
}

TEST(Workspaces, arrange_the_window_and_hold_until_it_is_changed)
{
    Driver driver(example("first"), {1600, 1000});
    driver.click("menu/workspace/inspect");
    driver.frames(2);
    EXPECT_EQ(driver.editor.view.panel, ui::Panel::cost);
    EXPECT_EQ(driver.editor.view.view, "steps");
    driver.click("menu/workspace/present");
    driver.frames(2);
    EXPECT_FALSE(driver.editor.view.panes.shown);
    EXPECT_EQ(driver.editor.view.view, "beauty");
    driver.click("menu/workspace/build");
    driver.frames(2);
    EXPECT_TRUE(driver.editor.view.panes.shown);
    EXPECT_EQ(driver.editor.view.panel, ui::Panel::cost) << "building is possible beside any panel";
    EXPECT_EQ(driver.document, example("first"));
}

}  // namespace
}  // namespace fieldwright::tests
