// Fields for texts and formulas.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// As many lines as the text has; true in frames in which `text` changed.
bool text_field(const FrameContext& frame, const char* id, std::string& text, float width_px);

// What is typed into a formula field is kept while it can be read, and however it is when the field is left.
struct FormulaField {
    std::string shown;  // what stands in the field
    bool keep = false;  // `shown` is new and to be kept
};
FormulaField formula_field(FrameContext& frame, std::string_view path, const graph::NodeType& type,
                           const std::string& kept, float width_px);
// Below the field: what is wrong with the shown formula, if anything is.
void formula_complaint(FrameContext& frame, std::string_view path, const graph::NodeType& type,
                       const std::string& shown);
std::string formula_name_list(const graph::NodeType& type);  // "x, y, z, time, k"
// What a formula of a node may be made of.
std::string formula_words(const graph::NodeType& type);

}  // namespace fieldwright::ui
