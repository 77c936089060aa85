// The code of a node type that belongs to the scene: written here, applied when the typing rests.
#pragma once

#include "ui/code_field.h"

namespace fieldwright::ui {

class OwnTypePanel {
public:
    static constexpr double rest_s = 0.5;

    // Of the node's own type; below its parameters.
    void draw(FrameContext& frame, const graph::Node& node);
    // Applies what was typed for another type than this one, as when another node is selected. Call each frame.
    void leave_others(FrameContext& frame, std::string_view type);

private:
    void take_text(const graph::OwnType& type);
    void apply(FrameContext& frame);
    void code(FrameContext& frame);
    void name_row(FrameContext& frame);
    void actions(FrameContext& frame, graph::NodeId node);

    CodeField field_;
    std::string type_, text_;  // what is shown, and as it is being typed
    std::string name_;         // in the field for it
    bool unapplied_ = false;
    double typed_at_s_ = 0;
};

}  // namespace fieldwright::ui
