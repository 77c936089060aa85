// From the inside of a group to its node type.
#include "graph/group_types.h"

#include "graph/contours.h"
#include "graph/wire_rules.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

// A field of any dimension has the one that its surroundings inside give it.
SocketKind fixed_kind(SocketKind kind, int dimension)
{
    if (kind != SocketKind::field_any || !dimension) return kind;
    return dimension == 2 ? SocketKind::field2d : SocketKind::field3d;
}

Quality worst(const Graph& graph, const Library& library, Quality NodeType::*side)
{
    Quality quality = Quality::exact;
    for (const Node& node : graph.nodes)
        if (const NodeType* type = library.type(node.type); type && type->is_field())
            quality = std::max(quality, type->*side);
    return quality;
}

class Interface {
public:
    Interface(const Group& group, const Library& library)
        : group_(group), library_(library), rules_(group.graph, library)
    {
        rules_.add_all();
    }

    NodeType type()
    {
        describe();
        for (const Exposed& exposed : group_.exposed) add(exposed);
        for (const Exposed& exposed : group_.exposed) add_ready_made(exposed);
        type_.inputs.insert(type_.inputs.end(), value_inputs_.begin(), value_inputs_.end());
        const Node* output = group_.graph.find(group_.output);
        const NodeType* given = output ? library_.type(output->type) : nullptr;
        if (given) type_.output = fixed_kind(given->output, rules_.dimension(output->id));
        return std::move(type_);
    }

private:
    void describe()
    {
        type_.name = group_type_name(group_.name);
        type_.category = group_category;
        type_.title = group_.name;
        type_.help = "A group of this scene, of " + std::to_string(group_.graph.nodes.size()) +
                     (group_.graph.nodes.size() == 1 ? " node." : " nodes.");
        type_.quality_outside = worst(group_.graph, library_, &NodeType::quality_outside);
        type_.quality_inside = worst(group_.graph, library_, &NodeType::quality_inside);
        type_.compiled = true;
    }

    void add(const Exposed& exposed)
    {
        const Node* node = group_.graph.find(exposed.node);
        const NodeType* inner = node ? library_.type(node->type) : nullptr;
        if (!inner) return;
        const Parameter* parameter = inner->parameter(exposed.socket);
        const Socket* socket = inner->input(exposed.socket);
        // What is wired inside has no value that counts; a wire from outside takes the inner one's place.
        bool counts = parameter && (parameter->kind == ParameterKind::material || !node->input(exposed.socket));
        if (counts) add(exposed, *node, *parameter);
        if (!socket) return;
        SocketKind kind =
            carries_field(socket->kind) ? fixed_kind(socket->kind, rules_.dimension(node->id)) : socket->kind;
        (carries_field(kind) ? type_.inputs : value_inputs_).push_back({exposed.name, kind});
    }

    void add(const Exposed& exposed, const Node& node, const Parameter& inner)
    {
        Parameter& parameter = type_.parameters.emplace_back(inner);
        parameter.name = exposed.name;
        if (!exposed.help.empty()) parameter.help = exposed.help;
        if (const Value* value = node.parameter(inner.name)) parameter.initial = *value;
        parameter.value_index = parameter.kind == ParameterKind::material ? -1 : values_++;
    }

    // The contours of a text that is written from outside.
    void add_ready_made(const Exposed& exposed)
    {
        const Node* node = group_.graph.find(exposed.node);
        const NodeType* inner = node ? library_.type(node->type) : nullptr;
        if (!inner || !(node->type.starts_with(group_prefix) || is_writing(exposed.socket))) return;
        for (const Parameter& parameter : inner->parameters) {
            if (parameter.kind != ParameterKind::list || parameter.unit != contour_unit) continue;
            Exposed along{ready_made_name(node->id, parameter.name), {}, node->id, parameter.name};
            if (!type_.parameter(along.name)) add(along, *node, parameter);
        }
    }

    static bool is_writing(std::string_view parameter)
    {
        return std::find(writing_parameters.begin(), writing_parameters.end(), parameter) != writing_parameters.end();
    }

    const Group& group_;
    const Library& library_;
    WireRules rules_;
    NodeType type_;
    std::vector<Socket> value_inputs_;
    int values_ = 0;
};

}  // namespace

NodeType group_type(const Group& group, const Library& library) { return Interface(group, library).type(); }

std::shared_ptr<const Library> with_groups(const Library& library, const Document& document)
{
    std::vector<NodeType> types;
    std::shared_ptr<const Library> known = library.with(Origin::group, {});
    for (const Group* group : inner_first(document)) {
        // Only those that use some need to know more than the plain library.
        if (!groups_used_by(group->graph).empty()) known = library.with(Origin::group, {types, {}});
        types.push_back(group_type(*group, *known));
    }
    return types.empty() ? known : library.with(Origin::group, {std::move(types), {}});
}

std::shared_ptr<const Library> library_of(Document& document, const Library& library)
{
    AtRest rest(document);
    return with_groups(library, document);
}

bool same_interface(const NodeType& a, const NodeType& b)
{
    auto same_parameter = [](const Parameter& one, const Parameter& other) {
        return one.name == other.name && one.kind == other.kind && one.minimum == other.minimum &&
               one.maximum == other.maximum && one.choices == other.choices;
    };
    auto same_socket = [](const Socket& one, const Socket& other) {
        return one.name == other.name && one.kind == other.kind;
    };
    return a.output == b.output &&
           std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(), b.parameters.end(),
                      same_parameter) &&
           std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(), same_socket);
}

}  // namespace fieldwright::graph
