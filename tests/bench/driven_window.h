// The window driven by a hand that a benchmark moves, and the times of its frames.
#pragma once

#include "app/workbench.h"
#include "tests/bench/timing.h"

#include <cmath>
#include <filesystem>

namespace fieldwright::bench {

inline double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double percentile(std::vector<double> numbers, double share)
{
    std::sort(numbers.begin(), numbers.end());
    auto at = static_cast<std::size_t>(share * static_cast<double>(numbers.size()));
    return numbers[std::min(numbers.size() - 1, at)];
}

struct FrameLog {
    std::vector<double> ui_s, ui_processor_s, edit_processor_s, whole_s;
    int pictures = 0, rendering = 0;  // rendering: frames in which a picture was in the making

    void note(const app::Workbench& workbench)
    {
        const app::Workbench::FrameTimes& times = workbench.frame_times();
        ui_s.push_back(times.ui.wall_s);
        ui_processor_s.push_back(times.ui.processor_s);
        edit_processor_s.push_back(times.edit.processor_s);
        whole_s.push_back(times.whole_s);
        rendering += workbench.rendering().busy;
    }
};

class DrivenWindow {
public:
    using Hand = std::function<void(double s)>;  // pushes events

    DrivenWindow(const std::filesystem::path& scene, const std::filesystem::path& state)
        : workbench_({.scene = scene, .state = state, .size = {1280, 720}})
    {
        workbench_.editor().rects.listening = true;
        run(1);
    }

    // Turns for a time, and until what was pushed is taken.
    void run(double seconds)
    {
        auto start = std::chrono::steady_clock::now();
        while (seconds_since(start) < seconds || !workbench_.input().empty()) workbench_.turn();
    }

    // Turns for a time, the hand before each; widgets do not tell their places, as they do not to users.
    FrameLog measure(double seconds, const Hand& hand)
    {
        FrameLog log;
        workbench_.editor().rects.listening = false;
        int drawn = workbench_.frames_drawn();
        std::uint64_t shown = workbench_.shown_generation();
        for (auto start = std::chrono::steady_clock::now(); seconds_since(start) < seconds;) {
            hand(seconds_since(start));
            workbench_.turn();
            if (std::exchange(drawn, workbench_.frames_drawn()) != workbench_.frames_drawn()) log.note(workbench_);
            log.pictures += std::exchange(shown, workbench_.shown_generation()) != workbench_.shown_generation();
        }
        workbench_.editor().rects.listening = true;
        return log;
    }

    // The middle of a widget; frames are drawn until it is there.
    glm::vec2 place(const char* widget)
    {
        auto rect = workbench_.editor().rects.find(widget);
        for (auto start = std::chrono::steady_clock::now(); !rect && seconds_since(start) < 5;) {
            move(hand_at_);
            run(0);
            rect = workbench_.editor().rects.find(widget);
        }
        demand(rect.has_value(), widget);
        return rect->centre();
    }
    void move(glm::vec2 at)
    {
        hand_at_ = at;
        workbench_.input().push({.kind = ui::InputEvent::Kind::move, .at = at});
    }
    void button(bool down) { workbench_.input().push({.kind = ui::InputEvent::Kind::button, .code = 0, .down = down}); }
    app::Workbench& workbench() { return workbench_; }

private:
    app::Workbench workbench_;
    glm::vec2 hand_at_{1, 1};
};

}  // namespace fieldwright::bench
