// The whole window: menu bar, viewport, node canvas, inspector, panels and status line, laid out and drawn each frame.
#pragma once

#include "ui/canvas.h"
#include "ui/command_palette.h"
#include "ui/dialogs.h"
#include "ui/file_browser.h"
#include "ui/inspector.h"
#include "ui/menu_bar.h"
#include "ui/panels.h"
#include "ui/shortcut_sheet.h"
#include "ui/status_line.h"
#include "ui/viewport.h"

#include <glm/glm.hpp>

namespace fieldwright::ui {

class Editor {
public:
    struct Output {
        std::vector<Request> requests;
        // A gesture ended: the live document is a step of this name. Empty = nothing to record.
        std::string settled_step;
        bool document_changed = false;
        bool hands_moving = false;          // something is being dragged: pictures may be coarse
        bool text_expected = false;         // tell the input queue: what is typed is meant for a field about to open
        std::optional<double> redraw_in_s;  // when the window will look different although nobody does anything
    };

    // Draws between ImGui::NewFrame and ImGui::Render.
    Output draw(graph::Document& document, const graph::Library& library, const Readings& readings, const Theme& theme);

    // Each is done in the next frame.
    void run(std::string command_id) { asked_commands_.push_back(std::move(command_id)); }
    // Does what a part of the window would ask for, after the question about unsaved changes.
    void ask(Request request) { asked_.push_back(std::move(request)); }
    void ask_quit() { ask(Quit{}); }
    // The built-in file browser, for systems without a file dialog. Empty folder = the user's home.
    void browse(ChooseFile what, std::string folder, std::string name);

    ViewState view;
    WidgetRects rects;

    glm::ivec2 viewport_size_px() const { return viewport_size_px_; }  // of the last frame
    const std::string& status_text() const { return status_line_.text(); }
    Canvas& canvas() { return canvas_; }
    Viewport& viewport() { return viewport_; }

private:
    Output draw_shown(graph::Document& document, const graph::Library& library, const Readings& readings,
                      const Theme& theme);
    void follow_selection(const graph::Document& document);
    void run_commands(CommandContext& context);
    void run_command(std::string_view id, CommandContext& context);
    void run_pressed_shortcut(CommandContext& context);
    bool hands_free() const;
    void draw_panes(FrameContext& frame);
    void draw_dialogs(CommandContext& context);
    void splitter(const char* name, bool vertical, float& share, float low, float high, float length_px,
                  FrameContext& frame);

    Canvas canvas_;
    Inspector inspector_;
    Panels panels_;
    Viewport viewport_;
    MenuBar menu_bar_;
    StatusLine status_line_;
    CommandPalette palette_;
    ShortcutSheet sheet_;
    Dialogs dialogs_;
    FileBrowser browser_;

    std::vector<Command> commands_;   // of this frame
    Scope over_ = Scope::everywhere;  // the pane under the mouse, in the last frame
    std::vector<std::string> asked_commands_;
    std::vector<Request> asked_;
    std::string pending_step_;
    ImGuiID active_item_ = 0;  // of the last frame
    glm::ivec2 viewport_size_px_{0, 0};
};

}  // namespace fieldwright::ui
