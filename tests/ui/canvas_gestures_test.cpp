// Gestures with more than one finger: the lasso, and all wires of an output at once.
#include "tests/ui/driver.h"

#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::NodeId;

class CanvasGestures : public testing::Test {
protected:
    NodeId add(std::string_view type, glm::vec2 position) { return graph::add_node(start, *library, type, position); }
    void wire(NodeId source, NodeId target, std::string_view socket)
    {
        ASSERT_FALSE(graph::connect(start, *library, source, target, socket));
    }
    void open()
    {
        driver.emplace(start);
        driver->editor.view.panes.canvas_share = 0.9f;
        driver->editor.view.canvas = {{60, 60}, 1};
        driver->editor.view.minimap = false;
        driver->frames(2);
    }
    void hold(int key, bool down = true)
    {
        driver->queue.push({.kind = ui::InputEvent::Kind::key, .code = key, .down = down});
        driver->run_until_quiet();
    }
    void draw(std::initializer_list<glm::vec2> way)
    {
        driver->move(*way.begin());
        driver->press();
        for (glm::vec2 p : way) driver->move(p);
    }
    static std::string name(NodeId id) { return "canvas/node/" + std::to_string(id.number); }
    glm::vec2 out(NodeId id) { return driver->place(name(id) + "/out"); }
    glm::vec2 middle(NodeId id) { return driver->place(name(id)); }
    NodeId source(NodeId id, std::string_view socket) { return driver->document.root.find(id)->input(socket); }
    const std::vector<NodeId>& selected() { return driver->editor.view.selection.nodes(); }

    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    graph::Document start;
    std::optional<Driver> driver;
};

class Lasso : public CanvasGestures {
protected:
    void SetUp() override
    {
        left = add("sphere", {0, 0}), right = add("box", {300, 0}), below = add("torus", {0, 260});
        open();
        hold(ui::key::left_control);
        hold(ui::key::left_alt);
    }
    // Around the two in the left column, with a bay that leaves out the one at the right.
    void around_the_left()
    {
        glm::vec2 a = middle(left), b = middle(below);
        draw({a + glm::vec2(-110, -50), a + glm::vec2(130, -50), b + glm::vec2(130, 80), b + glm::vec2(-110, 80)});
    }
    NodeId left, right, below;
};

TEST_F(Lasso, selects_the_nodes_whose_middle_is_in_it)
{
    around_the_left();
    driver->release();
    EXPECT_EQ(driver->editor.view.selection.as_set(), (std::set<NodeId>{left, below}));
    EXPECT_EQ(driver->steps.size(), 1u) << "looking at nodes is no step";
}

TEST_F(Lasso, begins_on_a_node_as_well_and_leaves_it_where_it_is)
{
    glm::vec2 a = middle(left);
    draw({a, a + glm::vec2(500, 0), a + glm::vec2(500, -55), a + glm::vec2(0, -55)});
    driver->release();
    EXPECT_EQ(driver->document, start);
}

TEST_F(Lasso, escape_brings_the_selection_back)
{
    driver->editor.view.selection.only(right);
    around_the_left();
    EXPECT_EQ(selected().size(), 2u);
    driver->key(ui::key::escape);
    driver->release();
    EXPECT_EQ(selected(), std::vector<NodeId>{right});
}

TEST_F(Lasso, with_shift_adds_to_the_selection)
{
    driver->editor.view.selection.only(right);
    hold(ui::key::left_shift);
    around_the_left();
    driver->release();
    EXPECT_EQ(selected().size(), 3u);
}

class MovingAllWires : public CanvasGestures {
protected:
    void SetUp() override
    {
        ball = add("sphere", {0, 0}), block = add("box", {0, 160}), round = add("round", {500, 300});
        both = add("union", {500, 0});
        wire(ball, both, "a");
        wire(ball, both, "b");
        wire(ball, round, "d");
        open();
        hold(ui::key::left_control);
    }
    NodeId ball, block, round, both;
};

TEST_F(MovingAllWires, to_another_output_is_one_step)
{
    driver->drag(out(ball), out(block));
    EXPECT_EQ(source(both, "a"), block);
    EXPECT_EQ(source(both, "b"), block);
    EXPECT_EQ(source(round, "d"), block);
    ASSERT_EQ(driver->steps.size(), 2u);
    EXPECT_EQ(driver->steps[1].second, "Move 3 wires");
    driver->editor.run("edit.undo");
    driver->frames(2);
    EXPECT_EQ(driver->document, start);
}

TEST_F(MovingAllWires, onto_one_of_their_readers_is_refused_with_its_reason)
{
    driver->move(out(ball));
    driver->press();
    driver->move(middle(both));
    const ui::MovingWires* wires = driver->editor.canvas().doing<ui::MovingWires>();
    ASSERT_TRUE(wires);
    EXPECT_NE(wires->reason.find("cycle"), std::string::npos) << wires->reason;
    driver->release();
    EXPECT_EQ(driver->document, start);
}

TEST_F(MovingAllWires, into_empty_space_takes_them_off)
{
    driver->drag(out(ball), out(ball) + glm::vec2(60, 220));
    EXPECT_FALSE(source(both, "a"));
    EXPECT_FALSE(source(round, "d"));
    ASSERT_EQ(driver->steps.size(), 2u);
    EXPECT_EQ(driver->steps[1].second, "Disconnect 3 wires");
}

TEST_F(MovingAllWires, back_onto_their_own_node_or_escape_change_nothing)
{
    driver->drag(out(ball), middle(ball));
    EXPECT_EQ(driver->document, start);
    driver->move(out(ball));
    driver->press();
    driver->move(out(block));
    driver->key(ui::key::escape);
    driver->release();
    EXPECT_EQ(driver->document, start);
    EXPECT_EQ(driver->steps.size(), 1u);
}

}  // namespace
}  // namespace fieldwright::tests
