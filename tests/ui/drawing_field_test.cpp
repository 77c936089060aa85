// Hands on a drawing: every stroke is one step.
#include "graph/drawing.h"
#include "tests/ui/driver.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::Drawing;

struct Canvas {
    Canvas() : driver(graph::Document{}, {1280, 1000})
    {
        driver.editor.view.panes.inspector_share = 0.85f;
        id = graph::add_node(driver.document, *driver.library, "drawn_profile");
        EXPECT_EQ(graph::set_parameter(driver.document, *driver.library, id, "rectangles", graph::PointList{}),
                  std::nullopt);
        driver.steps = {{driver.document, "start"}};
        driver.editor.view.selection.only(id);
        driver.frames(2);
    }

    int side() const { return std::get<int>(*driver.document.root.find(id)->parameter("cells")); }
    Drawing drawing() const
    {
        return Drawing(std::get<graph::PointList>(*driver.document.root.find(id)->parameter("rectangles")), side());
    }
    // The middle of a cell on the screen.
    glm::vec2 place(int x, int y)
    {
        ui::WidgetRect rect = *driver.editor.rects.find("inspector/rectangles/canvas");
        float cell = (rect.high.x - rect.low.x) / static_cast<float>(side());
        return {rect.low.x + (static_cast<float>(x) + 0.5f) * cell,
                rect.high.y - (static_cast<float>(y) + 0.5f) * cell};
    }
    void tool(const char* name) { driver.click(std::string("inspector/rectangles/tool/") + name); }
    void stroke(int x0, int y0, int x1, int y1, int button = 0) { driver.drag(place(x0, y0), place(x1, y1), button); }
    std::string last_step() const { return driver.steps.back().second; }

    Driver driver;
    graph::NodeId id;
};

TEST(DrawingField, a_stroke_fills_every_cell_on_its_way_and_is_one_step)
{
    Canvas canvas;
    canvas.stroke(2, 3, 12, 3);
    Drawing expected(16);
    for (int x = 2; x <= 12; ++x) expected.fill(x, 3, true);
    EXPECT_EQ(canvas.drawing(), expected);
    EXPECT_EQ(canvas.driver.steps.size(), 2u);
    EXPECT_EQ(canvas.last_step(), "Paint drawn profile");
    canvas.stroke(5, 3, 6, 3, 1);
    expected.fill(5, 3, false), expected.fill(6, 3, false);
    EXPECT_EQ(canvas.drawing(), expected) << "the right button erases";
    EXPECT_EQ(canvas.last_step(), "Erase drawn profile");
    canvas.tool("erase");
    canvas.driver.click(canvas.place(2, 3));
    expected.fill(2, 3, false);
    EXPECT_EQ(canvas.drawing(), expected);
    EXPECT_EQ(canvas.driver.steps.size(), 4u);
}

TEST(DrawingField, a_line_and_a_rectangle_go_from_where_the_mouse_went_down_to_where_it_is)
{
    Canvas canvas;
    canvas.tool("rectangle");
    canvas.stroke(3, 4, 8, 9);
    Drawing expected(16);
    for (int y = 4; y <= 9; ++y)
        for (int x = 3; x <= 8; ++x) expected.fill(x, y, true);
    EXPECT_EQ(canvas.drawing(), expected);
    canvas.tool("line");
    canvas.stroke(0, 0, 15, 15);
    for (int i = 0; i < 16; ++i) expected.fill(i, i, true);
    EXPECT_EQ(canvas.drawing(), expected);
    EXPECT_EQ(canvas.driver.steps.size(), 3u);
}

TEST(DrawingField, mirrored_strokes_paint_both_halves)
{
    Canvas canvas;
    canvas.driver.click("inspector/rectangles/mirror");
    canvas.stroke(1, 2, 4, 2);
    Drawing expected(16);
    for (int x : {1, 2, 3, 4}) expected.fill(x, 2, true), expected.fill(15 - x, 2, true);
    EXPECT_EQ(canvas.drawing(), expected);
}

TEST(DrawingField, buttons_clear_invert_refine_and_coarsen)
{
    Canvas canvas;
    canvas.driver.click(canvas.place(4, 5));
    canvas.driver.click("inspector/rectangles/finer");
    EXPECT_EQ(canvas.side(), 32);
    EXPECT_EQ(canvas.drawing().count(), 4);
    EXPECT_TRUE(canvas.drawing().filled(9, 11));
    EXPECT_EQ(canvas.driver.steps.size(), 3u) << "cells and rectangles are one step";
    canvas.driver.click("inspector/rectangles/coarser");
    EXPECT_EQ(canvas.side(), 16);
    EXPECT_EQ(canvas.drawing().count(), 1);
    canvas.driver.click("inspector/rectangles/invert");
    EXPECT_EQ(canvas.drawing().count(), 255);
    EXPECT_FALSE(canvas.drawing().filled(4, 5));
    canvas.driver.click("inspector/rectangles/clear");
    EXPECT_EQ(canvas.drawing().count(), 0);
    EXPECT_EQ(canvas.last_step(), "Clear drawn profile");
}

TEST(DrawingField, a_stroke_that_leaves_the_canvas_stays_on_it)
{
    Canvas canvas;
    canvas.stroke(14, 8, 20, 8);
    EXPECT_EQ(canvas.drawing().count(), 2);
    EXPECT_EQ(graph::validate(canvas.driver.document, *canvas.driver.library), std::nullopt);
}

}  // namespace
}  // namespace fieldwright::tests
