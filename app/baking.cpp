// Between text nodes and the letters of assets.
#include "app/baking.h"

#include "graph/contours.h"
#include "graph/edits.h"
#include "graph/groups.h"
#include "ui/font_files.h"

#include <algorithm>

namespace fieldwright::app {
namespace {

using assets::Outlines;
using assets::Writing;
using graph::Document;
using graph::Group;
using graph::Library;
using graph::Node;
using graph::NodeType;
using graph::PointList;

constexpr std::size_t remembered = 64;  // writings whose outlines are kept at hand

template <typename T>
void take(const graph::Value& value, T& into)
{
    if (const T* held = std::get_if<T>(&value)) into = *held;
}

// By the name of one of graph::writing_parameters; others say nothing of how a text is written.
void set(Writing& writing, std::string_view name, const graph::Value& value)
{
    if (name == "text") take(value, writing.text);
    if (name == "font") take(value, writing.font);
    if (name == "letter_spacing") take(value, writing.letter_spacing);
    if (name == "line_spacing") take(value, writing.line_spacing);
    if (name == "alignment") take(value, writing.alignment);
}

// What the nodes of a document write, through the groups that let their words be set from outside.
class Writings {
public:
    Writings(const Document& document, const Library& library) : document_(document), library_(library) {}

    // visit(node, its list of contours, how it is written): for every text of every graph.
    template <typename Visit>
    void each(const Visit& visit) const
    {
        graph::for_each_graph(document_, [&](const graph::Graph& graph) {
            for (const Node& node : graph.nodes)
                if (const NodeType* type = library_.type(node.type))
                    for (const graph::Parameter& parameter : type->parameters)
                        if (auto writing = is_contours(parameter) ? of(node, parameter.name) : std::nullopt)
                            visit(node, parameter.name, *writing);
        });
    }

private:
    static bool is_contours(const graph::Parameter& parameter)
    {
        return parameter.kind == graph::ParameterKind::list && parameter.unit == graph::contour_unit;
    }

    std::optional<Writing> of(const Node& node, std::string_view contours) const
    {
        const Group* group = graph::group_of(document_, node);
        if (group) return of_group(node, *group, contours);
        if (!node.parameter("text")) return std::nullopt;
        Writing writing;
        for (const auto& [name, value] : node.parameters) set(writing, name, value);
        return writing;
    }

    // As inside, but for what is set here.
    std::optional<Writing> of_group(const Node& node, const Group& group, std::string_view contours) const
    {
        auto [id, inner_contours] = graph::ready_made(contours);
        const Node* inner = group.graph.find(id);
        std::optional<Writing> writing = inner ? of(*inner, inner_contours) : std::nullopt;
        if (!writing) return std::nullopt;
        for (const graph::Exposed& exposed : group.exposed) {
            const graph::Value* value = exposed.node == id ? node.parameter(exposed.name) : nullptr;
            if (value) set(*writing, what_it_sets(*inner, exposed.socket, inner_contours), *value);
        }
        return writing;
    }

    // The parameter of the text itself that a parameter of the node sets.
    std::string_view what_it_sets(const Node& node, std::string_view parameter, std::string_view contours) const
    {
        const Group* group = graph::group_of(document_, node);
        if (!group) return parameter;
        auto [id, inner_contours] = graph::ready_made(contours);
        const Node* inner = group->graph.find(id);
        for (const graph::Exposed& exposed : group->exposed)
            if (inner && exposed.node == id && exposed.name == parameter)
                return what_it_sets(*inner, exposed.socket, inner_contours);
        return {};
    }

    const Document& document_;
    const Library& library_;
};

}  // namespace

const Outlines& Baking::outlines(const Writing& writing)
{
    if (auto found = known_.find(writing); found != known_.end()) return found->second;
    if (known_.size() >= remembered) known_.clear();
    return known_[writing] = assets::outlines_of(writing, ui::inter_regular());
}

void Baking::follow(const Document& document, const Library& library)
{
    written_.clear();
    Writings(document, library).each([&](const Node& node, const std::string& contours, const Writing& writing) {
        written_[{node.id, contours}] = writing;
    });
}

void Baking::bake(Document& document, const Library& library)
{
    std::map<std::pair<graph::NodeId, std::string>, PointList> remade;
    Writings(document, library).each([&](const Node& node, const std::string& contours, const Writing& writing) {
        auto before = written_.find({node.id, contours});
        bool may_be_kept = before == written_.end() ? !graph::group_of(document, node) : before->second == writing;
        if (may_be_kept) return;
        const Outlines& baked = outlines(writing);
        if (baked.problem.empty()) remade[{node.id, contours}] = baked.contours;
    });
    if (!remade.empty())
        graph::for_each_graph(document, [&](graph::Graph& graph) {
            for (Node& node : graph.nodes)
                for (auto& [name, value] : node.parameters)
                    if (auto found = remade.find({node.id, name}); found != remade.end()) value = found->second;
        });
    follow(document, library);
}

std::vector<graph::Problem> Baking::notes(const Document& document, const Library& library)
{
    std::vector<graph::Problem> notes;
    Writings(document, library).each([&](const Node& node, const std::string&, const Writing& writing) {
        const std::string& problem = outlines(writing).problem;
        if (!problem.empty()) notes.push_back({node.id, problem, graph::Problem::Severity::note});
    });
    return notes;
}

}  // namespace fieldwright::app
