// Lowering of formulas: calls of their operations, and how steep they are over their box.
#include "graph/lowering.h"

#include <cmath>
#include <numbers>

namespace fieldwright::graph {
namespace {

constexpr double longest_time_s = 3600;  // to either side, where a slope depends on the time
constexpr double doubt = 2;              // a slope without a bound is taken so much steeper than what was found

// Where a numeric slope ends and a field of nothing but one number begins.
constexpr double least_slope = 1e-6;

}  // namespace

// Why a formula of the node cannot be computed, as a sentence without its end; else they are kept.
std::string Lowering::formula_error(const Node& node, const NodeType& type)
{
    for (const Parameter& parameter : type.parameters) {
        if (parameter.kind != ParameterKind::formula) continue;
        const Value* value = node.parameter(parameter.name);
        bool usable = value && value_error(parameter, *value).empty();
        ParsedFormula parsed = parse_formula(std::get<std::string>(usable ? *value : parameter.initial), type);
        if (auto* error = std::get_if<FormulaError>(&parsed)) return "its formula cannot be read, " + error->sentence();
        formulas_[{node.id, parameter.name}] = std::get<Formula>(std::move(parsed));
    }
    return {};
}

ValueId Lowering::formula(int index, int parameter_index, Context context)
{
    const NodeType& type = this->type(index);
    const Parameter& parameter = type.parameters[static_cast<std::size_t>(parameter_index)];
    const Formula& formula = formulas_.at({node(index).id, parameter.name});
    std::vector<const Parameter*> numbers = formula_parameters(type);
    constexpr std::string_view components[] = {"formula_x", "formula_y", "formula_z"};
    ValueId point = no_value;
    auto variable = [&](int number) {
        if (number == formula_time) return builder_.program().time;
        if (number >= formula_numbers) {
            const Parameter* wanted = numbers[static_cast<std::size_t>(number - formula_numbers)];
            return this->parameter(index, static_cast<int>(wanted - type.parameters.data()), context);
        }
        if (point == no_value) point = formula_point(index, parameter, context);
        return builder_.call(components[number], {point}, node(index).id);
    };
    std::vector<ValueId> values;
    for (const FormulaTerm& term : formula.terms) {
        std::array<ValueId, 3> arguments;
        auto count = static_cast<std::size_t>(argument_count(term.operation));
        for (std::size_t k = 0; k < count; ++k) arguments[k] = values[static_cast<std::size_t>(term.arguments[k])];
        if (term.operation == FormulaOperation::literal) values.push_back(builder_.constant(term.number));
        else if (term.operation == FormulaOperation::variable) values.push_back(variable(term.variable));
        else
            values.push_back(
                builder_.call(function_name(term.operation), std::span(arguments).first(count), node(index).id));
    }
    return values.back();
}

// The point a formula sees; over a box, the nearest one in it.
ValueId Lowering::formula_point(int index, const Parameter& parameter, Context context)
{
    ValueId point = point_argument(index, ProgramBuilder::vec3_type(), context);
    if (parameter.over.empty()) return point;
    const std::vector<Parameter>& parameters = type(index).parameters;
    int half_size = static_cast<int>(type(index).parameter(parameter.over) - parameters.data());
    return builder_.call("formula_within", {point, this->parameter(index, half_size, context)}, node(index).id);
}

// Where a number lies: at its value, or anywhere in its range when something is wired to it. Radians.
Interval Lowering::range_of(int index, const Parameter& parameter) const
{
    double scale = parameter.kind == ParameterKind::angle ? std::numbers::pi / 180 : 1;
    const Value* value = node(index).parameter(parameter.name);
    const float* number = value ? std::get_if<float>(value) : nullptr;
    if (!number || node(index).input(parameter.name)) return {parameter.minimum * scale, parameter.maximum * scale};
    return {*number * scale, *number * scale};
}

ValueId Lowering::slope(int index)
{
    if (auto known = slope_memo_.find(index); known != slope_memo_.end()) return known->second;
    for (const Parameter& parameter : type(index).parameters)
        if (!parameter.over.empty()) return slope_memo_[index] = slope_over(index, parameter);
    return builder_.constant(1.0f);
}

ValueId Lowering::slope_over(int index, const Parameter& parameter)
{
    const Node& node = this->node(index);
    const Parameter& box = *type(index).parameter(parameter.over);
    const Value* value = node.parameter(box.name);
    const auto* half_size = value && !node.input(box.name) ? std::get_if<glm::vec3>(value) : nullptr;
    std::vector<Interval> variables;
    for (int axis = 0; axis < 3; ++axis) {
        double reach = half_size ? static_cast<double>((*half_size)[axis]) : box.maximum;
        variables.push_back({-reach, reach});
    }
    variables.push_back({-longest_time_s, longest_time_s});
    for (const Parameter* number : formula_parameters(type(index))) variables.push_back(range_of(index, *number));
    const Formula& formula = formulas_.at({node.id, parameter.name});
    SlopeBound bound = options_.slopes ? options_.slopes->bound(formula, variables) : slope_bound(formula, variables);
    if (!bound.bounded)
        note(node.id,
             "its formula is steeper than any number somewhere in the box (a root, a division or a jump); "
             "rays may pass through it there");
    else if (bound.chooses)
        note(node.id, "its formula chooses between two; where these do not meet, rays may pass through");
    double slope = std::max(bound.bounded ? bound.slope : doubt * bound.slope, least_slope);
    return builder_.constant(static_cast<float>(std::nextafter(static_cast<float>(std::min(slope, 1e12)), 1e30f)));
}

}  // namespace fieldwright::graph
