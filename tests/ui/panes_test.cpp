// The borders between panes: dragged anywhere, no pane is lost.
#include "tests/ui/driver.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

using tests::Driver;

TEST(Splitters, dragged_beyond_every_edge_leave_each_pane_its_least)
{
    for (glm::vec2 size : {glm::vec2(1280, 720), glm::vec2(801, 503)}) {
        Driver driver({}, size);
        for (const char* name : {"splitter/side", "splitter/canvas", "splitter/inspector"})
            for (glm::vec2 away :
                 {glm::vec2(-3000, -3000), glm::vec2(3000, 3000), glm::vec2(-3, 5), glm::vec2(-3000, -3000)}) {
                driver.drag(driver.place(name), driver.place(name) + away, 0, 7);
                const ui::Panes& panes = driver.editor.view.panes;
                EXPECT_GE(panes.side_width, 279) << name;
                EXPECT_LE(panes.side_width, size.x - 319) << name;
                EXPECT_GE(panes.canvas_share, 0.099f) << name;
                EXPECT_LE(panes.canvas_share, 0.901f) << name;
                EXPECT_GE(panes.inspector_share, 0.149f) << name;
                EXPECT_LE(panes.inspector_share, 0.851f) << name;
            }
    }
}

}  // namespace
}  // namespace fieldwright
