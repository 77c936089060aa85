// Compiles an entry into operations over rows, and runs them.
#include "field/evaluator.h"

#include "field/single_arguments.h"
#include "field/steps.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>

namespace fieldwright::field {
namespace {

using graph::Instruction;
using graph::Program;
using graph::ValueId;

constexpr std::size_t max_arguments = 32;

std::size_t index(std::int32_t number) { return static_cast<std::size_t>(number); }

const graph::ProgramValue& value_of(const Program& program, ValueId id) { return program.values[index(id)]; }

std::span<const ValueId> arguments_of(const Program& program, const Instruction& instruction)
{
    return std::span(program.arguments).subspan(index(instruction.first_argument), index(instruction.argument_count));
}

std::span<const graph::Carried> carried_of(const Program& program, const Instruction& block)
{
    return std::span(program.carried).subspan(index(block.first_carried), index(block.carried_count));
}

// Kernels are made of the texts built in: a function of the same name in an edited file is another one.
bool is_built_in(const Program& program, const graph::Function& function)
{
    auto built_in = graph::embedded_texts().find(function.file);
    return built_in != graph::embedded_texts().end() && built_in->second == program.library->text(function.file);
}

const KernelEntry& kernel_of(const KernelTable& table, const Program& program, const graph::Function& function,
                             graph::NodeId node)
{
    const KernelEntry* kernel = find_kernel(table, function.name);
    if (!kernel || !is_built_in(program, function))
        throw graph::Failure(1, "node " + std::to_string(node.number) + " (" + function.name +
                                    ") is not compiled into this program; render it with --device gpu or rebuild");
    return *kernel;
}

// Looks each function up once.
class KernelFinder {
public:
    KernelFinder(const KernelTable& table, const Program& program) : table_(table), program_(program) {}

    const KernelEntry& operator()(const graph::Function& function, graph::NodeId node)
    {
        auto [found, added] = found_.try_emplace(&function, nullptr);
        if (added) found->second = &kernel_of(table_, program_, function, node);
        return *found->second;
    }
    const KernelEntry& operator()(const Instruction& call) { return (*this)(*call.function, call.node); }

private:
    const KernelTable& table_;
    const Program& program_;
    std::unordered_map<const graph::Function*, const KernelEntry*> found_;
};

}  // namespace

class Evaluator::Compiler {
public:
    Compiler(Evaluator& evaluator, const Program& program, const graph::Entry& entry, const KernelTable& table)
        : evaluator_(evaluator),
          program_(program),
          entry_(entry),
          kernel_of_(table, program),
          values_(program.values.size()),
          plan_(plan_of(program, entry)),
          steps_(plan_.steps)
    {
    }

    void compile()
    {
        find_last_uses();
        for (ValueId input : entry_.inputs) {
            take_rows(input);
            evaluator_.input_lanes_ += value_of(program_, input).lanes;
        }
        for (std::size_t step = 0; step < steps_.size(); ++step) {
            emit(steps_[step]);
            release_after(static_cast<int>(step));
        }
        emit_results();
    }

private:
    struct Life {
        int row = -1;                           // first row, while the value has rows
        int counter = -1;                       // of a block's copy value
        int born = -1;                          // step
        int last_use = -1;                      // step after which the rows are free
        ValueId next_to_die = graph::no_value;  // others of the same last step
    };

    Life& life(ValueId id) { return values_[index(id)]; }
    int lanes(ValueId id) const { return value_of(program_, id).lanes; }
    bool in_block(ValueId id) const { return value_of(program_, id).rate != graph::Rate::point; }
    bool has_rows(ValueId id) { return !in_block(id) && life(id).counter < 0; }

    // A value from outside a block that is used inside lives to the block's end: the body runs again.
    void find_last_uses()
    {
        std::vector<int> open;  // steps at which the blocks around this one begin
        std::vector<int> ends = block_ends();
        auto use = [&](ValueId id, int step) {
            auto outermost = std::upper_bound(open.begin(), open.end(), life(id).born);
            int until = outermost == open.end() ? step : ends[index(*outermost)];
            life(id).last_use = std::max(life(id).last_use, until);
        };
        for (int step = 0; step < static_cast<int>(steps_.size()); ++step) {
            const Step& now = steps_[index(step)];
            const Instruction& instruction = now.instruction ? *now.instruction : *guard_of(now).call;
            switch (now.kind) {
                case Step::Kind::call:
                    for (ValueId argument : arguments_of(program_, instruction)) use(argument, step);
                    life(instruction.result).born = life(instruction.result).last_use = step;
                    break;
                case Step::Kind::begin_block:
                    for (const graph::Carried& pair : carried_of(program_, instruction)) {
                        use(pair.initial, step);
                        life(pair.accumulator).born = step;
                        life(pair.accumulator).last_use = ends[index(step)];
                    }
                    open.push_back(step);
                    break;
                case Step::Kind::end_block:
                    for (const graph::Carried& pair : carried_of(program_, instruction)) use(pair.next, step);
                    open.pop_back();
                    break;
                case Step::Kind::begin_guard:
                    for (ValueId id : least_arguments(guard_of(now))) use(id, step);
                    for (ValueId id : guard_of(now).rivals) use(id, step);
                    break;
                case Step::Kind::end_guard: break;
            }
        }
        int never = static_cast<int>(steps_.size());
        for (ValueId input : entry_.inputs) life(input).last_use = never;
        for (ValueId result : entry_.results) life(result).last_use = never;
        list_dying();
    }

    // By step at which a block begins: the step of its end.
    std::vector<int> block_ends() const
    {
        std::vector<int> ends(steps_.size()), open;
        for (std::size_t step = 0; step < steps_.size(); ++step) {
            if (steps_[step].kind == Step::Kind::begin_block) open.push_back(static_cast<int>(step));
            if (steps_[step].kind != Step::Kind::end_block) continue;
            ends[index(open.back())] = static_cast<int>(step);
            open.pop_back();
        }
        return ends;
    }

    void list_dying()
    {
        first_to_die_.assign(steps_.size() + 1, graph::no_value);
        for (ValueId id = 0; id < static_cast<ValueId>(values_.size()); ++id) {
            if (life(id).last_use < 0) continue;
            ValueId& first = first_to_die_[index(life(id).last_use)];
            life(id).next_to_die = first;
            first = id;
        }
    }

    void release_after(int step)
    {
        for (ValueId id = first_to_die_[index(step)]; id != graph::no_value; id = life(id).next_to_die) {
            if (life(id).row < 0) continue;
            free_rows(lanes(id)).push_back(life(id).row);
            life(id).row = -1;
        }
    }

    std::vector<int>& free_rows(int count)
    {
        if (free_.size() <= index(count)) free_.resize(index(count) + 1);
        return free_[index(count)];
    }

    int new_rows(int count)
    {
        evaluator_.row_count_ += count;
        return evaluator_.row_count_ - count;
    }

    // The rows freed last are the likeliest to be in the cache.
    int rows(int count)
    {
        std::vector<int>& free = free_rows(count);
        if (free.empty()) return new_rows(count);
        int row = free.back();
        free.pop_back();
        return row;
    }

    void take_rows(ValueId id) { life(id).row = rows(lanes(id)); }

    void emit(const Step& step)
    {
        switch (step.kind) {
            case Step::Kind::call: emit_call(*step.instruction); break;
            case Step::Kind::begin_block: emit_begin(*step.instruction); break;
            case Step::Kind::end_block: emit_end(*step.instruction); break;
            case Step::Kind::begin_guard: emit_begin_guard(guard_of(step)); break;
            case Step::Kind::end_guard: emit_end_guard(guard_of(step)); break;
        }
    }

    void emit_call(const Instruction& instruction)
    {
        life(instruction.result).row = emit_call(*instruction.function, kernel_of_(instruction),
                                                 arguments_of(program_, instruction), lanes(instruction.result));
    }

    // The rows of the result.
    int emit_call(const graph::Function& function, const KernelEntry& kernel, std::span<const ValueId> arguments,
                  int result_lanes)
    {
        bool varying = false;
        for (std::size_t k = 0; k < arguments.size(); ++k)
            varying = varying || (has_rows(arguments[k]) && is_single(function, function.arguments[k]));

        std::vector<std::pair<int, int>> spread;  // rows and how many, of this call only
        assert(arguments.size() <= max_arguments);
        std::array<Operand, max_arguments> operands;
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            const graph::Argument& argument = function.arguments[k];
            bool single = argument.type.base == graph::BaseType::list || (!varying && is_single(function, argument));
            operands[k] =
                single || has_rows(arguments[k]) ? place(arguments[k]) : spread_over_rows(arguments[k], spread);
        }
        int result = rows(result_lanes);
        Operation call{Operation::Kind::call, varying ? kernel.varying : kernel.uniform, result};
        call.first_operand = static_cast<int>(evaluator_.operands_.size());
        for (std::size_t k = 0; k < arguments.size(); ++k) add_operand(operands[k]);
        evaluator_.operations_.push_back(call);
        for (auto [row, count] : spread) free_rows(count).push_back(row);
        return result;
    }

    Operand place(ValueId id)
    {
        if (in_block(id)) return {Operand::Kind::block, value_of(program_, id).slot};
        if (life(id).counter >= 0) return {Operand::Kind::counter, life(id).counter};
        return {Operand::Kind::rows, life(id).row};
    }

    void add_operand(Operand operand)
    {
        if (operand.kind == Operand::Kind::block)
            evaluator_.block_operands_.push_back(static_cast<int>(evaluator_.operands_.size()));
        evaluator_.operands_.push_back(operand);
    }

    // Spreads a single value for one call; inside blocks values of the block are spread once, before the outermost one.
    Operand spread_over_rows(ValueId id, std::vector<std::pair<int, int>>& spread)
    {
        if (open_.empty() || !in_block(id)) {
            spread.emplace_back(rows(lanes(id)), lanes(id));
            add_move(Operation::Kind::spread, place(id), spread.back().first, lanes(id), evaluator_.operations_.size());
            return {Operand::Kind::rows, spread.back().first};
        }
        auto [known, added] = hoisted_.try_emplace(id, 0);
        if (added) {
            known->second = new_rows(lanes(id));  // rows in use earlier in the body would be overwritten there
            add_move(Operation::Kind::spread, place(id), known->second, lanes(id), open_.front() + hoisted_.size() - 1);
        }
        return {Operand::Kind::rows, known->second};
    }

    void add_move(Operation::Kind kind, Operand from, int to, int count, std::size_t at)
    {
        Operation move{kind, nullptr, to, static_cast<int>(evaluator_.operands_.size()), count};
        add_operand(from);
        evaluator_.operations_.insert(evaluator_.operations_.begin() + static_cast<std::ptrdiff_t>(at), move);
    }

    // Rows of a value become those of another: a copy, or a single value spread.
    void set_rows(int to, ValueId from)
    {
        add_move(has_rows(from) ? Operation::Kind::copy : Operation::Kind::spread, place(from), to, lanes(from),
                 evaluator_.operations_.size());
    }

    void emit_begin(const Instruction& block)
    {
        for (const graph::Carried& pair : carried_of(program_, block)) {
            take_rows(pair.accumulator);
            set_rows(life(pair.accumulator).row, pair.initial);
        }
        life(block.copy).counter = evaluator_.counter_count_++;
        if (open_.empty()) hoisted_.clear();
        open_.push_back(evaluator_.operations_.size());
        Operation begin{Operation::Kind::begin_block};
        begin.counter = life(block.copy).counter;
        evaluator_.operations_.push_back(begin);
        bodies_.push_back(evaluator_.operations_.size() - hoisted_.size());
    }

    void emit_end(const Instruction& block)
    {
        fold(carried_of(program_, block));
        Operation end{Operation::Kind::end_block};
        end.counter = life(block.copy).counter;
        end.copies = block.copies;
        if (block.needed != graph::no_value) end.needed = value_of(program_, block.needed).slot;
        end.body = static_cast<int>(evaluator_.operations_.size() - hoisted_.size() - bodies_.back());
        evaluator_.operations_.push_back(end);
        open_.pop_back();
        bodies_.pop_back();
        if (!open_.empty()) return;
        for (auto [id, row] : hoisted_) free_rows(lanes(id)).push_back(row);
        hoisted_.clear();
    }

    const Guard& guard_of(const Step& step) const { return plan_.guards[index(step.guard)]; }

    std::vector<ValueId> least_arguments(const Guard& guard) const
    {
        std::vector<ValueId> arguments;
        for (const graph::Argument& argument : guard.least->arguments)
            arguments.push_back(argument_named(program_, *guard.call, argument.name));
        return arguments;
    }

    void emit_begin_guard(const Guard& guard)
    {
        int least = emit_call(*guard.least, kernel_of_(*guard.least, guard.call->node), least_arguments(guard), 1);
        Operation begin{Operation::Kind::guard};
        begin.first_operand = static_cast<int>(evaluator_.operands_.size());
        begin.lanes = static_cast<int>(guard.rivals.size());
        add_operand({Operand::Kind::rows, least});
        for (ValueId rival : guard.rivals) add_operand(place(rival));
        guarded_.push_back(evaluator_.operations_.size() - hoisted_.size());
        evaluator_.operations_.push_back(begin);
        free_rows(1).push_back(least);
    }

    void emit_end_guard(const Guard& guard)
    {
        std::size_t at = guarded_.back() + hoisted_.size();
        guarded_.pop_back();
        evaluator_.operations_[at].result = life(guard.guarded).row;
        evaluator_.operations_[at].body = static_cast<int>(evaluator_.operations_.size() - at) - 1;
    }

    // All pairs at once: a `next` that is another pair's accumulator is read before it changes.
    void fold(std::span<const graph::Carried> pairs)
    {
        auto is_accumulator = [&](ValueId id) {
            return std::any_of(pairs.begin(), pairs.end(),
                               [&](const graph::Carried& pair) { return pair.accumulator == id; });
        };
        std::vector<std::pair<int, const graph::Carried*>> kept;
        for (const graph::Carried& pair : pairs)
            if (is_accumulator(pair.next)) {
                kept.emplace_back(rows(lanes(pair.next)), &pair);
                set_rows(kept.back().first, pair.next);
            }
        for (const graph::Carried& pair : pairs)
            if (!is_accumulator(pair.next)) set_rows(life(pair.accumulator).row, pair.next);
        for (auto [row, pair] : kept) {
            add_move(Operation::Kind::copy, {Operand::Kind::rows, row}, life(pair->accumulator).row, lanes(pair->next),
                     evaluator_.operations_.size());
            free_rows(lanes(pair->next)).push_back(row);
        }
    }

    void emit_results()
    {
        for (ValueId result : entry_.results) {
            if (!has_rows(result)) {
                int row = rows(lanes(result));
                set_rows(row, result);
                life(result).row = row;
            }
            for (int lane = 0; lane < lanes(result); ++lane) evaluator_.result_rows_.push_back(life(result).row + lane);
        }
    }

    Evaluator& evaluator_;
    const Program& program_;
    const graph::Entry& entry_;
    KernelFinder kernel_of_;
    std::vector<Life> values_;
    Plan plan_;
    const std::vector<Step>& steps_;
    std::vector<ValueId> first_to_die_;         // by step
    std::vector<std::vector<int>> free_;        // first rows, by number of lanes
    std::vector<std::size_t> open_;             // operations at which the blocks being emitted begin
    std::vector<std::size_t> bodies_;           // their first operations, less those hoisted
    std::vector<std::size_t> guarded_;          // operations of the guards being emitted, less those hoisted
    std::unordered_map<ValueId, int> hoisted_;  // values spread before the outermost block being emitted: first rows
};

Evaluator::Evaluator(const Program& program, const graph::Entry& entry, const KernelTable& table)
    : list_data_(program.list_data)
{
    Compiler(*this, program, entry, table).compile();
}

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

namespace {

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

std::vector<float> distances(const Program& program, std::span<const float> block, std::span<const glm::vec3> points,
                             const KernelTable& table)
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
