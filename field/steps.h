// The order in which the CPU runs an entry: calls, blocks with their ends, and parts that may be left out.
//
// A guard says by one of its inputs alone how far the other is at least: `X_least` of a node file. Where rivals in the
// same union are nearer than that at every point of a row, the guarded part is not evaluated, and the union is the same
// to the last bit.
#pragma once

#include "graph/program.h"

#include <vector>

namespace fieldwright::field {

struct Guard {
    const graph::Instruction* call;      // of the guard's `_distance`
    const graph::Function* least;        // its arguments are among those of the call, by name
    graph::ValueId guarded;              // what the part computes
    std::vector<graph::ValueId> rivals;  // distances in the same union that are known before, at point rate
};

struct Step {
    enum class Kind { call, begin_block, end_block, begin_guard, end_guard } kind;
    const graph::Instruction* instruction = nullptr;  // of calls and blocks
    int guard = -1;                                   // index into Plan::guards
};

struct Plan {
    std::vector<Step> steps;
    std::vector<Guard> guards;
};

Plan plan_of(const graph::Program& program, const graph::Entry& entry);

// The argument of a call that a function names so; no_value when there is none.
graph::ValueId argument_named(const graph::Program& program, const graph::Instruction& call, std::string_view name);

}  // namespace fieldwright::field
