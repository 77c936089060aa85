// A number that is dragged, or typed after Ctrl+click, double-click or Enter.
#pragma once

#include "graph/library.h"
#include "ui/frame_context.h"

#include <string>

namespace fieldwright::ui {

struct NumberStyle {
    double minimum = -1e6, maximum = 1e6;            // hard, inclusive
    double soft_minimum = -1e6, soft_maximum = 1e6;  // where a drag stays, when it starts there
    std::string unit;
    bool whole = false;
    bool show_unit = true;    // behind the number, when there is room
    std::string at_zero;      // what 0 means, where that is not an amount: shown in its place
    bool fill = true;         // a bar from zero to the value, when the soft range is finite
    const char* letter = "";  // "x"
    ImU32 letter_tint = colour::quiet_text;
    float width_px = 100;
    std::string tip;
};

// As the field shows it: with as many decimals as fit into `room_px`, or in words.
std::string shown_number(double value, const NumberStyle& style, float room_px);

NumberStyle number_style(const graph::Parameter& parameter);
// What a parameter is and may be: help, range, default.
std::string parameter_tip(const graph::Parameter& parameter);

// True in frames in which `value` changed; `id` begins with ##. What is typed is clamped; what is no number is refused with a sentence
// about `name`, and the value from before the typing stands.
bool number_field(FrameContext& frame, const char* id, std::string_view name, double& value, const NumberStyle& style);

// Whether two or three fields stand below each other in this width, and then show their unit.
bool vector_is_stacked(const Theme& theme, int count, float width_px);
// Two or three of them, side by side where there is room: marks `path`/x, /y, /z.
bool vector_field(FrameContext& frame, std::string_view path, std::string_view name, float* components, int count,
                  const NumberStyle& style);

}  // namespace fieldwright::ui
