// Small things every panel is made of: text that fits, rows of a label and a field, quiet buttons, toggles, headings.
#pragma once

#include "ui/frame_context.h"

#include "graph/words.h"

#include <string>
#include <string_view>

namespace fieldwright::ui {

using graph::as_sentence;
using graph::in_words;
using graph::title_of;
const char* category_icon(std::string_view category);

// `text` cut to `width_px` with an ellipsis, in the current font.
std::string fitted(std::string_view text, float width_px);
// Text in a row of its own height, cut to what is left of the line; the whole is its tooltip when cut.
void line_text(const FrameContext& frame, std::string_view text, ImU32 tint = colour::text, float width_px = 0);
void paragraph(std::string_view text, ImU32 tint = colour::quiet_text);  // wrapped
bool mouse_rests();                                                      // on the last item; ask in every frame
// Of the last item, once the mouse rests on it.
void tooltip(const FrameContext& frame, std::string_view text);

// Frame padding that makes Dear ImGui's own fields one row high. Lives for a block.
class RowPadding {
public:
    explicit RowPadding(const Theme& theme);
    ~RowPadding();
    RowPadding(const RowPadding&) = delete;
    RowPadding& operator=(const RowPadding&) = delete;
};

// A square of one row without a frame; `lit` draws it in the accent colour.
bool icon_button(const FrameContext& frame, const char* id, const char* icon, std::string_view tip,
                 ImU32 tint = colour::quiet_text, bool lit = false);
// A framed button; `width_px` 0 fits the label, which is cut when it must be.
bool text_button(const FrameContext& frame, const char* id, std::string_view label, float width_px = 0,
                 ImU32 tint = colour::text);
// A switch; true when it was flipped.
bool toggle(const FrameContext& frame, const char* id, bool& on);
// Fixed choices side by side; true when another was chosen.
bool segments(FrameContext& frame, std::string_view path, const std::vector<std::pair<std::string, std::string>>& words,
              std::string& chosen);
// A field for a name; true in frames in which `text` changed.
bool name_field(const FrameContext& frame, const char* id, std::string& text, const std::string& hint, float width_px);
// A bar of the share 0 .. 1 of something.
void share_bar(const FrameContext& frame, float share, ImU32 tint);

// A heading with a line to its right.
void section(const FrameContext& frame, std::string_view title);
// A heading that folds what follows; remembers.
bool folding_section(const FrameContext& frame, const char* title);
// What stands where a list would, and says what to do.
void empty_state(const FrameContext& frame, const char* icon, std::string_view sentence);
// A sentence with an icon on a tinted ground.
void notice(const FrameContext& frame, const char* icon, ImU32 tint, std::string_view sentence);

// A row: a right-aligned label in the column common to all, then the field. Returns the field's width, which leaves
// room for one icon after it.
float begin_row(const FrameContext& frame, std::string_view label, std::string_view tip = {});
void to_field_column(const FrameContext& frame);     // a row without a label
float usual_field_width(const FrameContext& frame);  // of a row that begins at the left
float row_field_width(const FrameContext& frame);
// Moves to the place for an icon at the end of the row, whether or not one is drawn.
void to_row_end(const FrameContext& frame);
// A row that only tells: label and text.
void fact_row(const FrameContext& frame, std::string_view label, std::string_view text, std::string_view tip = {});

}  // namespace fieldwright::ui
