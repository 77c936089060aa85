// The outdoor rig: sun, sky and occlusion.
#include "graph/light_rig.h"

#include "graph/known_types.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

constexpr float row_px = 220;  // from the sky down to the sun

NodeId shining_sun(const Document& document)
{
    const auto& nodes = document.root.nodes;
    auto found = std::find_if(nodes.begin(), nodes.end(),
                              [](const Node& node) { return node.type == known_types::sun && !node.muted; });
    return found == nodes.end() ? NodeId{} : found->id;
}

// The first reason of any stays.
class Attempt {
public:
    void note(const Refusal& refusal)
    {
        if (!refusal_) refusal_ = refusal;
    }
    NodeId note(const Placed& placed)
    {
        note(placed.refusal);
        return placed.node;
    }
    const Refusal& refusal() const { return refusal_; }

private:
    Refusal refusal_;
};

}  // namespace

Placed add_outdoor_light(Document& document, const Library& library, glm::vec2 position)
{
    Document lit = document;
    Attempt attempt;
    NodeId sky = attempt.note(add_to_output(lit, library, known_types::sun_and_sky, position));
    NodeId sun = shining_sun(lit);
    if (!sun && !attempt.refusal())
        sun = attempt.note(add_alone(lit, library, known_types::sun, position + glm::vec2(0, row_px)));
    if (attempt.refusal()) return {NodeId{}, attempt.refusal()};
    for (std::string_view angle : {known_types::sun_elevation, known_types::sun_azimuth})
        attempt.note(set_parameter(lit, library, sky, angle, *lit.root.find(sun)->parameter(angle)));
    attempt.note(set_parameter(lit, library, sun, known_types::light_shadow, std::string("soft_corrected")));
    OcclusionSettings occlusion = lit.occlusion;
    if (occlusion.strength == 0) occlusion.strength = OcclusionSettings{}.strength;
    attempt.note(set_occlusion(lit, occlusion));
    if (attempt.refusal()) return {NodeId{}, attempt.refusal()};
    document = std::move(lit);
    return {sky, std::nullopt};
}

}  // namespace fieldwright::graph
