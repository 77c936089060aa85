// Columns by longest way, order by barycentres, heights by what reads a node.
#include "graph/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fieldwright::graph {
namespace {

using Indices = std::vector<std::size_t>;

class Layering {
public:
    Layering(const Graph& graph, const std::set<NodeId>& nodes, const NodeSizes& size_px)
    {
        std::map<NodeId, std::size_t> index;
        for (const Node& node : graph.nodes) {
            if ((!nodes.empty() && !nodes.contains(node.id)) || !node.unknown_source.empty()) continue;
            index[node.id] = nodes_.size();
            nodes_.push_back(&node);
            sizes_.push_back(size_px(node.id));
        }
        sources_.resize(nodes_.size());
        readers_.resize(nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            for (const auto& [socket, source] : nodes_[i]->inputs)
                if (auto found = index.find(source); found != index.end()) {
                    sources_[i].push_back(found->second);
                    readers_[found->second].push_back(i);
                }
    }

    std::map<NodeId, glm::vec2> places()
    {
        std::map<NodeId, glm::vec2> result;
        if (nodes_.empty()) return result;
        assign_columns();
        assign_first_order();
        for (int sweep = 0; sweep < 4; ++sweep) sweep_columns(sweep % 2 == 0);
        assign_positions();
        glm::vec2 before = corner([&](std::size_t i) { return nodes_[i]->position; });
        glm::vec2 shift = before - corner([&](std::size_t i) { return positions_[i]; });
        for (std::size_t i = 0; i < nodes_.size(); ++i) result[nodes_[i]->id] = glm::round(positions_[i] + shift);
        return result;
    }

private:
    // A node's column is one behind that of its furthest reader.
    void assign_columns()
    {
        column_of_.assign(nodes_.size(), 0);
        Indices waiting(nodes_.size()), ready;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            waiting[i] = readers_[i].size();
            if (waiting[i] == 0) ready.push_back(i);
        }
        for (std::size_t done = 0; done < ready.size(); ++done)
            for (std::size_t source : sources_[ready[done]]) {
                column_of_[source] = std::max(column_of_[source], column_of_[ready[done]] + 1);
                if (--waiting[source] == 0) ready.push_back(source);
            }
        columns_.resize(*std::max_element(column_of_.begin(), column_of_.end()) + 1);
    }

    // From every end upwards, inputs in order; what is wired to nothing comes last.
    void assign_first_order()
    {
        Indices stack;
        std::vector<bool> seen(nodes_.size(), false);
        for (bool alone : {true, false})
            for (std::size_t i = nodes_.size(); i-- > 0;)
                if (readers_[i].empty() && sources_[i].empty() == alone) stack.push_back(i);
        while (!stack.empty()) {
            std::size_t i = stack.back();
            stack.pop_back();
            if (seen[i]) continue;
            seen[i] = true;
            columns_[column_of_[i]].push_back(i);
            stack.insert(stack.end(), sources_[i].rbegin(), sources_[i].rend());
        }
        rank_.resize(nodes_.size());
        for (const Indices& column : columns_) assign_ranks(column);
    }

    void assign_ranks(const Indices& column)
    {
        for (std::size_t rank = 0; rank < column.size(); ++rank) rank_[column[rank]] = static_cast<double>(rank);
    }

    void sweep_columns(bool away_from_output)
    {
        std::size_t count = columns_.size();
        for (std::size_t step = 1; step < count; ++step)
            sort_column(columns_[away_from_output ? step : count - 1 - step], away_from_output ? readers_ : sources_);
    }

    void sort_column(Indices& column, const std::vector<Indices>& neighbours)
    {
        std::vector<std::pair<double, std::size_t>> keyed;
        for (std::size_t i : column) keyed.emplace_back(mean(neighbours[i], rank_, rank_[i]), i);
        std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t rank = 0; rank < keyed.size(); ++rank) column[rank] = keyed[rank].second;
        assign_ranks(column);
    }

    static double mean(const Indices& of, const std::vector<double>& values, double otherwise)
    {
        if (of.empty()) return otherwise;
        double sum = 0;
        for (std::size_t i : of) sum += values[i];
        return sum / static_cast<double>(of.size());
    }

    void assign_positions()
    {
        positions_.resize(nodes_.size());
        centre_y_.assign(nodes_.size(), 0);
        float x = 0;
        for (const Indices& column : columns_) {
            float width = 0;
            for (std::size_t i : column) width = std::max(width, sizes_[i].x);
            x -= width;
            for (std::size_t i : column) positions_[i].x = x;
            x -= layout_gap_x_px;
            stack_column(column);
        }
    }

    // Each node at the height of its readers where those before it leave room; then the column as a whole.
    void stack_column(const Indices& column)
    {
        double bottom = -std::numeric_limits<double>::infinity(), off = 0;
        for (std::size_t i : column) {
            double height = sizes_[i].y;
            double wanted = mean(readers_[i], centre_y_, std::isfinite(bottom) ? bottom + 0.5 * height : 0);
            centre_y_[i] = std::max(wanted, bottom + 0.5 * height);
            off += wanted - centre_y_[i];
            bottom = centre_y_[i] + 0.5 * height + layout_gap_y_px;
        }
        off /= static_cast<double>(column.size());
        for (std::size_t i : column) {
            centre_y_[i] += off;
            positions_[i].y = static_cast<float>(centre_y_[i] - 0.5 * sizes_[i].y);
        }
    }

    template <typename Place>
    glm::vec2 corner(Place place) const
    {
        glm::vec2 least = place(0);
        for (std::size_t i = 1; i < nodes_.size(); ++i) least = glm::min(least, place(i));
        return least;
    }

    std::vector<const Node*> nodes_;
    std::vector<glm::vec2> sizes_;
    std::vector<Indices> sources_, readers_;  // within the selection
    Indices column_of_;                       // 0 at the right
    std::vector<Indices> columns_;            // from above to below
    std::vector<double> rank_;                // in the column
    std::vector<double> centre_y_;
    std::vector<glm::vec2> positions_;
};

}  // namespace

std::map<NodeId, glm::vec2> layout(const Graph& graph, const std::set<NodeId>& nodes, const NodeSizes& size_px)
{
    return Layering(graph, nodes, size_px).places();
}

bool lies_in_heaps(const Graph& graph)
{
    std::map<std::pair<float, float>, std::size_t> at;
    for (const Node& node : graph.nodes) ++at[{node.position.x, node.position.y}];
    std::size_t covered = 0;
    for (const auto& [place, count] : at) covered += count > 1 ? count : 0;
    return 2 * covered > graph.nodes.size();
}

Refusal arrange(Document& document, const std::set<NodeId>& nodes, const NodeSizes& size_px)
{
    for (NodeId id : nodes)
        if (!document.root.find(id)) return "there is no node " + std::to_string(id.number);
    std::map<NodeId, glm::vec2> places = layout(document.root, nodes, size_px);
    for (const auto& [id, position] : places)
        if (!std::isfinite(position.x) || !std::isfinite(position.y)) return "the nodes are too far out to be arranged";
    for (const auto& [id, position] : places) move_node(document, id, position);
    return std::nullopt;
}

}  // namespace fieldwright::graph
