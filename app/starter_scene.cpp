// Wires a node of any type into a scene that shows it: a subject, an output, a camera, a sky and a sun.
#include "app/starter_scene.h"

#include "field/evaluator.h"
#include "graph/layout.h"
#include "graph/program.h"
#include "graph/settings.h"
#include "ui/node_geometry.h"

#include <algorithm>
#include <array>

namespace fieldwright::app {

using graph::Node;
using graph::NodeId;
using graph::NodeType;
using graph::SocketKind;

namespace {

constexpr glm::vec3 warm_albedo{0.80f, 0.33f, 0.12f};
constexpr int shown_inputs = 3;

bool is_field(SocketKind kind)
{
    return kind == SocketKind::field2d || kind == SocketKind::field3d || kind == SocketKind::field_any;
}

void require(const graph::Refusal& refusal)
{
    if (refusal) throw graph::Failure(1, "the small scene cannot be built: " + *refusal);
}

}  // namespace

StarterScene::StarterScene(std::shared_ptr<const graph::Library> library, const NodeType& type)
    : library_(std::move(library)), type_(type)
{
    require(graph::set_bounces(document, graph::bounces_of_new_scenes));
    shown_ = place(type.name);
    NodeId root = subject();
    output_ = type.category == "output" ? shown_ : place("output");
    camera_ = type.output == SocketKind::camera ? shown_ : place("perspective");
    NodeId sky = type.output == SocketKind::sky ? shown_ : place("gradient");
    if (sky != shown_) set(sky, "strength", 0.7f);
    // The camera stands to the right: light from the left gives the subject a lit and a shaded side.
    if (type.output != SocketKind::light) set(place("sun"), "azimuth", -35.0f);
    wire(root, output_, "d");
    wire(camera_, output_, "camera");
    wire(sky, output_, "sky");
}

void StarterScene::compose()
{
    if (ball_) keep_visible();
    if (camera_ != shown_) aim_camera();
    lay_out();
}

NodeId StarterScene::place(std::string_view type)
{
    NodeId node = graph::add_node(document, *library_, type);
    if (!node)
        throw graph::Failure(1, "the library has no node `" + std::string(type) + "`, which a small scene needs");
    return node;
}

void StarterScene::wire(NodeId source, NodeId target, std::string_view socket)
{
    require(graph::connect(document, *library_, source, target, socket));
}

void StarterScene::wire_first(NodeId source, NodeId target, SocketKind kind)
{
    for (const graph::Socket& socket : library_->type(document.root.find(target)->type)->inputs)
        if (socket.kind == kind) return wire(source, target, socket.name);
}

void StarterScene::set(NodeId node, std::string_view parameter, graph::Value value)
{
    require(graph::set_parameter(document, *library_, node, parameter, std::move(value)));
}

// A new node of `type` that takes the source as its field.
NodeId StarterScene::over(std::string_view type, NodeId source)
{
    NodeId node = place(type);
    wire(source, node, "d");
    return node;
}

// The 3D field that shows the node.
NodeId StarterScene::subject()
{
    if (type_.category == "output") return still_life();
    fill_inputs();
    switch (type_.output) {
        case SocketKind::field3d:
        case SocketKind::field_any: return shown_;
        case SocketKind::field2d: return over("extrude", shown_);
        case SocketKind::number:
        case SocketKind::vec2:
        case SocketKind::vec3: return measured();
        case SocketKind::material: return painted(shown_);
        default: return still_life();
    }
}

// A ball on a floor, for what only shows on something: lights, cameras, skies.
NodeId StarterScene::still_life()
{
    NodeId material = place("phong"), both = place("union"), floor = place("plane");
    set(material, "albedo", warm_albedo);
    set(floor, "height", -1.0f);
    wire(painted(material), both, "a");
    wire(floor, both, "b");
    return both;
}

NodeId StarterScene::painted(NodeId material)
{
    NodeId paint = over("paint", place("sphere"));
    wire(material, paint, "material");
    return paint;
}

// A value at work: a number is a ball's radius, a pair a plate's size, a triple a ball's colour.
NodeId StarterScene::measured()
{
    if (type_.output == SocketKind::vec2) {
        NodeId plate = place("rectangle");
        wire_first(shown_, plate, SocketKind::vec2);
        return over("extrude", plate);
    }
    if (type_.output == SocketKind::number) {
        ball_ = place("sphere");
        wire(shown_, ball_, "radius");
        return ball_;
    }
    NodeId material = place("phong");
    wire_first(shown_, material, SocketKind::colour);
    return painted(material);
}

// Something different at every field input, of many at the first few, and a colour at a material's.
void StarterScene::fill_inputs()
{
    int fields = 0;
    for (const graph::Socket& socket : type_.inputs) {
        if (is_field(socket.kind) && fields < shown_inputs) wire(companion(socket.kind, fields++), shown_, socket.name);
        if (socket.kind != SocketKind::material) continue;
        NodeId material = place("phong");
        set(material, "albedo", warm_albedo);
        wire(material, shown_, socket.name);
    }
}

NodeId StarterScene::companion(SocketKind kind, int index)
{
    if (kind == SocketKind::field2d) return place(index == 0 ? "rectangle" : "circle");
    if (index == 0) return place("box");
    NodeId ball = place("sphere"), moved = over("translate", ball);
    set(ball, "radius", 0.5f);
    set(moved, "offset", index % 2 == 1 ? glm::vec3(0.4f, 0.4f, 0.4f) : glm::vec3(-0.4f, -0.4f, 0.6f));
    return moved;
}

// A number too small for a radius, such as the time at the start, changes a radius instead of being it.
void StarterScene::keep_visible()
{
    graph::Program program = graph::lower(document, library_);
    if (program.gpu_only) return;
    std::vector<float> block = field::evaluate_frame(program, 0);
    float radius = -field::distances(program, block, std::array{glm::vec3(0.0f)}).front();
    if (radius > 0.1f) return;
    NodeId scaled = place("multiply_add");
    set(scaled, "factor", 0.25f);
    set(scaled, "addend", 1.0f);
    require(graph::disconnect(document, ball_, "radius"));
    wire(shown_, scaled, "x");
    wire(scaled, ball_, "radius");
}

// Far enough away to see the subject's bounds; what has none is seen from where a unit ball would be.
void StarterScene::aim_camera()
{
    graph::LowerOptions options;
    options.bounds = true;
    graph::Program program = graph::lower(document, library_, options);
    glm::vec3 centre(0.0f), half_size(1.0f);
    std::int32_t slot = program.bounds < 0 ? -1 : program.values[static_cast<std::size_t>(program.bounds)].slot;
    if (slot >= 0) {
        std::vector<float> block = field::evaluate_frame(program, 0);
        const float* box = &block[static_cast<std::size_t>(slot)];
        glm::vec3 found(box[3], box[4], box[5]);
        if (std::max({found.x, found.y, found.z}) < 30.0f) centre = {box[0], box[1], box[2]}, half_size = found;
    }
    float reach = std::max(glm::length(half_size), 0.05f);
    set(camera_, "position", centre + 2.4f * reach * glm::normalize(glm::vec3(0.55f, 0.42f, 0.85f)));
    set(camera_, "target", centre);
}

// Columns by the longest way to the output, rows in the order of making.
void StarterScene::lay_out()
{
    auto size_px = [&](NodeId id) {
        const Node& node = *document.root.find(id);
        return ui::node_size(node, library_->type(node.type));
    };
    require(graph::arrange(document, {}, size_px));
}

}  // namespace fieldwright::app
