// Reading a camera node.
#include "ui/scene_camera.h"

#include "graph/groups.h"
#include "graph/known_types.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float widest_view_rad = 2.6f;  // that a view without a bent projection takes over

template <typename T>
const T* stored(const graph::Node& node, std::string_view name)
{
    const graph::Value* value = node.parameter(name);
    return value ? std::get_if<T>(value) : nullptr;
}

const graph::Node* camera_node(const graph::Graph& graph)
{
    for (const graph::Node& node : graph.nodes)
        if (node.type == "output") return graph.find(node.input("camera"));
    return nullptr;
}

}  // namespace

std::optional<SceneCamera> scene_camera(const graph::Document& document)
{
    const graph::Node* node = camera_node(graph::scene_graph(document));
    if (!node || node->muted) return std::nullopt;
    const auto *position = stored<glm::vec3>(*node, "position"), *target = stored<glm::vec3>(*node, "target");
    const auto *angle_deg = stored<float>(*node, "field_of_view"), *height = stored<float>(*node, "height");
    if (!position || !target || (!angle_deg && !height)) return std::nullopt;
    SceneCamera camera{ViewCamera::seen_from(*position, *target), !node->inputs.empty()};
    camera.eye.orthographic = height != nullptr;
    camera.eye.field_of_view_rad =
        height ? 2 * std::atan(0.5f * *height / camera.eye.distance) : glm::radians(*angle_deg);
    camera.eye.rays_from = camera.eye.distance;
    camera.bent = node->type != graph::known_types::perspective && node->type != graph::known_types::orthographic;
    if (camera.bent) camera.eye.field_of_view_rad = std::min(camera.eye.field_of_view_rad, widest_view_rad);
    return camera;
}

}  // namespace fieldwright::ui
