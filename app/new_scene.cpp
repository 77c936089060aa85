// Builds the new scene in columns that read from left to right.
#include "app/new_scene.h"

#include "graph/edits.h"
#include "graph/settings.h"

#include <array>
#include <cassert>

namespace fieldwright::app {
namespace {

using graph::NodeId;

constexpr float column_width_px = 240, row_px = 24, header_px = 28, gap_px = 32;

class NewScene {
public:
    explicit NewScene(const graph::Library& library) : library_(library) {}

    graph::Document build()
    {
        graph::set_bounces(document_, graph::bounces_of_new_scenes);
        NodeId solid = place(0, "rounded_box", "Block");
        NodeId hollow = place(0, "sphere", "Hollow");
        NodeId pearl = place(0, "sphere", "Pearl");
        NodeId pearly = place(0, "phong", "Ivory");
        NodeId carved = place(1, "smooth_subtract", "Carve");
        NodeId glaze = place(1, "phong", "Glaze");
        NodeId painted_pearl = place(1, "paint", "Paint pearl");
        NodeId painted_solid = place(2, "paint", "Paint block");
        NodeId floor = place(3, "plane", "Ground");
        NodeId chalk = place(3, "phong", "Chalk");
        NodeId both = place(3, "union", "Block and pearl");
        NodeId turned = place(4, "rotate", "Turn");
        NodeId raised = place(5, "translate", "Stand on ground");
        NodeId painted_floor = place(4, "paint", "Paint ground");
        NodeId everything = place(6, "union", "Everything");
        NodeId camera = place(6, "perspective", "Camera");
        NodeId sky = place(6, "gradient", "Sky");
        NodeId sun = place(7, "sun", "Sun");
        NodeId output = place(7, "output", "Output");
        set(solid, "half_size", glm::vec3(0.8f));
        set(solid, "rounding", 0.1f);
        set(hollow, "radius", 0.95f);
        set(carved, "smoothness", 0.12f);
        set(pearl, "radius", 0.5f);
        set(glaze, "albedo", glm::vec3(0.74f, 0.20f, 0.085f));
        set(glaze, "specular", 0.35f);
        set(glaze, "shininess", 60.0f);
        set(pearly, "albedo", glm::vec3(0.85f, 0.72f, 0.48f));
        set(pearly, "specular", 0.6f);
        set(pearly, "shininess", 90.0f);
        set(chalk, "albedo", glm::vec3(0.42f, 0.48f, 0.55f));
        set(chalk, "specular", 0.0f);
        set(turned, "angles", glm::vec3(0, 20, 0));
        set(raised, "offset", glm::vec3(0, 0.8f, 0));
        set(camera, "position", glm::vec3(3.9f, 2.6f, 5.2f));
        set(camera, "target", glm::vec3(0.3f, 0.74f, 0));
        set(camera, "field_of_view", 26.0f);
        set(sky, "zenith", glm::vec3(0.30f, 0.44f, 0.66f));
        set(sky, "horizon", glm::vec3(0.43f, 0.47f, 0.52f));
        set(sky, "strength", 0.8f);
        set(sun, "elevation", 36.0f);
        set(sun, "azimuth", -22.0f);
        wire(solid, carved, "a");
        wire(hollow, carved, "b");
        wire(carved, painted_solid, "d");
        wire(glaze, painted_solid, "material");
        wire(pearl, painted_pearl, "d");
        wire(pearly, painted_pearl, "material");
        wire(painted_solid, both, "a");
        wire(painted_pearl, both, "b");
        wire(both, turned, "d");
        wire(turned, raised, "d");
        wire(floor, painted_floor, "d");
        wire(chalk, painted_floor, "material");
        wire(raised, everything, "a");
        wire(painted_floor, everything, "b");
        wire(everything, output, "d");
        wire(camera, output, "camera");
        wire(sky, output, "sky");
        return std::move(document_);
    }

private:
    NodeId place(std::size_t column, const char* type, const char* name)
    {
        float& y = column_bottom_px_[column];
        NodeId node = graph::add_node(document_, library_, type, {column_width_px * static_cast<float>(column), y});
        if (!node) return node;
        graph::rename_node(document_, node, name);
        y += height_px(*library_.type(type)) + gap_px;
        return node;
    }

    // Rows: the output, inputs, and parameters that are no inputs.
    static float height_px(const graph::NodeType& type)
    {
        std::size_t rows = type.inputs.size() + 1;
        for (const graph::Parameter& parameter : type.parameters) rows += type.input(parameter.name) ? 0 : 1;
        return header_px + row_px * static_cast<float>(rows);
    }

    void wire(NodeId source, NodeId target, const char* socket)
    {
        if (source && target) graph::connect(document_, library_, source, target, socket);
    }

    void set(NodeId node, const char* parameter, graph::Value value)
    {
        if (node) graph::set_parameter(document_, library_, node, parameter, std::move(value));
    }

    const graph::Library& library_;
    graph::Document document_;
    std::array<float, 8> column_bottom_px_{};
};

}  // namespace

graph::Document new_scene(const graph::Library& library) { return NewScene(library).build(); }

}  // namespace fieldwright::app
