// The whole window: menu bar, viewport, node canvas, inspector, panels and status line, laid out and drawn each frame.
#pragma once

#include "ui/canvas.h"
#include "ui/inspector.h"
#include "ui/panels.h"
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
        bool hands_moving = false;  // something is being dragged: pictures may be coarse
    };

    // Draws between ImGui::NewFrame and ImGui::Render.
    Output draw(graph::Document& document, const graph::Library& library, const Readings& readings, const Theme& theme);

    ViewState view;
    WidgetRects rects;

    glm::ivec2 viewport_size_px() const { return viewport_size_px_; }  // of the last frame
    Canvas& canvas() { return canvas_; }
    Viewport& viewport() { return viewport_; }

private:
    void draw_panes(FrameContext& frame);
    void splitter(const char* name, bool vertical, float& share, float low, float high, float length_px,
                  FrameContext& frame);

    Canvas canvas_;
    Inspector inspector_;
    Panels panels_;
    Viewport viewport_;
    std::string pending_step_;
    glm::ivec2 viewport_size_px_{0, 0};
};

}  // namespace fieldwright::ui
