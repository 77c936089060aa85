// A combiner of many on the canvas and in the inspector: what is wired, and one input more.
#include "tests/ui/driver.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::NodeId;

struct ManyInputs : testing::Test {
    ManyInputs()
    {
        auto library = graph::Library::embedded();
        graph::Document document;
        all = graph::add_node(document, *library, "smooth_union_many", {320, 0});
        for (float y : {0.0f, 110.0f, 220.0f, 330.0f})
            balls.push_back(graph::add_node(document, *library, "sphere", {0, y}));
        driver.emplace(std::move(document), glm::vec2(1600, 1000));
        driver->editor.view.panes.canvas_share = 0.8f;
        driver->editor.view.canvas = {{20, 20}, 1};
        driver->frames(2);
    }
    std::string pin(const std::string& socket) const
    {
        return "canvas/node/" + std::to_string(all.number) + "/in/" + socket;
    }
    void wire(std::size_t ball, const std::string& socket)
    {
        glm::vec2 from = driver->place("canvas/node/" + std::to_string(balls[ball].number) + "/out");
        driver->drag(from, driver->place(pin(socket)));
        driver->frames(2);
    }
    NodeId wired(const char* socket) const { return driver->document.root.find(all)->input(socket); }

    NodeId all;
    std::vector<NodeId> balls;
    std::optional<Driver> driver;
};

TEST_F(ManyInputs, show_what_is_wired_and_one_more)
{
    EXPECT_TRUE(driver->shows(pin("b")));
    EXPECT_FALSE(driver->shows(pin("shape_3")));
    EXPECT_TRUE(driver->shows(pin("smoothness")));
    wire(0, "a");
    EXPECT_FALSE(driver->shows(pin("shape_3")));
    wire(1, "b");
    wire(2, "shape_3");
    EXPECT_EQ(wired("shape_3"), balls[2]);
    EXPECT_TRUE(driver->shows(pin("shape_4")));
    EXPECT_FALSE(driver->shows(pin("shape_5")));
}

TEST_F(ManyInputs, keep_a_gap_between_wired_ones)
{
    wire(0, "a");
    wire(1, "b");
    wire(2, "shape_3");
    ASSERT_FALSE(graph::disconnect(driver->document, all, "b"));
    driver->frames(2);
    EXPECT_TRUE(driver->shows(pin("b")));
    EXPECT_TRUE(driver->shows(pin("shape_4")));
}

TEST_F(ManyInputs, are_the_same_in_the_inspector)
{
    wire(0, "a");
    wire(1, "b");
    driver->editor.view.selection.only(all);
    driver->frames(3);
    EXPECT_TRUE(driver->shows("inspector/input/shape_3"));
    EXPECT_FALSE(driver->shows("inspector/input/shape_4"));
}

TEST_F(ManyInputs, end_when_all_are_wired)
{
    const graph::NodeType& type = *driver->library->type("smooth_union_many");
    for (int i = 0; i < type.most_inputs; ++i)
        ASSERT_FALSE(graph::connect(driver->document, *driver->library, balls[static_cast<std::size_t>(i) % 4], all,
                                    type.inputs[static_cast<std::size_t>(i)].name));
    driver->frames(2);
    EXPECT_TRUE(driver->shows(pin("shape_16")));
    EXPECT_TRUE(driver->shows(pin("smoothness")));
}

}  // namespace
}  // namespace fieldwright::tests
