// The add menu: a popup to find a node type by name, synonym or category; offers only what fits where it was opened.
#pragma once

#include "ui/frame_context.h"

#include "graph/compose.h"

namespace fieldwright::ui {

// Where the new node goes, and what it is wired to.
struct AddPlace {
    struct Wire {
        graph::NodeId node;  // its target
        std::string socket;
    };
    glm::vec2 position{0, 0};            // canvas px
    std::optional<graph::LooseEnd> end;  // of a wire that was dropped into empty space
    std::optional<Wire> on_wire;         // to be inserted into
};

// Types of this category are texts that own nodes begin with: `<own_prefix><template>` (graph/custom_nodes.h).
inline constexpr std::string_view own_category = "custom", own_prefix = "custom:";

class AddMenu {
public:
    AddMenu();
    // At the next draw; `at_px`: of the screen.
    void open(glm::vec2 at_px, AddPlace place);
    bool is_open() const { return shown_; }

    // What was picked in this frame, if anything was.
    const graph::NodeType* draw(FrameContext& frame);
    const AddPlace& place() const { return place_; }
    void remember(const std::string& type);  // as the latest of the recent ones

private:
    const graph::NodeType* draw_inside(FrameContext& frame);
    void find_offered(const Draft& draft, const std::vector<SavedGroup>& saved);
    std::vector<const graph::NodeType*> listed() const;
    std::vector<std::string> categories() const;
    bool search_field(FrameContext& frame);
    void move_highlight(int count);
    void category_column(FrameContext& frame);
    const graph::NodeType* entries(FrameContext& frame, const std::vector<const graph::NodeType*>& types);
    bool entry(FrameContext& frame, const graph::NodeType& type, bool highlighted);

    const std::vector<graph::NodeType> own_beginnings_;
    AddPlace place_;
    glm::vec2 at_px_{0, 0};
    bool opening_ = false, shown_ = false, scroll_to_highlight_ = false;
    std::vector<const graph::NodeType*> offered_;
    std::vector<std::string> recent_;  // names, latest first
    std::string query_, category_;     // of the left column; empty = recent ones
    int highlight_ = 0;
};

}  // namespace fieldwright::ui
