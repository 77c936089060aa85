// What is typed as one thing and computed as several.
#include "graph/formula_terms.h"

#include <cmath>

namespace fieldwright::graph {

using Operation = FormulaOperation;

int FormulaTerms::literal(double number)
{
    terms_.push_back({.operation = Operation::literal, .number = static_cast<float>(number)});
    return static_cast<int>(terms_.size()) - 1;
}

int FormulaTerms::shared(FormulaTerm term)
{
    auto [known, added] =
        known_.try_emplace({term.operation, term.variable, term.arguments}, static_cast<int>(terms_.size()));
    if (added) terms_.push_back(term);
    return known->second;
}

int FormulaTerms::power(int base, int exponent)
{
    float number = at(exponent).number;
    bool product =
        at(exponent).operation == Operation::literal && number >= 2 && number <= 8 && number == std::floor(number);
    return product ? repeated(base, static_cast<int>(number)) : apply(Operation::power, base, exponent);
}

int FormulaTerms::repeated(int base, int times)
{
    if (times == 1) return base;
    int half = repeated(base, times / 2), whole = multiply(half, half);
    return times % 2 ? multiply(whole, base) : whole;
}

int FormulaTerms::root(int a)
{
    std::vector<int> squared = squares_of(a);
    if (squared.empty()) return apply(Operation::sqrt, a);
    if (squared.size() == 1) return apply(Operation::abs, squared[0]);
    int length = squared[0];
    for (std::size_t i = 1; i < squared.size(); ++i) length = apply(Operation::length, length, squared[i]);
    return length;
}

// What is squared in a sum of nothing but squares; else empty.
std::vector<int> FormulaTerms::squares_of(int sum) const
{
    std::vector<int> squared, open = {sum};
    while (!open.empty()) {
        const FormulaTerm& term = at(open.back());
        open.pop_back();
        auto [a, b, c] = term.arguments;
        if (term.operation == Operation::add) open.insert(open.end(), {b, a});
        else if (term.operation == Operation::multiply && a == b) squared.push_back(a);
        else return {};
    }
    return squared;
}

int FormulaTerms::inverse_sine(int a)
{
    int sine = clamp(a, literal(-1), literal(1));
    int square = multiply(subtract(literal(1), sine), add(literal(1), sine));  // of the cosine, exact near 1
    return apply(Operation::atan2, sine, apply(Operation::sqrt, square));
}

int FormulaTerms::fraction(int a) { return subtract(a, apply(Operation::floor, a)); }

int FormulaTerms::remainder(int a, int b) { return subtract(a, multiply(b, apply(Operation::floor, divide(a, b)))); }

int FormulaTerms::smooth_step(int low, int high, int x)
{
    int t = clamp(divide(subtract(x, low), subtract(high, low)), literal(0), literal(1));
    return multiply(multiply(t, t), subtract(literal(3), multiply(literal(2), t)));
}

Formula FormulaTerms::finish(int result) const
{
    std::vector<bool> needed(terms_.size(), false);
    needed[static_cast<std::size_t>(result)] = true;
    for (std::size_t i = terms_.size(); i-- > 0;)
        for (int k = 0; needed[i] && k < argument_count(terms_[i].operation); ++k) needed[argument(i, k)] = true;
    Formula formula;
    std::vector<int> place(terms_.size(), 0);
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        if (!needed[i]) continue;
        place[i] = static_cast<int>(formula.terms.size());
        FormulaTerm term = terms_[i];
        for (int k = 0; k < argument_count(term.operation); ++k)
            term.arguments[static_cast<std::size_t>(k)] = place[argument(i, k)];
        formula.terms.push_back(term);
    }
    return formula;
}

}  // namespace fieldwright::graph
