// A field for GLSL: colours, line numbers, and the line that is wrong.
#pragma once

#include "ui/frame_context.h"

#include <string>

namespace fieldwright::ui {

class CodeField {
public:
    struct Outcome {
        bool edited = false;  // `text` is another
        bool left = false;    // the hand is somewhere else now, or Ctrl+Enter was pressed
    };
    // `height_px` of the whole; the text scrolls in it. `wrong_line` counts from 1; 0 = none.
    Outcome draw(FrameContext& frame, const std::string& path, std::string& text, int wrong_line, float height_px);

private:
    struct Layout {
        ImVec2 origin;  // of the first line's first letter
        float gutter_px, letter_px, line_px;
    };
    void paint(const std::string& text, const Layout& layout, int wrong_line) const;
    void paint_cursor(const std::string& text, const Layout& layout) const;
    void follow_cursor(const std::string& text, const Layout& layout);
    static int on_edit(ImGuiInputTextCallbackData* data);

    int cursor_ = 0, followed_ = 0;  // byte of the text
    int length_ = 0;                 // bytes before the last edit
    bool active_ = false;
};

}  // namespace fieldwright::ui
