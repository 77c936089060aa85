// Compiles an entry into operations over rows, and runs them.
#include "field/evaluator.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fieldwright::field {
namespace {

using graph::Instruction;
using graph::Program;
using graph::Rate;
using graph::ValueId;

constexpr int max_arguments = 32;

const KernelEntry& kernel_of(const KernelTable& table, const Instruction& instruction)
{
    const KernelEntry* kernel = find_kernel(table, instruction.function->name);
    if (!kernel)
        throw graph::Failure(1, "node " + std::to_string(instruction.node.number) + " (" + instruction.function->name +
                                    ") is not compiled into this program; render it with --device gpu or rebuild");
    return *kernel;
}

// Arguments that a kernel's uniform form reads as single values.
bool is_single(const graph::Function& function, const graph::Argument& argument)
{
    bool of_node = function.file.starts_with("nodes/");
    return of_node && (argument.parameter >= 0 || argument.role == graph::Role::copy || argument.role == graph::Role::time);
}

}  // namespace

class Evaluator::Compiler {
public:
    Compiler(Evaluator& evaluator, const Program& program, const graph::Entry& entry, const KernelTable& table)
        : evaluator_(evaluator), program_(program), entry_(entry), table_(table), row_of_(program.values.size(), -1)
    {
    }

    void compile()
    {
        for (ValueId input : entry_.inputs) {
            row_of_[index(input)] = take(value(input).lanes);
            evaluator_.input_lanes_ += value(input).lanes;
        }
        find_last_uses();
        emit(entry_.first, entry_.last);
        for (ValueId result : entry_.results)
            for (int lane = 0; lane < value(result).lanes; ++lane) evaluator_.results_.push_back(result_operand(result, lane));
        spread_results();
    }

private:
    static std::size_t index(ValueId id) { return static_cast<std::size_t>(id); }
    const graph::ProgramValue& value(ValueId id) const { return program_.values[index(id)]; }
    bool in_block(ValueId id) const { return value(id).rate != Rate::point; }

    // Rows are taken first fit from those free.
    int take(int lanes)
    {
        auto& free = free_[static_cast<std::size_t>(std::min(lanes, 32))];
        if (!free.empty()) {
            int row = free.back();
            free.pop_back();
            return row;
        }
        int row = evaluator_.row_count_;
        evaluator_.row_count_ += lanes;
        return row;
    }

    void release(ValueId id)
    {
        free_[static_cast<std::size_t>(std::min(value(id).lanes, 32))].push_back(row_of_[index(id)]);
        row_of_[index(id)] = -1;
    }

    // last_use_: the instruction after which a value's rows may be reused; a value from outside a block lives to its end.
    void find_last_uses()
    {
        last_use_.assign(program_.values.size(), -1);
        defined_.assign(program_.values.size(), entry_.first - 1);
        std::vector<std::int32_t> open;  // blocks around the instruction
        for (std::int32_t i = entry_.first; i < entry_.last; ++i) {
            while (!open.empty() && program_.instructions[index(open.back())].body_end <= i) open.pop_back();
            const Instruction& instruction = program_.instructions[index(i)];
            for (std::int32_t k = 0; k < instruction.argument_count; ++k)
                use(program_.arguments[index(instruction.first_argument + k)], i, open);
            if (instruction.is_block()) {
                open.push_back(i);
                for (std::int32_t k = 0; k < instruction.carried_count; ++k) {
                    const graph::Carried& carried = program_.carried[index(instruction.first_carried + k)];
                    defined_[index(carried.accumulator)] = i - 1;  // outside the body
                    last_use_[index(carried.accumulator)] = instruction.body_end;
                    last_use_[index(carried.next)] = instruction.body_end;
                }
            } else {
                defined_[index(instruction.result)] = i;
            }
        }
        for (ValueId result : entry_.results) last_use_[index(result)] = std::numeric_limits<std::int32_t>::max();
        for (ValueId input : entry_.inputs) last_use_[index(input)] = std::numeric_limits<std::int32_t>::max();
    }

    void use(ValueId id, std::int32_t at, const std::vector<std::int32_t>& open)
    {
        std::int32_t until = at;
        for (std::int32_t block : open)
            if (defined_[index(id)] < block) {
                until = program_.instructions[index(block)].body_end;
                break;
            }
        last_use_[index(id)] = std::max(last_use_[index(id)], until);
    }

    void emit(std::int32_t first, std::int32_t last)
    {
        for (std::int32_t i = first; i < last;) {
            const Instruction& instruction = program_.instructions[index(i)];
            if (instruction.is_block()) {
                emit_block(i, instruction);
                i = instruction.body_end;
            } else {
                emit_call(i, instruction);
                ++i;
            }
        }
    }

    void emit_call(std::int32_t at, const Instruction& instruction)
    {
        const graph::Function& function = *instruction.function;
        const KernelEntry& kernel = kernel_of(table_, instruction);
        bool varying = kernel.uniform == kernel.varying;
        for (std::int32_t k = 0; k < instruction.argument_count; ++k) {
            ValueId id = program_.arguments[index(instruction.first_argument + k)];
            bool rows = !in_block(id) && !counters_.contains(id);
            varying = varying || (rows && is_single(function, function.arguments[index(k)]));
        }
        Operation operation;
        operation.kernel = varying ? kernel.varying : kernel.uniform;
        operation.first_operand = static_cast<int>(evaluator_.operands_.size());
        operation.operand_count = instruction.argument_count;
        for (std::int32_t k = 0; k < instruction.argument_count; ++k) {
            const graph::Argument& argument = function.arguments[index(k)];
            bool single = argument.type.base == graph::BaseType::list || (!varying && is_single(function, argument));
            evaluator_.operands_.push_back(operand(program_.arguments[index(instruction.first_argument + k)], single));
        }
        operation.result = take(value(instruction.result).lanes);
        row_of_[index(instruction.result)] = operation.result;
        evaluator_.operations_.push_back(operation);
        scratch_in_use_.clear();
        release_dead(at, instruction);
    }

    Operand operand(ValueId id, bool single)
    {
        Operand operand{Operand::Kind::rows, 0, value(id).lanes, 0};
        if (auto counter = counters_.find(id); counter != counters_.end()) {
            operand.kind = single ? Operand::Kind::counter : Operand::Kind::counter_as_rows;
            operand.at = counter->second;
        } else if (in_block(id)) {
            operand.kind = single ? Operand::Kind::block : Operand::Kind::block_as_rows;
            operand.at = value(id).slot;
        } else {
            operand.at = row_of_[index(id)];
        }
        if (operand.kind == Operand::Kind::counter_as_rows || operand.kind == Operand::Kind::block_as_rows)
            operand.scratch = scratch_rows(operand.lanes);
        return operand;
    }

    // Rows that single values are spread over for one call: never among those the allocator hands out.
    int scratch_rows(int lanes)
    {
        for (const auto& [row, size] : scratch_pool_)
            if (size == lanes && std::find(scratch_in_use_.begin(), scratch_in_use_.end(), row) == scratch_in_use_.end()) {
                scratch_in_use_.push_back(row);
                return row;
            }
        int row = evaluator_.row_count_;
        evaluator_.row_count_ += lanes;
        scratch_pool_.emplace_back(row, lanes);
        scratch_in_use_.push_back(row);
        return row;
    }

    void release_dead(std::int32_t at, const Instruction& instruction)
    {
        for (std::int32_t k = 0; k < instruction.argument_count; ++k) {
            ValueId id = program_.arguments[index(instruction.first_argument + k)];
            if (!in_block(id) && row_of_[index(id)] >= 0 && last_use_[index(id)] <= at && !counters_.contains(id)) release(id);
        }
        if (last_use_[index(instruction.result)] < 0) release(instruction.result);
    }

    void emit_block(std::int32_t at, const Instruction& block)
    {
        std::span carried(program_.carried.data() + block.first_carried, index(block.carried_count));
        for (const graph::Carried& pair : carried) {
            row_of_[index(pair.accumulator)] = take(value(pair.accumulator).lanes);
            emit_set(pair.accumulator, pair.initial);
        }
        int counter = evaluator_.counter_count_++;
        counters_[block.copy] = counter;
        Operation begin;
        begin.kind = Operation::Kind::begin_block;
        begin.counter = counter;
        evaluator_.operations_.push_back(begin);
        int body = static_cast<int>(evaluator_.operations_.size());
        emit(at + 1, block.body_end);
        for (const graph::Carried& pair : carried) emit_set(pair.accumulator, pair.next);
        Operation end;
        end.kind = Operation::Kind::end_block;
        end.counter = counter;
        end.copies = block.copies;
        end.jump = body;
        evaluator_.operations_.push_back(end);
        release_after_block(block);
    }

    void emit_set(ValueId target, ValueId source)
    {
        Operation set;
        set.kind = Operation::Kind::set;
        set.result = row_of_[index(target)];
        set.first_operand = static_cast<int>(evaluator_.operands_.size());
        Operand from = operand(source, true);
        from.lanes = value(target).lanes;
        evaluator_.operands_.push_back(from);
        evaluator_.operations_.push_back(set);
    }

    // Values that lived to the block's end because the body runs several times.
    void release_after_block(const Instruction& block)
    {
        std::int32_t end = block.body_end;
        auto release_if_dead = [&](ValueId id) {
            if (!in_block(id) && row_of_[index(id)] >= 0 && last_use_[index(id)] <= end && !counters_.contains(id)) release(id);
        };
        for (std::int32_t i = static_cast<std::int32_t>(&block - program_.instructions.data()) + 1; i < end; ++i) {
            const Instruction& inner = program_.instructions[index(i)];
            for (std::int32_t k = 0; k < inner.argument_count; ++k) {
                ValueId id = program_.arguments[index(inner.first_argument + k)];
                if (!is_accumulator_of(block, id)) release_if_dead(id);
            }
        }
        for (std::int32_t k = 0; k < block.carried_count; ++k)
            release_if_dead(program_.carried[index(block.first_carried + k)].next);
    }

    // An accumulator is read after its block: its later uses decide when it dies.
    bool is_accumulator_of(const Instruction& block, ValueId id) const
    {
        for (std::int32_t k = 0; k < block.carried_count; ++k)
            if (program_.carried[index(block.first_carried + k)].accumulator == id) return true;
        return false;
    }

    Operand result_operand(ValueId id, int lane)
    {
        if (in_block(id)) return {Operand::Kind::block_as_rows, value(id).slot + lane, 1, 0};
        return {Operand::Kind::rows, row_of_[index(id)] + lane, 1, 0};
    }

    // Results that are single values are spread over rows of their own at the end.
    void spread_results()
    {
        for (Operand& result : evaluator_.results_)
            if (result.kind != Operand::Kind::rows) result.scratch = evaluator_.row_count_++;
    }

    Evaluator& evaluator_;
    const Program& program_;
    const graph::Entry& entry_;
    const KernelTable& table_;
    std::vector<int> row_of_;                 // by value
    std::vector<std::int32_t> last_use_, defined_;
    std::map<ValueId, int> counters_;         // copy values
    std::array<std::vector<int>, 33> free_;   // first rows by number of lanes
    std::vector<std::pair<int, int>> scratch_pool_;
    std::vector<int> scratch_in_use_;
};

Evaluator::Evaluator(const Program& program, const graph::Entry& entry, const KernelTable& table) : list_data_(program.list_data)
{
    Compiler(*this, program, entry, table).compile();
}

Evaluator::Workspace::Workspace(const Evaluator& evaluator)
    : memory_(static_cast<std::size_t>(evaluator.row_count_ + 1) * row_width), evaluator_(&evaluator)
{
    auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    rows_ = memory_.data() + ((64 - address % 64) % 64) / sizeof(float);
}

const float* Evaluator::Workspace::result(int lane) const
{
    const Operand& operand = evaluator_->results_[static_cast<std::size_t>(lane)];
    int row = operand.kind == Operand::Kind::rows ? operand.at : operand.scratch;
    return rows_ + static_cast<std::ptrdiff_t>(row) * row_width;
}

void Evaluator::evaluate(Workspace& workspace, std::span<const float> block, int count) const
{
    std::array<float, 64> counters{};
    auto spread = [&](const float* from, int first_row, int lanes) {
        for (int lane = 0; lane < lanes; ++lane) std::fill_n(workspace.row(first_row + lane), count, from[lane]);
        return workspace.row(first_row);
    };
    auto resolve = [&](const Operand& operand) -> const float* {
        switch (operand.kind) {
            case Operand::Kind::rows: return workspace.row(operand.at);
            case Operand::Kind::block: return block.data() + operand.at;
            case Operand::Kind::block_as_rows: return spread(block.data() + operand.at, operand.scratch, operand.lanes);
            case Operand::Kind::counter: return &counters[static_cast<std::size_t>(operand.at) % counters.size()];
            case Operand::Kind::counter_as_rows: break;
        }
        return spread(&counters[static_cast<std::size_t>(operand.at) % counters.size()], operand.scratch, 1);
    };
    for (std::size_t at = 0; at < operations_.size(); ++at) {
        const Operation& operation = operations_[at];
        switch (operation.kind) {
            case Operation::Kind::call: {
                std::array<const float*, max_arguments> arguments;
                for (int k = 0; k < operation.operand_count; ++k)
                    arguments[static_cast<std::size_t>(k)] = resolve(operands_[static_cast<std::size_t>(operation.first_operand + k)]);
                operation.kernel(workspace.row(operation.result), arguments.data(), list_data_.data(), count);
                break;
            }
            case Operation::Kind::begin_block: counters[static_cast<std::size_t>(operation.counter) % counters.size()] = 0; break;
            case Operation::Kind::end_block: {
                float& counter = counters[static_cast<std::size_t>(operation.counter) % counters.size()];
                counter += 1;
                if (counter < static_cast<float>(operation.copies)) at = static_cast<std::size_t>(operation.jump) - 1;
                break;
            }
            case Operation::Kind::set: {
                const Operand& from = operands_[static_cast<std::size_t>(operation.first_operand)];
                if (from.kind == Operand::Kind::rows)
                    for (int lane = 0; lane < from.lanes; ++lane)
                        std::copy_n(workspace.row(from.at + lane), count, workspace.row(operation.result + lane));
                else
                    spread(resolve(from), operation.result, from.lanes);
                break;
            }
        }
    }
    for (const Operand& result : results_)
        if (result.kind != Operand::Kind::rows) spread(block.data() + result.at, result.scratch, 1);
}

std::vector<float> evaluate_frame(const Program& program, float time)
{
    std::vector<float> block = program.block;
    const KernelTable& table = kernels();
    if (program.time != graph::no_value) block[static_cast<std::size_t>(program.values[static_cast<std::size_t>(program.time)].slot)] = time;
    std::vector<float> rows;
    for (std::int32_t i = program.frame.first; i < program.frame.last; ++i) {
        const Instruction& instruction = program.instructions[static_cast<std::size_t>(i)];
        std::array<const float*, max_arguments> arguments;
        std::array<std::size_t, max_arguments> offsets;
        rows.clear();
        for (std::int32_t k = 0; k < instruction.argument_count; ++k) {
            const auto& value = program.values[static_cast<std::size_t>(program.arguments[static_cast<std::size_t>(instruction.first_argument + k)])];
            offsets[static_cast<std::size_t>(k)] = rows.size();
            // Lists are read in place; everything else as rows of one point.
            std::size_t stride = value.type->base == graph::BaseType::list ? 1 : row_width;
            rows.resize(rows.size() + static_cast<std::size_t>(value.lanes) * stride);
            for (int lane = 0; lane < value.lanes; ++lane)
                rows[offsets[static_cast<std::size_t>(k)] + static_cast<std::size_t>(lane) * stride] = block[static_cast<std::size_t>(value.slot + lane)];
        }
        for (std::int32_t k = 0; k < instruction.argument_count; ++k)
            arguments[static_cast<std::size_t>(k)] = rows.data() + offsets[static_cast<std::size_t>(k)];
        const auto& result = program.values[static_cast<std::size_t>(instruction.result)];
        std::vector<float> out(static_cast<std::size_t>(result.lanes) * row_width);
        kernel_of(table, instruction).varying(out.data(), arguments.data(), program.list_data.data(), 1);
        for (int lane = 0; lane < result.lanes; ++lane)
            block[static_cast<std::size_t>(result.slot + lane)] = out[static_cast<std::size_t>(lane) * row_width];
    }
    return block;
}

std::vector<float> distances(const Program& program, std::span<const float> block, std::span<const glm::vec3> points,
                             const KernelTable& table)
{
    Evaluator evaluator(program, program.distance, table);
    Evaluator::Workspace workspace(evaluator);
    std::vector<float> result(points.size());
    for (std::size_t first = 0; first < points.size(); first += row_width) {
        int count = static_cast<int>(std::min<std::size_t>(row_width, points.size() - first));
        for (int i = 0; i < count; ++i)
            for (int lane = 0; lane < 3; ++lane) workspace.input(lane)[i] = points[first + static_cast<std::size_t>(i)][lane];
        evaluator.evaluate(workspace, block, count);
        std::copy_n(workspace.result(0), count, result.begin() + static_cast<std::ptrdiff_t>(first));
    }
    return result;
}

}  // namespace fieldwright::field
