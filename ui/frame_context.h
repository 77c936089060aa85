// What every part of the window is given to draw one frame.
#pragma once

#include "ui/draft.h"
#include "ui/icons.h"
#include "ui/readings.h"
#include "ui/requests.h"
#include "ui/theme.h"
#include "ui/view_state.h"
#include "ui/widget_rects.h"

namespace fieldwright::ui {

struct FrameContext {
    Draft& draft;
    ViewState& view;
    const Readings& readings;
    std::vector<Request>& requests;
    const Theme& theme;
    WidgetRects& rects;
    bool text_expected = false;  // a text field was focused in this frame; it takes letters a frame or two later

    void focus_next_text()
    {
        ImGui::SetKeyboardFocusHere();
        text_expected = true;
    }
};

}  // namespace fieldwright::ui
