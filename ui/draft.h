// The document under the hands: every part of the window edits it through the functions of graph/ and says what it did.
#pragma once

#include "graph/edits.h"

#include <memory>
#include <string>

namespace fieldwright::ui {

struct Draft {
    graph::Document& document;
    const graph::Library& library;
    std::string step;        // name of the step that was made in this frame ("Change radius"); empty = nothing changed
    bool step_ends = false;  // with this frame, though the hands go on
    std::string refusal;     // why an edit was refused in this frame; shown in the status line

    // Notes the outcome of an edit; true when it was done.
    bool done(std::string_view step_name, const graph::Refusal& refused)
    {
        if (refused) refusal = *refused;
        else step = step_name;
        return !refused;
    }
};

}  // namespace fieldwright::ui
