// Placing lamps by the eye.
#include "ui/lamp_place.h"

#include "graph/known_types.h"
#include "ui/scene_camera.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {

namespace known_types = graph::known_types;

namespace {

constexpr float alone_irradiance = 1, beside_irradiance = 0.3f;  // at the subject; 1 shows its own colour
constexpr float heights_away = 0.55f;                            // from the subject, in heights of what is seen

float rounded(float value, float unit) { return std::round(value / unit) * unit; }

// A power of ten that leaves two digits.
float unit_of(float value) { return std::pow(10.0f, std::floor(std::log10(std::max(value, 1e-3f))) - 1); }

bool gives_light(const graph::Node& node, const graph::Library& library)
{
    const graph::NodeType* type = library.type(node.type);
    return type && type->output == graph::SocketKind::light;
}

ViewCamera shown_eye(const FrameContext& frame)
{
    std::optional<SceneCamera> camera = frame.view.through_camera ? scene_camera(frame.draft.document) : std::nullopt;
    return camera ? camera->eye : frame.view.camera;
}

}  // namespace

void place_lamp(const FrameContext& frame, graph::Document& document, graph::NodeId id)
{
    const graph::Library& library = frame.draft.library;
    const graph::Node* node = document.root.find(id);
    if (!node || !gives_light(*node, library) || !node->parameter(known_types::light_position) ||
        !node->parameter(known_types::light_intensity))
        return;
    const auto& nodes = document.root.nodes;
    bool lit = std::any_of(nodes.begin(), nodes.end(), [&](const graph::Node& other) {
        return other.id != id && !other.muted && gives_light(other, library);
    });
    ViewCamera eye = shown_eye(frame);
    float away = std::clamp(heights_away * eye.height_at_pivot(), 0.01f, 500.0f), unit = unit_of(away);
    glm::vec3 way = glm::normalize(eye.backward() - 0.6f * eye.right() + glm::vec3(0, 0.9f, 0));
    glm::vec3 place = eye.pivot + away * way;
    for (int axis = 0; axis < 3; ++axis) place[axis] = std::clamp(rounded(place[axis], unit), -1000.0f, 1000.0f);
    float distance = glm::length(place - eye.pivot);
    float intensity = (lit ? beside_irradiance : alone_irradiance) * distance * distance;
    bool is_aimed = node->parameter(known_types::light_target);
    graph::set_parameter(document, library, id, known_types::light_position, place);
    if (is_aimed) graph::set_parameter(document, library, id, known_types::light_target, eye.pivot);
    graph::set_parameter(document, library, id, known_types::light_intensity, rounded(intensity, unit_of(intensity)));
}

}  // namespace fieldwright::ui
