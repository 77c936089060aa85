// Values, slots and sequences of a program under construction.
#include "graph/program_builder.h"

#include <algorithm>

namespace fieldwright::graph {

const Type& ProgramBuilder::real_type()
{
    static const Type type{BaseType::real, "float"};
    return type;
}

const Type& ProgramBuilder::integer_type()
{
    static const Type type{BaseType::integer, "int"};
    return type;
}

const Type& ProgramBuilder::vec2_type()
{
    static const Type type{BaseType::vec2, "vec2"};
    return type;
}

const Type& ProgramBuilder::vec3_type()
{
    static const Type type{BaseType::vec3, "vec3"};
    return type;
}

ProgramBuilder::ProgramBuilder(std::shared_ptr<const Library> library)
{
    program_.library = std::move(library);
    program_.time = add_value(real_type(), Rate::frame, {}, "time");
    program_.values.back().slot = take_slot(1);
}

// A guess, and a generous one: memory that is never touched costs nothing, moving what has grown does.
void ProgramBuilder::reserve(std::size_t nodes)
{
    program_.values.reserve(8 * nodes);
    program_.instructions.reserve(6 * nodes);
    program_.arguments.reserve(16 * nodes);
    program_.block.reserve(8 * nodes);
    sequence_.reserve(4 * nodes);
    point_dependent_.reserve(8 * nodes);
}

ValueId ProgramBuilder::add_value(const Type& type, Rate rate, NodeId node, const char* name)
{
    ProgramValue value;
    value.type = &type;
    value.rate = rate;
    value.lanes = library().lanes(type);
    value.node = node;
    value.name = name;
    program_.values.push_back(value);
    point_dependent_.push_back(false);
    return static_cast<ValueId>(program_.values.size() - 1);
}

// Vectors never straddle a vec4; structures begin at one.
std::int32_t ProgramBuilder::take_slot(int lanes)
{
    auto at = program_.block.size();
    if (lanes > 1 && (lanes > 4 || at % 4 + static_cast<std::size_t>(lanes) > 4)) at = (at + 3) / 4 * 4;
    program_.block.resize(at + static_cast<std::size_t>(lanes), 0.0f);
    return static_cast<std::int32_t>(at);
}

ValueId ProgramBuilder::constant(const Type& type, std::span<const float> lanes, NodeId node, const char* name)
{
    ValueId value = add_value(type, Rate::constant, node, name);
    ProgramValue& added = program_.values.back();
    added.slot = take_slot(added.lanes);
    std::copy(lanes.begin(), lanes.end(), program_.block.begin() + added.slot);
    return value;
}

ValueId ProgramBuilder::list(const PointList& points, NodeId node, const char* name)
{
    static const Type type{BaseType::list, "List"};
    float lanes[2] = {static_cast<float>(program_.list_data.size()), static_cast<float>(points.size())};
    program_.list_data.insert(program_.list_data.end(), points.begin(), points.end());
    return constant(type, lanes, node, name);
}

std::size_t ProgramBuilder::list_size(ValueId list) const
{
    auto slot = static_cast<std::size_t>(program_.values[static_cast<std::size_t>(list)].slot);
    return static_cast<std::size_t>(program_.block[slot + 1]);
}

ValueId ProgramBuilder::input(const Type& type, const char* name) { return add_value(type, Rate::point, {}, name); }

ValueId ProgramBuilder::call(const Function& function, std::span<const ValueId> arguments, NodeId node, bool compiled)
{
    Rate rate = compiled ? Rate::constant : Rate::point;
    bool point_dependent = false;
    for (ValueId argument : arguments) {
        rate = std::max(rate, this->rate(argument));
        point_dependent = point_dependent || depends_on_point(argument);
    }
    Instruction instruction;
    instruction.function = &function;
    instruction.first_argument = static_cast<std::int32_t>(program_.arguments.size());
    instruction.argument_count = static_cast<std::int32_t>(arguments.size());
    program_.arguments.insert(program_.arguments.end(), arguments.begin(), arguments.end());
    instruction.node = node;
    instruction.result = add_value(function.result, rate, node, nullptr);
    point_dependent_.back() = point_dependent;
    if (rate == Rate::point) {
        sequence_.push_back(instruction);
    } else {
        program_.values.back().slot = take_slot(program_.values.back().lanes);
        frame_.push_back(instruction);
    }
    return instruction.result;
}

ValueId ProgramBuilder::call(std::string_view support, std::initializer_list<ValueId> arguments, NodeId node)
{
    return call(support, std::span(arguments.begin(), arguments.size()), node);
}

ValueId ProgramBuilder::call(std::string_view support, std::span<const ValueId> arguments, NodeId node)
{
    return call(library().support(support), arguments, node);
}

std::size_t ProgramBuilder::begin_block(int copies, NodeId node)
{
    Instruction block;
    block.node = node;
    block.copies = copies;
    block.copy = input(integer_type(), "copy");
    sequence_.push_back(block);
    return sequence_.size() - 1;
}

void ProgramBuilder::end_block(std::size_t block, std::span<const Carried> carried)
{
    sequence_[block].body_end = static_cast<std::int32_t>(sequence_.size());
    sequence_[block].first_carried = static_cast<std::int32_t>(program_.carried.size());
    sequence_[block].carried_count = static_cast<std::int32_t>(carried.size());
    program_.carried.insert(program_.carried.end(), carried.begin(), carried.end());
}

// By value: whether one of `results` depends on it.
std::vector<bool> ProgramBuilder::needed_for(std::span<const ValueId> results) const
{
    std::vector<std::span<const ValueId>> arguments(program_.values.size());  // of what computes a value
    for (const Instruction& instruction : sequence_) {
        if (!instruction.is_block())
            arguments[static_cast<std::size_t>(instruction.result)] = arguments_of(program_, instruction);
        for (const Carried& pair : carried_of(program_, instruction))
            arguments[static_cast<std::size_t>(pair.accumulator)] = {&pair.next, 1};
    }
    std::vector<bool> needed(program_.values.size(), false);
    std::vector<ValueId> open(results.begin(), results.end());
    while (!open.empty()) {
        auto value = static_cast<std::size_t>(open.back());
        open.pop_back();
        if (needed[value]) continue;
        needed[value] = true;
        open.insert(open.end(), arguments[value].begin(), arguments[value].end());
    }
    return needed;
}

void ProgramBuilder::keep_carried(Instruction& block, const std::vector<bool>& needed)
{
    auto first = program_.carried.begin() + block.first_carried;
    auto last = std::stable_partition(first, first + block.carried_count, [&](const Carried& pair) {
        return needed[static_cast<std::size_t>(pair.accumulator)];
    });
    block.carried_count = static_cast<std::int32_t>(last - first);
}

void ProgramBuilder::keep_what_gives(std::span<const ValueId> results)
{
    std::vector<bool> needed = needed_for(results);
    std::vector<Instruction> kept;
    std::vector<std::int32_t> kept_before;  // by old place
    kept.reserve(sequence_.size());
    for (Instruction& instruction : sequence_) {
        kept_before.push_back(static_cast<std::int32_t>(kept.size()));
        if (instruction.is_block()) keep_carried(instruction, needed);
        bool keeps = instruction.is_block() ? instruction.carried_count > 0
                                            : needed[static_cast<std::size_t>(instruction.result)];
        if (keeps) kept.push_back(instruction);
    }
    kept_before.push_back(static_cast<std::int32_t>(kept.size()));
    for (Instruction& instruction : kept)
        if (instruction.is_block()) instruction.body_end = kept_before[static_cast<std::size_t>(instruction.body_end)];
    sequence_ = std::move(kept);
}

Entry ProgramBuilder::finish_entry(std::vector<ValueId> inputs, std::vector<ValueId> results)
{
    auto offset = static_cast<std::int32_t>(program_.instructions.size());
    for (Instruction& instruction : sequence_) {
        if (instruction.is_block()) instruction.body_end += offset;
        program_.instructions.push_back(instruction);
    }
    sequence_.clear();
    return {offset, static_cast<std::int32_t>(program_.instructions.size()), std::move(inputs), std::move(results)};
}

Program ProgramBuilder::finish()
{
    sequence_ = std::move(frame_);
    program_.frame = finish_entry({}, {});
    program_.block.resize((program_.block.size() + 3) / 4 * 4, 0.0f);
    return std::move(program_);
}

}  // namespace fieldwright::graph
