// What the open group shows outside: its name, and the parameters and inputs that it exposes.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

class GroupInterface {
public:
    // A section of the inspector; nothing while no group is open.
    void draw(FrameContext& frame);

private:
    bool name_row(FrameContext& frame, const std::string& path, const std::string& name, float width_px,
                  const std::string& hint = {});
    bool help_row(FrameContext& frame, const std::string& path, const graph::Exposed& exposed,
                  const graph::NodeType* type);
    void exposed_row(FrameContext& frame, const graph::Group& group, const graph::Exposed& exposed);

    std::string edited_path_, edited_;  // the name or help under the cursor
};

// The menu of a row that is about a parameter or input of a node in the open group: exposes it, or hides it again.
void expose_menu(FrameContext& frame, const std::string& path, graph::NodeId node, std::string_view socket,
                 ImVec2 row_low);
// What it is called outside; null while it is not exposed, or no group is open.
const graph::Exposed* exposed_as(const Draft& draft, graph::NodeId node, std::string_view socket);

}  // namespace fieldwright::ui
