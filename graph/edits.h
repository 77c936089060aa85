// The only functions that change a document. Each returns the reason when it refuses, and then changes nothing.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <optional>
#include <set>

namespace fieldwright::graph {

// Empty = done; else one sentence saying why not.
using Refusal = std::optional<std::string>;

// Adds a node of `type` with its default parameters; NodeId{} when the type is unknown.
NodeId add_node(Document& document, const Library& library, std::string_view type, glm::vec2 position = {0, 0});
Refusal remove_node(Document& document, NodeId node);  // its wires go with it
// Wires source's output to an input. Refuses cycles, wrong kinds, mixed 2D/3D and unknown sockets.
Refusal connect(Document& document, const Library& library, NodeId source, NodeId target, std::string_view socket);
Refusal disconnect(Document& document, NodeId target, std::string_view socket);

// An input and what it reads; NodeId{} as source: nothing.
struct Wire {
    NodeId source, target;
    std::string socket;
    bool operator==(const Wire&) const = default;
};
// Gives every named input its source, all or none. An input named twice gets the last. O((nodes + wires) log nodes).
Refusal connect_all(Document& document, const Library& library, const std::vector<Wire>& wires);
// All or none, in one pass; their wires go with them.
Refusal remove_nodes(Document& document, const std::set<NodeId>& nodes);

Refusal set_parameter(Document& document, const Library& library, NodeId node, std::string_view name, Value value);
Refusal node_name_error(std::string_view name);
Refusal rename_node(Document& document, NodeId node, std::string_view name);  // UTF-8, at most 256 bytes
Refusal move_node(Document& document, NodeId node, glm::vec2 position);
Refusal set_muted(Document& document, NodeId node, bool muted);
Refusal set_march(Document& document, const MarchSettings& settings);
Refusal set_occlusion(Document& document, const OcclusionSettings& settings);
Refusal set_picture(Document& document, const PictureSettings& settings);
Refusal set_animation(Document& document, const AnimationSettings& settings);
Refusal set_fog(Document& document, const FogSettings& settings);
Refusal set_bounces(Document& document, int bounces);

// Why a wire is not allowed in this document, or nothing. `connect` and the file reader share it (cycles excluded).
Refusal wire_error(const Document& document, const Library& library, NodeId source, NodeId target,
                   std::string_view socket);
// Checks what every document promises: ids, types, ranges, wires, acyclic. First broken promise, or nothing.
Refusal validate(const Document& document, const Library& library);
// 2, 3 or 0 (undecided: combiners without inputs) for a field node.
int field_dimension(const Document& document, const Library& library, NodeId node);

}  // namespace fieldwright::graph
