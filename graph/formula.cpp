// What the operations of formulas are called, take and give.
#include "graph/formula.h"

#include "graph/library.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::graph {
namespace {

// As in shaders/render/formula.glsl.
constexpr double limit = 1e12, tiny = 1e-20;

double limited(double a) { return std::clamp(a, -limit, limit); }
double truth(bool holds) { return holds ? 1 : 0; }

double divided(double a, double b) { return std::abs(b) < tiny ? 0 : limited(a / b); }

double raised(double a, double b)
{
    double size = std::abs(a);
    if (size < tiny) return truth(b == 0);
    double magnitude = std::exp2(std::min(b * std::log2(size), std::log2(limit)));
    if (a > 0) return magnitude;
    if (std::floor(b) != b) return 0;
    return std::fmod(b, 2) != 0 ? -magnitude : magnitude;
}

struct OperationKind {
    std::string_view function;
    int arguments;
    double (*compute)(double a, double b, double c);
};

// In the order of FormulaOperation.
constexpr OperationKind kinds[] = {
    {"", 0, nullptr},
    {"", 0, nullptr},
    {"formula_negate", 1, [](double a, double, double) { return -a; }},
    {"formula_add", 2, [](double a, double b, double) { return a + b; }},
    {"formula_subtract", 2, [](double a, double b, double) { return a - b; }},
    {"formula_multiply", 2, [](double a, double b, double) { return limited(a * b); }},
    {"formula_divide", 2, [](double a, double b, double) { return divided(a, b); }},
    {"formula_power", 2, [](double a, double b, double) { return raised(a, b); }},
    {"formula_less", 2, [](double a, double b, double) { return truth(a < b); }},
    {"formula_less_equal", 2, [](double a, double b, double) { return truth(a <= b); }},
    {"formula_equal", 2, [](double a, double b, double) { return truth(a == b); }},
    {"formula_choose", 3, [](double condition, double a, double b) { return condition == 0 ? b : a; }},
    {"formula_sin", 1, [](double a, double, double) { return std::sin(a); }},
    {"formula_cos", 1, [](double a, double, double) { return std::cos(a); }},
    {"formula_atan2", 2, [](double y, double x, double) { return std::atan2(y, x); }},
    {"formula_sqrt", 1, [](double a, double, double) { return std::sqrt(std::max(a, 0.0)); }},
    {"formula_abs", 1, [](double a, double, double) { return std::abs(a); }},
    {"formula_min", 2, [](double a, double b, double) { return std::min(a, b); }},
    {"formula_max", 2, [](double a, double b, double) { return std::max(a, b); }},
    {"formula_floor", 1, [](double a, double, double) { return std::floor(a); }},
    {"formula_sign", 1, [](double a, double, double) { return truth(a > 0) - truth(a < 0); }},
    {"formula_exp", 1, [](double a, double, double) { return std::exp(std::min(a, std::log(limit))); }},
    {"formula_log", 1, [](double a, double, double) { return std::log(std::max(a, tiny)); }},
    {"formula_length", 2, [](double a, double b, double) { return std::sqrt(a * a + b * b); }},
};
static_assert(std::size(kinds) == static_cast<std::size_t>(FormulaOperation::length) + 1);

const OperationKind& kind_of(FormulaOperation operation) { return kinds[static_cast<std::size_t>(operation)]; }

}  // namespace

bool Formula::uses(int variable) const
{
    return std::any_of(terms.begin(), terms.end(), [&](const FormulaTerm& term) { return term.variable == variable; });
}

std::string FormulaError::sentence() const { return "column " + std::to_string(column) + ": " + what; }

int argument_count(FormulaOperation operation) { return kind_of(operation).arguments; }

std::string_view function_name(FormulaOperation operation) { return kind_of(operation).function; }

std::vector<const Parameter*> formula_parameters(const NodeType& type)
{
    std::vector<const Parameter*> numbers;
    for (const Parameter& parameter : type.parameters)
        if (parameter.kind == ParameterKind::number || parameter.kind == ParameterKind::angle)
            numbers.push_back(&parameter);
    return numbers;
}

std::vector<std::string_view> formula_names(const NodeType& type)
{
    std::vector<std::string_view> names = {"x", "y", "z", "time"};
    for (const Parameter* parameter : formula_parameters(type)) names.push_back(parameter->name);
    return names;
}

ParsedFormula parse_formula(std::string_view text, const NodeType& type)
{
    return parse_formula(text, formula_names(type));
}

double evaluate(const Formula& formula, std::span<const double> variables)
{
    std::vector<double> values;
    values.reserve(formula.terms.size());
    for (const FormulaTerm& term : formula.terms) {
        auto value = [&](int i) {
            return values[static_cast<std::size_t>(term.arguments[static_cast<std::size_t>(i)])];
        };
        const OperationKind& kind = kind_of(term.operation);
        if (term.operation == FormulaOperation::literal) values.push_back(static_cast<double>(term.number));
        else if (term.operation == FormulaOperation::variable)
            values.push_back(variables[static_cast<std::size_t>(term.variable)]);
        else
            values.push_back(
                kind.compute(value(0), kind.arguments > 1 ? value(1) : 0, kind.arguments > 2 ? value(2) : 0));
    }
    return values.back();
}

}  // namespace fieldwright::graph
