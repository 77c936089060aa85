// A small lit scene around one node of any type, made by edits alone.
#pragma once

#include "graph/edits.h"

namespace fieldwright::app {

class StarterScene {
public:
    // Failure 1 when the library lacks a node that the scene stands on.
    StarterScene(std::shared_ptr<const graph::Library> library, const graph::NodeType& type);

    graph::NodeId shown() const { return shown_; }  // the node of the wanted type
    // Puts the camera where the whole subject is seen and the nodes where they read from left to right.
    void compose();

    graph::Document document;

private:
    graph::NodeId place(std::string_view type);
    void wire(graph::NodeId source, graph::NodeId target, std::string_view socket);
    void wire_first(graph::NodeId source, graph::NodeId target, graph::SocketKind kind);
    void set(graph::NodeId node, std::string_view parameter, graph::Value value);
    graph::NodeId over(std::string_view type, graph::NodeId source);

    graph::NodeId subject();
    graph::NodeId still_life();
    graph::NodeId measured();
    graph::NodeId painted(graph::NodeId material);
    void fill_inputs();
    graph::NodeId companion(graph::SocketKind kind, int index);
    void keep_visible();
    void aim_camera();
    void lay_out();

    std::shared_ptr<const graph::Library> library_;
    const graph::NodeType& type_;
    graph::NodeId shown_, output_, camera_;
    graph::NodeId ball_;  // whose radius is the shown number
};

}  // namespace fieldwright::app
