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
using graph::Library;
using graph::Node;
using graph::NodeType;

constexpr std::size_t remembered = 64;  // writings whose outlines are kept at hand

const graph::Parameter* contours_of(const NodeType* type)
{
    if (!type || !type->parameter("text")) return nullptr;
    for (const graph::Parameter& parameter : type->parameters)
        if (parameter.kind == graph::ParameterKind::list && parameter.unit == graph::contour_unit) return &parameter;
    return nullptr;
}

Writing writing_of(const Node& node)
{
    Writing writing;
    auto read = [&](const char* name, auto& into) {
        using T = std::remove_reference_t<decltype(into)>;
        const graph::Value* value = node.parameter(name);
        if (const T* held = value ? std::get_if<T>(value) : nullptr) into = *held;
    };
    read("text", writing.text);
    read("font", writing.font);
    read("letter_spacing", writing.letter_spacing);
    read("line_spacing", writing.line_spacing);
    read("alignment", writing.alignment);
    return writing;
}

template <typename Visit>
void each_text(const Document& document, const Library& library, const Visit& visit)
{
    graph::for_each_graph(document, [&](const graph::Graph& graph) {
        for (const Node& node : graph.nodes)
            if (const graph::Parameter* contours = contours_of(library.type(node.type))) visit(node, *contours);
    });
}

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
    each_text(document, library,
              [&](const Node& node, const graph::Parameter&) { written_[node.id] = writing_of(node); });
}

void Baking::bake(Document& document, const Library& library)
{
    graph::for_each_graph(document, [&](graph::Graph& graph) {
        for (Node& node : graph.nodes) {
            const graph::Parameter* contours = contours_of(library.type(node.type));
            auto before = written_.find(node.id);
            if (!contours || before == written_.end() || before->second == writing_of(node)) continue;
            const Outlines& baked = outlines(writing_of(node));
            if (!baked.problem.empty()) continue;
            for (auto& [name, value] : node.parameters)
                if (name == contours->name) value = baked.contours;
        }
    });
    follow(document, library);
}

std::vector<graph::Problem> Baking::notes(const Document& document, const Library& library)
{
    std::vector<graph::Problem> notes;
    each_text(document, library, [&](const Node& node, const graph::Parameter&) {
        const std::string& problem = outlines(writing_of(node)).problem;
        if (!problem.empty()) notes.push_back({node.id, problem, graph::Problem::Severity::note});
    });
    return notes;
}

}  // namespace fieldwright::app
