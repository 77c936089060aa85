// Grows a program: values, slots of the block, and calls placed by rate.
#pragma once

#include "graph/program.h"

#include <initializer_list>

namespace fieldwright::graph {

class ProgramBuilder {
public:
    explicit ProgramBuilder(std::shared_ptr<const Library> library);

    // Makes room for the program of so many nodes.
    void reserve(std::size_t nodes);

    // Constants in the block. `type_name` as in the dialect.
    ValueId constant(const Type& type, std::span<const float> lanes, NodeId node = {}, const char* name = nullptr);
    ValueId constant(float number) { return constant(real_type(), {&number, 1}); }
    ValueId constant_int(int number)
    {
        float lane = static_cast<float>(number);
        return constant(integer_type(), {&lane, 1});
    }
    ValueId constant_id(std::int64_t id) { return constant(static_cast<float>(id)); }
    ValueId list(const PointList& points, NodeId node, const char* name);
    std::size_t list_size(ValueId list) const;
    // A point-rate value that a caller or a block sets.
    ValueId input(const Type& type, const char* name);

    // A call. Constant and frame arguments to a `compiled` function give a frame call with a slot; the rest goes to the
    // sequence being emitted.
    ValueId call(const Function& function, std::span<const ValueId> arguments, NodeId node, bool compiled = true);
    ValueId call(std::string_view support, std::initializer_list<ValueId> arguments, NodeId node = {});
    ValueId call(std::string_view support, std::span<const ValueId> arguments, NodeId node = {});

    // Blocks of the sequence being emitted.
    std::size_t begin_block(int copies, NodeId node);
    ValueId copy_of(std::size_t block) const { return sequence_[block].copy; }
    void set_needed(std::size_t block, ValueId count) { sequence_[block].needed = count; }
    void end_block(std::size_t block, std::span<const Carried> carried);

    std::size_t position() const { return sequence_.size(); }
    void truncate(std::size_t position) { sequence_.resize(position); }
    // Takes what none of `results` depends on out of the sequence being emitted.
    void keep_what_gives(std::span<const ValueId> results);
    // Closes the sequence being emitted as an entry.
    Entry finish_entry(std::vector<ValueId> inputs, std::vector<ValueId> results);
    // Appends the frame sequence and hands the program over.
    Program finish();

    Rate rate(ValueId value) const { return program_.values[static_cast<std::size_t>(value)].rate; }
    const Type& type(ValueId value) const { return *program_.values[static_cast<std::size_t>(value)].type; }
    bool depends_on_point(ValueId value) const { return point_dependent_[static_cast<std::size_t>(value)]; }
    void mark_point_dependent(ValueId value, bool dependent = true)
    {
        point_dependent_[static_cast<std::size_t>(value)] = dependent;
    }

    static const Type& real_type();
    static const Type& integer_type();
    static const Type& vec2_type();
    static const Type& vec3_type();

    Program& program() { return program_; }
    const Library& library() const { return *program_.library; }

private:
    ValueId add_value(const Type& type, Rate rate, NodeId node, const char* name);
    std::int32_t take_slot(int lanes);
    std::vector<bool> needed_for(std::span<const ValueId> results) const;
    void keep_carried(Instruction& block, const std::vector<bool>& needed);

    Program program_;
    std::vector<bool> point_dependent_;  // by value: varies with p itself, not only with the cell or the copy
    std::vector<Instruction> sequence_;  // being emitted; body_end relative to its start
    std::vector<Instruction> frame_;
};

}  // namespace fieldwright::graph
