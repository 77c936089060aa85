// A scene as a value: nodes, wires (stored once, at the input) and march settings. Always acyclic, typed, finite and
// unique by construction; changed only through graph/edits.h, graph/adapt.h and graph/scene_file.h.
#pragma once

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

struct Document {
    std::int64_t next_id = 1;
    MarchSettings march;
    OcclusionSettings occlusion;
    Graph root;
    int version = 1;  // of the file it came from; newer than ours = opened with placeholders
    std::vector<std::pair<std::string, std::string>> extras;  // unknown top-level members: key -> JSON text
    bool operator==(const Document&) const = default;
};

inline constexpr int document_version = 1;

}  // namespace fieldwright::graph
