// Scripts: the hands of screenshots and of the walk through the window.
#include "app/script.h"

#include "graph/problem.h"
#include "tests/graph/temporary_folder.h"
#include "ui/keys.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace fieldwright {
namespace {

using Kind = ui::InputEvent::Kind;

class ScriptTest : public testing::Test {
protected:
    app::Script script(const std::string& text)
    {
        graph::write_file(folder_ / "test.script", text);
        return app::Script(folder_ / "test.script");
    }

    // Plays to the end as the window does, a frame at a time; what was told to Dear ImGui, as a recording.
    std::string played(app::Script script, int frame_limit = 200)
    {
        ImGuiIO io;
        input.start_recording();
        app::Script::Stage stage{
            .input = input,
            .rects = rects,
            .settled = true,
            .take_screenshot = [&](const std::filesystem::path& path) { screenshots.push_back(path.string()); },
            .drop = [&](const std::filesystem::path& path) { dropped.push_back(path.string()); },
            .resize = [&](glm::ivec2 wanted) { size = wanted; },
            .quit = [&] { quit = true; },
        };
        for (int i = 0; i < frame_limit && !(script.finished() && input.empty()); ++i) {
            input.pass(io);
            script.play(stage);
        }
        EXPECT_TRUE(script.finished());
        std::string told;
        for (const auto& frame : ui::parse_recording(input.recording()))
            for (const ui::InputEvent& event : frame) told += ui::event_line(event) + "; ";
        return told;
    }

    ui::InputQueue input;
    ui::WidgetRects rects;
    std::vector<std::string> screenshots, dropped;
    glm::ivec2 size{0, 0};
    bool quit = false;

private:
    graph::TemporaryFolder folder_;
};

TEST_F(ScriptTest, a_click_presses_and_releases_in_the_middle_of_the_widget)
{
    rects.listening = true;
    rects.mark("menu/File", {{10, 20}, {30, 40}});
    EXPECT_EQ(played(script("# a comment\n\nclick menu/File\n")), "move 20 30; button 0 down; button 0 up; ");
}

TEST_F(ScriptTest, keys_come_with_their_modifiers_and_text_as_letters)
{
    EXPECT_EQ(played(script("key ctrl+z\ntype ab\n")),
              "key 341 down; key 90 down; key 90 up; key 341 up; character 97; character 98; ");
}

TEST_F(ScriptTest, text_of_any_alphabet_comes_as_code_points)
{
    EXPECT_EQ(played(script("type \u00e9\u03b1\u6c34\U0001f642 x\n")),
              "character 233; character 945; character 27700; character 128578; character 32; character 120; ");
    for (const char* broken : {"\xff", "a\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80"})
        EXPECT_THROW(script(std::string("type ") + broken + "\n"), graph::Failure) << broken;
}

TEST_F(ScriptTest, every_key_that_a_shortcut_may_use_has_a_name)
{
    auto key = [](std::string_view text) { return app::parse_key_chord(text).value_or(app::KeyChord{-1}).key; };
    EXPECT_EQ(key("a"), ui::key::a);
    EXPECT_EQ(key("z"), ui::key::z);
    EXPECT_EQ(key("0"), ui::key::zero);
    EXPECT_EQ(key("ctrl+9"), ui::key::nine);
    for (int number = 1; number <= 12; ++number) EXPECT_EQ(key("f" + std::to_string(number)), ui::key::f1 + number - 1);
    EXPECT_EQ(key("f12"), ui::key::f12);
    EXPECT_EQ(key("home"), ui::key::home);
    EXPECT_EQ(key("end"), ui::key::end);
    EXPECT_EQ(key("shift+page_up"), ui::key::page_up);
    EXPECT_EQ(key("page_down"), ui::key::page_down);
    EXPECT_EQ(key("keypad_9"), ui::key::keypad_9);
    EXPECT_EQ(key("comma"), ui::key::comma);
    for (const char* none : {"f0", "f13", "10", "A", "", "ctrl+"}) EXPECT_EQ(key(none), -1) << none;
}

TEST_F(ScriptTest, sizes_follow_each_other_frame_by_frame)
{
    std::string sizes;
    for (int i = 1; i <= 50; ++i) sizes += "resize " + std::to_string(100 + i) + "x80\n";
    played(script(sizes), 55);
    EXPECT_EQ(size, glm::ivec2(150, 80));
}

TEST_F(ScriptTest, a_drag_moves_in_steps_between_press_and_release)
{
    rects.listening = true;
    rects.mark("a", {{0, 0}, {20, 20}});
    std::string told = played(script("drag a 60 0\n"));
    EXPECT_EQ(told.find("move 10 10; button 0 down; move 20 10; "), 0u) << told;
    EXPECT_NE(told.find("move 70 10; wheel 0 0; button 0 up; "), std::string::npos) << told;
}

TEST_F(ScriptTest, the_window_is_asked_for_pictures_sizes_and_its_end)
{
    played(script("settle\nscreenshot a.png\ndrop b.png\nresize 640x480\nquit\n"));
    EXPECT_EQ(dropped, std::vector<std::string>{"b.png"});
    EXPECT_EQ(screenshots, std::vector<std::string>{"a.png"});
    EXPECT_EQ(size, glm::ivec2(640, 480));
    EXPECT_TRUE(quit);
}

TEST_F(ScriptTest, a_slip_is_refused_with_file_and_line)
{
    for (const char* text : {"click a\ndance\n", "click a\nkey ctrl+nothing\n", "click a\ndrag a\n"}) {
        try {
            script(text);
            ADD_FAILURE() << text << " was taken";
        } catch (const graph::Failure& failure) {
            EXPECT_EQ(std::string(failure.what()).find("test.script:2: "), 0u) << failure.what();
            EXPECT_EQ(failure.exit_code, 2);
        }
    }
}

TEST_F(ScriptTest, a_widget_that_never_appears_is_named)
{
    app::Script waiting = script("click nowhere\n");
    EXPECT_THROW(played(std::move(waiting), 2000), graph::Failure);
}

}  // namespace
}  // namespace fieldwright
