// Every command, whichever way it is reached.
#include "ui/commands.h"
#include "graph/scene_file.h"
#include "tests/ui/driver.h"
#include "ui/command_search.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

#include <set>

namespace fieldwright::tests {
namespace {

graph::Document example(const std::string& name)
{
    return graph::open_scene(std::string(FIELDWRIGHT_SOURCE_DIR) + "/examples/" + name + ".scene.json",
                             *graph::Library::embedded());
}

graph::NodeId first_of_type(const graph::Document& document, std::string_view type)
{
    for (const graph::Node& node : document.root.nodes)
        if (node.type == type) return node.id;
    return {};
}

std::vector<ui::Command> all_commands(const Driver& driver) { return ui::commands(driver.readings, *driver.library); }

void close_popups(Driver& driver)
{
    for (int i = 0; i < 3; ++i) driver.key(ui::key::escape);
}

void undo_all(Driver& driver)
{
    while (driver.step > 0) {
        std::size_t before = driver.step;
        driver.editor.run("edit.undo");
        driver.frames(3);
        ASSERT_EQ(driver.step, before - 1);
    }
}

TEST(Commands, say_what_they_do)
{
    Driver driver({});
    driver.readings.recent = {{"/scenes/one.scene.json", false}, {"/scenes/two.scene.json", true}};
    std::set<std::string> ids;
    for (const ui::Command& command : all_commands(driver)) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.id << " is there twice";
        EXPECT_FALSE(command.title.empty()) << command.id;
        EXPECT_FALSE(command.menu.empty()) << command.id;
        EXPECT_TRUE(command.help.ends_with('.')) << command.id << ": " << command.help;
        EXPECT_TRUE(command.run) << command.id;
    }
    EXPECT_GE(ids.size(), 100u);
}

TEST(Commands, share_no_shortcut_in_one_place)
{
    Driver driver({});
    std::vector<std::pair<ui::Shortcut, std::string>> taken;
    for (const ui::Command& command : all_commands(driver))
        for (ui::Shortcut shortcut : command.shortcuts) {
            shortcut.repeats = false;
            for (auto& [other, id] : taken) {
                bool both_apply = other.scope == shortcut.scope || other.scope == ui::Scope::everywhere ||
                                  shortcut.scope == ui::Scope::everywhere;
                ui::Shortcut same_scope = other;
                same_scope.scope = shortcut.scope;
                EXPECT_FALSE(both_apply && same_scope == shortcut)
                    << command.id << " and " << id << ": " << ui::shortcut_text(shortcut);
            }
            taken.emplace_back(shortcut, command.id);
        }
}

TEST(Commands, offer_every_node_type_once)
{
    Driver driver({});
    std::vector<ui::Command> list = all_commands(driver);
    for (const graph::NodeType* type : driver.library->types())
        EXPECT_TRUE(ui::find_command(list, "add." + type->name)) << type->name;
}

// Runs each command on the scene, with a node selected, and takes it back.
class EveryCommand : public testing::TestWithParam<std::string> {};

TEST_P(EveryCommand, leaves_a_valid_document_and_can_be_undone)
{
    graph::Document start = GetParam().empty() ? graph::Document{} : example(GetParam());
    // Examples are laid out already: something must be left to lay out.
    if (graph::NodeId sphere = first_of_type(start, "sphere")) graph::move_node(start, sphere, {-500, 900});
    Driver driver(start);
    ui::ViewState view = driver.editor.view;
    std::set<std::string> changing;
    for (const ui::Command& command : all_commands(driver)) {
        ImGui::SetClipboardText("not nodes");
        driver.editor.view = view;
        driver.steps.resize(1);
        if (graph::NodeId sphere = first_of_type(driver.document, "sphere")) driver.editor.view.selection.only(sphere);
        driver.editor.run(command.id);
        driver.frames(4);
        close_popups(driver);
        EXPECT_EQ(graph::validate(driver.document, *driver.library), std::nullopt) << command.id;
        EXPECT_EQ(driver.document, driver.steps[driver.step].first) << command.id << " left a step unsettled";
        if (driver.step > 0) changing.insert(command.id);
        undo_all(driver);
        EXPECT_EQ(driver.document, start) << command.id;
    }
    EXPECT_TRUE(changing.contains("add.torus"));
    if (GetParam().empty()) return;
    for (const char* id : {"edit.delete", "edit.cut", "edit.dissolve", "edit.mute", "edit.duplicate", "edit.layout"})
        EXPECT_TRUE(changing.contains(id)) << id;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryCommand, testing::Values("first", ""),
                         [](const auto& scene) { return scene.param.empty() ? std::string("empty") : scene.param; });

TEST(Commands, all_in_a_row_are_undone_to_the_start)
{
    graph::Document start = example("first");
    Driver driver(start);
    for (const ui::Command& command : all_commands(driver)) {
        if (command.id == "edit.undo" || command.id == "edit.redo") continue;
        driver.editor.run("edit.select_all");
        driver.frames(1);
        if (command.id.starts_with("edit.") && !driver.document.root.nodes.empty())
            driver.editor.view.selection.only(driver.document.root.nodes.front().id);
        driver.editor.run(command.id);
        driver.frames(4);
        close_popups(driver);
        ASSERT_EQ(graph::validate(driver.document, *driver.library), std::nullopt) << command.id;
    }
    EXPECT_GT(driver.steps.size(), 60u);
    graph::Document end = driver.document;
    std::size_t last = driver.step;
    undo_all(driver);
    EXPECT_EQ(driver.document, start);
    while (driver.step < last) {
        driver.editor.run("edit.redo");
        driver.frames(2);
    }
    EXPECT_EQ(driver.document, end);
}

TEST(Shortcuts, delete_over_the_canvas_removes_the_selected_node)
{
    Driver driver(example("first"));
    graph::NodeId sphere = first_of_type(driver.document, "sphere");
    driver.editor.view.selection.only(sphere);
    driver.move({400, 60});  // over the viewport: its scope has the key, too
    driver.key(ui::key::del);
    EXPECT_FALSE(driver.document.root.find(sphere));
    driver.key('Z', true);
    EXPECT_TRUE(driver.document.root.find(sphere));
    driver.key('Y', true);
    EXPECT_FALSE(driver.document.root.find(sphere));
}

TEST(Shortcuts, keep_to_their_pane)
{
    Driver driver(example("first"));
    driver.move({1200, 200});  // over the inspector
    driver.key(ui::key::space);
    EXPECT_TRUE(driver.editor.view.panes.shown);
    driver.move({400, 200});  // over the viewport
    driver.key(ui::key::space);
    EXPECT_FALSE(driver.editor.view.panes.shown);
}

TEST(Shortcuts, rest_while_text_is_typed_and_popups_are_open)
{
    Driver driver(example("first"));
    graph::Document before = driver.document;
    driver.editor.view.selection.only(first_of_type(driver.document, "sphere"));
    driver.move({400, 200});
    driver.editor.run("help.palette");
    driver.frames(3);
    driver.key(ui::key::del);
    driver.key('X');
    EXPECT_EQ(driver.document, before);
    EXPECT_TRUE(driver.shows("palette/search"));
}

TEST(Clipboard, copied_nodes_are_text_and_foreign_text_is_refused_kindly)
{
    Driver driver(example("first"));
    graph::NodeId sphere = first_of_type(driver.document, "sphere");
    driver.editor.view.selection.only(sphere);
    driver.move({400, 200});
    driver.key('C', true);
    EXPECT_NE(std::string_view(ImGui::GetClipboardText()).find("fieldwright-nodes"), std::string_view::npos);
    std::size_t count = driver.document.root.nodes.size();
    driver.key('V', true);
    EXPECT_EQ(driver.document.root.nodes.size(), count + 1);
    EXPECT_NE(driver.editor.view.selection.active(), sphere);
    ImGui::SetClipboardText("hello");
    driver.key('V', true);
    EXPECT_EQ(driver.document.root.nodes.size(), count + 1);
    EXPECT_TRUE(driver.shows("status/left"));
}

TEST(Search, the_beginning_of_a_title_comes_first)
{
    Driver driver({});
    std::vector<ui::Command> list = all_commands(driver);
    std::vector<const ui::Command*> all;
    for (const ui::Command& command : list) all.push_back(&command);
    auto first = [&](std::string_view query) {
        auto found = ui::search_commands(all, query);
        return found.empty() ? std::string() : found.front()->id;
    };
    EXPECT_EQ(first("undo"), "edit.undo");
    EXPECT_EQ(first("torus"), "add.torus");
    EXPECT_EQ(first("add smooth uni"), "add.smooth_union");
    EXPECT_EQ(first("heatmap"), "view.show.steps");
    EXPECT_EQ(first("svas"), "file.save_as");
    EXPECT_EQ(first("zzz"), "");
    EXPECT_EQ(ui::search_commands(all, "  ").size(), list.size());
}

}  // namespace
}  // namespace fieldwright::tests
