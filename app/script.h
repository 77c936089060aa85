// Hands that follow a script: how screenshots are made and how the window is tried from end to end.
#pragma once

#include "ui/input_queue.h"
#include "ui/widget_rects.h"

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

namespace fieldwright::app {

// One action a line; widgets by name (ui/widget_rects.h):
//   click WIDGET | double_click WIDGET | right_click WIDGET | move WIDGET
//   drag WIDGET DX DY            px of the window
//   connect WIDGET WIDGET        drags from one to the other
//   wheel WIDGET NOTCHES | key ctrl+shift+z | type TEXT (UTF-8)
//   settle                       waits until the picture is finished, an export written, and nothing moves
//   drop FILE                    as another program's hand lets go of it over the window
//   screenshot FILE | resize WIDTHxHEIGHT (one a frame) | quit
// Empty lines and lines that begin with # say nothing.
class Script {
public:
    // What the script asks of the window.
    struct Stage {
        ui::InputQueue& input;
        const ui::WidgetRects& rects;
        bool settled;  // the picture is finished and nothing moves
        std::function<void(const std::filesystem::path&)> take_screenshot, drop;
        std::function<void(glm::ivec2)> resize;
        std::function<void()> quit;
    };

    // Throws graph::Failure{2, "FILE:line: ..."} for an action that is none.
    explicit Script(const std::filesystem::path& file);

    bool finished() const { return actions_.empty(); }
    // Call once per frame, after it was drawn. Throws graph::Failure{1} naming the line when a widget does not appear.
    void play(Stage& stage);

private:
    struct Action {
        int line = 0;
        std::string verb;
        std::vector<std::string> words;
        std::string rest;  // of the line, after the verb
    };
    Action parse(const std::string& line, int number) const;
    bool perform(const Action& action, Stage& stage);
    std::optional<glm::vec2> place(const std::string& widget, const Stage& stage) const;
    [[noreturn]] void fail(const Action& action, const std::string& what, int code) const;
    void drag(glm::vec2 from, glm::vec2 to, ui::InputQueue& input);

    std::string name_;
    std::deque<Action> actions_;
    int patience_ = 0;  // frames waited for the widget of the first action
    int quiet_ = 0;     // frames since the last event was told
};

// The key and its modifiers of "ctrl+shift+z", "delete", "5", "f11", "page_up", "keypad_7"; nothing when it is none.
struct KeyChord {
    int key = 0;
    bool control = false, shift = false, alt = false;
};
std::optional<KeyChord> parse_key_chord(std::string_view text);

}  // namespace fieldwright::app
