// Input events in the order they happened, handed to Dear ImGui a frame at a time without losing one. Also the test
// driver, and what recordings are made of.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct ImGuiIO;

namespace fieldwright::ui {

struct InputEvent {
    enum class Kind { move, button, wheel, key, character, focus };
    Kind kind = Kind::move;
    glm::vec2 at{0, 0};  // move: px of the window; wheel: notches
    int code = 0;        // button: 0 left, 1 right, 2 middle; key: ui::key; character: Unicode code point
    bool down = false;   // button, key: pressed; focus: gained
    bool operator==(const InputEvent&) const = default;
};

class InputQueue {
public:
    void push(InputEvent event);
    // Applies events until the next would hide an earlier one from this frame. Call before ImGui::NewFrame.
    void pass(ImGuiIO& io);
    // A text field is about to open: what comes next waits for it, a few frames at most.
    void wait_for_text() { text_patience_ = longest_text_wait; }
    bool empty() const { return events_.empty(); }
    bool has_press() const;  // a key, a button or a letter waits, down or up

    // Everything passed so far, when recording: `frame` lines between the events of different frames.
    void start_recording() { recording_.emplace(); }
    std::string recording() const { return recording_.value_or(""); }

private:
    void apply(const InputEvent& event, ImGuiIO& io);
    void release_all(ImGuiIO& io);

    static constexpr int longest_text_wait = 4;  // frames

    std::deque<InputEvent> events_;
    int text_patience_ = 0;
    // What Dear ImGui was told last. Told again each frame: its backend for the window system writes there too, what is so
    // at that moment instead of what comes next.
    glm::vec2 mouse_{-std::numeric_limits<float>::max()};
    std::array<bool, 5> buttons_{};
    std::optional<std::string> recording_;
};

// One event as a line: `move 10 20`, `button 0 down`, `wheel 0 1`, `key 65 up`, `character 97`, `focus lost`.
std::string event_line(const InputEvent& event);
std::optional<InputEvent> parse_event_line(std::string_view line);  // nothing when it is not one
// Events of a recording by frame. A line that is no event is left out.
std::vector<std::vector<InputEvent>> parse_recording(std::string_view text);

// Tells Dear ImGui which of our keys are its arrows, Enter and so on.
void map_keys(ImGuiIO& io);

}  // namespace fieldwright::ui
