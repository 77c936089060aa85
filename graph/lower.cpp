// From a document to its program: walks the graph from the output and emits calls.
#include "graph/lowering.h"

#include "graph/words.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace fieldwright::graph {

Lowering::Lowering(const Document& document, std::shared_ptr<const Library> library, const LowerOptions& options)
    : document_(document), options_(options), builder_(std::move(library))
{
    builder_.reserve(nodes().size());
    resolve_types();
    count_uses();
    origin_ = builder_.constant(ProgramBuilder::vec3_type(), std::array{0.0f, 0.0f, 0.0f});
    corners_ = {origin_, no_value, no_value, no_value};
}

Program Lowering::lower()
{
    int output = find_output();
    int root = options_.root ? index_of(options_.root) : field_source(output, "d");
    if (root >= 0 && !types_[static_cast<std::size_t>(root)]) root = -1;
    Entry distance = lower_distance(root);
    if (over_cost_) {
        problems_.push_back({output >= 0 ? nodes()[static_cast<std::size_t>(output)].id : NodeId{},
                             "the scene takes more than " + std::to_string(options_.cost_limit) +
                                 " evaluations of shapes for one distance; remove copies or shared branches"});
        root = -1;
        std::int64_t refused_cost = cost_;  // what was counted when the limit was passed is what a reader wants to see
        distance = lower_distance(root);
        cost_ = refused_cost;
    }
    Entry surface = lower_surface(root);
    Entry ray = lower_ray(output >= 0 ? other_source(output, "camera", SocketKind::camera) : -1);
    Entry sky = lower_sky(output >= 0 ? other_source(output, "sky", SocketKind::sky) : -1);
    std::vector<LightEntry> lights = lower_lights();
    ValueId bounds = options_.bounds && root >= 0 ? box(root) : no_value;
    ValueId lipschitz =
        root >= 0 && types_[static_cast<std::size_t>(root)]->is_field() ? memo_lipschitz(root) : no_value;
    Program program = builder_.finish();
    program.distance = std::move(distance);
    program.surface = std::move(surface);
    program.ray = std::move(ray);
    program.sky = std::move(sky);
    program.lights = std::move(lights);
    program.bounds = bounds;
    program.lipschitz = lipschitz;
    program.march = document_.march;
    program.occlusion = document_.occlusion;
    program.fog = document_.fog;
    program.bounces = document_.bounces;
    program.expanded_cost = cost_;
    program.loop_iterations = static_cast<int>(std::min(loop_iterations_, 59999.0));
    program.step_budget = 60000 / (1 + program.loop_iterations);
    program.gpu_only = gpu_only_;
    program.problems = std::move(problems_);
    return program;
}

void Lowering::resolve_types()
{
    types_.reserve(nodes().size());
    int parameters = 0;
    for (const Node& node : nodes()) {
        types_.push_back(builder_.library().type(node.type));
        stored_offset_.push_back(parameters);
        const NodeType* type = types_.back();
        bool known = type && !type->held_back;
        if (!known || type->former) tell_left_out(node, type);
        if (!known || !has_its_image(node, *type) || !has_good_formulas(node, *type)) types_.back() = nullptr;
        else if (!type->compiled && !type->former)
            note(node.id, "this node is not compiled into the program and runs on the GPU only");
        if (types_.back()) parameters += static_cast<int>(type->parameters.size());
    }
    stored_.assign(static_cast<std::size_t>(parameters), no_value);
}

// Whether there is what its picture file was to be made into; says so when not.
bool Lowering::has_its_image(const Node& node, const NodeType& type)
{
    std::optional<ImageRequest> request = image_request(node, type);
    if (!request) return true;
    const BakedImage* image = options_.images ? baked_image(*options_.images, *request) : nullptr;
    if (image && image->sentence.empty()) return true;
    if (image) problems_.push_back({node.id, image->sentence});
    else note(node.id, "reading the picture " + request->path);
    return false;
}

bool Lowering::has_good_formulas(const Node& node, const NodeType& type)
{
    std::string error = formula_error(node, type);
    if (!error.empty()) problems_.push_back({node.id, error + "; the node counts as unconnected"});
    return error.empty();
}

// Without its type a node counts as unconnected.
void Lowering::tell_left_out(const Node& node, const NodeType* type)
{
    const TextError* error = builder_.library().left_out(node.type);
    std::string why = error ? sentence(*error) : "this version does not know nodes of type " + titled(node.type);
    if (error && error->waiting) return note(node.id, why);
    why += type && type->former ? "; what it was before is shown" : "; it counts as unconnected";
    problems_.push_back({node.id, std::move(why)});
}

void Lowering::count_uses()
{
    uses_.assign(nodes().size(), 0);
    for (const Node& node : nodes())
        for (const auto& [socket, source] : node.inputs)
            if (int index = index_of(source); index >= 0) ++uses_[static_cast<std::size_t>(index)];
}

int Lowering::find_output()
{
    int found = -1;
    for (std::size_t i = 0; i < nodes().size(); ++i) {
        if (!types_[i] || types_[i]->category != "output") continue;
        if (found >= 0) note(nodes()[i].id, "a scene has one output; this one is not shown");
        else found = static_cast<int>(i);
    }
    if (found < 0 && !options_.root)
        problems_.push_back({{}, "the scene has no output; add one and wire a shape to it"});
    return found;
}

void Lowering::note(NodeId node, std::string sentence)
{
    Problem problem{node, std::move(sentence), Problem::Severity::note};
    if (std::find(problems_.begin(), problems_.end(), problem) == problems_.end())
        problems_.push_back(std::move(problem));
}

int Lowering::index_of(NodeId id) const
{
    // Ids begin near 1 and rarely have gaps: the first guess is mostly right.
    if (auto guess = static_cast<std::size_t>(id.number - 1); guess < nodes().size() && nodes()[guess].id == id)
        return static_cast<int>(guess);
    auto found = std::lower_bound(nodes().begin(), nodes().end(), id,
                                  [](const Node& node, NodeId wanted) { return node.id < wanted; });
    return found != nodes().end() && found->id == id ? static_cast<int>(found - nodes().begin()) : -1;
}

// The node whose field reaches a socket, past muted ones; -1 for nothing.
int Lowering::field_source(int target, std::string_view socket)
{
    if (target < 0) return -1;
    for (int index = index_of(node(target).input(socket)); index >= 0;) {
        const NodeType* type = types_[static_cast<std::size_t>(index)];
        if (!type || !type->is_field()) return -1;
        if (!node(index).muted) return index;
        if (type->inputs.empty() || !is_field_kind(type->inputs.front().kind)) return -1;
        bool converts = type->inputs.front().kind != type->output;
        if (converts) return -1;
        index = index_of(node(index).input(type->inputs.front().name));
    }
    return -1;
}

// The unmuted node of another kind (camera, sky, material, value) at a socket; -1 for nothing.
int Lowering::other_source(int target, std::string_view socket, SocketKind kind)
{
    int index = index_of(node(target).input(socket));
    if (index < 0 || !types_[static_cast<std::size_t>(index)] || node(index).muted) return -1;
    return types_[static_cast<std::size_t>(index)]->output == kind ? index : -1;
}

bool Lowering::is_field_kind(SocketKind kind)
{
    return kind == SocketKind::field2d || kind == SocketKind::field3d || kind == SocketKind::field_any;
}

void Lowering::begin_entry()
{
    memo_.clear();
    value_memo_.clear();
    contexts_.clear();
    plane_points_.clear();
}

Lowering::Context Lowering::new_context(ValueId point, ValueId cell)
{
    contexts_.push_back({point, cell});
    plane_points_.push_back(no_value);
    return static_cast<Context>(contexts_.size() - 1);
}

Entry Lowering::lower_distance(int root)
{
    begin_entry();
    counting_ = true;
    cost_ = 0;
    visits_ = 0;
    loop_iterations_ = 0;
    over_cost_ = false;
    with_surface_ = false;
    ValueId p = builder_.input(ProgramBuilder::vec3_type(), "p");
    builder_.mark_point_dependent(p);
    FieldValue value = root >= 0 ? field(root, new_context(p, origin_), true) : FieldValue{};
    counting_ = false;
    if (over_cost_) builder_.truncate(0);
    if (value.distance == no_value || over_cost_) value.distance = builder_.call("nothing_distance", {p});
    return builder_.finish_entry({p}, {value.distance});
}

Entry Lowering::lower_surface(int root)
{
    begin_entry();
    with_surface_ = true;
    ValueId p = builder_.input(ProgramBuilder::vec3_type(), "p");
    builder_.mark_point_dependent(p);
    default_material_ = builder_.call("default_material", {});
    no_id_ = builder_.constant_id(0);
    FieldValue value = root >= 0 ? field(root, new_context(p, origin_), true) : FieldValue{};
    with_surface_ = false;
    if (value.distance == no_value)
        value.material = default_material_, value.material_id = no_id_, value.node_id = no_id_;
    std::vector<ValueId> results = {value.material, value.material_id, value.node_id};
    builder_.keep_what_gives(results);
    return builder_.finish_entry({p}, std::move(results));
}

Entry Lowering::lower_ray(int camera)
{
    begin_entry();
    uv_ = builder_.input(ProgramBuilder::vec2_type(), "uv");
    lens_ = builder_.input(ProgramBuilder::vec2_type(), "lens");
    Context context = new_context(origin_, origin_);
    const NodeType* fallback = builder_.library().type("perspective");
    ValueId ray = no_value;
    if (camera >= 0) ray = node_call(camera, "ray", context, {});
    else if (fallback) ray = default_call(*fallback, "ray");
    return builder_.finish_entry({uv_, lens_}, {ray});
}

Entry Lowering::lower_sky(int sky)
{
    begin_entry();
    direction_ = builder_.input(ProgramBuilder::vec3_type(), "direction");
    spread_ = builder_.input(ProgramBuilder::real_type(), "spread");
    Context context = new_context(origin_, origin_);
    ValueId radiance =
        sky >= 0 ? node_call(sky, "sky", context, {}) : builder_.call("empty_sky", {direction_, spread_});
    return builder_.finish_entry({direction_, spread_}, {radiance});
}

namespace {

// Of a user's own light, a switch gives hard shadows.
Shadow shadow_of(const Node& node)
{
    const Value* value = node.parameter("shadow");
    if (const bool* casts = value ? std::get_if<bool>(value) : nullptr) return *casts ? Shadow::hard : Shadow::off;
    const std::string* word = value ? std::get_if<std::string>(value) : nullptr;
    if (!word) return Shadow::off;
    if (*word == "soft") return Shadow::soft;
    if (*word == "soft_corrected") return Shadow::soft_corrected;
    return *word == "hard" ? Shadow::hard : Shadow::off;
}

}  // namespace

std::vector<LightEntry> Lowering::lower_lights()
{
    std::vector<LightEntry> lights;
    for (std::size_t i = 0; i < nodes().size(); ++i) {
        if (!types_[i] || types_[i]->output != SocketKind::light || nodes()[i].muted) continue;
        if (lights.size() == light_limit) {
            problems_.push_back({nodes()[i].id, "a scene has at most " + std::to_string(light_limit) +
                                                    " lights; this one is left out"});
            continue;
        }
        begin_entry();
        ValueId p = builder_.input(ProgramBuilder::vec3_type(), "p");
        builder_.mark_point_dependent(p);
        ValueId light = node_call(static_cast<int>(i), "light", new_context(p, origin_), {});
        lights.push_back({builder_.finish_entry({p}, {light}), nodes()[i].id, shadow_of(nodes()[i])});
    }
    std::stable_partition(lights.begin(), lights.end(),
                          [](const LightEntry& light) { return light.shadow != Shadow::off; });
    return lights;
}

namespace {

// The same problem of every copy is told once for each group node of the scene.
std::vector<Problem> told_of_groups(const std::vector<Problem>& problems, const std::vector<InnerCopy>& copies)
{
    std::vector<Problem> told;
    for (Problem problem : problems) {
        std::vector<NodeId> path = path_of(copies, problem.node);
        problem.node = path.front();
        problem.inside.assign(path.begin() + 1, path.end());
        if (std::find(told.begin(), told.end(), problem) == told.end()) told.push_back(std::move(problem));
    }
    return told;
}

Program lower_groups(const Document& document, const std::shared_ptr<const Library>& library, LowerOptions options)
{
    Expansion expansion = expanded(document, *library);
    if (auto found = expansion.stand_ins.find(options.root); found != expansion.stand_ins.end())
        options.root = found->second;
    Program program = Lowering(expansion.document, library, options).lower();
    program.problems = told_of_groups(program.problems, expansion.copies);
    program.problems.insert(program.problems.end(), expansion.problems.begin(), expansion.problems.end());
    program.inner_copies = std::move(expansion.copies);
    return program;
}

}  // namespace

float step_scale(const MarchSettings& march) { return march.own_step_scale ? march.step_scale : 1.0f; }

int shadow_count(const Program& program)
{
    auto is_shadowed = [](const LightEntry& light) { return light.shadow != Shadow::off; };
    return static_cast<int>(std::count_if(program.lights.begin(), program.lights.end(), is_shadowed));
}

bool tracks_cone(const Program& program)
{
    return std::any_of(program.lights.begin(), program.lights.end(),
                       [](const LightEntry& light) { return light.shadow > Shadow::hard; });
}

Program lower(const Document& document, const std::shared_ptr<const Library>& library, const LowerOptions& options)
{
    if (!document.groups.empty()) return lower_groups(document, library, options);
    return Lowering(document, library, options).lower();
}

}  // namespace fieldwright::graph
