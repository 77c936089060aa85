// Prints a program's entries as GLSL functions: flat assignments, cut into parts of about 32 primitives each.
#pragma once

#include "codegen/parts.h"
#include "codegen/value_printer.h"

namespace fieldwright::codegen {

class ScenePrinter {
public:
    ScenePrinter(const graph::Program& program, std::span<const float> block, Placement placement,
                 std::vector<graph::StructDeclaration> structs, NodeName node_name = {});

    // Constants and functions of node files that the program calls, callees first.
    std::string node_functions() const;
    // scene_distance, scene_surface, scene_ray, scene_sky, scene_light, scene_shadow and the light counts.
    std::string scene_functions();
    // Exports only: frame values as globals and `void update_frame()`, which computes them.
    std::string frame_globals();
    // Whether the text reads the block; known after scene_functions().
    bool reads_block() const { return values_.reads_block(); }

private:
    std::string shadow_kinds() const;
    void function(std::string_view result_type, std::string_view name, const graph::Entry& entry);
    std::string entry_result(const graph::Entry& entry, std::string_view result_type);
    void level(std::string& out, std::int32_t first, std::int32_t last, std::span<const graph::ValueId> results,
               int indent);
    void part_function(const std::vector<Item>& items, const Part& part);
    void part_call(std::string& out, const Part& part, int indent);
    void statement(std::string& out, const Item& item, int indent);
    void call(std::string& out, const graph::Instruction& instruction);
    void block(std::string& out, const Item& item, int indent);
    const graph::ProgramValue& value(graph::ValueId id) const { return program_.values[static_cast<std::size_t>(id)]; }

    const graph::Program& program_;
    ValuePrinter values_;
    std::string functions_;  // finished functions, parts before their callers
    int part_count_ = 0;
};

}  // namespace fieldwright::codegen
