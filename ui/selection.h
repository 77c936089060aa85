// The selected nodes, in the order they were chosen; the last is the active one, which the inspector shows.
#pragma once

#include "graph/document.h"

#include <algorithm>
#include <set>
#include <vector>

namespace fieldwright::ui {

class Selection {
public:
    const std::vector<graph::NodeId>& nodes() const { return nodes_; }
    bool empty() const { return nodes_.empty(); }
    graph::NodeId active() const { return nodes_.empty() ? graph::NodeId{} : nodes_.back(); }
    bool contains(graph::NodeId id) const { return std::find(nodes_.begin(), nodes_.end(), id) != nodes_.end(); }
    std::set<graph::NodeId> as_set() const { return {nodes_.begin(), nodes_.end()}; }

    void clear() { nodes_.clear(); }
    void only(graph::NodeId id) { nodes_ = {id}; }
    void replace(std::vector<graph::NodeId> ids) { nodes_ = std::move(ids); }
    void add(graph::NodeId id)  // and makes it the active one
    {
        remove(id);
        nodes_.push_back(id);
    }
    void remove(graph::NodeId id) { std::erase(nodes_, id); }
    void toggle(graph::NodeId id) { contains(id) ? remove(id) : add(id); }
    // Forgets nodes that are no longer there (undo, delete).
    void keep_existing(const graph::Graph& graph)
    {
        std::erase_if(nodes_, [&](graph::NodeId id) { return !graph.find(id); });
    }

private:
    std::vector<graph::NodeId> nodes_;
};

}  // namespace fieldwright::ui
