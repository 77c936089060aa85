// Compiles an entry into operations over rows.
#include "field/evaluator.h"
#include "field/kernel_finder.h"
#include "field/program_values.h"
#include "field/single_arguments.h"
#include "field/value_lives.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <unordered_map>

namespace fieldwright::field {
namespace {

using graph::Instruction;
using graph::Program;
using graph::ValueId;

// Rows of a workspace, handed out in runs.
class RowPool {
public:
    int row_count() const { return row_count_; }

    // The first of so many rows. Those given back last are the likeliest to be in the cache.
    int take(int count)
    {
        std::vector<int>& free = free_runs(count);
        if (free.empty()) return take_new(count);
        int row = free.back();
        free.pop_back();
        return row;
    }

    // Rows that nothing had before.
    int take_new(int count)
    {
        row_count_ += count;
        return row_count_ - count;
    }

    void give_back(int row, int count) { free_runs(count).push_back(row); }

private:
    std::vector<int>& free_runs(int count)
    {
        if (free_.size() <= index(count)) free_.resize(index(count) + 1);
        return free_[index(count)];
    }

    std::vector<std::vector<int>> free_;  // first rows, by number of rows
    int row_count_ = 0;
};

}  // namespace

class Evaluator::Compiler {
public:
    Compiler(Evaluator& evaluator, const Program& program, const graph::Entry& entry, const KernelTable& table)
        : evaluator_(evaluator),
          program_(program),
          entry_(entry),
          kernel_of_(table, program),
          places_(program.values.size()),
          plan_(plan_of(program, entry)),
          lives_(program, entry, plan_)
    {
    }

    void compile()
    {
        for (ValueId input : entry_.inputs) {
            take_rows(input);
            evaluator_.input_lanes_ += value_of(program_, input).lanes;
        }
        for (std::size_t step = 0; step < plan_.steps.size(); ++step) {
            emit(plan_.steps[step]);
            release_after(step);
        }
        emit_results();
        evaluator_.row_count_ = pool_.row_count();
    }

private:
    struct Place {
        int row = -1;      // first row, while the value has rows
        int counter = -1;  // of a block's copy value
    };

    Place& place_of(ValueId id) { return places_[index(id)]; }
    int lanes(ValueId id) const { return value_of(program_, id).lanes; }
    bool in_block(ValueId id) const { return value_of(program_, id).rate != graph::Rate::point; }
    bool has_rows(ValueId id) { return !in_block(id) && place_of(id).counter < 0; }

    void release_after(std::size_t step)
    {
        for (ValueId id : lives_.ending_after(step)) {
            if (place_of(id).row < 0) continue;
            pool_.give_back(place_of(id).row, lanes(id));
            place_of(id).row = -1;
        }
    }

    void take_rows(ValueId id) { place_of(id).row = pool_.take(lanes(id)); }

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
        place_of(instruction.result).row = emit_call(*instruction.function, kernel_of_(instruction),
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
        int result = pool_.take(result_lanes);
        Operation call{Operation::Kind::call, varying ? kernel.varying : kernel.uniform, result};
        call.first_operand = static_cast<int>(evaluator_.operands_.size());
        for (std::size_t k = 0; k < arguments.size(); ++k) add_operand(operands[k]);
        evaluator_.operations_.push_back(call);
        for (auto [row, count] : spread) pool_.give_back(row, count);
        return result;
    }

    Operand place(ValueId id)
    {
        if (in_block(id)) return {Operand::Kind::block, value_of(program_, id).slot};
        if (place_of(id).counter >= 0) return {Operand::Kind::counter, place_of(id).counter};
        return {Operand::Kind::rows, place_of(id).row};
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
            spread.emplace_back(pool_.take(lanes(id)), lanes(id));
            add_move(Operation::Kind::spread, place(id), spread.back().first, lanes(id), evaluator_.operations_.size());
            return {Operand::Kind::rows, spread.back().first};
        }
        auto [known, added] = hoisted_.try_emplace(id, 0);
        if (added) {
            known->second = pool_.take_new(lanes(id));  // rows in use earlier in the body would be overwritten there
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
            set_rows(place_of(pair.accumulator).row, pair.initial);
        }
        place_of(block.copy).counter = evaluator_.counter_count_++;
        if (open_.empty()) hoisted_.clear();
        open_.push_back(evaluator_.operations_.size());
        Operation begin{Operation::Kind::begin_block};
        begin.counter = place_of(block.copy).counter;
        evaluator_.operations_.push_back(begin);
        bodies_.push_back(evaluator_.operations_.size() - hoisted_.size());
    }

    void emit_end(const Instruction& block)
    {
        fold(carried_of(program_, block));
        Operation end{Operation::Kind::end_block};
        end.counter = place_of(block.copy).counter;
        end.copies = block.copies;
        if (block.needed != graph::no_value) end.needed = value_of(program_, block.needed).slot;
        end.body = static_cast<int>(evaluator_.operations_.size() - hoisted_.size() - bodies_.back());
        evaluator_.operations_.push_back(end);
        open_.pop_back();
        bodies_.pop_back();
        if (!open_.empty()) return;
        for (auto [id, row] : hoisted_) pool_.give_back(row, lanes(id));
        hoisted_.clear();
    }

    const Guard& guard_of(const Step& step) const { return plan_.guards[index(step.guard)]; }

    void emit_begin_guard(const Guard& guard)
    {
        int least =
            emit_call(*guard.least, kernel_of_(*guard.least, guard.call->node), least_arguments(program_, guard), 1);
        Operation begin{Operation::Kind::guard};
        begin.first_operand = static_cast<int>(evaluator_.operands_.size());
        begin.lanes = static_cast<int>(guard.rivals.size());
        add_operand({Operand::Kind::rows, least});
        for (ValueId rival : guard.rivals) add_operand(place(rival));
        guarded_.push_back(evaluator_.operations_.size() - hoisted_.size());
        evaluator_.operations_.push_back(begin);
        pool_.give_back(least, 1);
    }

    void emit_end_guard(const Guard& guard)
    {
        std::size_t at = guarded_.back() + hoisted_.size();
        guarded_.pop_back();
        evaluator_.operations_[at].result = place_of(guard.guarded).row;
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
                kept.emplace_back(pool_.take(lanes(pair.next)), &pair);
                set_rows(kept.back().first, pair.next);
            }
        for (const graph::Carried& pair : pairs)
            if (!is_accumulator(pair.next)) set_rows(place_of(pair.accumulator).row, pair.next);
        for (auto [row, pair] : kept) {
            add_move(Operation::Kind::copy, {Operand::Kind::rows, row}, place_of(pair->accumulator).row,
                     lanes(pair->next), evaluator_.operations_.size());
            pool_.give_back(row, lanes(pair->next));
        }
    }

    void emit_results()
    {
        for (ValueId result : entry_.results) {
            if (!has_rows(result)) {
                int row = pool_.take(lanes(result));
                set_rows(row, result);
                place_of(result).row = row;
            }
            for (int lane = 0; lane < lanes(result); ++lane)
                evaluator_.result_rows_.push_back(place_of(result).row + lane);
        }
    }

    Evaluator& evaluator_;
    const Program& program_;
    const graph::Entry& entry_;
    KernelFinder kernel_of_;
    std::vector<Place> places_;  // by value
    Plan plan_;
    ValueLives lives_;
    RowPool pool_;
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

}  // namespace fieldwright::field
