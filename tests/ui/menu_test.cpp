// Menus, palette, sheet, status line and the questions, used by mouse and keys.
#include "graph/scene_file.h"
#include "tests/ui/driver.h"
#include "ui/commands.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

#include <set>

namespace fieldwright::tests {
namespace {

graph::Document first_example()
{
    return graph::open_scene(std::string(FIELDWRIGHT_SOURCE_DIR) + "/examples/first.scene.json",
                             *graph::Library::embedded());
}

template <typename Kind>
int count(const std::vector<ui::Request>& requests)
{
    return static_cast<int>(
        std::count_if(requests.begin(), requests.end(), [](const auto& r) { return std::holds_alternative<Kind>(r); }));
}

bool inside_the_window(const Driver& driver, const std::string& widget)
{
    auto rect = driver.editor.rects.find(widget);
    ImVec2 size = ImGui::GetIO().DisplaySize;
    return rect && rect->low.x >= 0 && rect->low.y >= 0 && rect->high.x <= size.x && rect->high.y <= size.y;
}

void open_submenus(Driver& driver, const std::string& menu)
{
    for (std::size_t slash = menu.find('/'); slash != std::string::npos;) {
        slash = menu.find('/', slash + 1);
        driver.move(driver.place("menu/" + menu.substr(0, slash)));
        driver.frames(40);  // submenus open after a moment
    }
}

TEST(Menus, every_command_is_reached_by_mouse)
{
    Driver driver(first_example(), {1280, 720});
    driver.readings.recent = {{"/scenes/one.scene.json", false}};
    std::vector<ui::Command> list = ui::commands(driver.readings, *driver.library);
    std::string open;
    for (const ui::Command& command : list) {
        if (command.menu != open) {
            driver.key(ui::key::escape);
            driver.click("menu/" + command.menu.substr(0, command.menu.find('/')));
            open_submenus(driver, command.menu);
            open = command.menu;
        }
        EXPECT_TRUE(inside_the_window(driver, "menu/" + command.id)) << command.id;
    }
}

TEST(Menus, a_click_runs_the_command)
{
    Driver driver(first_example());
    driver.click("menu/Add");
    open_submenus(driver, "Add/Primitive");
    driver.click("menu/add.torus");
    ASSERT_EQ(driver.step, 1u);
    EXPECT_EQ(driver.document.root.find(driver.editor.view.selection.active())->type, "torus");
    EXPECT_FALSE(driver.shows("menu/add.torus"));
}

TEST(Menus, escape_closes_them)
{
    Driver driver(first_example());
    driver.click("menu/File");
    EXPECT_TRUE(driver.shows("menu/file.new"));
    driver.key(ui::key::escape);
    EXPECT_FALSE(driver.shows("menu/file.new"));
}

TEST(Menus, escape_closes_those_of_buttons_and_nodes_too)
{
    Driver driver(first_example());
    auto closes = [&](std::string_view opened) {
        EXPECT_TRUE(driver.shows(opened)) << opened;
        driver.key(ui::key::escape);
        EXPECT_FALSE(driver.shows(opened)) << opened;
    };
    driver.click("viewport/view");
    closes("viewport/view/steps");
    driver.click("panel/materials/add");
    closes("panel/materials/add/phong");
    driver.click("menu/File");
    closes("menu/file.new");
    driver.move(driver.place("canvas"));
    driver.key(ui::key::home);
    driver.frames(60);
    driver.click("canvas/node/37/header", 1);
    closes("canvas/menu/delete");
    driver.editor.view.selection.only(graph::NodeId{17});
    driver.frames(2);
    driver.click("inspector/albedo");
    closes("inspector/albedo/picker");
}

TEST(Palette, escape_closes_it_while_typing)
{
    Driver driver(first_example());
    driver.key('P', true);
    driver.type("undo");
    ASSERT_TRUE(driver.shows("palette/search"));
    driver.key(ui::key::escape);
    EXPECT_FALSE(driver.shows("palette/search"));
}

TEST(Palette, finds_undo_and_runs_it)
{
    Driver driver(first_example());
    graph::Document start = driver.document;
    driver.editor.run("add.torus");
    driver.frames(3);
    ASSERT_NE(driver.document, start);
    driver.key('P', true);
    ASSERT_TRUE(driver.shows("palette/search"));
    driver.type("undo");
    EXPECT_TRUE(driver.shows("palette/item/edit.undo"));
    driver.key(ui::key::enter);
    EXPECT_EQ(driver.document, start);
    EXPECT_FALSE(driver.shows("palette/search"));
}

TEST(Palette, runs_what_is_clicked_and_what_the_arrows_reach)
{
    Driver driver(first_example());
    driver.key(ui::key::f3);
    driver.type("minimap");
    driver.click("palette/item/view.minimap");
    EXPECT_FALSE(driver.editor.view.minimap);
    driver.key(ui::key::f3);
    driver.type("anaglyph");
    driver.key(ui::key::down);
    driver.key(ui::key::enter);
    EXPECT_EQ(driver.editor.view.stereo, "dubois");
}

TEST(Palette, closes_with_escape)
{
    Driver driver(first_example());
    driver.key(ui::key::f3);
    ASSERT_TRUE(driver.shows("palette/search"));
    driver.key(ui::key::escape);
    driver.frame();
    EXPECT_FALSE(driver.shows("palette/search"));
}

TEST(Popups, close_with_escape_and_nothing_else_happens)
{
    Driver driver(first_example());
    graph::NodeId node = driver.document.root.nodes.front().id;
    driver.editor.view.selection.only(node);
    driver.click("viewport/stereo");
    ASSERT_TRUE(driver.shows("viewport/stereo/dubois"));
    driver.key(ui::key::escape);
    driver.frame();
    EXPECT_FALSE(driver.shows("viewport/stereo/dubois"));
    EXPECT_TRUE(driver.editor.view.selection.contains(node));
}

TEST(Palette, leaves_out_what_is_not_possible_now)
{
    Driver driver(first_example());
    driver.key(ui::key::f3);
    driver.type("redo");
    EXPECT_FALSE(driver.shows("palette/item/edit.redo"));
}

TEST(ShortcutSheet, lists_every_shortcut_within_the_window)
{
    Driver driver(first_example(), {1280, 720});
    driver.key(ui::key::f1);
    for (const ui::Command& command : ui::commands(driver.readings, *driver.library)) {
        bool listed = inside_the_window(driver, "sheet/" + command.id);
        EXPECT_EQ(listed, !command.shortcuts.empty()) << command.id;
    }
    driver.key(ui::key::f1);
    EXPECT_FALSE(driver.shows("sheet"));
}

TEST(StatusLine, shows_a_refusal_for_some_seconds)
{
    Driver driver(first_example());
    driver.move({1200, 200});  // over the inspector, which hints at nothing
    driver.editor.run("edit.paste");
    ImGui::SetClipboardText("hello");
    driver.frames(2);
    EXPECT_TRUE(driver.shows("status/left"));
    driver.frames(3 * 60);
    EXPECT_TRUE(driver.shows("status/left"));
    driver.frames(2 * 60);
    EXPECT_FALSE(driver.shows("status/left"));
}

TEST(StatusLine, the_same_news_again_is_seen_again)
{
    Driver driver(first_example());
    driver.move({1200, 200});
    driver.readings.status = "Exported first.png";
    driver.readings.status_count = 1;
    driver.frames(2);
    EXPECT_EQ(driver.editor.status_text(), "Exported first.png");
    driver.frames(5 * 60);
    EXPECT_EQ(driver.editor.status_text(), "");
    driver.readings.status_count = 2;
    driver.frames(2);
    EXPECT_EQ(driver.editor.status_text(), "Exported first.png");
}

TEST(UnsavedChanges, closing_a_clean_scene_asks_nothing)
{
    Driver driver(first_example());
    driver.editor.ask_quit();
    driver.frames(2);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 1);
}

class Unsaved : public testing::Test {
protected:
    Unsaved() : driver(first_example())
    {
        driver.readings.dirty = true;
        driver.readings.file_path = "/scenes/first.scene.json";
    }
    Driver driver;
};

TEST_F(Unsaved, cancel_does_nothing)
{
    driver.editor.ask_quit();
    driver.frames(3);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 0);
    driver.click("dialog/cancel");
    EXPECT_TRUE(driver.requests.empty());
    EXPECT_FALSE(driver.shows("dialog/save"));
}

TEST_F(Unsaved, discard_goes_on)
{
    driver.key('N', true);
    driver.click("dialog/discard");
    EXPECT_EQ(count<ui::NewScene>(driver.requests), 1);
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 0);
}

TEST_F(Unsaved, save_goes_on_once_the_scene_is_saved)
{
    driver.editor.ask_quit();
    driver.frames(3);
    driver.click("dialog/save");
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 1);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 0);
    driver.readings.dirty = false;
    driver.frames(2);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 1);
    driver.frames(20);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 1);
}

TEST_F(Unsaved, a_save_that_fails_goes_on_with_nothing)
{
    driver.editor.ask_quit();
    driver.frames(3);
    driver.click("dialog/save");
    driver.frames(20);  // still dirty
    driver.readings.dirty = false;
    driver.frames(20);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 0);
}

TEST_F(Unsaved, a_scene_without_a_file_is_named_first)
{
    driver.readings.file_path.clear();
    driver.key('O', true);
    EXPECT_TRUE(driver.requests.empty());
    driver.key(ui::key::enter);  // Save
    ASSERT_EQ(count<ui::ChooseFile>(driver.requests), 1);
    EXPECT_EQ(std::get<ui::ChooseFile>(driver.requests.back()).then, ui::ChooseFile::Then::save_as);
    driver.readings.dialog_open = true;
    driver.frames(100);
    driver.readings.dialog_open = false;
    driver.readings.dirty = false;
    driver.frames(2);
    ASSERT_EQ(count<ui::ChooseFile>(driver.requests), 2);
    EXPECT_EQ(std::get<ui::ChooseFile>(driver.requests.back()).then, ui::ChooseFile::Then::open);
}

TEST_F(Unsaved, a_file_changed_on_disk_is_not_overwritten_unasked)
{
    driver.readings.changed_on_disk = true;
    driver.key('S', true);
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 0);
    driver.click("dialog/cancel");
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 0);
    driver.key('S', true);
    driver.click("dialog/replace");
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 1);
}

TEST_F(Unsaved, a_warning_is_heeded_before_saving)
{
    driver.readings.overwrite_warning = "This scene is of version 7.";
    driver.key('S', true);
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 0);
    driver.click("dialog/replace");
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 1);
}

TEST_F(Unsaved, both_questions_come_one_after_the_other)
{
    driver.readings.changed_on_disk = true;
    driver.editor.ask_quit();
    driver.frames(3);
    driver.click("dialog/save");
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 0);
    driver.click("dialog/replace");
    EXPECT_EQ(count<ui::SaveFile>(driver.requests), 1);
    driver.readings.dirty = driver.readings.changed_on_disk = false;
    driver.frames(2);
    EXPECT_EQ(count<ui::Quit>(driver.requests), 1);
}

TEST(Recovery, is_offered_for_each_copy)
{
    Driver driver(first_example());
    driver.readings.recovered = {{"a", "first.scene.json", "Today 14:02"}, {"b", "Untitled", "Yesterday"}};
    driver.frames(3);
    driver.click("dialog/discard/b");
    ASSERT_EQ(count<ui::DiscardRecovered>(driver.requests), 1);
    driver.readings.recovered.pop_back();
    driver.frames(2);
    driver.click("dialog/recover/a");
    ASSERT_EQ(count<ui::Recover>(driver.requests), 1);
    EXPECT_EQ(std::get<ui::Recover>(driver.requests.back()).id, "a");
    driver.frames(2);
    EXPECT_FALSE(driver.shows("dialog/recover/a"));
}

TEST(Recovery, can_be_decided_later)
{
    Driver driver(first_example());
    driver.readings.recovered = {{"a", "first.scene.json", "Today 14:02"}};
    driver.frames(3);
    driver.click("dialog/later");
    EXPECT_TRUE(driver.requests.empty());
    EXPECT_FALSE(driver.shows("dialog/later"));
}

}  // namespace
}  // namespace fieldwright::tests
