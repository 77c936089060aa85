// The rules of differentiation, on intervals (Moore, Kearfott and Cloud, "Introduction to Interval Analysis", 2009).
#include "graph/cell_slope.h"

#include "graph/interval.h"

#include <limits>

namespace fieldwright::graph {
namespace {

using Operation = FormulaOperation;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tiny = 1e-20, limit = 1e12;  // as in shaders/render/formula.glsl

double box_length(const std::array<Interval, 3>& gradient)
{
    return std::hypot(size(gradient[0]), size(gradient[1]), size(gradient[2]));
}

ValueInCell tightened(ValueInCell known, double length)
{
    known.length = std::min(box_length(known.gradient), length);
    return known;
}

// f(a) with the slope f' of f in the cell.
ValueInCell chained(const ValueInCell& a, Interval value, Interval slope)
{
    ValueInCell result{.value = value};
    for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = slope * a.gradient[i];
    return tightened(result, times(size(slope), a.length));
}

// Without a bound where an argument moves.
ValueInCell endless(Interval value, const ValueInCell& a, const ValueInCell& b = {})
{
    ValueInCell result{.value = value};
    auto moves = [](Interval component) { return component != Interval{}; };
    for (std::size_t i = 0; i < 3; ++i)
        if (moves(a.gradient[i]) || moves(b.gradient[i])) result.gradient[i] = {-infinite, infinite};
    return tightened(result, infinite);
}

// Either of two.
ValueInCell either(const ValueInCell& a, const ValueInCell& b, Interval value)
{
    ValueInCell result{.value = value};
    for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = hull(a.gradient[i], b.gradient[i]);
    return tightened(result, std::max(a.length, b.length));
}

// At most, of one multiple of a gradient with another.
double together(const ValueInCell& a, const ValueInCell& b)
{
    double product = 0;
    for (std::size_t i = 0; i < 3; ++i) product += times(size(a.gradient[i]), size(b.gradient[i]));
    return product;
}

// The length of the sum of two multiples of gradients that may stand upright on each other.
double summed_length(const ValueInCell& a, double times_a, const ValueInCell& b, double times_b)
{
    double one = times(a.length, times_a), other = times(b.length, times_b);
    double square = one * one + other * other + 2 * times(times_a * times_b, together(a, b));
    return std::min(one + other, std::sqrt(square));
}

ValueInCell sum(const ValueInCell& a, const ValueInCell& b)
{
    ValueInCell result{.value = a.value + b.value};
    for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = a.gradient[i] + b.gradient[i];
    return tightened(result, summed_length(a, 1, b, 1));
}

Interval limited(Interval a) { return {std::clamp(a.low, -limit, limit), std::clamp(a.high, -limit, limit)}; }

ValueInCell negated(const ValueInCell& a) { return chained(a, -a.value, {-1, -1}); }

ValueInCell product(const ValueInCell& a, const ValueInCell& b)
{
    ValueInCell result{.value = limited(a.value * b.value)};
    for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = a.value * b.gradient[i] + b.value * a.gradient[i];
    return tightened(result, summed_length(a, size(b.value), b, size(a.value)));
}

ValueInCell quotient(const ValueInCell& a, const ValueInCell& b)
{
    if (b.value.low > -tiny && b.value.high < tiny) return {};
    if (holds(b.value, 0)) return endless({-limit, limit}, a, b);
    Interval inverted = inverse(b.value);
    return product(a, chained(b, inverted, -square(inverted)));
}

ValueInCell root(const ValueInCell& a)
{
    Interval inside = {std::max(a.value.low, 0.0), std::max(a.value.high, 0.0)};
    Interval value = rising(inside, [](double x) { return std::sqrt(x); });
    if (value.high == 0) return {};
    if (value.low == 0) return endless(value, a);
    return chained(a, value, inverse({2 * value.low, 2 * value.high}));
}

// A power of what is positive, with a fixed exponent.
ValueInCell positive_power(const ValueInCell& a, double exponent)
{
    auto raised = [](Interval base, double to) {
        Interval ends = rising(base, [&](double x) { return std::pow(x, to); });
        return hull({ends.low, ends.low}, {ends.high, ends.high});
    };
    Interval slope = raised(a.value, exponent - 1);
    return chained(a, limited(raised(a.value, exponent)), Interval{exponent, exponent} * slope);
}

ValueInCell power(const ValueInCell& a, const ValueInCell& b)
{
    Interval anything = {-limit, limit};
    if (b.still() && b.value.low == b.value.high) {
        double exponent = b.value.low;
        bool whole = std::floor(exponent) == exponent, odd = std::fmod(exponent, 2) != 0;
        if (exponent == 0) return {.value = {1, 1}};
        if (a.value.low > 0) return positive_power(a, exponent);
        if (a.value.high < 0 && !whole) return {};
        if (a.value.high < 0)
            return odd ? negated(positive_power(negated(a), exponent)) : positive_power(negated(a), exponent);
        if (exponent < 1) return endless(anything, a);
        double reach = std::pow(size(a.value), exponent), slope = exponent * std::pow(size(a.value), exponent - 1);
        return chained(a, limited({-reach, reach}), {-slope, slope});
    }
    if (a.value.low <= tiny) return endless(anything, a, b);
    Interval logarithm = rising(a.value, [](double x) { return std::log(x); });
    ValueInCell exponent = product(b, chained(a, logarithm, inverse(a.value)));
    Interval value = limited(rising(exponent.value, [](double x) { return std::exp(x); }));
    return chained(exponent, value, value);
}

// sqrt(a^2 + b^2) turns with the vector (a, b) of length one, so it is no steeper than the largest singular value of
// the two gradients.
ValueInCell length(const ValueInCell& a, const ValueInCell& b)
{
    Interval squares = square(a.value) + square(b.value);
    ValueInCell result{.value = rising(squares, [](double x) { return std::sqrt(x); })};
    for (std::size_t i = 0; i < 3; ++i) {
        double most = std::hypot(size(a.gradient[i]), size(b.gradient[i]));
        result.gradient[i] = {-most, most};
        if (result.value.low <= 0) continue;
        Interval exact = (a.value * a.gradient[i] + b.value * b.gradient[i]) * inverse(result.value);
        result.gradient[i] = {std::max(exact.low, -most), std::min(exact.high, most)};
    }
    double one = a.length * a.length, other = b.length * b.length;
    double apart = std::isfinite(one) && std::isfinite(other) ? one - other : infinite;
    return tightened(result, std::sqrt(0.5 * (one + other + std::hypot(apart, 2 * together(a, b)))));
}

ValueInCell angle(const ValueInCell& y, const ValueInCell& x)
{
    constexpr double half_turn = std::numbers::pi;
    if (x.value.low <= 0 && holds(y.value, 0)) return endless({-half_turn, half_turn}, y, x);
    Interval value = {infinite, -infinite};
    for (double high : {y.value.low, y.value.high})
        for (double wide : {x.value.low, x.value.high}) {
            double corner = std::atan2(high, wide);
            value = hull(value, {corner, corner});
        }
    Interval inverted = inverse(square(x.value) + square(y.value));
    ValueInCell result{.value = value};
    for (std::size_t i = 0; i < 3; ++i)
        result.gradient[i] = (x.value * y.gradient[i] + -(y.value * x.gradient[i])) * inverted;
    return tightened(result, times(std::sqrt(inverted.high), std::hypot(x.length, y.length)));
}

ValueInCell smaller(const ValueInCell& a, const ValueInCell& b)
{
    if (a.value.high <= b.value.low) return a;
    if (b.value.high <= a.value.low) return b;
    return either(a, b, {std::min(a.value.low, b.value.low), std::min(a.value.high, b.value.high)});
}

ValueInCell absolute(const ValueInCell& a)
{
    if (a.value.low >= 0) return a;
    if (a.value.high <= 0) return negated(a);
    return chained(a, {0, size(a.value)}, {-1, 1});
}

// What jumps where `changes` is not the same in the whole cell.
ValueInCell stepped(const ValueInCell& a, Interval value)
{
    return value.low == value.high ? ValueInCell{.value = value} : endless(value, a);
}

ValueInCell compared(Operation operation, const ValueInCell& a, const ValueInCell& b)
{
    ValueInCell apart = sum(a, negated(b));
    const Interval& d = apart.value;
    bool surely = operation == Operation::less         ? d.high < 0
                  : operation == Operation::less_equal ? d.high <= 0
                                                       : d.low == 0 && d.high == 0;
    bool never = operation == Operation::less         ? d.low >= 0
                 : operation == Operation::less_equal ? d.low > 0
                                                      : d.low > 0 || d.high < 0;
    return stepped(apart, {surely ? 1.0 : 0.0, never ? 0.0 : 1.0});
}

ValueInCell variable(int index, Interval value)
{
    ValueInCell known{.value = value};
    if (index > formula_z) return known;
    known.gradient[static_cast<std::size_t>(index)] = {1, 1};
    known.length = 1;
    return known;
}

Interval cosine(Interval a)
{
    constexpr double quarter = 0.5 * std::numbers::pi;
    return sine(a + Interval{quarter, quarter});
}

}  // namespace

double CellSlope::steepest(std::span<const Interval> variables)
{
    for (std::size_t i = 0; i < known_.size(); ++i) known_[i] = term(formula_.terms[i], variables);
    return known_.back().length;
}

ValueInCell CellSlope::choice(const FormulaTerm& term)
{
    const ValueInCell &condition = argument(term, 0), &yes = argument(term, 1), &no = argument(term, 2);
    if (!holds(condition.value, 0)) return yes;
    if (condition.value == Interval{}) return no;
    chose_ = true;
    return either(yes, no, hull(yes.value, no.value));
}

ValueInCell CellSlope::term(const FormulaTerm& term, std::span<const Interval> variables)
{
    auto number = static_cast<double>(term.number);
    if (term.operation == Operation::literal) return {.value = {number, number}};
    if (term.operation == Operation::variable)
        return variable(term.variable, variables[static_cast<std::size_t>(term.variable)]);
    const ValueInCell &a = argument(term, 0), &b = argument(term, 1);
    switch (term.operation) {
        case Operation::negate: return negated(a);
        case Operation::add: return sum(a, b);
        case Operation::subtract: return sum(a, negated(b));
        case Operation::multiply:
            if (&a == &b) return chained(a, limited(square(a.value)), {2 * a.value.low, 2 * a.value.high});
            return product(a, b);
        case Operation::divide: return quotient(a, b);
        case Operation::power: return power(a, b);
        case Operation::less:
        case Operation::less_equal:
        case Operation::equal: return compared(term.operation, a, b);
        case Operation::choose: return choice(term);
        case Operation::sin: return chained(a, sine(a.value), cosine(a.value));
        case Operation::cos: return chained(a, cosine(a.value), -sine(a.value));
        case Operation::atan2: return angle(a, b);
        case Operation::sqrt: return root(a);
        case Operation::abs: return absolute(a);
        case Operation::min: return smaller(a, b);
        case Operation::max: return negated(smaller(negated(a), negated(b)));
        case Operation::floor: return stepped(a, rising(a.value, [](double x) { return std::floor(x); }));
        case Operation::sign:
            return stepped(a, rising(a.value, [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }));
        case Operation::exp: {
            Interval value = rising(a.value, [](double x) { return std::exp(std::min(x, std::log(limit))); });
            return chained(a, value, value);
        }
        case Operation::log: {
            Interval value = rising(a.value, [](double x) { return std::log(std::max(x, tiny)); });
            if (a.value.high <= tiny) return {.value = value};
            return a.value.low <= tiny ? endless(value, a) : chained(a, value, inverse(a.value));
        }
        case Operation::length: return length(a, b);
        case Operation::literal:
        case Operation::variable: break;
    }
    return {};
}

}  // namespace fieldwright::graph
