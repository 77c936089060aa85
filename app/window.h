// The window of the desktop: its GL context, its input as an ordered queue, and the frames drawn into it.
#pragma once

#include "ui/input_queue.h"
#include "ui/theme.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;
struct ImGuiContext;

namespace fieldwright::app {

// The size a new window is given, in units of which `scale` make a pixel on each side: with a title bar it fits into the
// screen's free area.
glm::ivec2 fitting_size(glm::ivec2 wanted, glm::ivec2 area_px, glm::vec2 scale);

class Window {
public:
    // Throws graph::Failure{4} when there is no display or no OpenGL 3.3 for it.
    Window(const std::string& title, glm::ivec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Sleeps until there is input, a wake() or the time is over.
    void wait(double seconds);
    static void wake();  // from any thread
    void begin_frame();  // ImGui is ready to be drawn into
    void end_frame();    // what ImGui was told is complete
    void draw_frame();   // into the back buffer
    void show_frame();

    void rename(const std::string& title);
    void resize(glm::ivec2 size);
    bool close_asked();                        // once per click on the close button
    std::vector<std::string> dropped_files();  // since the last call
    glm::ivec2 size_px() const;
    bool visible() const;  // not minimised
    const ui::Theme& theme() const { return theme_; }
    std::string renderer_name() const;             // GL_RENDERER
    bool was_touched() const { return touched_; }  // input arrived since the last begin_frame

    // The frame just drawn and not yet shown: top-down RGB rows of size_px().
    std::vector<unsigned char> screenshot() const;

    ui::InputQueue input;

private:
    struct ContextDeleter {
        void operator()(ImGuiContext* context) const;
    };
    void connect_input();
    void find_mouse();
    void forget_mouse();
    float content_scale() const;
    void update_theme();
    void push(ui::InputEvent event);

    GLFWwindow* window_ = nullptr;
    std::unique_ptr<ImGuiContext, ContextDeleter> context_;
    ui::Theme theme_;
    bool touched_ = false;
    bool close_asked_ = false;
    std::vector<std::string> dropped_;
};

}  // namespace fieldwright::app
