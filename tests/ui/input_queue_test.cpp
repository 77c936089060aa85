// Slow frames lose no click and no key.
#include "ui/input_queue.h"

#include "ui/keys.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace fieldwright {
namespace {

using Kind = ui::InputEvent::Kind;

class QueueOverSlowFrames : public testing::Test {
protected:
    QueueOverSlowFrames() : context_(ImGui::CreateContext())
    {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(640, 480);
        ui::map_keys(io);
        unsigned char* pixels;
        int width, height;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    ~QueueOverSlowFrames() override { ImGui::DestroyContext(context_); }

    // What happened within 100 ms is one frame's worth of events.
    template <typename Look>
    int count_over_frames(const Look& look)
    {
        int count = 0;
        do {
            ImGui::GetIO().DeltaTime = 0.1f;
            queue.pass(ImGui::GetIO());
            ImGui::NewFrame();
            count += look();
            ImGui::EndFrame();
        } while (!queue.empty());
        return count;
    }

    ui::InputQueue queue;

private:
    ImGuiContext* context_;
};

TEST_F(QueueOverSlowFrames, ten_taps_of_a_key_are_ten_presses)
{
    for (int i = 0; i < 10; ++i) {
        queue.push({.kind = Kind::key, .code = ui::key::del, .down = true});
        queue.push({.kind = Kind::key, .code = ui::key::del, .down = false});
    }
    EXPECT_EQ(count_over_frames([] { return ImGui::IsKeyPressed(ui::key::del, false) ? 1 : 0; }), 10);
}

TEST_F(QueueOverSlowFrames, ten_clicks_are_ten_clicks)
{
    for (int i = 0; i < 10; ++i) {
        queue.push({.kind = Kind::button, .code = 0, .down = true});
        queue.push({.kind = Kind::button, .code = 0, .down = false});
    }
    EXPECT_EQ(count_over_frames([] { return ImGui::IsMouseClicked(0) ? 1 : 0; }), 10);
}

TEST_F(QueueOverSlowFrames, a_quick_drag_is_pressed_where_it_began)
{
    queue.push({.kind = Kind::move, .at = {50, 200}});
    queue.push({.kind = Kind::button, .code = 0, .down = true});
    queue.push({.kind = Kind::move, .at = {300, 250}});
    queue.push({.kind = Kind::button, .code = 0, .down = false});
    float pressed_at = -1, released_at = -1;
    count_over_frames([&] {
        if (ImGui::IsMouseClicked(0)) pressed_at = ImGui::GetIO().MousePos.x;
        if (ImGui::IsMouseReleased(0)) released_at = ImGui::GetIO().MousePos.x;
        return 0;
    });
    EXPECT_EQ(pressed_at, 50);
    EXPECT_EQ(released_at, 300);
}

TEST_F(QueueOverSlowFrames, a_hand_is_seen_to_arrive_before_it_presses)
{
    queue.push({.kind = Kind::move, .at = {50, 200}});
    queue.push({.kind = Kind::button, .code = 0, .down = true});
    queue.push({.kind = Kind::button, .code = 0, .down = false});
    int frames = 0, pressed_in = 0;
    count_over_frames([&] {
        ++frames;
        if (ImGui::IsMouseClicked(0)) pressed_in = frames;
        return 0;
    });
    EXPECT_EQ(pressed_in, 2);
}

TEST_F(QueueOverSlowFrames, a_trembling_hand_can_double_click)
{
    for (float tremble : {0.0f, 2.0f}) {
        queue.push({.kind = Kind::move, .at = {50 + tremble, 200}});
        queue.push({.kind = Kind::button, .code = 0, .down = true});
        queue.push({.kind = Kind::button, .code = 0, .down = false});
    }
    EXPECT_EQ(count_over_frames([] { return ImGui::IsMouseDoubleClicked(0) ? 1 : 0; }), 1);
}

TEST_F(QueueOverSlowFrames, a_shortcut_keeps_its_modifier)
{
    queue.push({.kind = Kind::key, .code = ui::key::left_control, .down = true});
    queue.push({.kind = Kind::key, .code = 'Z', .down = true});
    queue.push({.kind = Kind::key, .code = 'Z', .down = false});
    queue.push({.kind = Kind::key, .code = ui::key::left_control, .down = false});
    EXPECT_EQ(count_over_frames([] { return ImGui::GetIO().KeyCtrl && ImGui::IsKeyPressed('Z', false) ? 1 : 0; }), 1);
}

TEST_F(QueueOverSlowFrames, a_press_comes_a_frame_after_the_move_to_its_place)
{
    queue.push({.kind = Kind::move, .at = {50, 60}});
    queue.push({.kind = Kind::key, .code = 'X', .down = true});
    queue.push({.kind = Kind::button, .code = 0, .down = true});
    std::vector<bool> pressed;
    count_over_frames([&] {
        pressed.push_back(ImGui::IsMouseClicked(0) && ImGui::IsKeyPressed('X', false));
        EXPECT_EQ(ImGui::GetIO().MousePos.x, 50);
        return 0;
    });
    EXPECT_EQ(pressed, (std::vector<bool>{false, true}));
}

TEST_F(QueueOverSlowFrames, a_release_and_what_follows_it_come_one_by_one)
{
    queue.push({.kind = Kind::button, .code = 0, .down = true});
    queue.push({.kind = Kind::move, .at = {50, 60}});
    queue.push({.kind = Kind::button, .code = 0, .down = false});
    queue.push({.kind = Kind::key, .code = ui::key::space, .down = true});
    std::string told;
    count_over_frames([&] {
        const ImGuiIO& io = ImGui::GetIO();
        told += io.MouseDown[0] ? "held" : "free";
        told += io.MousePos.x == 50 ? " there" : " before";
        told += ImGui::IsKeyPressed(ui::key::space, false) ? " key; " : "; ";
        return 0;
    });
    EXPECT_EQ(told, "held before; held there; free there; free there key; ");
}

TEST_F(QueueOverSlowFrames, what_others_write_between_frames_does_not_count)
{
    queue.push({.kind = Kind::move, .at = {50, 60}});
    queue.push({.kind = Kind::button, .code = 0, .down = true});
    count_over_frames([] { return 0; });
    // As the backend does: the real mouse is elsewhere, and its button already up.
    ImGui::GetIO().MousePos = ImVec2(300, 300);
    ImGui::GetIO().MouseDown[0] = false;
    count_over_frames([] { return 0; });
    EXPECT_EQ(ImGui::GetIO().MousePos.x, 50);
    EXPECT_TRUE(ImGui::GetIO().MouseDown[0]);
}

TEST_F(QueueOverSlowFrames, lost_focus_releases_everything)
{
    queue.push({.kind = Kind::button, .code = 0, .down = true});
    queue.push({.kind = Kind::key, .code = ui::key::left_shift, .down = true});
    queue.push({.kind = Kind::focus, .down = false});
    count_over_frames([] { return 0; });
    EXPECT_FALSE(ImGui::GetIO().MouseDown[0]);
    EXPECT_FALSE(ImGui::GetIO().KeyShift);
}

TEST_F(QueueOverSlowFrames, tells_a_press_that_waits_from_a_mere_move)
{
    queue.push({.kind = Kind::move, .at = {50, 60}});
    queue.push({.kind = Kind::wheel, .at = {0, 1}});
    EXPECT_FALSE(queue.has_press());
    for (Kind kind : {Kind::key, Kind::button, Kind::character}) {
        queue.push({.kind = kind, .code = 1, .down = true});
        EXPECT_TRUE(queue.has_press());
        count_over_frames([] { return 0; });
        EXPECT_FALSE(queue.has_press());
    }
}

TEST_F(QueueOverSlowFrames, a_recording_replays_the_same_events)
{
    std::vector<ui::InputEvent> events = {{.kind = Kind::move, .at = {10.5f, 20}},
                                          {.kind = Kind::button, .code = 1, .down = true},
                                          {.kind = Kind::button, .code = 1, .down = false},
                                          {.kind = Kind::wheel, .at = {0, -1}},
                                          {.kind = Kind::key, .code = ui::key::home, .down = true},
                                          {.kind = Kind::character, .code = 0x3b1},
                                          {.kind = Kind::focus, .down = false}};
    queue.start_recording();
    for (const ui::InputEvent& event : events) queue.push(event);
    count_over_frames([] { return 0; });
    std::vector<ui::InputEvent> read;
    for (const auto& frame : ui::parse_recording(queue.recording()))
        read.insert(read.end(), frame.begin(), frame.end());
    EXPECT_EQ(read, events);
}

}  // namespace
}  // namespace fieldwright
