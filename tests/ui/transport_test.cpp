// The clock of the animation: frames, loops and their ends; and the bar's buttons.
#include "ui/transport.h"

#include "graph/settings.h"
#include "tests/support/scene.h"
#include "tests/ui/driver.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::AnimationSettings;
using ui::ViewState;

const AnimationSettings ten{.first_frame = 1, .last_frame = 10, .frames_per_second = 10};

TEST(Frames, show_the_moment_that_many_frames_after_the_first)
{
    EXPECT_EQ(graph::time_of_frame(ten, 1), 0.0f);
    EXPECT_FLOAT_EQ(graph::time_of_frame(ten, 4), 0.3f);
    for (int frame = -3; frame < 2000; ++frame)
        ASSERT_EQ(ui::shown_frame(ten, static_cast<double>(graph::time_of_frame(ten, frame))), frame);
}

TEST(Playing, goes_on_by_whole_frames_whatever_the_window_does)
{
    ViewState view;
    view.playing = true;
    for (int i = 0; i < 35; ++i) ui::play_on(view, ten, 0.01);
    EXPECT_EQ(ui::shown_frame(ten, view.time_s), 4);
    EXPECT_FLOAT_EQ(static_cast<float>(view.time_s), 0.3f) << "not between frames";
    ui::play_on(view, ten, 0.2);
    EXPECT_EQ(ui::shown_frame(ten, view.time_s), 6);
}

TEST(Playing, begins_again_or_stops_at_the_last_frame)
{
    ViewState view;
    view.playing = true;
    ui::go_to_frame(view, ten, 10);
    ui::play_on(view, ten, 0.11);
    EXPECT_EQ(ui::shown_frame(ten, view.time_s), 1);
    EXPECT_TRUE(view.playing);
    view.looping = false;
    ui::go_to_frame(view, ten, 9);
    ui::play_on(view, ten, 0.5);
    EXPECT_EQ(ui::shown_frame(ten, view.time_s), 10);
    EXPECT_FALSE(view.playing);
}

TEST(Stepping, wraps_only_in_a_loop)
{
    ViewState view;
    ui::step_frames(view, ten, -1);
    EXPECT_EQ(ui::shown_frame(ten, view.time_s), 10);
    view.looping = false;
    ui::step_frames(view, ten, 3);
    EXPECT_EQ(ui::shown_frame(ten, view.time_s), 10);
}

class Transport : public testing::Test {
protected:
    Transport()
    {
        driver.readings.program = std::make_shared<graph::Program>(graph::lower(driver.document, driver.library));
        driver.frames(2);
    }

    static graph::Document swinging()
    {
        Scene scene;
        NodeId radius = scene.node("sine", {{"x", scene.node("time")}});
        scene.show(scene.node("sphere", {{"radius", radius}}));
        scene.document.animation = ten;
        return scene.document;
    }

    int frame() const { return ui::shown_frame(ten, driver.editor.view.time_s); }

    Driver driver{swinging()};
};

TEST_F(Transport, is_there_when_something_depends_on_time)
{
    EXPECT_TRUE(driver.shows("viewport/transport"));
    driver.readings.program = nullptr;
    driver.frames(2);
    EXPECT_FALSE(driver.shows("viewport/transport"));
}

TEST_F(Transport, has_buttons_that_do_what_the_commands_do)
{
    driver.click("viewport/next_frame");
    driver.click("viewport/next_frame");
    EXPECT_EQ(frame(), 3);
    driver.click("viewport/previous_frame");
    EXPECT_EQ(frame(), 2);
    driver.click("viewport/start");
    EXPECT_EQ(frame(), 1);
    driver.click("viewport/play");
    EXPECT_TRUE(driver.editor.view.playing);
    driver.click("viewport/loop");
    EXPECT_FALSE(driver.editor.view.looping);
}

TEST_F(Transport, is_scrubbed_along_its_line)
{
    ui::WidgetRect line = *driver.editor.rects.find("viewport/time");
    driver.move({line.high.x - 3, line.centre().y});
    driver.press();
    driver.release();
    EXPECT_EQ(frame(), 10);
    driver.move({line.low.x + 3, line.centre().y});
    driver.press();
    driver.release();
    EXPECT_EQ(frame(), 1);
}

}  // namespace
}  // namespace fieldwright::tests
