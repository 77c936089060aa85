// Steps on groups.
#include "ui/group_actions.h"

#include "ui/widgets.h"

#include "graph/expansion.h"
#include "graph/group_edits.h"

namespace fieldwright::ui {

using graph::NodeId;

namespace {

const graph::Group* active_group(const FrameContext& frame)
{
    const graph::Node* node = frame.draft.document.root.find(frame.view.selection.active());
    return node ? graph::group_of(frame.draft.document, *node) : nullptr;
}

}  // namespace

std::string shown_group(const graph::Document& document, ViewState& view)
{
    const graph::Graph* graph = &document.root;
    std::string name;
    for (std::size_t i = 0; i < view.way.size(); ++i) {
        const graph::Node* node = graph->find(view.way[i].node);
        const graph::Group* group = node ? graph::group_of(document, *node) : nullptr;
        if (!group) {
            view.canvas = view.way[i].around;
            view.way.resize(i);
            break;
        }
        name = group->name;
        graph = &group->graph;
    }
    return name;
}

void close_groups(ViewState& view)
{
    if (!view.way.empty()) view.canvas = view.way.front().around;
    view.way.clear();
}

std::vector<graph::Problem> shown_problems(std::vector<graph::Problem> problems, const graph::Graph& shown)
{
    for (graph::Problem& problem : problems) {
        std::vector<NodeId> path = {problem.node};
        path.insert(path.end(), problem.inside.begin(), problem.inside.end());
        if (NodeId node = graph::shown_on(path, shown)) problem.node = node;
    }
    return problems;
}

void group_selected(FrameContext& frame)
{
    graph::Placed placed = graph::group_nodes(frame.draft.document, frame.draft.library, frame.view.selection.as_set());
    if (frame.draft.done("Group", placed.refusal)) frame.view.selection.only(placed.node);
}

void ungroup_active(FrameContext& frame)
{
    graph::Pasted inner = graph::ungroup(frame.draft.document, frame.view.selection.active());
    if (frame.draft.done("Ungroup", inner.refusal)) frame.view.selection.replace(std::move(inner.nodes));
}

void make_active_unique(FrameContext& frame)
{
    frame.draft.done("Make group unique",
                     graph::make_group_unique(frame.draft.document, frame.view.selection.active()).refusal);
}

void use_as_output(FrameContext& frame, NodeId node)
{
    std::string group = frame.draft.document.entered;
    frame.draft.done("Use as group's result",
                     graph::set_group_output(frame.draft.document, frame.draft.library, group, node));
}

void save_active_group(FrameContext& frame)
{
    graph::Document& document = frame.draft.document;
    const graph::Group* group = active_group(frame);
    std::string name = group ? group->name : document.entered;
    graph::AtRest scene(document);
    frame.requests.push_back(SaveGroup{name, graph::saved_group_text(document, frame.draft.library, name)});
}

void delete_unused_groups(FrameContext& frame)
{
    graph::AtRest scene(frame.draft.document);
    graph::Document& document = frame.draft.document;
    std::size_t before = document.groups.size();
    for (bool again = true; again;) {
        again = false;
        for (const graph::Group& group : document.groups)
            if (!graph::uses_of(document, group.name)) {
                again = !graph::delete_group(document, std::string(group.name));
                break;
            }
    }
    if (document.groups.size() == before) frame.draft.refusal = "Every group of this scene is in use.";
    else frame.draft.step = "Delete unused groups";
}

bool is_group(const Draft& draft, NodeId id)
{
    const graph::Node* node = draft.document.root.find(id);
    return node && graph::group_of(draft.document, *node);
}

}  // namespace fieldwright::ui
