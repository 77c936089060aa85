// What hands did at 60 frames a second, told again at 10: every click and key counts, and the scene becomes the same.
#include "tests/ui/driver.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

using tests::Driver;

graph::Document example()
{
    return graph::open_scene(FIELDWRIGHT_SOURCE_DIR "/examples/first.scene.json", *graph::Library::embedded());
}

// A little of everything: added by search, typed, dragged, shortcuts in a burst.
void work(Driver& driver)
{
    driver.move(driver.place("canvas"));
    driver.key(ui::key::tab);
    driver.type("torus");
    driver.key(ui::key::enter);
    driver.drag(driver.place("inspector/minor"), driver.place("inspector/minor") + glm::vec2(30, 0));
    driver.move(driver.place("canvas"));
    for (int i = 0; i < 3; ++i) driver.key('D', true);
    driver.key('M');
    driver.key('A', true);
    driver.key('Z', true);
    driver.key('Z', true);
    driver.key('Y', true);
    driver.click("panel/tab/lights");
    driver.click("panel/lights/add");
    driver.click("panel/lights/add/point");
}

TEST(Replay, at_100_ms_per_frame_loses_no_click_and_no_key)
{
    std::string recording;
    graph::Document made;
    std::vector<std::string> steps;
    {
        Driver driver(example());
        driver.queue.start_recording();
        work(driver);
        recording = driver.queue.recording();
        made = driver.document;
        steps = driver.readings.step_names;
    }
    ASSERT_GT(steps.size(), 6u);

    Driver driver(example());
    driver.frame_s = 0.1f;
    constexpr std::size_t told_at_once = 6;  // frames of 1/60 s in 100 ms
    auto frames = ui::parse_recording(recording);
    for (std::size_t i = 0; i < frames.size(); i += told_at_once) {
        for (std::size_t j = i; j < std::min(i + told_at_once, frames.size()); ++j)
            for (const ui::InputEvent& event : frames[j]) driver.queue.push(event);
        driver.frame();
    }
    driver.run_until_quiet();
    EXPECT_EQ(driver.readings.step_names, steps);
    EXPECT_TRUE(driver.document == made);
}

}  // namespace
}  // namespace fieldwright
