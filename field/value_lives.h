// How long an entry's values are wanted while the CPU runs it step by step.
#pragma once

#include "field/steps.h"
#include "graph/program.h"

#include <span>
#include <vector>

namespace fieldwright::field {

// Inputs and results are wanted for ever, everything else up to the step that uses it last. What a block needs from
// outside lives to the block's end: the body runs again.
class ValueLives {
public:
    ValueLives(const graph::Program& program, const graph::Entry& entry, const Plan& plan);

    std::span<const graph::ValueId> ending_after(std::size_t step) const;

private:
    struct Life {
        int born = -1;      // step
        int last_use = -1;  // step; -1: no value of this entry
    };

    void begin(graph::ValueId id, int step, int last_use);
    void use(graph::ValueId id, int step);
    void use_inputs(const Step& now, int step);
    void follow(const Step& now, int step);
    void list_endings();

    const graph::Program& program_;
    const Plan& plan_;
    std::vector<Life> lives_;             // by value
    std::vector<int> block_ends_;         // by step at which a block begins
    std::vector<int> open_;               // steps at which the blocks around the present one begin
    std::vector<graph::ValueId> ending_;  // by step of the last use
    std::vector<std::size_t> first_;      // of a step in ending_
};

// What the guard's `_least` receives.
std::vector<graph::ValueId> least_arguments(const graph::Program& program, const Guard& guard);

}  // namespace fieldwright::field
