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
    float step_scale = 1.0f;      // of a step in distances, when it is the user's own
    float constant_step = 0.05f;  // m, when steps are constant
    float normal_step = 0.0f;     // m, from the hit to the taps for its normal; 0 fits it to the distance from the eye
    bool out_of_steps_hits = false;
    bool own_step_scale = false;   // else distances are divided by the derived Lipschitz constants
    bool constant_steps = false;   // with bisection; else sphere tracing
    bool central_normals = false;  // six taps; else the four of a tetrahedron
    bool coverage = false;  // edges within a pixel of an eye ray share its light; else it is that of the ray alone
    bool operator==(const MarchSettings&) const = default;
};

struct OcclusionSettings {
    float strength = 1.0f;  // 0 off .. 1
    float radius = 0.5f;    // m, along the normal
    int samples = 5;
    bool smallest_ratio = false;  // of distance and height; else the mean of the ratios
    bool operator==(const OcclusionSettings&) const = default;
};

enum class ToneMap { none, neutral, agx, aces };
enum class Backdrop { sky, colour, transparent };

// How what a scene's rays see becomes a picture.
struct PictureSettings {
    int samples = 16;                    // of a pixel
    float shutter = 0;                   // s around its moment that a picture is exposed; 0 freezes what moves
    ToneMap tone_map = ToneMap::none;    // of beauty, in pictures of 8 bits
    float exposure = 0;                  // stops before tone mapping: each doubles the light
    Backdrop backdrop = Backdrop::sky;   // what shows where rays meet nothing
    glm::vec3 backdrop_colour{0, 0, 0};  // linear Rec.709
    bool operator==(const PictureSettings&) const = default;
};

// Frame n shows the moment (n - 1) / frames_per_second, so that frame 1 is time 0.
struct AnimationSettings {
    int first_frame = 1, last_frame = 120;
    float frames_per_second = 24;
    bool operator==(const AnimationSettings&) const = default;
};

// What the air between things adds: the light of what is far away gives way to the fog's colour.
struct FogSettings {
    glm::vec3 colour{0.55f, 0.62f, 0.7f};  // linear Rec.709
    float density = 0;                     // per m: share of the light lost over a short way; 0 is off
    float start = 0;                       // m along the view, free of fog
    float height_falloff = 0;              // per m above y = 0, by which the density falls; 0: the same everywhere
    bool operator==(const FogSettings&) const = default;
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
    PictureSettings picture;
    AnimationSettings animation;
    FogSettings fog;
    int bounces = 0;                 // how often mirrors and glass send a ray on; 0: they show the sky at one look
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
