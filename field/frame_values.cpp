// The values of a frame: calls whose arguments are single numbers, each run as a row of one point.
#include "field/evaluator.h"
#include "field/kernel_finder.h"
#include "field/program_values.h"

#include <array>
#include <cassert>

namespace fieldwright::field {
namespace {

using graph::Instruction;
using graph::Program;
using graph::ValueId;

// Rows of one point for the calls of a frame: room for the arguments of any, and for its result.
class FrameRows {
public:
    explicit FrameRows(const Program& program) : program_(program) {}

    void run(const Instruction& instruction, const KernelEntry& kernel, std::vector<float>& block)
    {
        std::span<const ValueId> arguments = arguments_of(program_, instruction);
        const graph::ProgramValue& result = value_of(program_, instruction.result);
        reserve(arguments, result.lanes);
        std::array<const float*, max_arguments> pointers;
        std::size_t lane = index(result.lanes);
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            const graph::ProgramValue& value = value_of(program_, arguments[k]);
            pointers[k] = place(value, block, lane);
            lane += index(value.lanes);
        }
        kernel.varying(rows_.data(), pointers.data(), program_.list_data.data(), 1);
        for (std::size_t i = 0; i < index(result.lanes); ++i) block[index(result.slot) + i] = rows_[i * row_width];
    }

private:
    void reserve(std::span<const ValueId> arguments, int lanes)
    {
        assert(arguments.size() <= max_arguments);
        for (ValueId id : arguments) lanes += value_of(program_, id).lanes;
        if (rows_.size() < index(lanes) * row_width) rows_.resize(index(lanes) * row_width);
    }

    // Lists are read in place.
    const float* place(const graph::ProgramValue& value, const std::vector<float>& block, std::size_t first_lane)
    {
        const float* single = block.data() + value.slot;
        if (value.type->base == graph::BaseType::list) return single;
        float* row = rows_.data() + first_lane * row_width;
        for (std::size_t i = 0; i < index(value.lanes); ++i) row[i * row_width] = single[i];
        return row;
    }

    const Program& program_;
    std::vector<float> rows_;
};

}  // namespace

std::vector<float> evaluate_frame(const Program& program, float time)
{
    std::vector<float> block = program.block;
    if (program.time != graph::no_value) block[index(value_of(program, program.time).slot)] = time;
    KernelFinder kernel_of(kernels(), program);
    FrameRows rows(program);
    for (std::int32_t i = program.frame.first; i < program.frame.last; ++i) {
        const Instruction& instruction = program.instructions[index(i)];
        rows.run(instruction, kernel_of(instruction), block);
    }
    return block;
}

}  // namespace fieldwright::field
