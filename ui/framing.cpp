// Gathering the boxes that a view should show.
#include "ui/framing.h"

#include "ui/placement.h"

#include <algorithm>
#include <set>

namespace fieldwright::ui {
namespace {

constexpr float enough = 3;  // m, of what has no end

bool is_bounded(const Measured& box)
{
    return std::max({box.half_size.x, box.half_size.y, box.half_size.z}) < 0.5f * unbounded;
}

class Gathering {
public:
    explicit Gathering(const FrameContext& frame) : frame_(frame) {}

    // The node's box, or those of what it is made of when it has no end.
    void add(graph::NodeId id)
    {
        const graph::Node* node = frame_.draft.document.root.find(id);
        if (!node || !seen_.insert(id).second) return;
        std::optional<Measured> box = world_box(id);
        if (box && is_bounded(*box)) return join(*box);
        if (box && !endless_) endless_ = box;
        const graph::NodeType* type = frame_.draft.library.type(node->type);
        if (!type || !type->is_field()) return;
        for (const graph::Socket& socket : type->inputs)
            if (graph::NodeId source = node->input(socket.name)) add(source);
    }

    Measured box() const
    {
        if (low_) return {0.5f * (*low_ + high_), 0.5f * (high_ - *low_)};
        Measured box = endless_.value_or(Measured{{0, 0, 0}, glm::vec3(unbounded)});
        for (int axis = 0; axis < 3; ++axis) {
            if (box.half_size[axis] < 0.5f * unbounded) continue;
            box.half_size[axis] = enough;
            box.centre[axis] = 0;
        }
        return box;
    }

private:
    std::optional<Measured> world_box(graph::NodeId id) const
    {
        const graph::Document& document = frame_.draft.document;
        auto place = placement(document, frame_.draft.library, id);
        auto box = place && frame_.readings.bounds_of ? frame_.readings.bounds_of(id) : std::nullopt;
        if (!box) return std::nullopt;
        return placed(*place, *box);
    }

    void join(const Measured& box)
    {
        glm::vec3 low = box.centre - box.half_size, high = box.centre + box.half_size;
        high_ = low_ ? glm::max(high_, high) : high;
        low_ = low_ ? glm::min(*low_, low) : low;
    }

    const FrameContext& frame_;
    std::set<graph::NodeId> seen_;
    std::optional<glm::vec3> low_;
    glm::vec3 high_{0};
    std::optional<Measured> endless_;
};

}  // namespace

Measured box_to_frame(const FrameContext& frame, std::span<const graph::NodeId> nodes)
{
    Gathering gathering(frame);
    for (graph::NodeId node : nodes) gathering.add(node);
    if (nodes.empty())
        for (const graph::Node& node : frame.draft.document.root.nodes)
            if (node.type == "output") gathering.add(node.id);
    return gathering.box();
}

}  // namespace fieldwright::ui
