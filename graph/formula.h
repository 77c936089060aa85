// Formulas that are typed: numbers computed from variables. Parsed into operations of shaders/render/formula.glsl,
// which say what comes out where mathematics has no answer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fieldwright::graph {

struct NodeType;
struct Parameter;

// The first two are no functions of the shading library. Everything else that can be typed is made of these.
enum class FormulaOperation : std::uint8_t {
    literal,
    variable,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    less,
    less_equal,
    equal,
    choose,
    sin,
    cos,
    atan2,
    sqrt,
    abs,
    min,
    max,
    floor,
    sign,
    exp,
    log,
    length
};

struct FormulaTerm {
    FormulaOperation operation = FormulaOperation::literal;
    float number = 0;                   // of a literal
    int variable = -1;                  // of a variable: index into the names
    std::array<int, 3> arguments = {};  // indices of earlier terms
    bool operator==(const FormulaTerm&) const = default;
};

struct Formula {
    std::vector<FormulaTerm> terms;  // arguments before what reads them; the last one is the result
    bool uses(int variable) const;
    bool operator==(const Formula&) const = default;
};

struct FormulaError {
    int column = 1;  // in letters, from 1
    std::string what;
    std::string sentence() const;  // "column 7: a bracket is not closed"
};

using ParsedFormula = std::variant<Formula, FormulaError>;

inline constexpr int formula_depth_limit = 64;  // of brackets, signs, powers and choices within each other

// `names` are those of the variables. Never throws; takes any bytes.
ParsedFormula parse_formula(std::string_view text, std::span<const std::string_view> names);

// The variables of a formula of a node: x, y, z, time, then the node's own numbers.
enum FormulaVariable : int { formula_x, formula_y, formula_z, formula_time, formula_numbers };
std::vector<std::string_view> formula_names(const NodeType& type);
std::vector<const Parameter*> formula_parameters(const NodeType& type);  // by variable - formula_numbers
ParsedFormula parse_formula(std::string_view text, const NodeType& type);

std::vector<std::string_view> formula_functions();  // what may be typed before a bracket

int argument_count(FormulaOperation operation);
std::string_view function_name(FormulaOperation operation);  // "formula_add"

// As the shading library computes it, in double precision.
double evaluate(const Formula& formula, std::span<const double> variables);

}  // namespace fieldwright::graph
