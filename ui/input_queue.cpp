// Passing events: what happened between two frames must not cancel itself out.
#include "ui/input_queue.h"

#include "ui/keys.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <iterator>
#include <sstream>

namespace fieldwright::ui {
namespace {

// As far as the two clicks of a double click may be apart in Dear ImGui.
constexpr float trembling_px = 6;
constexpr float drag_px = 2;  // what a drag may be short of

// What this frame has already been told.
struct Told {
    float way_px = 0;  // of the mouse
    bool button = false, wheel = false, character = false, press = false;
    std::vector<int> buttons, keys;

    bool has(const std::vector<int>& codes, int code) const
    {
        return std::find(codes.begin(), codes.end(), code) != codes.end();
    }

    // Whether `event` would hide something told: a position under a click, a second change of one button. What lies
    // under the mouse is known a frame after it came there: a press before that hits what lies below, a key goes to the
    // pane that was left, and a release ends a drag before its last way was gone. A key right after a release would come
    // while the hand still counts as busy.
    bool hides(const InputEvent& event) const
    {
        switch (event.kind) {
            case InputEvent::Kind::move: return button || wheel;
            case InputEvent::Kind::button:
                return has(buttons, event.code) || wheel || way_px > (event.down ? trembling_px : drag_px);
            case InputEvent::Kind::wheel: return button;
            case InputEvent::Kind::key:
                return has(keys, event.code) || character || (event.down ? way_px > trembling_px || button : press);
            case InputEvent::Kind::character: return false;
            case InputEvent::Kind::focus: return button || wheel || !keys.empty();
        }
        return false;
    }

    void note(const InputEvent& event)
    {
        if (event.kind == InputEvent::Kind::button) button = true, buttons.push_back(event.code);
        if (event.kind == InputEvent::Kind::wheel) wheel = true;
        if (event.kind == InputEvent::Kind::key) keys.push_back(event.code), press = press || event.down;
        if (event.kind == InputEvent::Kind::character) character = true;
    }
};

void update_modifiers(ImGuiIO& io)
{
    auto either = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
    io.KeyCtrl = either(key::left_control, key::right_control);
    io.KeyShift = either(key::left_shift, key::right_shift);
    io.KeyAlt = either(key::left_alt, key::right_alt);
    io.KeySuper = either(key::left_super, key::right_super);
}

}  // namespace

void InputQueue::push(InputEvent event)
{
    // A hand moves faster than frames: only its last place before another event counts.
    bool moves_on = event.kind == InputEvent::Kind::move && !events_.empty() && events_.back().kind == event.kind;
    if (moves_on) events_.back() = event;
    else events_.push_back(event);
}

bool InputQueue::has_press() const
{
    return std::any_of(events_.begin(), events_.end(), [](const InputEvent& event) {
        return event.kind == InputEvent::Kind::button || event.kind == InputEvent::Kind::key ||
               event.kind == InputEvent::Kind::character;
    });
}

void InputQueue::release_all(ImGuiIO& io)
{
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    buttons_.fill(false);
    mouse_ = glm::vec2(-FLT_MAX);
}

void InputQueue::apply(const InputEvent& event, ImGuiIO& io)
{
    switch (event.kind) {
        case InputEvent::Kind::move: mouse_ = event.at; break;
        case InputEvent::Kind::button:
            if (event.code >= 0 && event.code < static_cast<int>(buttons_.size()))
                buttons_[static_cast<std::size_t>(event.code)] = event.down;
            break;
        case InputEvent::Kind::wheel:
            io.MouseWheelH += event.at.x;
            io.MouseWheel += event.at.y;
            break;
        case InputEvent::Kind::key:
            if (event.code >= 0 && event.code < key::count) io.KeysDown[event.code] = event.down;
            break;
        case InputEvent::Kind::character: io.AddInputCharacter(static_cast<unsigned>(event.code)); break;
        case InputEvent::Kind::focus:
            io.AddFocusEvent(event.down);
            if (!event.down) release_all(io);
            break;
    }
}

void InputQueue::pass(ImGuiIO& io)
{
    Told told;
    text_patience_ = io.WantTextInput ? 0 : std::max(text_patience_ - 1, 0);
    while (text_patience_ == 0 && !events_.empty() && !told.hides(events_.front())) {
        InputEvent event = events_.front();
        events_.pop_front();
        if (event.kind == InputEvent::Kind::move) told.way_px = std::max(told.way_px, glm::distance(event.at, mouse_));
        told.note(event);
        apply(event, io);
        if (recording_) *recording_ += event_line(event) + "\n";
    }
    io.MousePos = ImVec2(mouse_.x, mouse_.y);
    std::copy(buttons_.begin(), buttons_.end(), io.MouseDown);
    update_modifiers(io);
    if (recording_) *recording_ += "frame\n";
}

std::string event_line(const InputEvent& event)
{
    std::ostringstream line;
    line.imbue(std::locale::classic());
    const char* state = event.down ? " down" : " up";
    switch (event.kind) {
        case InputEvent::Kind::move: line << "move " << event.at.x << ' ' << event.at.y; break;
        case InputEvent::Kind::button: line << "button " << event.code << state; break;
        case InputEvent::Kind::wheel: line << "wheel " << event.at.x << ' ' << event.at.y; break;
        case InputEvent::Kind::key: line << "key " << event.code << state; break;
        case InputEvent::Kind::character: line << "character " << event.code; break;
        case InputEvent::Kind::focus: line << "focus " << (event.down ? "gained" : "lost"); break;
    }
    return line.str();
}

std::optional<InputEvent> parse_event_line(std::string_view text)
{
    std::istringstream line{std::string(text)};
    line.imbue(std::locale::classic());
    std::string kind, state;
    InputEvent event;
    line >> kind;
    if (kind == "move" || kind == "wheel") {
        event.kind = kind == "move" ? InputEvent::Kind::move : InputEvent::Kind::wheel;
        line >> event.at.x >> event.at.y;
    } else if (kind == "button" || kind == "key") {
        event.kind = kind == "button" ? InputEvent::Kind::button : InputEvent::Kind::key;
        line >> event.code >> state;
        if (state != "down" && state != "up") return std::nullopt;
        event.down = state == "down";
    } else if (kind == "character") {
        event.kind = InputEvent::Kind::character;
        line >> event.code;
    } else if (kind == "focus") {
        event.kind = InputEvent::Kind::focus;
        line >> state;
        event.down = state == "gained";
    } else {
        return std::nullopt;
    }
    if (line.fail()) return std::nullopt;
    return event;
}

std::vector<std::vector<InputEvent>> parse_recording(std::string_view text)
{
    std::vector<std::vector<InputEvent>> frames(1);
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        if (line == "frame") frames.emplace_back();
        else if (auto event = parse_event_line(line)) frames.back().push_back(*event);
    }
    return frames;
}

void map_keys(ImGuiIO& io)
{
    const std::pair<int, int> keys[] = {{ImGuiKey_Tab, key::tab},
                                        {ImGuiKey_LeftArrow, key::left},
                                        {ImGuiKey_RightArrow, key::right},
                                        {ImGuiKey_UpArrow, key::up},
                                        {ImGuiKey_DownArrow, key::down},
                                        {ImGuiKey_PageUp, key::page_up},
                                        {ImGuiKey_PageDown, key::page_down},
                                        {ImGuiKey_Home, key::home},
                                        {ImGuiKey_End, key::end},
                                        {ImGuiKey_Insert, key::insert},
                                        {ImGuiKey_Delete, key::del},
                                        {ImGuiKey_Backspace, key::backspace},
                                        {ImGuiKey_Space, key::space},
                                        {ImGuiKey_Enter, key::enter},
                                        {ImGuiKey_Escape, key::escape},
                                        {ImGuiKey_KeyPadEnter, key::keypad_enter},
                                        {ImGuiKey_A, 'A'},
                                        {ImGuiKey_C, 'C'},
                                        {ImGuiKey_V, 'V'},
                                        {ImGuiKey_X, 'X'},
                                        {ImGuiKey_Y, 'Y'},
                                        {ImGuiKey_Z, 'Z'}};
    for (auto [theirs, ours] : keys) io.KeyMap[theirs] = ours;
}

}  // namespace fieldwright::ui
