// One walk over the steps, blocks kept on a stack.
#include "field/value_lives.h"

#include "field/program_values.h"

#include <algorithm>

namespace fieldwright::field {
namespace {

using graph::Carried;
using graph::ValueId;

// By step at which a block begins: the step of its end.
std::vector<int> block_ends(const std::vector<Step>& steps)
{
    std::vector<int> ends(steps.size()), open;
    for (std::size_t step = 0; step < steps.size(); ++step) {
        if (steps[step].kind == Step::Kind::begin_block) open.push_back(static_cast<int>(step));
        if (steps[step].kind != Step::Kind::end_block) continue;
        ends[index(open.back())] = static_cast<int>(step);
        open.pop_back();
    }
    return ends;
}

}  // namespace

ValueLives::ValueLives(const graph::Program& program, const graph::Entry& entry, const Plan& plan)
    : program_(program), plan_(plan), lives_(program.values.size()), block_ends_(block_ends(plan.steps))
{
    for (int step = 0; step < static_cast<int>(plan.steps.size()); ++step) follow(plan.steps[index(step)], step);
    int never = static_cast<int>(plan.steps.size());
    for (ValueId input : entry.inputs) lives_[index(input)].last_use = never;
    for (ValueId result : entry.results) lives_[index(result)].last_use = never;
    list_endings();
}

std::span<const ValueId> ValueLives::ending_after(std::size_t step) const
{
    return std::span(ending_).subspan(first_[step], first_[step + 1] - first_[step]);
}

void ValueLives::begin(ValueId id, int step, int last_use) { lives_[index(id)] = {step, last_use}; }

void ValueLives::use(ValueId id, int step)
{
    Life& life = lives_[index(id)];
    auto outermost = std::upper_bound(open_.begin(), open_.end(), life.born);
    int until = outermost == open_.end() ? step : block_ends_[index(*outermost)];
    life.last_use = std::max(life.last_use, until);
}

void ValueLives::use_inputs(const Step& now, int step)
{
    switch (now.kind) {
        case Step::Kind::call:
            for (ValueId argument : arguments_of(program_, *now.instruction)) use(argument, step);
            break;
        case Step::Kind::begin_block:
            for (const Carried& pair : carried_of(program_, *now.instruction)) use(pair.initial, step);
            break;
        case Step::Kind::end_block:
            for (const Carried& pair : carried_of(program_, *now.instruction)) use(pair.next, step);
            break;
        case Step::Kind::begin_guard: {
            const Guard& guard = plan_.guards[index(now.guard)];
            for (ValueId id : least_arguments(program_, guard)) use(id, step);
            for (ValueId id : guard.rivals) use(id, step);
            break;
        }
        case Step::Kind::end_guard: break;
    }
}

void ValueLives::follow(const Step& now, int step)
{
    use_inputs(now, step);
    if (now.kind == Step::Kind::call) begin(now.instruction->result, step, step);
    if (now.kind == Step::Kind::begin_block) {
        for (const Carried& pair : carried_of(program_, *now.instruction))
            begin(pair.accumulator, step, block_ends_[index(step)]);
        open_.push_back(step);
    }
    if (now.kind == Step::Kind::end_block) open_.pop_back();
}

void ValueLives::list_endings()
{
    first_.assign(plan_.steps.size() + 2, 0);
    for (const Life& life : lives_)
        if (life.last_use >= 0) ++first_[index(life.last_use) + 1];
    for (std::size_t step = 1; step < first_.size(); ++step) first_[step] += first_[step - 1];
    ending_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    for (std::size_t id = 0; id < lives_.size(); ++id)
        if (lives_[id].last_use >= 0) ending_[next[index(lives_[id].last_use)]++] = static_cast<ValueId>(id);
}

std::vector<ValueId> least_arguments(const graph::Program& program, const Guard& guard)
{
    std::vector<ValueId> arguments;
    for (const graph::Argument& argument : guard.least->arguments)
        arguments.push_back(argument_named(program, *guard.call, argument.name));
    return arguments;
}

}  // namespace fieldwright::field
