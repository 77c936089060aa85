// The document's nodes of one kind as a list: choose, add, rename, duplicate, delete, mute.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

class NodeList {
public:
    // `path`: of marked names, "panel/lights"; `kind`: what the nodes give; `noun`: one of them, "light".
    NodeList(std::string path, graph::SocketKind kind, std::string noun)
        : path_(std::move(path)), kind_(kind), noun_(std::move(noun))
    {
    }

    // A heading with the add menu, the rows, and the parameters of the active node if it is one of them.
    void draw(FrameContext& frame, std::string_view heading, std::string_view when_empty);

    bool mutes = false;  // rows have a mute button
    // The output has a socket for one of them; rows say which is in use, and another can be chosen.
    std::string output_socket;

private:
    bool lists(const graph::NodeType* type) const { return type && type->output == kind_; }
    void heading_row(FrameContext& frame, std::string_view heading);
    void offer(FrameContext& frame);
    void add_menu(FrameContext& frame);
    void add(FrameContext& frame, const graph::NodeType& type);
    void row(FrameContext& frame, graph::NodeId id);
    void name(FrameContext& frame, const graph::Node& node, float width_px);
    void row_icons(FrameContext& frame, graph::NodeId id, bool shown);
    void use_icon(FrameContext& frame, graph::NodeId id);
    void duplicate(FrameContext& frame, graph::NodeId id);
    void remove(FrameContext& frame, graph::NodeId id);
    std::string mark(graph::NodeId id, std::string_view part = {}) const;

    std::string path_;
    graph::SocketKind kind_;
    std::string noun_;
    graph::NodeId renaming_;
    bool focus_name_ = false;
};

}  // namespace fieldwright::ui
