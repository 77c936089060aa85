// How a program's values are written: by name, as literals, or as places in the block.
#pragma once

#include "codegen/glsl.h"

#include <functional>

namespace fieldwright::codegen {

// Empty names: identifiers n<node>_<value>. Else `name(node)` begins each identifier (exports).
using NodeName = std::function<std::string(graph::NodeId)>;

class ValuePrinter {
public:
    // `structs`: as the shader declares them, which may be with fewer members than the library's.
    ValuePrinter(const graph::Program& program, std::span<const float> block, Placement placement,
                 std::vector<graph::StructDeclaration> structs, NodeName node_name = {});

    void name(std::string& out, graph::ValueId value) const;
    void reference(std::string& out, graph::ValueId value);
    void use_frame_globals() { frame_globals_ = true; }  // frame values have names from here on
    bool reads_block() const { return reads_block_; }    // whether a reference so far does

private:
    void literal(std::string& out, const graph::Type& type, const float*& lanes) const;
    void block_read(std::string& out, const graph::Type& type, std::int32_t& slot);
    template <typename Print>
    void members(std::string& out, const graph::Type& type, const Print& print) const;
    const graph::ProgramValue& value(graph::ValueId id) const { return program_.values[static_cast<std::size_t>(id)]; }

    const graph::Program& program_;
    std::span<const float> block_;
    Placement placement_;
    std::vector<graph::StructDeclaration> structs_;
    NodeName node_name_;
    bool reads_block_ = false;
    bool frame_globals_ = false;
};

// A float as the dialect writes it: shortest round trip, always with a point or exponent, suffix f.
void append_float(std::string& out, float number);

}  // namespace fieldwright::codegen
