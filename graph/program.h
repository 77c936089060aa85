// The program: what a document means, as flat lists of typed calls. Printers and evaluators read it; none of it is text.
#pragma once

#include "graph/expansion.h"
#include "graph/image_request.h"

#include <memory>
#include <span>

namespace fieldwright::graph {

class SlopeMemo;

enum class Rate { constant, frame, point };  // constant < frame (depends on time only) < point (depends on p)

using ValueId = std::int32_t;
inline constexpr ValueId no_value = -1;

struct ProgramValue {
    const Type* type;  // owned by the library or static
    Rate rate = Rate::constant;
    std::int32_t slot = -1;  // constant and frame values: first float in the block; vec3 never straddles a vec4
    std::int32_t lanes = 1;
    NodeId node;                 // for names in exports
    const char* name = nullptr;  // parameter or input name, for exports; null for call results
};

// One call, or (body_end > 0) one block: the instructions after it up to body_end, run `copies` times with `copy`
// counting up and every `carried` pair folded: initial value, then the body's last value of `next`.
struct Instruction {
    const Function* function = nullptr;
    std::int32_t first_argument = 0, argument_count = 0;  // into Program::arguments
    ValueId result = no_value;
    NodeId node;
    // Blocks only.
    std::int32_t body_end = 0;  // index after the last instruction of the body
    std::int32_t copies = 0;
    ValueId copy = no_value;    // int value: 0 .. copies-1
    ValueId needed = no_value;  // int value of constant or frame rate: the copies from here on repeat earlier ones
    std::int32_t first_carried = 0, carried_count = 0;  // into Program::carried
    bool is_block() const { return copies > 0; }
};

struct Carried {
    ValueId accumulator;  // readable in the body and after the block
    ValueId initial;      // constant-rate value
    ValueId next;         // computed in the body
};

// A contiguous run of instructions with inputs and results. Each entry is called once per shader.
struct Entry {
    std::int32_t first = 0, last = 0;  // [first, last) into Program::instructions
    std::vector<ValueId> inputs;       // point-rate values set by the caller
    std::vector<ValueId> results;
};

enum class Shadow { off, hard, soft, soft_corrected };  // numbered as the kinds of render/march.glsl

struct LightEntry {
    Entry entry;  // p -> Light
    NodeId node;
    Shadow shadow = Shadow::off;
};

struct Program {
    std::shared_ptr<const Library> library;  // keeps types and functions alive
    std::vector<ProgramValue> values;
    std::vector<Instruction> instructions;
    std::vector<ValueId> arguments;
    std::vector<Carried> carried;

    // Constants in place, frame slots zero; field::evaluate_frame fills the rest. Size is a multiple of 4.
    std::vector<float> block;
    std::vector<glm::vec4> list_data;  // all list parameters, one after the other

    ValueId time = no_value;         // frame-rate input, seconds
    Entry frame;                     // constant- and frame-rate calls: results go to the block
    Entry distance;                  // p -> float
    Entry surface;                   // p -> Material, material node id, node id (whole numbers as float)
    Entry ray;                       // uv, lens -> Ray
    Entry sky;                       // direction, spread (0 one direction .. 1 the hemisphere around it) -> vec3
    std::vector<LightEntry> lights;  // shadowed first

    MarchSettings march;
    OcclusionSettings occlusion;
    FogSettings fog;
    int bounces = 0;
    std::int64_t expanded_cost = 0;  // primitive evaluations per distance call, copies included, saturating
    int loop_iterations = 0;         // per distance call
    int step_budget = 60000;         // floor(60000 / (1 + loop_iterations)), all rays of a pixel together
    ValueId bounds = no_value;       // Box of the root field, when asked for
    ValueId lipschitz = no_value;    // largest constant divided out anywhere, when there is one
    bool gpu_only = false;           // a node is not compiled into this program
    std::vector<Problem> problems;
    std::vector<InnerCopy> inner_copies;  // what the ids of nodes stand for that the scene itself does not have
};

inline std::span<const ValueId> arguments_of(const Program& program, const Instruction& call)
{
    return std::span(program.arguments)
        .subspan(static_cast<std::size_t>(call.first_argument), static_cast<std::size_t>(call.argument_count));
}

inline std::span<const Carried> carried_of(const Program& program, const Instruction& block)
{
    return std::span(program.carried)
        .subspan(static_cast<std::size_t>(block.first_carried), static_cast<std::size_t>(block.carried_count));
}

float step_scale(const MarchSettings& march);  // 1 when derived
int shadow_count(const Program& program);      // lights that cast shadows; they come first
// Whether the march must keep the smallest ratio of distance and way along its rays.
bool tracks_cone(const Program& program);

struct LowerOptions {
    std::int64_t cost_limit = 2048;
    bool bounds = false;
    // When set, the distance entry is this node's field instead of the output's (2D fields at z = 0). Of a node in a
    // group, its first copy's.
    NodeId root;
    // Whether surfaces know their node and material id. Without, both are 0 everywhere, and of combiners only those
    // are left in the surface entry whose sides differ in material: the shader is ready sooner.
    bool ids = true;
    // Whether chains of affine nodes become one matrix. Without, every node's own function is called: exports are read.
    bool fold_moves = true;
    // What was baked for image_requests(document, library); what is missing here is still being read.
    const BakedImages* images = nullptr;
    // Where the slopes of typed formulas are kept from one lowering of a scene to the next; null computes them.
    SlopeMemo* slopes = nullptr;
};

// Pure; never throws for a valid document at rest. Problems' nodes count as unconnected. A problem inside a group is
// about the group node in the scene, and says the way from there.
Program lower(const Document& document, const std::shared_ptr<const Library>& library,
              const LowerOptions& options = {});

}  // namespace fieldwright::graph
