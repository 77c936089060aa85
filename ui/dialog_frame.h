// What dialogs have in common: a place in the middle, a heading, a row of buttons at the right, keys for yes and no.
#pragma once

#include "ui/frame_context.h"

#include <initializer_list>

namespace fieldwright::ui {

// Begins a modal dialog that is open as long as it is `wanted`; when it is, draw into it and end it.
bool begin_dialog(const char* name, bool wanted, const Theme& theme, float width_px, float height_px = 0);
void end_dialog();
void heading(const Theme& theme, const std::string& text);

struct DialogButton {
    const char* text;
    const char* mark;  // of its rectangle: "dialog/save"
    bool primary = false;
};
// At the right end of the current line's room. The index of the one that was clicked, or -1.
int button_row(FrameContext& frame, std::initializer_list<DialogButton> buttons);
// The keys that mean the primary button and Cancel; not while a text field is used, but for Escape.
bool confirmed_by_key();
bool cancelled_by_key();

}  // namespace fieldwright::ui
