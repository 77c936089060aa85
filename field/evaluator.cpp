// Runs an entry's operations over rows.
#include "field/evaluator.h"

#include "field/program_values.h"

#include <algorithm>
#include <cassert>

namespace fieldwright::field {

Evaluator::Workspace::Workspace(const Evaluator& evaluator)
    : memory_(static_cast<std::size_t>(evaluator.row_count_) * row_width + 16),
      counters_(static_cast<std::size_t>(evaluator.counter_count_)),
      pointers_(evaluator.operands_.size()),
      evaluator_(&evaluator)
{
    auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    rows_ = memory_.data() + (64 - address % 64) % 64 / sizeof(float);
    for (std::size_t i = 0; i < pointers_.size(); ++i) {
        const Operand& operand = evaluator.operands_[i];
        if (operand.kind == Operand::Kind::rows) pointers_[i] = row(operand.at);
        if (operand.kind == Operand::Kind::counter) pointers_[i] = &counters_[index(operand.at)];
    }
}

void Evaluator::Workspace::point_into(std::span<const float> block)
{
    if (block.data() == block_) return;
    block_ = block.data();
    for (int operand : evaluator_->block_operands_)
        pointers_[index(operand)] = block_ + evaluator_->operands_[index(operand)].at;
}

const float* Evaluator::Workspace::result(int lane) const
{
    return rows_ + static_cast<std::ptrdiff_t>(evaluator_->result_rows_[index(lane)]) * row_width;
}

float Evaluator::copies(const Operation& end_of_block, std::span<const float> block)
{
    auto all = static_cast<float>(end_of_block.copies);
    return end_of_block.needed < 0 ? all : std::min(all, block[index(end_of_block.needed)]);
}

namespace {

// Whether at every point one of the rivals is as near as the least that a guard leaves possible.
bool is_beaten(const float* least, const float* const* rivals, int rival_count, int count)
{
    int beaten = 0;
    for (int i = 0; i < count; ++i) {
        float nearest = rivals[0][i];
        for (int k = 1; k < rival_count; ++k) nearest = rivals[k][i] < nearest ? rivals[k][i] : nearest;
        beaten += nearest <= least[i] ? 1 : 0;
    }
    return beaten == count;
}

}  // namespace

void Evaluator::evaluate(Workspace& workspace, std::span<const float> block, int count) const
{
    assert(workspace.evaluator_ == this && count <= row_width);
    workspace.point_into(block);
    const float* const* pointers = workspace.pointers_.data();
    float* counters = workspace.counters_.data();
    const Operation* end = operations_.data() + operations_.size();
    for (const Operation* operation = operations_.data(); operation != end; ++operation) {
        const float* const* arguments = pointers + operation->first_operand;
        float* result = workspace.row(operation->result);
        switch (operation->kind) {
            case Operation::Kind::call: operation->kernel(result, arguments, list_data_.data(), count); break;
            case Operation::Kind::spread:
                for (int lane = 0; lane < operation->lanes; ++lane)
                    std::fill_n(result + lane * row_width, count, arguments[0][lane]);
                break;
            case Operation::Kind::copy:
                for (int lane = 0; lane < operation->lanes; ++lane)
                    std::copy_n(arguments[0] + lane * row_width, count, result + lane * row_width);
                break;
            case Operation::Kind::begin_block: counters[operation->counter] = 0; break;
            case Operation::Kind::end_block:
                counters[operation->counter] += 1;
                if (counters[operation->counter] < copies(*operation, block)) operation -= operation->body + 1;
                break;
            case Operation::Kind::guard:
                if (!is_beaten(arguments[0], arguments + 1, operation->lanes, count)) break;
                std::copy_n(arguments[0], count, result);
                operation += operation->body;
                break;
        }
    }
}

std::vector<float> distances(const graph::Program& program, std::span<const float> block,
                             std::span<const glm::vec3> points, const KernelTable& table)
{
    Evaluator evaluator(program, program.distance, table);
    Evaluator::Workspace workspace(evaluator);
    std::vector<float> result(points.size());
    for (std::size_t first = 0; first < points.size(); first += row_width) {
        int count = static_cast<int>(std::min<std::size_t>(row_width, points.size() - first));
        for (int lane = 0; lane < 3; ++lane)
            for (int i = 0; i < count; ++i) workspace.input(lane)[i] = points[first + index(i)][lane];
        evaluator.evaluate(workspace, block, count);
        std::copy_n(workspace.result(0), count, result.begin() + static_cast<std::ptrdiff_t>(first));
    }
    return result;
}

}  // namespace fieldwright::field
