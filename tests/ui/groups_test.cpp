// Groups under hands: making, opening, exposing, renaming, leaving, taking apart.
#include "tests/ui/driver.h"

#include "graph/expansion.h"
#include "graph/group_edits.h"
#include "tests/support/scene.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::Document;

// A torus and a box united and shown.
struct Hands : testing::Test {
    Hands()
    {
        Scene scene;
        ring = scene.node("torus", {{"minor", 0.2f}});
        block = scene.node("box");
        both = scene.node("union", {{"a", ring}, {"b", block}});
        output = scene.show(both);
        float x = 60;
        for (graph::Node& node : scene.document.root.nodes) node.position = {x, 100}, x += 220;
        flat = scene.document;
        driver.emplace(scene.document, glm::vec2(1600, 1000));
        driver->editor.view.canvas = {{20, 20}, 0.75f};
        driver->frames(2);
    }

    Driver& hands() { return *driver; }
    Document& document() { return driver->document; }
    std::string node(NodeId id) const { return "canvas/node/" + std::to_string(id.number); }
    void over_canvas() { hands().move(hands().place("canvas") + glm::vec2(0, 120)); }

    NodeId make_group()
    {
        driver->editor.view.selection.replace({ring, block, both});
        over_canvas();
        hands().key('G', true);
        return driver->editor.view.selection.active();
    }

    void expect_valid() { EXPECT_EQ(graph::validate(document(), *hands().library), std::nullopt); }
    std::string step() const { return driver->steps[driver->step].second; }

    NodeId ring, block, both, output;
    Document flat;
    std::optional<Driver> driver;
};

TEST_F(Hands, control_g_makes_a_group_and_undo_takes_it_back)
{
    NodeId made = make_group();
    ASSERT_EQ(document().groups.size(), 1u);
    EXPECT_EQ(document().root.find(made)->type, "group:Group");
    EXPECT_EQ(document().root.find(output)->input("d"), made);
    EXPECT_EQ(step(), "Group");
    expect_valid();
    hands().key('Z', true);
    EXPECT_EQ(document(), flat);
}

TEST_F(Hands, tab_opens_the_group_and_escape_leaves_it)
{
    NodeId made = make_group();
    EXPECT_TRUE(hands().shows(node(made)));
    hands().key(ui::key::tab);
    hands().frames(2);
    EXPECT_TRUE(hands().shows(node(ring)));
    EXPECT_FALSE(hands().shows(node(output)));
    EXPECT_FALSE(hands().shows("viewport/nothing"));
    EXPECT_TRUE(hands().shows("canvas/way/1"));
    over_canvas();
    hands().key(ui::key::escape);
    EXPECT_TRUE(hands().shows(node(output)));
    EXPECT_FALSE(hands().shows("canvas/way/0"));
    EXPECT_EQ(driver->editor.view.selection.active(), made);
    // The steps of the history know nothing of it.
    EXPECT_EQ(driver->steps.size(), 2u);
    EXPECT_TRUE(document().entered.empty());
}

TEST_F(Hands, a_double_click_opens_and_the_breadcrumb_leaves)
{
    NodeId made = make_group();
    hands().double_click(hands().place(node(made) + "/header"));
    hands().frames(2);
    ASSERT_TRUE(hands().shows("canvas/way/0"));
    hands().click("canvas/way/0");
    EXPECT_TRUE(hands().shows(node(made)));
}

TEST_F(Hands, an_edit_inside_changes_the_group_and_not_the_scene)
{
    NodeId made = make_group();
    hands().key(ui::key::tab);
    hands().frames(2);
    Document before = document();
    hands().click(node(ring) + "/header");
    over_canvas();
    hands().key('M');
    EXPECT_EQ(document().root, before.root);
    EXPECT_TRUE(document().groups[0].graph.find(ring)->muted);
    EXPECT_TRUE(document().root.find(made));
    expect_valid();
    hands().key('Z', true);
    EXPECT_EQ(document(), before);
    EXPECT_TRUE(hands().shows(node(ring)));  // still inside
}

TEST_F(Hands, a_parameter_is_exposed_renamed_and_dragged_outside)
{
    NodeId made = make_group();
    hands().key(ui::key::tab);
    hands().frames(2);
    hands().click(node(ring) + "/header");
    hands().click("inspector/minor", 1);
    hands().click("inspector/minor/expose");
    ASSERT_EQ(document().groups[0].exposed.size(), 1u);
    EXPECT_NE(document().root.find(made)->parameter("minor"), nullptr);
    hands().click("group/exposed/minor");
    hands().key('A', true);
    hands().type("Thickness");
    hands().key(ui::key::enter);
    EXPECT_EQ(document().groups[0].exposed[0].name, "Thickness");
    expect_valid();
    over_canvas();
    hands().key(ui::key::escape);
    EXPECT_TRUE(hands().shows("inspector/Thickness"));
    std::size_t before = hands().readings.program->instructions.size();
    glm::vec2 at = hands().place("inspector/Thickness");
    hands().drag(at, at + glm::vec2(30, 0));
    EXPECT_NE(*document().root.find(made)->parameter("Thickness"), graph::Value(0.2f));
    EXPECT_EQ(hands().readings.program->instructions.size(), before);
    expect_valid();
}

TEST_F(Hands, what_is_exposed_is_moved_and_removed_in_the_inspector)
{
    make_group();
    hands().key(ui::key::tab);
    hands().frames(2);
    for (const char* name : {"minor", "major"})
        ASSERT_FALSE(graph::expose(document(), *hands().library, "Group", ring, name));
    hands().frames(2);
    hands().click("group/exposed/major/up");
    EXPECT_EQ(document().groups[0].exposed[0].name, "major");
    EXPECT_EQ(step(), "Move major");
    hands().click("group/exposed/minor/remove");
    EXPECT_EQ(document().groups[0].exposed.size(), 1u);
    expect_valid();
}

TEST_F(Hands, what_is_exposed_is_described_in_the_inspector)
{
    make_group();
    hands().key(ui::key::tab);
    hands().frames(2);
    ASSERT_FALSE(graph::expose(document(), *hands().library, "Group", ring, "minor"));
    hands().frames(2);
    hands().click("group/exposed/minor/help");
    hands().type("How thick the tyre is.");
    hands().key(ui::key::enter);
    EXPECT_EQ(document().groups[0].exposed[0].help, "How thick the tyre is.");
    EXPECT_EQ(step(), "Describe minor");
    hands().frames(2);
    EXPECT_EQ(hands().library->type("group:Group")->parameter("minor")->help, "How thick the tyre is.");
    expect_valid();
}

TEST_F(Hands, ungrouping_shows_the_same_picture_as_before)
{
    make_group();
    hands().key('G', true, false, true);
    EXPECT_TRUE(document().groups.empty());
    EXPECT_EQ(driver->editor.view.selection.nodes().size(), 3u);
    EXPECT_EQ(document().root.nodes.size(), flat.root.nodes.size());
    graph::LowerOptions options{.ids = false};  // which are others now
    graph::Program before = graph::lower(flat, hands().library, options);
    graph::Program after = graph::lower(document(), hands().library, options);
    ASSERT_EQ(before.instructions.size(), after.instructions.size());
    for (std::size_t i = 0; i < before.instructions.size(); ++i)
        EXPECT_EQ(before.instructions[i].function, after.instructions[i].function);
    EXPECT_EQ(before.block, after.block);
    expect_valid();
}

TEST_F(Hands, a_shape_added_inside_becomes_part_of_the_group)
{
    make_group();
    hands().key(ui::key::tab);
    hands().frames(2);
    driver->editor.view.selection.clear();
    driver->editor.run("add.sphere");
    hands().frames(3);
    const graph::Group& group = document().groups[0];
    EXPECT_EQ(group.graph.find(group.output)->type, "union");
    EXPECT_EQ(document().root.nodes.size(), 2u);
    expect_valid();
}

TEST_F(Hands, saving_a_group_asks_for_a_file_and_a_saved_one_can_be_added)
{
    make_group();
    driver->editor.run("edit.save_group");
    hands().frames(2);
    const ui::SaveGroup* save = nullptr;
    for (const ui::Request& request : hands().requests)
        if (auto* found = std::get_if<ui::SaveGroup>(&request)) save = found;
    ASSERT_TRUE(save);
    EXPECT_EQ(save->name, "Group");
    graph::SavedGroupText saved = graph::read_saved_group(save->text, *graph::Library::embedded(), "Group.json");
    ui::SavedGroup entry{saved.type, save->text};
    entry.type.name = "my_group:Group";
    entry.type.category = "my_groups";
    Driver other({});
    other.readings.saved_groups = {entry};
    other.move(other.place("canvas"));
    other.editor.canvas().open_add_menu();
    other.frames(3);
    other.type("group");
    other.key(ui::key::enter);
    ASSERT_EQ(other.document.groups.size(), 1u);
    EXPECT_EQ(other.document.groups[0].name, "Group");
    EXPECT_EQ(graph::validate(other.document, *other.library), std::nullopt);
}

}  // namespace
}  // namespace fieldwright::tests
