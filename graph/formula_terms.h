// The terms of a formula under construction. Equal operations on equal arguments are one term; literals are not
// compared, so that what is a term does not depend on numbers.
#pragma once

#include "graph/formula.h"

#include <map>
#include <tuple>

namespace fieldwright::graph {

class FormulaTerms {
public:
    int literal(double number);
    int variable(int index) { return shared({.operation = FormulaOperation::variable, .variable = index}); }
    int apply(FormulaOperation operation, int a, int b = 0, int c = 0)
    {
        return shared({.operation = operation, .arguments = {a, b, c}});
    }

    int negate(int a) { return apply(FormulaOperation::negate, a); }
    int add(int a, int b) { return apply(FormulaOperation::add, a, b); }
    int subtract(int a, int b) { return apply(FormulaOperation::subtract, a, b); }
    int multiply(int a, int b) { return apply(FormulaOperation::multiply, a, b); }
    int divide(int a, int b) { return apply(FormulaOperation::divide, a, b); }
    int smaller(int a, int b) { return apply(FormulaOperation::min, a, b); }
    int larger(int a, int b) { return apply(FormulaOperation::max, a, b); }
    int clamp(int x, int low, int high) { return smaller(larger(x, low), high); }

    // A small whole exponent that is written out is a product: exact, fast, and of negative numbers too.
    int power(int base, int exponent);
    // The square root of a sum of squares is a length, whose slope is bounded where that of a root is not.
    int root(int a);
    int inverse_sine(int a);
    int fraction(int a);
    int remainder(int a, int b);
    int smooth_step(int low, int high, int x);

    Formula finish(int result) const;  // what the result needs, in order

private:
    const FormulaTerm& at(int index) const { return terms_[static_cast<std::size_t>(index)]; }
    std::size_t argument(std::size_t term, int k) const
    {
        return static_cast<std::size_t>(terms_[term].arguments[static_cast<std::size_t>(k)]);
    }
    int shared(FormulaTerm term);
    int repeated(int base, int times);
    std::vector<int> squares_of(int sum) const;

    std::vector<FormulaTerm> terms_;
    std::map<std::tuple<FormulaOperation, int, std::array<int, 3>>, int> known_;
};

}  // namespace fieldwright::graph
