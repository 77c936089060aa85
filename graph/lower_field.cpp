// Lowering of fields: primitives, domain operators, modifiers, combiners and blocks, with their materials.
#include "graph/lowering.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

std::uint64_t memo_key(int index, std::int32_t context, bool may_divide)
{
    return static_cast<std::uint64_t>(index) << 33 | static_cast<std::uint64_t>(context) << 1 | (may_divide ? 1u : 0u);
}

bool is_primitive(const NodeType& type) { return type.inputs.empty() || type.input("d") == nullptr; }

// Moves points without stretching: a division may stay below it.
bool is_isometry(const NodeType& type)
{
    return type.function("point") && !type.function("distance") && !type.function("stretch") &&
           !type.function("lipschitz");
}

bool passes_division(const NodeType& type) { return type.scaling != Scaling::none || is_isometry(type); }

}  // namespace

// Counts a visited node against the cost limit; false when the scene is over it.
bool Lowering::spend(int index)
{
    if (over_cost_) return false;
    if (!counting_) return true;
    visits_ += static_cast<std::int64_t>(copies_);
    bool leaf = is_primitive(type(index)) && type(index).input("a") == nullptr;
    if (leaf) cost_ = static_cast<std::int64_t>(std::min(static_cast<double>(cost_) + copies_, 1e15));
    over_cost_ = cost_ > options_.cost_limit || visits_ > 64 * options_.cost_limit;
    return !over_cost_;
}

Lowering::FieldValue Lowering::field(int index, Context context, bool may_divide)
{
    bool shared = uses_[static_cast<std::size_t>(index)] > 1;
    std::uint64_t key = memo_key(index, context, may_divide);
    if (shared)
        if (auto known = memo_.find(key); known != memo_.end()) return known->second;
    if (depth_ >= depth_limit) {
        problems_.push_back({node(index).id, "the graph is nested more than " + std::to_string(depth_limit) +
                                                 " nodes deep here; what lies deeper counts as unconnected"});
        return {};
    }
    if (!spend(index)) return {};
    ++depth_;
    FieldValue value = divided(index, context, may_divide);
    --depth_;
    if (shared) memo_[key] = value;
    return value;
}

// Divides a Lipschitz constant out at the highest place above which only hard combiners and isometries follow, unless the
// scene's own step scale stands for all of them.
Lowering::FieldValue Lowering::divided(int index, Context context, bool may_divide)
{
    if (!may_divide || document_.march.own_step_scale || passes_division(type(index)) || !may_exceed_one(index))
        return raw_field(index, context, may_divide);
    FieldValue value = raw_field(index, context, false);
    if (value.distance != no_value)
        value.distance = builder_.call("divide_distance", {value.distance, memo_lipschitz(index)}, node(index).id);
    return value;
}

Lowering::FieldValue Lowering::raw_field(int index, Context context, bool may_divide)
{
    const NodeType& type = this->type(index);
    gpu_only_ = gpu_only_ || !type.compiled;
    bool inner_may_divide = may_divide && passes_division(type);
    if (is_folded(type)) return chain(index, context, inner_may_divide);
    if (type.input("c")) return ternary(index, context, inner_may_divide);
    if (type.input("a")) return binary(index, context, inner_may_divide);
    if (type.copies > 1) return block(index, context, inner_may_divide);
    if (type.input("d")) return unary(index, context, inner_may_divide);
    return primitive(index, context);
}

Lowering::FieldValue Lowering::primitive(int index, Context context)
{
    FieldValue value;
    value.distance = node_call(index, "distance", context, {});
    if (with_surface_) {
        value.material = default_material_;
        value.material_id = no_id_;
        value.node_id = id_of(node(index).id);
    }
    return value;
}

Lowering::FieldValue Lowering::unary(int index, Context context, bool may_divide)
{
    int source = field_source(index, "d");
    if (source < 0) return {};
    FieldValue value = field(source, inner_context(index, context, "d"), may_divide);
    if (value.distance == no_value) return {};
    const Function* distance = type(index).function("distance");
    if (distance && type(index).category != "output")
        value.distance = call_function(index, *distance, context, {.d = value.distance});
    if (with_surface_) paint(index, context, value);
    return value;
}

// A field node with a `_material` gives its surface that material.
void Lowering::paint(int index, Context context, FieldValue& value)
{
    const Function* material = type(index).function("material");
    if (!material) return;
    int source = -1;
    for (const Parameter& parameter : type(index).parameters)
        if (parameter.kind == ParameterKind::material)
            source = other_source(index, parameter.name, SocketKind::material);
    if (source < 0) return;
    value.material = call_function(index, *material, context, {});
    value.material_id = id_of(node(source).id);
}

// Nobody has an id in a program without ids: then nothing is left to choose.
ValueId Lowering::id_of(NodeId node) { return options_.ids ? builder_.constant_id(node.number) : no_id_; }

// How much of b's material shows.
ValueId Lowering::blend(int index, Context context, const Bindings& sides)
{
    if (type(index).function("blend")) return node_call(index, "blend", context, sides);
    return builder_.call("nearest_blend", {sides.acc, sides.d});
}

// Whether b's id shows. `weight` is the blend where that is known already.
ValueId Lowering::shows_b(int index, Context context, const Bindings& sides, ValueId weight)
{
    const NodeType& type = this->type(index);
    if (type.function("shows_b")) return node_call(index, "shows_b", context, sides);
    if (!type.function("blend")) return builder_.call("nearest_shows", {sides.acc, sides.d});
    return builder_.call("mostly_b", {weight == no_value ? blend(index, context, sides) : weight});
}

Lowering::FieldValue Lowering::side(int index, std::string_view socket, Context context, bool may_divide)
{
    int source = field_source(index, socket);
    return source < 0 ? FieldValue{} : field(source, inner_context(index, context, socket), may_divide);
}

Lowering::FieldValue Lowering::binary(int index, Context context, bool may_divide)
{
    FieldValue a = side(index, "a", context, may_divide);
    FieldValue b = side(index, "b", context, may_divide);
    return combined(index, context, a, b);
}

// A combiner of three: the distance of an unconnected side is that of nothing. Materials and ids are chosen side by
// side: b's share of a, then c's of both.
Lowering::FieldValue Lowering::ternary(int index, Context context, bool may_divide)
{
    FieldValue sides[3];
    for (std::size_t i = 0; i < 3; ++i) sides[i] = side(index, std::string(1, "abc"[i]), context, may_divide);
    Bindings bindings{.a = sides[0].distance, .b = sides[1].distance, .c = sides[2].distance};
    FieldValue value;
    for (std::size_t i = 0; i < 3; ++i) {
        if (sides[i].distance == no_value) continue;
        if (value.distance == no_value) {
            value = sides[i];
            value.distance = node_call(index, "distance", context, bindings);
        } else if (with_surface_) {
            ValueId weight = node_call(index, i == 1 ? "blend" : "blend_c", context, bindings);
            value.material = builder_.call("mix_material", {value.material, sides[i].material, weight});
            ValueId shows = builder_.call("mostly_b", {weight});
            value.material_id = builder_.call("choose_id", {value.material_id, sides[i].material_id, shows});
            value.node_id = builder_.call("choose_id", {value.node_id, sides[i].node_id, shows});
        }
    }
    return value;
}

// A combiner of which one side is unconnected passes the other on.
Lowering::FieldValue Lowering::combined(int index, Context context, const FieldValue& a, const FieldValue& b)
{
    if (a.distance == no_value) return b;
    if (b.distance == no_value) return a;
    Bindings sides{.a = a.distance, .b = b.distance};
    FieldValue value;
    value.distance = node_call(index, "distance", context, sides);
    if (!with_surface_) return value;
    value.material = a.material;
    value.material_id = a.material_id;
    value.node_id = a.node_id;
    ValueId weight = no_value;
    bool same_material = a.material == b.material;
    if (!same_material) {
        weight = blend(index, context, sides);
        value.material = builder_.call("mix_material", {a.material, b.material, weight});
    }
    if (a.node_id == b.node_id && (same_material || a.material_id == b.material_id)) return value;
    ValueId b_shows = shows_b(index, context, sides, weight);
    value.node_id = builder_.call("choose_id", {a.node_id, b.node_id, b_shows});
    if (!same_material) value.material_id = builder_.call("choose_id", {a.material_id, b.material_id, b_shows});
    return value;
}

// Whether the node's inputs, and those of its like below it, are the leaves of one tree.
bool Lowering::is_folded(const NodeType& type)
{
    return type.scaling == Scaling::hard_associative || type.most_inputs > 0;
}

// A run of the same associative combiner becomes a balanced tree, and the inputs of a combiner of many another: shorter
// dependency chains compile and run faster.
Lowering::FieldValue Lowering::chain(int index, Context context, bool may_divide)
{
    std::vector<int> leaves = chain_leaves(index);
    if (leaves.empty()) return {};
    return balanced(index, leaves, context, may_divide);
}

std::vector<int> Lowering::chain_leaves(int index)
{
    std::vector<int> leaves;
    std::vector<int> open = {index};
    bool joins_its_like = type(index).scaling == Scaling::hard_associative;
    while (!open.empty()) {
        int at = open.back();
        open.pop_back();
        bool same_chain =
            at == index ||
            (joins_its_like && types_[static_cast<std::size_t>(at)] == types_[static_cast<std::size_t>(index)] &&
             uses_[static_cast<std::size_t>(at)] == 1);
        if (!same_chain) {
            leaves.push_back(at);
            continue;
        }
        const std::vector<Socket>& sockets = type(at).inputs;
        for (auto socket = sockets.rbegin(); socket != sockets.rend(); ++socket) {
            if (!is_field_kind(socket->kind)) continue;
            if (int source = field_source(at, socket->name); source >= 0) open.push_back(source);
        }
    }
    return leaves;
}

Lowering::FieldValue Lowering::balanced(int index, std::span<const int> leaves, Context context, bool may_divide)
{
    if (leaves.size() == 1) return field(leaves[0], context, may_divide);
    std::size_t half = leaves.size() / 2;
    FieldValue a = balanced(index, leaves.first(half), context, may_divide);
    FieldValue b = balanced(index, leaves.subspan(half), context, may_divide);
    return combined(index, context, a, b);
}

Lowering::FieldValue Lowering::block(int index, Context context, bool may_divide)
{
    const NodeType& type = this->type(index);
    int source = field_source(index, "d");
    if (source < 0) return {};
    // What the block reads from outside is emitted before it begins.
    for (std::size_t i = 0; i < type.parameters.size(); ++i) parameter(index, static_cast<int>(i), context);
    for (const Argument& argument : type.function("point")->arguments)
        if (argument.role == Role::p) point_argument(index, argument.type, context);

    // What the CPU cannot count it does not leave out.
    ValueId needed = type.compiled && type.function("copies") ? node_call(index, "copies", context, {}) : no_value;
    std::size_t start = builder_.begin_block(type.copies, node(index).id);
    if (needed != no_value && builder_.rate(needed) != Rate::point) builder_.set_needed(start, needed);
    double outer_copies = copies_;
    if (counting_) loop_iterations_ += copies_ * type.copies;
    copies_ *= type.copies;
    Bindings bindings{.copy = builder_.copy_of(start)};
    ValueId point = node_call(index, "point", context, bindings);
    ValueId cell = contexts_[static_cast<std::size_t>(context)].cell;
    if (type.function("cell")) {
        cell = node_call(index, "cell", context, bindings);
        builder_.mark_point_dependent(cell, false);  // constant within a copy
    }
    FieldValue inner = field(source, new_context(point, cell), may_divide);
    copies_ = outer_copies;
    if (inner.distance == no_value) {
        builder_.truncate(start);
        return {};
    }

    std::vector<Carried> carried;
    auto carry = [&](ValueId initial) {
        carried.push_back({builder_.input(builder_.type(initial), "acc"), initial, no_value});
        return carried.back().accumulator;
    };
    auto fold = [&](ValueId accumulator, ValueId next) {
        for (Carried& pair : carried)
            if (pair.accumulator == accumulator) pair.next = next;
    };
    FieldValue value;
    value.distance = carry(builder_.constant(1e6f));
    Bindings sides{.d = inner.distance, .a = value.distance, .b = inner.distance, .acc = value.distance};
    fold(value.distance, node_call(index, "distance", context, sides));
    if (with_surface_) {
        ValueId weight = blend(index, context, sides), b_shows = shows_b(index, context, sides, weight);
        // What is the same in every copy needs no fold.
        auto folded = [&](std::string_view function, ValueId next, ValueId initial, ValueId share) {
            if (builder_.rate(next) != Rate::point) return next;
            ValueId accumulator = carry(initial);
            fold(accumulator, builder_.call(function, {accumulator, next, share}));
            return accumulator;
        };
        value.material = folded("mix_material", inner.material, default_material_, weight);
        value.material_id = folded("choose_id", inner.material_id, no_id_, b_shows);
        value.node_id = folded("choose_id", inner.node_id, no_id_, b_shows);
    }
    builder_.end_block(start, carried);
    return value;
}

// The context an input sees: through `_point_<socket>` or `_point`, or the same one.
Lowering::Context Lowering::inner_context(int index, Context context, std::string_view socket)
{
    const NodeType& type = this->type(index);
    const Function* point = type.function("point_" + std::string(socket));
    if (!point) point = type.function("point");
    if (!point) return context;
    if (options_.fold_moves && moves_affinely(index)) {
        contexts_.push_back({no_value, contexts_[static_cast<std::size_t>(context)].cell, index, context});
        plane_points_.push_back(no_value);
        return static_cast<Context>(contexts_.size() - 1);
    }
    return new_context(call_function(index, *point, context, {}), contexts_[static_cast<std::size_t>(context)].cell);
}

}  // namespace fieldwright::graph
