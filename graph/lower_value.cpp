// Lowering of numbers: calls, their arguments, parameters and wires, Lipschitz constants and bounds.
#include "graph/contours.h"
#include "graph/drawing.h"
#include "graph/known_types.h"
#include "graph/leader.h"
#include "graph/lowering.h"
#include "graph/outline.h"
#include "graph/words.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace fieldwright::graph {
namespace {

constexpr int value_part = 255, material_part = 254, any_context = 0xffffff;

std::uint64_t part_key(int index, std::int32_t context, int part)
{
    return static_cast<std::uint64_t>(index) << 32 | static_cast<std::uint64_t>(context & 0xffffff) << 8 |
           static_cast<std::uint64_t>(part);
}

}  // namespace

ValueId Lowering::node_call(int index, std::string_view suffix, Context context, const Bindings& bindings)
{
    return call_function(index, *type(index).function(suffix), context, bindings);
}

ValueId Lowering::call_function(int index, const Function& function, Context context, const Bindings& bindings)
{
    std::array<ValueId, 32> arguments;
    std::size_t count = 0;
    for (const Argument& argument : function.arguments) {
        if (count == arguments.size()) break;
        arguments[count++] = this->argument(index, argument, context, bindings);
    }
    if (counting_) loop_iterations_ += copies_ * iterations_of_call(function, {arguments.data(), count});
    const NodeType& type = this->type(index);
    gpu_only_ = gpu_only_ || !type.compiled;
    return builder_.call(function, {arguments.data(), count}, node(index).id, type.compiled);
}

// Loops over a list leave off at its end.
int Lowering::iterations_of_call(const Function& function, std::span<const ValueId> arguments) const
{
    std::size_t longest = 0;
    for (ValueId argument : arguments)
        if (builder_.type(argument).base == BaseType::list) longest = std::max(longest, builder_.list_size(argument));
    auto over_lists = static_cast<std::int64_t>(function.list_loops) * static_cast<std::int64_t>(longest + 1);
    return function.loop_iterations - function.list_iterations +
           static_cast<int>(std::min<std::int64_t>(over_lists, function.list_iterations));
}

// A call of a type that no node of the document has: its parameters' defaults.
ValueId Lowering::default_call(const NodeType& type, std::string_view suffix)
{
    const Function& function = *type.function(suffix);
    std::vector<ValueId> arguments;
    for (const Argument& argument : function.arguments) {
        if (argument.role == Role::uv) arguments.push_back(uv_);
        else if (argument.role == Role::lens) arguments.push_back(lens_);
        else if (argument.role == Role::time) arguments.push_back(builder_.program().time);
        else if (argument.parameter >= 0) {
            const Parameter& parameter = type.parameters[static_cast<std::size_t>(argument.parameter)];
            arguments.push_back(constant_of(parameter, parameter.initial, {}));
        } else arguments.push_back(origin_);
    }
    return builder_.call(function, arguments, {}, type.compiled);
}

ValueId Lowering::argument(int index, const Argument& argument, Context context, const Bindings& bindings)
{
    auto bound = [&](ValueId value) { return value != no_value ? value : builder_.constant(1e6f); };
    switch (argument.role) {
        case Role::parameter: return parameter(index, argument.parameter, context);
        case Role::p: return point_argument(index, argument.type, context);
        case Role::cell: return context < 0 ? origin_ : contexts_[static_cast<std::size_t>(context)].cell;
        case Role::time: return builder_.program().time;
        case Role::uv: return uv_;
        case Role::lens: return lens_;
        case Role::direction: return direction_;
        case Role::spread: return spread_;
        case Role::d: return bound(bindings.d);
        case Role::a: return bound(bindings.a);
        case Role::b: return bound(bindings.b);
        case Role::c: return bound(bindings.c);
        case Role::acc: return bound(bindings.acc);
        case Role::copy: return bindings.copy != no_value ? bindings.copy : builder_.constant_int(0);
        case Role::child: return bindings.child;
        case Role::box_a: return bindings.box_a;
        case Role::box_b: return bindings.box_b;
        case Role::steepest: return slope(index);
        case Role::box_c: return bindings.box_c;
        case Role::camera:
        case Role::sky: break;
    }
    return bound(no_value);
}

// The point in the dimension a function asks for: a 2D field in space lies in the plane z = 0.
ValueId Lowering::point_argument(int, const Type& type, Context context)
{
    if (context < 0) return origin_;
    ValueId point = point_of(context);
    if (builder_.type(point).base == type.base) return point;
    ValueId& converted = plane_points_[static_cast<std::size_t>(context)];
    if (converted == no_value)
        converted = builder_.call(type.base == BaseType::vec2 ? "plane_point" : "lift_point", {point});
    return converted;
}

// The node that an index follows, or -1.
int Lowering::leader(int index)
{
    if (!wants_leader(node(index), type(index))) return -1;
    auto [known, is_new] = leader_memo_.try_emplace(index, -1);
    if (!is_new) return known->second;
    const Node* leader = leader_of(document_.root, node(index), type(index));
    int found = leader ? index_of(leader->id) : -1;
    bool usable = found >= 0 && types_[static_cast<std::size_t>(found)];
    if (!usable) tell_no_leader(index);
    return known->second = usable ? found : -1;
}

void Lowering::tell_no_leader(int index)
{
    const NodeType* wanted = builder_.library().type(type(index).follows);
    std::string title = inside_a_sentence(wanted ? wanted->title : type(index).follows);
    note(node(index).id, "there is no " + title + " to follow, so its own values count: add a " + title +
                             ", unmute one, or turn off " + in_words(type(index).follows_while));
}

ValueId Lowering::parameter(int index, int parameter_index, Context context)
{
    const Parameter& parameter = type(index).parameters[static_cast<std::size_t>(parameter_index)];
    if (int leader = this->leader(index); leader >= 0 && is_led(node(index), parameter, type(leader))) {
        const Parameter* given = type(leader).parameter(parameter.name);
        return this->parameter(leader, static_cast<int>(given - type(leader).parameters.data()), context);
    }
    NodeId wired = node(index).inputs.empty() ? NodeId{} : node(index).input(parameter.name);
    if (parameter.kind == ParameterKind::material) {
        int source = other_source(index, parameter.name, SocketKind::material);
        return source < 0 ? default_material_ : material_of(source, context);
    }
    bool computed = parameter.kind == ParameterKind::formula;
    if (wired || computed) {
        std::uint64_t key = part_key(index, context, parameter_index);
        if (auto known = value_memo_.find(key); known != value_memo_.end()) return known->second;
        ValueId value =
            computed ? formula(index, parameter_index, context) : wired_parameter(index, parameter, context);
        if (value != no_value) return value_memo_[key] = value;
    }
    return stored_parameter(index, parameter_index);
}

// The document's own value; one slot per parameter in the whole program.
ValueId Lowering::stored_parameter(int index, int parameter_index)
{
    ValueId& known =
        stored_[static_cast<std::size_t>(stored_offset_[static_cast<std::size_t>(index)] + parameter_index)];
    if (known != no_value) return known;
    const Parameter& parameter = type(index).parameters[static_cast<std::size_t>(parameter_index)];
    if (parameter.kind == ParameterKind::image) return known = image_list(index, parameter);
    const Node& node = this->node(index);
    const Value* value = nullptr;
    auto at = static_cast<std::size_t>(parameter.value_index);
    if (at < node.parameters.size() && node.parameters[at].first == parameter.name) value = &node.parameters[at].second;
    else value = node.parameter(parameter.name);
    bool usable = value && value_error(parameter, *value).empty();
    return known = constant_of(parameter, usable ? *value : parameter.initial, node.id);
}

// The list baked from a node's picture, one for all that ask alike; empty when no file is chosen.
ValueId Lowering::image_list(int index, const Parameter& parameter)
{
    const Node& node = this->node(index);
    std::optional<ImageRequest> request = image_request(node, type(index));
    const BakedImage* image = request ? baked_image(*options_.images, *request) : nullptr;
    auto [known, is_new] = image_lists_.try_emplace(image, no_value);
    if (is_new) known->second = builder_.list(image ? image->list : PointList{}, node.id, parameter.name.c_str());
    return known->second;
}

ValueId Lowering::constant_of(const Parameter& parameter, const Value& value, NodeId node)
{
    constexpr float radians_per_degree = std::numbers::pi_v<float> / 180.0f;
    auto constant = [&](std::initializer_list<float> lanes) {
        return builder_.constant(parameter.type, {lanes.begin(), lanes.size()}, node, parameter.name.c_str());
    };
    float scale =
        parameter.kind == ParameterKind::angle || parameter.kind == ParameterKind::angles ? radians_per_degree : 1.0f;
    if (auto* number = std::get_if<float>(&value)) return constant({*number * scale});
    if (auto* vector = std::get_if<glm::vec3>(&value))
        return constant({vector->x * scale, vector->y * scale, vector->z * scale});
    if (auto* vector = std::get_if<glm::vec2>(&value)) return constant({vector->x, vector->y});
    if (auto* whole = std::get_if<int>(&value)) return constant({static_cast<float>(*whole)});
    if (auto* flag = std::get_if<bool>(&value)) return constant({*flag ? 1.0f : 0.0f});
    if (auto* points = std::get_if<PointList>(&value))
        return builder_.list(expanded(parameter, *points, node), node, parameter.name.c_str());
    if (parameter.kind == ParameterKind::image) return builder_.list({}, node, parameter.name.c_str());
    const auto& word = std::get<std::string>(value);
    auto choice = std::find(parameter.choices.begin(), parameter.choices.end(), word) - parameter.choices.begin();
    return constant({static_cast<float>(choice)});
}

// What a function receives of a list: drawings with their gaps, contours as sides.
PointList Lowering::expanded(const Parameter& parameter, const PointList& points, NodeId node)
{
    if (parameter.unit == drawing_unit) return expanded_drawing(points, node);
    if (int index = index_of(node); index >= 0 && type(index).name == known_types::polygon) tell_contact(points, node);
    if (parameter.unit != contour_unit) return points;
    PointList sides = sides_of(points);
    if (sides.size() < points.size())
        note(node, "its outlines have " + std::to_string(points.size()) + " sides; of these, " +
                       std::to_string(sides.size()) + " are drawn");
    return sides;
}

void Lowering::tell_contact(const PointList& outline, NodeId node)
{
    std::optional<glm::vec2> place = self_contact(outline);
    if (!place) return;
    char where[48];
    std::snprintf(where, sizeof where, "(%.3g, %.3g)", static_cast<double>(place->x), static_cast<double>(place->y));
    note(node, "its outline meets itself at " + std::string(where) +
                   "; what it goes round twice is empty there: move its corners apart for a plain shape");
}

PointList Lowering::expanded_drawing(const PointList& rectangles, NodeId node)
{
    PointList all = with_gaps(rectangles);
    std::string most = std::to_string(drawing_rectangle_limit);
    if (rectangles.size() > drawing_rectangle_limit)
        note(node, "the drawing takes " + std::to_string(rectangles.size()) + " rectangles; the first " + most +
                       " are drawn: paint larger areas");
    else if (all.size() == rectangles.size() && !all.empty())
        note(node, "the drawing takes more than " + most +
                       " rectangles, those of its gaps included; inside, its distance is a bound");
    return all;
}

// The value at a parameter's socket, or no_value when what is wired gives none here.
ValueId Lowering::wired_parameter(int index, const Parameter& parameter, Context context)
{
    int source = index_of(node(index).input(parameter.name));
    if (source < 0 || !types_[static_cast<std::size_t>(source)] || node(source).muted ||
        !type(source).function("value"))
        return no_value;
    if (context < 0 && value_needs(source) != 0) return no_value;
    ValueId value = value_of(source, context);
    return value == no_value ? no_value : clamped(parameter, converted(value, parameter.type));
}

// A wire may leave a parameter's hard range; the field must not.
ValueId Lowering::clamped(const Parameter& parameter, ValueId value)
{
    if (parameter.minimum <= -1e6 && parameter.maximum >= 1e6) return value;
    float scale = parameter.kind == ParameterKind::angle || parameter.kind == ParameterKind::angles
                      ? std::numbers::pi_v<float> / 180.0f
                      : 1.0f;
    ValueId low = builder_.constant(static_cast<float>(parameter.minimum) * scale);
    ValueId high = builder_.constant(static_cast<float>(parameter.maximum) * scale);
    switch (builder_.type(value).base) {
        case BaseType::vec2: return builder_.call("clamp_vec2", {value, low, high});
        case BaseType::vec3: return builder_.call("clamp_vec3", {value, low, high});
        default: return builder_.call("clamp_number", {value, low, high});
    }
}

ValueId Lowering::converted(ValueId value, const Type& wanted)
{
    if (builder_.type(value).base == wanted.base) return value;
    if (builder_.type(value).base != BaseType::real) return no_value;
    if (wanted.base == BaseType::vec2) return builder_.call("splat_vec2", {value});
    if (wanted.base == BaseType::vec3) return builder_.call("splat_vec3", {value});
    return no_value;
}

ValueId Lowering::value_of(int source, Context context)
{
    if (auto known = value_memo_.find(part_key(source, any_context, value_part)); known != value_memo_.end())
        return known->second;
    std::uint64_t key = part_key(source, context, value_part);
    if (auto known = value_memo_.find(key); known != value_memo_.end()) return known->second;
    if (depth_ >= depth_limit) return no_value;
    ++depth_;
    ValueId value = node_call(source, "value", context, {});
    --depth_;
    if (builder_.rate(value) != Rate::point) key = part_key(source, any_context, value_part);
    return value_memo_[key] = value;
}

ValueId Lowering::material_of(int source, Context context)
{
    std::uint64_t key = part_key(source, context, material_part);
    if (auto known = value_memo_.find(part_key(source, any_context, material_part)); known != value_memo_.end())
        return known->second;
    if (auto known = value_memo_.find(key); known != value_memo_.end()) return known->second;
    ValueId value = node_call(source, "material", context, {});
    if (builder_.rate(value) != Rate::point) key = part_key(source, any_context, material_part);
    return value_memo_[key] = value;
}

// What a value node's result depends on, through its wires: needs_point, needs_cell, needs_gpu.
int Lowering::value_needs(int source)
{
    if (auto known = needs_memo_.find(source); known != needs_memo_.end()) return known->second;
    int& needs = needs_memo_[source];
    needs = type(source).compiled ? 0 : needs_gpu;
    if (const Function* function = type(source).function("value"))
        for (const Argument& argument : function->arguments) {
            if (argument.role == Role::p) needs |= needs_point;
            if (argument.role == Role::cell) needs |= needs_cell;
        }
    for (const Parameter& parameter : type(source).parameters) {
        if (parameter.kind != ParameterKind::formula) continue;
        const Formula& formula = formulas_.at({node(source).id, parameter.name});
        if (formula.uses(formula_x) || formula.uses(formula_y) || formula.uses(formula_z)) needs |= needs_point;
    }
    int result = needs;
    for (const auto& [socket, from] : node(source).inputs)
        if (int index = index_of(from); index >= 0 && types_[static_cast<std::size_t>(index)])
            result |= value_needs(index);
    return needs_memo_[source] = result;
}

// A parameter that changes from point to point adds to the field's slope by an amount nobody states.
bool Lowering::varies_with_point(int index)
{
    for (const auto& [socket, from] : node(index).inputs) {
        int source = index_of(from);
        if (source < 0 || !types_[static_cast<std::size_t>(source)] || !type(source).function("value")) continue;
        if (value_needs(source) & needs_point) return true;
    }
    return false;
}

bool Lowering::may_exceed_one(int index)
{
    if (auto known = exceeds_memo_.find(index); known != exceeds_memo_.end()) return known->second;
    const NodeType& type = this->type(index);
    bool exceeds = type.function("lipschitz") || type.function("stretch") || type.declared_lipschitz > 1 ||
                   type.approximate_step < 1 || varies_with_point(index);
    exceeds_memo_[index] = exceeds;
    if (!exceeds)
        for (int source : field_inputs(index)) exceeds = exceeds || may_exceed_one(source);
    return exceeds_memo_[index] = exceeds;
}

// The nodes whose fields a node reads; through a run of one associative combiner at once, so that depth stays small.
std::vector<int> Lowering::field_inputs(int index)
{
    if (type(index).scaling == Scaling::hard_associative) return chain_leaves(index);
    std::vector<int> sources;
    for (const Socket& socket : type(index).inputs)
        if (is_field_kind(socket.kind))
            if (int source = field_source(index, socket.name); source >= 0) sources.push_back(source);
    return sources;
}

ValueId Lowering::memo_lipschitz(int index)
{
    if (!may_exceed_one(index)) return no_value;
    if (auto known = lipschitz_memo_.find(index); known != lipschitz_memo_.end()) return known->second;
    if (depth_ >= depth_limit) return builder_.constant(1.0f);
    ++depth_;
    ValueId value = lipschitz(index);
    --depth_;
    return lipschitz_memo_[index] = value;
}

// Own constant times the largest of the inputs'.
ValueId Lowering::lipschitz(int index)
{
    ValueId largest = no_value;
    for (int source : field_inputs(index))
        if (ValueId inner = memo_lipschitz(source); inner != no_value)
            largest = largest == no_value ? inner : builder_.call("larger_lipschitz", {largest, inner});
    ValueId own = own_lipschitz(index);
    if (own == no_value) return largest == no_value ? builder_.constant(1.0f) : largest;
    return largest == no_value ? own : builder_.call("multiply_lipschitz", {own, largest});
}

// What the author says of a type whose functions do not run here.
float Lowering::declared_lipschitz(int index)
{
    const NodeType& type = this->type(index);
    bool may_stretch = type.function("lipschitz") || type.function("stretch");
    if (type.compiled || !may_stretch || type.declared_lipschitz > 1) return type.declared_lipschitz;
    note(node(index).id,
         "how much it stretches space is not known; rays take quarter steps here until its text has a line "
         "`// lipschitz: L` that says how much at most");
    return 4.0f;
}

ValueId Lowering::own_lipschitz(int index)
{
    const NodeType& type = this->type(index);
    ValueId own = no_value;
    auto multiply = [&](ValueId factor) {
        own = own == no_value ? factor : builder_.call("multiply_lipschitz", {own, factor});
    };
    for (const char* suffix : {"lipschitz", "stretch"})
        if (const Function* function = type.compiled ? type.function(suffix) : nullptr)
            multiply(call_function(index, *function, frame_context, boxes_of_inputs(index)));
    if (float declared = declared_lipschitz(index); own == no_value && declared > 1)
        multiply(builder_.constant(declared));
    if (type.approximate_step < 1) multiply(builder_.constant(1.0f / type.approximate_step));
    if (varies_with_point(index)) {
        note(node(index).id, "a parameter varies over space; rays take half steps here to be safe");
        multiply(builder_.constant(2.0f));
    }
    return own;
}

ValueId Lowering::box_of_input(int index, std::string_view socket)
{
    if (!type(index).input(socket)) return no_value;
    int source = field_source(index, socket);
    return source < 0 ? builder_.call("everywhere", {}) : box(source);
}

Lowering::Bindings Lowering::boxes_of_inputs(int index)
{
    return {.child = box_of_input(index, "d"),
            .box_a = box_of_input(index, "a"),
            .box_b = box_of_input(index, "b"),
            .box_c = box_of_input(index, "c")};
}

// Of the tree that `balanced` makes.
ValueId Lowering::balanced_box(int index, std::span<const int> leaves)
{
    if (leaves.size() == 1) return box(leaves[0]);
    std::size_t half = leaves.size() / 2;
    ValueId a = balanced_box(index, leaves.first(half)), b = balanced_box(index, leaves.subspan(half));
    return node_call(index, "bounds", frame_context, {.box_a = a, .box_b = b});
}

// Box around a field's surface, in the space of its own point.
ValueId Lowering::box(int index)
{
    if (auto known = box_memo_.find(index); known != box_memo_.end()) return known->second;
    bool computable = type(index).compiled && depth_ < depth_limit;
    for (const auto& [socket, from] : node(index).inputs)
        if (int source = index_of(from);
            source >= 0 && types_[static_cast<std::size_t>(source)] && type(source).function("value"))
            computable = computable && value_needs(source) == 0;
    if (!computable) return box_memo_[index] = builder_.call("everywhere", {});
    ++depth_;
    ValueId value = no_value;
    if (is_folded(type(index))) {
        std::vector<int> leaves = chain_leaves(index);
        value = leaves.empty() ? builder_.call("everywhere", {}) : balanced_box(index, leaves);
    } else {
        value = node_call(index, "bounds", frame_context, boxes_of_inputs(index));
    }
    --depth_;
    return box_memo_[index] = value;
}

}  // namespace fieldwright::graph
