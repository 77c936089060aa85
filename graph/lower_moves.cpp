// Lowering of moves: a chain of affine nodes whose numbers are the same at all points becomes one matrix, multiplied once
// per frame.
#include "graph/lowering.h"

#include <algorithm>

namespace fieldwright::graph {

bool Lowering::moves_affinely(int index)
{
    const NodeType& type = this->type(index);
    if (!type.affine || !type.compiled) return false;
    return std::none_of(type.parameters.begin(), type.parameters.end(), [&](const Parameter& parameter) {
        int source = index_of(node(index).input(parameter.name));
        return source >= 0 && types_[static_cast<std::size_t>(source)] && value_needs(source) != 0;
    });
}

// The point of a context, computed when it is first asked for: what lies between two affine nodes rarely is.
ValueId Lowering::point_of(Context context)
{
    std::vector<int> movers;
    Context before = context;
    while (contexts_[static_cast<std::size_t>(before)].point == no_value) {
        movers.push_back(contexts_[static_cast<std::size_t>(before)].mover);
        before = contexts_[static_cast<std::size_t>(before)].before;
    }
    if (movers.empty()) return contexts_[static_cast<std::size_t>(context)].point;
    std::reverse(movers.begin(), movers.end());
    // One node's own function is cheaper than a matrix.
    ValueId point = movers.size() == 1 ? node_call(movers[0], "point", before, {}) : moved_by_chain(before, movers);
    return contexts_[static_cast<std::size_t>(context)].point = point;
}

// Where the chain takes the origin and the unit vectors says where it takes every point.
ValueId Lowering::moved_by_chain(Context before, std::span<const int> movers)
{
    if (corners_[1] == no_value)
        for (int axis = 0; axis < 3; ++axis) {
            std::array lanes{0.0f, 0.0f, 0.0f};
            lanes[static_cast<std::size_t>(axis)] = 1;
            corners_[static_cast<std::size_t>(axis) + 1] = builder_.constant(ProgramBuilder::vec3_type(), lanes);
        }
    std::array<ValueId, 4> corners = corners_;
    for (int mover : movers)
        for (ValueId& corner : corners) corner = node_call(mover, "point", new_context(corner, origin_), {});
    for (std::size_t axis = 1; axis < 4; ++axis)
        corners[axis] = builder_.call("way_between", {corners[0], corners[axis]});
    ValueId point = point_argument(movers[0], ProgramBuilder::vec3_type(), before);
    return builder_.call("moved_point", {point, corners[0], corners[1], corners[2], corners[3]}, node(movers[0]).id);
}

}  // namespace fieldwright::graph
