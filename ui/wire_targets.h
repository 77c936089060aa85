// The pins that a wire in the hand may go to, found once when it is picked up.
#pragma once

#include "graph/compose.h"

#include <set>

namespace fieldwright::ui {

class WireTargets {
public:
    // `document`: without the wire that was taken off, if any. O((nodes + wires) log nodes) but for rare exact checks.
    WireTargets(graph::Document document, const graph::Library& library, graph::LooseEnd end);

    const graph::LooseEnd& end() const { return end_; }
    // `socket` is empty for the output of `node`.
    bool fits(graph::NodeId node, std::string_view socket) const;
    // Wires it. Refuses with the sentence that says why not.
    graph::Refusal connect(graph::Document& document, const graph::Library& library, graph::NodeId node,
                           std::string_view socket) const;
    // Why a pin is not one of them, and which pin of its node is, in one sentence.
    std::string reason(const graph::Library& library, graph::NodeId node, std::string_view socket) const;
    // Why no pin of a node is.
    std::string reason(const graph::Library& library, graph::NodeId node) const;

private:
    void find_inputs(const graph::Library& library);
    void find_outputs(const graph::Library& library);
    std::string fitting_input(const graph::NodeType& type, graph::NodeId node) const;

    graph::Document document_;
    graph::LooseEnd end_;
    std::set<std::pair<graph::NodeId, std::string>, std::less<>> fitting_;
};

}  // namespace fieldwright::ui
