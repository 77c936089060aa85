// Hands on a node's own code: adding it, writing it, naming it, and code that a scene brings with it.
#include "graph/own_type_edits.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::NodeId;

class OwnCode : public testing::Test {
protected:
    OwnCode() : driver(graph::Document{}, {1280, 1000})
    {
        driver.editor.view.panes.inspector_share = 0.85f;
        driver.editor.run("add.custom/custom_shape");
        driver.frames(4);
    }
    const std::string& text(const char* type = "custom_shape") const
    {
        return graph::find_own_type(driver.document, type)->text;
    }
    std::string last_step() const { return driver.steps[driver.step].second; }
    NodeId node() const { return driver.editor.view.selection.active(); }
    void rest() { driver.frames(40); }
    // Into the first line, at its end.
    void enter_first_line()
    {
        auto rect = *driver.editor.rects.find("inspector/code");
        driver.click(rect.low + glm::vec2(60, 6));
        driver.key(ui::key::home, true);
        driver.key(ui::key::end);
    }
    template <typename Kind>
    int asked() const
    {
        return static_cast<int>(std::count_if(driver.requests.begin(), driver.requests.end(), [](const auto& request) {
            return std::holds_alternative<Kind>(request);
        }));
    }

    Driver driver;
};

TEST_F(OwnCode, is_added_with_a_node_in_one_step_and_trusted)
{
    ASSERT_EQ(driver.document.own_types.size(), 1u);
    EXPECT_EQ(driver.document.root.find(node())->type, "custom_shape");
    EXPECT_EQ(driver.steps.size(), 2u);
    EXPECT_EQ(asked<ui::TrustCode>(), 1);
    EXPECT_TRUE(driver.shows("inspector/code"));
    EXPECT_TRUE(driver.shows("inspector/gpu_only"));
    EXPECT_TRUE(driver.shows("inspector/size"));
    driver.editor.run("add.custom/custom_shape");
    driver.frames(4);
    EXPECT_EQ(driver.document.root.find(node())->type, "custom_shape_2");
    driver.editor.run("edit.undo");
    driver.frames(4);
    EXPECT_EQ(driver.document.own_types.size(), 1u);
}

TEST_F(OwnCode, what_is_typed_is_one_step_once_it_rests)
{
    enter_first_line();
    driver.type(" Mine.");
    EXPECT_EQ(driver.steps.size(), 2u) << "still typing";
    rest();
    EXPECT_EQ(driver.steps.size(), 3u);
    EXPECT_EQ(last_step(), "Edit the code of Custom shape");
    EXPECT_TRUE(text().starts_with("// Custom shape: a rounded box, yours to change. Mine.\n")) << text();
    driver.type(" Still.");
    rest();
    EXPECT_EQ(driver.steps.size(), 4u) << "a second burst in the same field";
    EXPECT_EQ(asked<ui::TrustCode>(), 3);
    EXPECT_EQ(driver.library->type("custom_shape")->help, "A rounded box, yours to change. Mine. Still.");
}

TEST_F(OwnCode, control_enter_applies_at_once)
{
    enter_first_line();
    driver.type(" Mine.");
    driver.key(ui::key::enter, true);
    EXPECT_EQ(driver.steps.size(), 3u);
}

TEST_F(OwnCode, escape_keeps_what_was_typed)
{
    enter_first_line();
    driver.type(" Mine.");
    driver.key(ui::key::escape);
    EXPECT_NE(text().find("Mine."), std::string::npos);
}

TEST_F(OwnCode, a_tab_is_blanks_and_a_new_line_begins_where_the_last_did)
{
    enter_first_line();
    driver.key(ui::key::enter);
    driver.type("//");
    driver.key(ui::key::home);
    driver.key(ui::key::tab);
    driver.key(ui::key::end);
    driver.key(ui::key::enter);
    driver.type("// next");
    rest();
    EXPECT_NE(text().find("\n    //\n    // next\n"), std::string::npos) << text();
}

TEST_F(OwnCode, selecting_another_node_applies_what_was_typed)
{
    NodeId other = graph::add_node(driver.document, *driver.library, "sphere");
    enter_first_line();
    driver.type(" Mine.");
    driver.editor.view.selection.only(other);
    driver.frames(2);
    EXPECT_NE(text().find("Mine."), std::string::npos);
}

TEST_F(OwnCode, a_slip_is_told_on_the_node_and_mended)
{
    graph::Document whole = driver.document;
    enter_first_line();
    driver.key(ui::key::enter);
    driver.type("#define A B");
    rest();
    ASSERT_FALSE(driver.readings.problems.empty());
    EXPECT_EQ(driver.readings.problems[0].node, node());
    EXPECT_NE(driver.readings.problems[0].sentence.find("line 2, column 1: preprocessor"), std::string::npos)
        << driver.readings.problems[0].sentence;
    ASSERT_TRUE(driver.shows("inspector/code")) << "the way to mend it";
    driver.editor.run("edit.undo");
    driver.frames(4);
    EXPECT_EQ(driver.document, whole);
    EXPECT_TRUE(driver.library->type("custom_shape"));
}

TEST_F(OwnCode, the_type_is_renamed_in_text_and_nodes)
{
    driver.click("inspector/type_name");
    driver.key('A', true);
    driver.type("pebble");
    driver.key(ui::key::enter);
    driver.frames(2);
    ASSERT_EQ(driver.document.own_types.size(), 1u);
    EXPECT_EQ(driver.document.own_types[0].name, "pebble");
    EXPECT_NE(text("pebble").find("float pebble_distance("), std::string::npos);
    EXPECT_EQ(driver.document.root.find(node())->type, "pebble");
    EXPECT_EQ(graph::validate(driver.document, *driver.library), std::nullopt);
}

TEST_F(OwnCode, a_name_that_is_taken_is_refused)
{
    driver.click("inspector/type_name");
    driver.key('A', true);
    driver.type("sphere");
    driver.key(ui::key::enter);
    driver.frames(2);
    EXPECT_EQ(driver.document.own_types[0].name, "custom_shape");
    EXPECT_EQ(driver.steps.size(), 2u);
}

TEST_F(OwnCode, one_of_two_nodes_gets_code_of_its_own)
{
    NodeId first = node();
    driver.editor.run("edit.duplicate");
    driver.frames(4);
    ASSERT_NE(node(), first);
    driver.click("inspector/code/single");
    driver.frames(2);
    EXPECT_EQ(driver.document.root.find(first)->type, "custom_shape");
    EXPECT_EQ(driver.document.root.find(node())->type, "custom_shape_2");
}

TEST_F(OwnCode, is_kept_for_other_scenes_on_demand)
{
    driver.click("inspector/code/save");
    EXPECT_EQ(asked<ui::SaveOwnNode>(), 1);
}

TEST_F(OwnCode, unused_code_is_removed_by_a_command)
{
    driver.editor.run("edit.delete");
    driver.frames(4);
    ASSERT_EQ(driver.document.own_types.size(), 1u) << "it may come back";
    driver.editor.run("edit.remove_unused_types");
    driver.frames(4);
    EXPECT_TRUE(driver.document.own_types.empty());
    EXPECT_EQ(last_step(), "Remove unused code");
}

TEST_F(OwnCode, code_that_came_with_the_scene_is_asked_about_once)
{
    EXPECT_FALSE(driver.shows("dialog/run_code"));
    driver.readings.foreign_code = {{"theirs", "// Theirs: code.\n"}};
    driver.frames(3);
    ASSERT_TRUE(driver.shows("dialog/run_code"));
    driver.click("dialog/show_code");
    EXPECT_TRUE(driver.shows("dialog/code"));
    driver.click("dialog/not_now");
    driver.frames(3);
    EXPECT_FALSE(driver.shows("dialog/run_code"));
    EXPECT_EQ(asked<ui::AllowSceneCode>(), 0);
    driver.editor.run("file.allow_code");
    driver.frames(3);
    driver.click("dialog/run_code");
    EXPECT_EQ(asked<ui::AllowSceneCode>(), 1);
    driver.readings.foreign_code = {{"others", "// Others: code.\n"}};
    driver.frames(3);
    EXPECT_TRUE(driver.shows("dialog/run_code")) << "other code is another question";
}

}  // namespace
}  // namespace fieldwright::tests
