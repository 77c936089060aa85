// A scene as a value: nodes, wires (stored once, at the input), groups and march settings. Always acyclic, typed, finite
// and unique by construction; changed only through graph/edits.h, graph/adapt.h and graph/scene_file.h.
#pragma once

#include "graph/own_type.h"
#include "graph/problem.h"
#include "graph/value.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fieldwright::graph {

struct Node {
    NodeId id;
    std::string type;          // a node type's name; may be unknown to this build
    std::string name;          // the user's; empty shows the type's title
    glm::vec2 position{0, 0};  // on the canvas, pixels at zoom 1
    bool muted = false;
    std::vector<std::pair<std::string, Value>> parameters;  // every parameter of the type, in declaration order
    std::vector<std::pair<std::string, NodeId>> inputs;     // wired sockets only: socket name -> source, sorted by name
    std::string unknown_source;  // of a node of unknown type: its JSON text as read, spliced back unchanged on save
    bool operator==(const Node&) const = default;

    const Value* parameter(std::string_view name) const;
    NodeId input(std::string_view socket) const;  // NodeId{} when not wired
};

struct MarchSettings {
    int step_limit = 256;
    float minimum_step = 0.001f;  // m
    float tolerance = 0.0001f;    // m
    float near = 0.01f;           // m, along the ray
    float far = 100.0f;           // m, along the ray
    bool out_of_steps_hits = false;
    bool operator==(const MarchSettings&) const = default;
};

struct OcclusionSettings {
    float strength = 1.0f;  // 0 off .. 1
    float radius = 0.5f;    // m, along the normal
    bool operator==(const OcclusionSettings&) const = default;
};

struct Graph {
    std::vector<Node> nodes;  // sorted by id
    bool operator==(const Graph&) const = default;

    const Node* find(NodeId id) const;  // O(log n)
    Node* find(NodeId id);
};

// Something inside a group that is set or wired from outside.
struct Exposed {
    std::string name;    // outside; unique in its group
    std::string help;    // empty: that of what it drives
    NodeId node;         // inside
    std::string socket;  // of that node: the parameter or field input it drives
    bool operator==(const Exposed&) const = default;
};

// A graph with a name, used as a node by any other graph (graph/groups.h). The value of an exposed parameter inside is
// the default of new nodes.
struct Group {
    std::string name;              // unique in the document
    std::vector<Exposed> exposed;  // in the order shown
    NodeId output;                 // the inner node whose result is the group's; NodeId{}: none
    Graph graph;
    bool operator==(const Group&) const = default;
};

struct Document {
    std::int64_t next_id = 1;  // of nodes in all graphs
    MarchSettings march;
    OcclusionSettings occlusion;
    std::vector<OwnType> own_types;  // sorted by name, each once; their library is own_types.h's
    Graph root;
    std::vector<Group> groups;  // sorted by name; none contains itself
    std::string entered;        // the group that changed places with `root` while it is worked on; empty at rest
    int version = 1;            // of the file it came from; newer than ours = opened with placeholders
    std::vector<std::pair<std::string, std::string>> extras;  // unknown top-level members: key -> JSON text
    bool operator==(const Document&) const = default;
};

inline constexpr int document_version = 1;

}  // namespace fieldwright::graph
