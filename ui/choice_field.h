// A field that opens a list, one entry of which holds.
#pragma once

#include "ui/frame_context.h"

#include <functional>
#include <optional>
#include <string>

namespace fieldwright::ui {

// The word that stands in its rectangle's mark, and the text that is shown.
using ChoiceLabel = std::function<std::pair<std::string, std::string>(std::size_t index)>;

// Marks `path`, and `path`/choice/word of the open list. The entry that was pressed, or nothing.
std::optional<std::size_t> choice_list(FrameContext& frame, std::string_view path, float width_px,
                                       const std::string& shown, std::size_t count, const ChoiceLabel& label);

// Of choices by name; true when another was chosen.
template <typename Kind>
bool choice_field(FrameContext& frame, std::string_view path, float width_px, const std::vector<Kind>& choices,
                  std::string& chosen)
{
    const Kind* held = find_choice(choices, chosen);
    auto label = [&](std::size_t i) { return std::pair(choices[i].name, choices[i].title); };
    auto picked = choice_list(frame, path, width_px, held ? held->title : chosen, choices.size(), label);
    if (!picked || choices[*picked].name == chosen) return false;
    chosen = choices[*picked].name;
    return true;
}

}  // namespace fieldwright::ui
