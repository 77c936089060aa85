// Prints a program's entries as GLSL functions: flat assignments, cut into parts of about 32 primitives each.
#pragma once

#include "codegen/glsl.h"

#include <functional>
#include <unordered_set>

namespace fieldwright::codegen {

class ScenePrinter {
public:
    // Empty names: identifiers n<node>_<value>. Else `name(node)` begins each identifier (exports).
    using NodeName = std::function<std::string(graph::NodeId)>;

    // `structs`: as the shader declares them, which may be with fewer members than the library's.
    ScenePrinter(const graph::Program& program, std::span<const float> block, Placement placement,
                 std::vector<graph::StructDeclaration> structs, NodeName node_name = {});

    // Constants and functions of node files that the program calls, callees first.
    std::string node_functions() const;
    // scene_distance, scene_surface, scene_ray, scene_sky, scene_light, scene_shadow and the light counts.
    std::string scene_functions();
    // Exports only: frame values as globals and `void update_frame()`, which computes them.
    std::string frame_globals();
    // Whether the text reads the block; known after scene_functions().
    bool reads_block() const { return reads_block_; }

private:
    // Instructions of one level: a body or an entry, blocks counted as one item.
    struct Item {
        std::int32_t instruction;
        std::int32_t end;  // index after it (after the body of a block)
    };
    struct Part {
        std::size_t first, last;  // items
        std::vector<graph::ValueId> inputs, outputs;
    };

    std::string shadow_kinds() const;
    void function(std::string_view result_type, std::string_view name, const graph::Entry& entry);
    std::string entry_result(const graph::Entry& entry, std::string_view result_type);
    std::vector<Item> items(std::int32_t first, std::int32_t last) const;
    void level(std::string& out, std::int32_t first, std::int32_t last, std::span<const graph::ValueId> results,
               int indent);
    std::vector<Part> parts(const std::vector<Item>& items, std::span<const graph::ValueId> results) const;
    void part_function(const std::vector<Item>& items, const Part& part);
    void part_call(std::string& out, const Part& part, int indent);
    void statement(std::string& out, const Item& item, int indent);
    void call(std::string& out, const graph::Instruction& instruction);
    void block(std::string& out, const Item& item, int indent);
    template <typename Visit>
    void for_each_use(const Item& item, const Visit& visit) const;
    template <typename Visit>
    void for_each_definition(const Item& item, const Visit& visit) const;
    std::size_t best_cut(const std::vector<Item>& items, std::size_t first,
                         const std::vector<std::uint32_t>& last_use) const;

    void name(std::string& out, graph::ValueId value) const;
    void reference(std::string& out, graph::ValueId value);
    void literal(std::string& out, const graph::Type& type, const float*& lanes) const;
    void block_read(std::string& out, const graph::Type& type, std::int32_t& slot);
    template <typename Print>
    void members(std::string& out, const graph::Type& type, const Print& print) const;
    const graph::ProgramValue& value(graph::ValueId id) const { return program_.values[static_cast<std::size_t>(id)]; }
    bool in_block(graph::ValueId id) const { return value(id).rate != graph::Rate::point; }

    const graph::Program& program_;
    std::span<const float> block_;
    Placement placement_;
    std::vector<graph::StructDeclaration> structs_;
    NodeName node_name_;
    std::string functions_;  // finished functions, parts before their callers
    int part_count_ = 0;
    bool reads_block_ = false;
    bool frame_globals_ = false;
};

// A float as the dialect writes it: shortest round trip, always with a point or exponent, suffix f.
void append_float(std::string& out, float number);

}  // namespace fieldwright::codegen
