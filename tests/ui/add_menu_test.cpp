// The add menu: found by name, placed by meaning, one step each.
#include "tests/ui/driver.h"

#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::NodeId;

class AddMenuTest : public testing::Test {
protected:
    AddMenuTest()
    {
        sphere = graph::add_node(start, *library, "sphere", {0, 0});
        output = graph::add_node(start, *library, "output", {400, 0});
        EXPECT_FALSE(graph::connect(start, *library, sphere, output, "d"));
    }
    Driver& open()
    {
        driver.emplace(start);
        driver->editor.view.panes.canvas_share = 0.9f;
        driver->editor.view.canvas = {{20, 20}, 1};
        driver->frames(2);
        driver->move(driver->place("canvas") + glm::vec2(0, -20));
        driver->editor.canvas().open_add_menu();
        driver->frames(3);
        return *driver;
    }
    const graph::Node& node(NodeId id) { return *driver->document.root.find(id); }
    NodeId root() { return node(output).input("d"); }
    void expect_one_step(std::string_view name)
    {
        ASSERT_EQ(driver->steps.size(), 2u);
        EXPECT_EQ(driver->steps[1].second, name);
        EXPECT_EQ(driver->steps[0].first, start);
        EXPECT_FALSE(graph::validate(driver->document, *library));
    }

    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    graph::Document start;
    NodeId sphere, output;
    std::optional<Driver> driver;
};

TEST_F(AddMenuTest, the_search_field_has_the_keyboard_at_once_and_enter_takes_the_first)
{
    open().type("torus");
    driver->key(ui::key::enter);
    EXPECT_FALSE(driver->shows("add_menu/search"));
    NodeId torus = driver->editor.view.selection.active();
    ASSERT_TRUE(torus);
    EXPECT_EQ(node(torus).type, "torus");
    expect_one_step("Add torus");
}

TEST_F(AddMenuTest, a_shape_is_united_with_what_the_output_shows)
{
    open().type("torus");
    driver->key(ui::key::enter);
    NodeId torus = driver->editor.view.selection.active();
    EXPECT_EQ(node(root()).type, "union");
    EXPECT_EQ((std::set<NodeId>{node(root()).input("a"), node(root()).input("b")}), (std::set<NodeId>{sphere, torus}));
    expect_one_step("Add torus");
}

TEST_F(AddMenuTest, an_operator_goes_after_the_selected_node)
{
    open();
    driver->editor.view.selection.only(sphere);
    driver->type("twist");
    driver->key(ui::key::enter);
    EXPECT_EQ(node(root()).type, "twist");
    EXPECT_EQ(node(root()).input("d"), sphere);
    EXPECT_EQ(driver->editor.view.selection.active(), root());
    expect_one_step("Add twist");
}

TEST_F(AddMenuTest, anything_else_is_placed_at_the_cursor)
{
    open();
    driver->type("phong");
    glm::vec2 cursor = driver->editor.canvas().cursor_on_canvas();
    driver->key(ui::key::enter);
    NodeId phong = driver->editor.view.selection.active();
    EXPECT_EQ(node(phong).position, cursor);
    EXPECT_EQ(root(), sphere);
    expect_one_step("Add phong");
}

TEST_F(AddMenuTest, synonyms_are_found)
{
    open().type("smin");
    EXPECT_TRUE(driver->shows("add_menu/item/smooth_union"));
    EXPECT_FALSE(driver->shows("add_menu/item/sphere"));
}

TEST_F(AddMenuTest, arrows_move_to_the_next_and_enter_takes_it)
{
    open().type("smooth");
    std::vector<std::pair<float, std::string>> shown;
    for (const auto& [name, rect] : driver->editor.rects.all())
        if (name.starts_with("add_menu/item/")) shown.emplace_back(rect.low.y, name.substr(14));
    ASSERT_GE(shown.size(), 2u);
    std::sort(shown.begin(), shown.end());
    driver->key(ui::key::down);
    driver->key(ui::key::enter);
    EXPECT_EQ(node(driver->document.root.nodes.back().id).type, shown[1].second);
}

TEST_F(AddMenuTest, categories_are_listed_while_nothing_is_searched)
{
    open();
    EXPECT_TRUE(driver->shows("add_menu/item/box"));
    driver->click("add_menu/category/light");
    EXPECT_FALSE(driver->shows("add_menu/item/box"));
    driver->click("add_menu/item/sun");
    EXPECT_EQ(node(driver->editor.view.selection.active()).type, "sun");
    expect_one_step("Add sun");
}

TEST_F(AddMenuTest, recent_ones_come_first)
{
    open().type("torus");
    driver->key(ui::key::enter);
    driver->editor.canvas().open_add_menu();
    driver->frames(3);
    EXPECT_TRUE(driver->shows("add_menu/category/recent"));
    EXPECT_TRUE(driver->shows("add_menu/item/torus"));
    EXPECT_FALSE(driver->shows("add_menu/item/box"));
    driver->key(ui::key::enter);
    EXPECT_EQ(node(driver->editor.view.selection.active()).type, "torus");
}

TEST_F(AddMenuTest, a_second_output_is_not_offered)
{
    open().type("output");
    EXPECT_FALSE(driver->shows("add_menu/item/output"));
}

TEST_F(AddMenuTest, escape_closes_it)
{
    open().key(ui::key::escape);
    EXPECT_FALSE(driver->shows("add_menu/search"));
    EXPECT_EQ(driver->steps.size(), 1u);
}

TEST_F(AddMenuTest, a_right_click_opens_it_where_the_node_will_be)
{
    open().key(ui::key::escape);
    glm::vec2 at = driver->place("canvas") + glm::vec2(30, 60);
    driver->click(at, 1);
    ASSERT_TRUE(driver->shows("add_menu/search"));
    glm::vec2 cursor = driver->editor.canvas().cursor_on_canvas();
    driver->type("number");
    driver->key(ui::key::enter);
    EXPECT_EQ(node(driver->editor.view.selection.active()).position, cursor);
}

TEST_F(AddMenuTest, the_menu_of_a_wire_inserts_what_fits)
{
    open().key(ui::key::escape);
    driver->click("canvas/wire/" + std::to_string(output.number) + "/d", 1);
    driver->click("canvas/menu/insert");
    driver->frames(2);
    driver->type("phong");
    EXPECT_FALSE(driver->shows("add_menu/item/phong"));
    for (int i = 0; i < 5; ++i) driver->key(ui::key::backspace);
    driver->type("twist");
    driver->key(ui::key::enter);
    EXPECT_EQ(node(root()).type, "twist");
    EXPECT_EQ(node(root()).input("d"), sphere);
    expect_one_step("Add twist");
}

TEST_F(AddMenuTest, a_space_typed_by_the_key_that_opened_it_is_no_query)
{
    open().type(" ");
    EXPECT_TRUE(driver->shows("add_menu/category/primitive"));
}

TEST_F(AddMenuTest, a_node_to_be_written_is_found_by_name_and_lives_in_the_scene)
{
    open().type("custom modifier");
    driver->key(ui::key::enter);
    ASSERT_EQ(driver->document.own_types.size(), 1u);
    NodeId added = driver->editor.view.selection.active();
    ASSERT_TRUE(added);
    EXPECT_EQ(node(added).type, driver->document.own_types[0].name);
    driver->editor.canvas().open_add_menu();
    driver->frames(3);
    EXPECT_TRUE(driver->shows("add_menu/category/custom"));
}

TEST_F(AddMenuTest, a_loose_wire_is_offered_no_node_that_is_yet_to_be_written)
{
    open();
    driver->key(ui::key::escape);
    glm::vec2 from = driver->place("canvas/node/" + std::to_string(sphere.number) + "/out");
    driver->drag(from, from + glm::vec2(40, 220));
    driver->frames(3);
    ASSERT_TRUE(driver->shows("add_menu/search"));
    EXPECT_FALSE(driver->shows("add_menu/category/custom"));
}

}  // namespace
}  // namespace fieldwright::tests
