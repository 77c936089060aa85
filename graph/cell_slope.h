// How steep a formula can be in one cell of space: its operations on intervals, each with its gradient.
#pragma once

#include "graph/slope.h"

namespace fieldwright::graph {

// A value in a cell, its gradient by component, and a bound on the gradient's length that may be tighter.
struct ValueInCell {
    Interval value;
    std::array<Interval, 3> gradient = {};
    double length = 0;

    bool still() const { return length == 0; }
};

// Computes one cell after the other; keeps its memory between them.
class CellSlope {
public:
    explicit CellSlope(const Formula& formula) : formula_(formula), known_(formula.terms.size()) {}

    bool chose() const { return chose_; }  // in some cell, a `? :` did not know its side
    double steepest(std::span<const Interval> variables);

private:
    const ValueInCell& argument(const FormulaTerm& term, std::size_t k) const
    {
        return known_[static_cast<std::size_t>(term.arguments[k])];
    }
    ValueInCell choice(const FormulaTerm& term);
    ValueInCell term(const FormulaTerm& term, std::span<const Interval> variables);

    const Formula& formula_;
    std::vector<ValueInCell> known_;  // by term
    bool chose_ = false;
};

}  // namespace fieldwright::graph
