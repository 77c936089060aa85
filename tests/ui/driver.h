// The window without a window: frames, hands and eyes for tests. Widgets are found by name.
#pragma once

#include "graph/scene_file.h"
#include "ui/editor.h"
#include "ui/input_queue.h"

#include <imgui.h>

#include <string_view>

namespace fieldwright::tests {

class Driver {
public:
    explicit Driver(graph::Document document, glm::vec2 size_px = {1280, 800});
    ~Driver();
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;

    // One frame of frame_s. Steps are recorded and undo, redo and jump done as the program does.
    void frame();
    void frames(int count);
    void run_until_quiet();  // until every event is told, and two frames more (hovering needs one)

    void move(glm::vec2 at);
    void press(int button = 0);
    void release(int button = 0);
    void click(glm::vec2 at, int button = 0);
    void click(std::string_view widget, int button = 0);  // fails the test when there is none of the name
    void double_click(glm::vec2 at);
    void drag(glm::vec2 from, glm::vec2 to, int button = 0, int steps = 4);
    void wheel(float notches);
    void key(int code, bool control = false, bool shift = false, bool alt = false);
    void type(std::string_view text);
    glm::vec2 place(std::string_view widget) const;  // its centre; fails the test when there is none
    bool shows(std::string_view widget) const { return editor.rects.find(widget).has_value(); }

    float frame_s = 1.0f / 60.0f;
    std::shared_ptr<const graph::Library> library;
    graph::Document document;
    ui::Editor editor;
    ui::Readings readings;
    ui::InputQueue queue;
    std::vector<ui::Request> requests;                           // of all frames, but those done here
    std::vector<std::pair<graph::Document, std::string>> steps;  // "start" first
    std::size_t step = 0;

private:
    void perform(const ui::Request& request);
    void follow_types();
    void refresh_readings();

    std::vector<graph::Group> known_groups_;
    ImGuiContext* context_;
    ui::Theme theme_;
};

}  // namespace fieldwright::tests
