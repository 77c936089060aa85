#include "graph/node_promises.h"

#include "graph/drawing.h"
#include "graph/formula.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

[[noreturn]] void fail(const NodeType& type, int line, const std::string& rule)
{
    throw DialectError(type.source.path, line, rule);
}

void default_formula(const NodeType& type, const Parameter& parameter)
{
    ParsedFormula parsed = parse_formula(std::get<std::string>(parameter.initial), type);
    if (auto* error = std::get_if<FormulaError>(&parsed))
        fail(type, 1, "the default of `" + parameter.name + "` cannot be read, " + error->sentence());
}

// A formula over a box knows how steep it is there.
void formulas(const NodeType& type)
{
    int over = 0;
    for (const Parameter& parameter : type.parameters) {
        if (parameter.kind == ParameterKind::formula) default_formula(type, parameter);
        if (parameter.over.empty()) continue;
        const Parameter* half_size = type.parameter(parameter.over);
        if (++over > 1) fail(type, 1, "one formula of a node may be over a box");
        if (!half_size || half_size->kind != ParameterKind::vec3)
            fail(type, 1, "the formula `" + parameter.name + "` is over `" + parameter.over + "`, which is no vec3");
    }
    for (const Function& function : type.source.functions)
        if (function.argument("steepest") && over == 0)
            fail(type, function.line, "`steepest` is the slope of a formula over a box; the node has none");
}

void images(const NodeType& type)
{
    auto is_image = [](const Parameter& parameter) { return parameter.kind == ParameterKind::image; };
    if (std::count_if(type.parameters.begin(), type.parameters.end(), is_image) > 1)
        fail(type, 1, "a node has one image");
}

// A drawing is rebuilt on a canvas of so many cells.
void drawings(const NodeType& type)
{
    for (const Parameter& list : type.parameters) {
        if (list.kind != ParameterKind::list || list.unit != drawing_unit) continue;
        const Parameter* side = type.parameter(drawing_unit);
        if (!side || side->kind != ParameterKind::integer)
            fail(type, 1, "a list in cells needs an int parameter `cells`, the side of its canvas");
    }
}

void combiners(const NodeType& type)
{
    if (type.argument("distance", "b") && !type.function("blend"))
        fail(type, 1, "a combiner defines `" + type.name + "_blend`: the share of b's material");
    if (type.argument("distance", "c") && !type.function("blend_c"))
        fail(type, 1, "a combiner of three defines `" + type.name + "_blend_c`: the share of c's material");
    if (const Function* shows = type.function("shows_b"); shows && shows->result.base != BaseType::boolean)
        fail(type, shows->line, "`" + shows->name + "` returns a bool: whether the share of b is at least a half");
    if (type.most_inputs == 0) return;
    bool of_two = type.argument("distance", "a") && type.argument("distance", "b") && !type.argument("distance", "c");
    if (!of_two || type.function("point_a") || type.function("point_b") || type.function("point"))
        fail(type, 1, "a node with `inputs: up to N` defines `_distance(a, b)` and moves no point");
}

void blocks(const NodeType& type)
{
    if (type.copies > 1 && (!type.argument("point", "copy") || !type.argument("distance", "acc")))
        fail(type, 1, "a node with `copies` defines `_point(p, ..., copy)` and `_distance(acc, d)`");
    if (const Function* count = type.function("copies");
        count && (count->result.base != BaseType::integer || type.copies < 2))
        fail(type, count->line, "`" + count->name + "` returns an int: how many of its `copies` differ");
}

}  // namespace

void check_promises(const NodeType& type)
{
    formulas(type);
    images(type);
    drawings(type);
    if (!type.is_field()) return;
    if (!type.function("bounds")) fail(type, 1, "a field node defines `" + type.name + "_bounds`");
    combiners(type);
    blocks(type);
}

}  // namespace fieldwright::graph
