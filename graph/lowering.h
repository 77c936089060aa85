// The walk behind lower(): one object per lowering. lower.cpp: entries; lower_field.cpp: fields; lower_moves.cpp: the
// points that chains of affine nodes see; lower_value.cpp: values, Lipschitz constants and bounds.
#pragma once

#include "graph/program_builder.h"
#include "graph/slope.h"

#include <array>
#include <map>
#include <unordered_map>

namespace fieldwright::graph {

class Lowering {
public:
    Lowering(const Document& document, std::shared_ptr<const Library> library, const LowerOptions& options);
    Program lower();

private:
    using Context = std::int32_t;  // index into contexts_

    // Where a field or value is evaluated: the point and the cell of the nearest repeat on the way.
    struct Place {
        ValueId point;  // no_value: not asked for yet; then the node `mover` moves the point of `before`
        ValueId cell;
        int mover = -1;
        Context before = -1;
    };

    // What a field node gives at a context. The surface part is filled in the surface entry only.
    struct FieldValue {
        ValueId distance = no_value;
        ValueId material = no_value, material_id = no_value, node_id = no_value;
    };

    // Values of the reserved arguments of one call.
    struct Bindings {
        ValueId d = no_value, a = no_value, b = no_value, c = no_value, acc = no_value, copy = no_value;
        ValueId child = no_value, box_a = no_value, box_b = no_value, box_c = no_value;
    };

    static constexpr std::size_t light_limit = 32;
    static constexpr int depth_limit = 1000;
    static constexpr Context frame_context = -1;  // no point: constants of fields
    static constexpr int needs_point = 1, needs_cell = 2, needs_gpu = 4;

    const std::vector<Node>& nodes() const { return document_.root.nodes; }
    const Node& node(int index) const { return document_.root.nodes[static_cast<std::size_t>(index)]; }
    const NodeType& type(int index) const { return *types_[static_cast<std::size_t>(index)]; }

    void resolve_types();
    bool has_its_image(const Node& node, const NodeType& type);
    ValueId image_list(int index, const Parameter& parameter);
    bool has_good_formulas(const Node& node, const NodeType& type);
    void tell_left_out(const Node& node, const NodeType* type);
    void count_uses();
    int find_output();
    void note(NodeId node, std::string sentence);
    int index_of(NodeId id) const;
    int field_source(int target, std::string_view socket);
    int other_source(int target, std::string_view socket, SocketKind kind);
    static bool is_field_kind(SocketKind kind);
    static bool is_folded(const NodeType& type);

    void begin_entry();
    Context new_context(ValueId point, ValueId cell);
    Entry lower_distance(int root);
    Entry lower_surface(int root);
    Entry lower_ray(int camera);
    Entry lower_sky(int sky);
    std::vector<LightEntry> lower_lights();

    // Fields.
    FieldValue field(int index, Context context, bool may_divide);
    FieldValue divided(int index, Context context, bool may_divide);
    FieldValue raw_field(int index, Context context, bool may_divide);
    FieldValue primitive(int index, Context context);
    FieldValue unary(int index, Context context, bool may_divide);
    FieldValue binary(int index, Context context, bool may_divide);
    FieldValue block(int index, Context context, bool may_divide);
    FieldValue chain(int index, Context context, bool may_divide);
    FieldValue balanced(int index, std::span<const int> leaves, Context context, bool may_divide);
    FieldValue combined(int index, Context context, const FieldValue& a, const FieldValue& b);
    FieldValue ternary(int index, Context context, bool may_divide);
    FieldValue side(int index, std::string_view socket, Context context, bool may_divide);
    void paint(int index, Context context, FieldValue& value);
    ValueId id_of(NodeId node);
    ValueId blend(int index, Context context, const Bindings& sides);
    ValueId shows_b(int index, Context context, const Bindings& sides, ValueId weight);
    std::vector<int> chain_leaves(int index);
    Context inner_context(int index, Context context, std::string_view socket);
    bool moves_affinely(int index);
    ValueId point_of(Context context);
    ValueId moved_by_chain(Context before, std::span<const int> movers);
    bool spend(int index);

    // Calls and their arguments.
    ValueId node_call(int index, std::string_view suffix, Context context, const Bindings& bindings);
    ValueId call_function(int index, const Function& function, Context context, const Bindings& bindings);
    ValueId default_call(const NodeType& type, std::string_view suffix);
    ValueId argument(int index, const Argument& argument, Context context, const Bindings& bindings);
    ValueId point_argument(int index, const Type& type, Context context);
    ValueId parameter(int index, int parameter, Context context);
    int leader(int index);
    void tell_no_leader(int index);
    ValueId stored_parameter(int index, int parameter);
    ValueId wired_parameter(int index, const Parameter& parameter, Context context);
    ValueId constant_of(const Parameter& parameter, const Value& value, NodeId node);
    PointList expanded(const Parameter& parameter, const PointList& points, NodeId node);
    void tell_contact(const PointList& outline, NodeId node);
    PointList expanded_drawing(const PointList& rectangles, NodeId node);
    ValueId clamped(const Parameter& parameter, ValueId value);
    ValueId value_of(int source, Context context);
    ValueId material_of(int source, Context context);
    ValueId converted(ValueId value, const Type& type);

    // Formulas.
    std::string formula_error(const Node& node, const NodeType& type);
    ValueId formula(int index, int parameter, Context context);
    ValueId formula_point(int index, const Parameter& parameter, Context context);
    Interval range_of(int index, const Parameter& parameter) const;
    ValueId slope(int index);
    ValueId slope_over(int index, const Parameter& parameter);

    // Constants of fields, at constant or frame rate.
    ValueId memo_lipschitz(int index);
    ValueId lipschitz(int index);
    ValueId own_lipschitz(int index);
    float declared_lipschitz(int index);
    bool may_exceed_one(int index);
    bool varies_with_point(int index);
    int value_needs(int source);
    std::vector<int> field_inputs(int index);
    ValueId box(int index);
    ValueId balanced_box(int index, std::span<const int> leaves);
    ValueId box_of_input(int index, std::string_view socket);
    Bindings boxes_of_inputs(int index);
    int iterations_of_call(const Function& function, std::span<const ValueId> arguments) const;

    const Document& document_;
    const LowerOptions& options_;
    ProgramBuilder builder_;
    std::vector<const NodeType*> types_;  // by node index; null when unknown
    std::vector<int> uses_;               // by node index: wires that leave it
    std::vector<Problem> problems_;

    std::array<ValueId, 4> corners_{};  // the origin and the ends of the unit vectors, when moves are folded
    ValueId origin_ = no_value, uv_ = no_value, lens_ = no_value, direction_ = no_value, spread_ = no_value;
    ValueId default_material_ = no_value, no_id_ = no_value;

    // Of the entry being emitted.
    std::vector<Place> contexts_;
    std::vector<ValueId> plane_points_;                      // by context: its point as vec2
    std::unordered_map<std::uint64_t, FieldValue> memo_;     // shared fields
    std::unordered_map<std::uint64_t, ValueId> value_memo_;  // parameters, shared values and materials
    bool with_surface_ = false;
    int depth_ = 0;

    // Of the whole program.
    std::vector<int> stored_offset_;                                   // by node index: its first parameter in stored_
    std::vector<ValueId> stored_;                                      // parameters from the document
    std::map<std::pair<NodeId, std::string_view>, Formula> formulas_;  // by parameter
    std::unordered_map<int, int> leader_memo_;                         // by node index that wants one; -1 without
    std::unordered_map<int, ValueId> slope_memo_;
    std::map<const BakedImage*, ValueId> image_lists_;
    std::unordered_map<int, int> needs_memo_;
    std::unordered_map<int, ValueId> lipschitz_memo_, box_memo_;
    std::unordered_map<int, bool> exceeds_memo_;

    bool counting_ = false;
    bool over_cost_ = false;
    bool gpu_only_ = false;
    std::int64_t cost_ = 0, visits_ = 0;
    double copies_ = 1;  // product of the enclosing blocks' copies
    double loop_iterations_ = 0;
};

}  // namespace fieldwright::graph
