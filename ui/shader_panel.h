// The live GLSL of the scene, read-only: colours, line numbers, copy and export.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

class ShaderPanel {
public:
    void draw(FrameContext& frame);

private:
    // A row on the screen: a line, or a part of one that is too long for the width.
    struct Row {
        std::uint32_t line, first, last;  // bytes of the text
        bool begins_line;
    };
    struct Line {
        std::uint32_t first, last;  // bytes of the text
        bool in_comment;            // a block comment is open where it begins
    };

    void toolbar(FrameContext& frame);
    void read_lines();
    void break_lines(std::uint32_t columns);
    void draw_row(FrameContext& frame, const Row& row, float gutter_px, float column_px) const;

    std::shared_ptr<const std::string> text_;  // what lines_ and rows_ were made of
    std::vector<Line> lines_;
    std::vector<Row> rows_;
    std::uint32_t columns_ = 0;
};

}  // namespace fieldwright::ui
