// csg(N), the scene that benchmarks draw: N spheres, rounded boxes and capped cylinders on a jittered lattice under a
// balanced tree of combiners, one third of them smooth unions, some differences; as a list and as a document.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <numeric>
#include <span>

namespace fieldwright::bench {

enum class Shape { sphere, rounded_box, cylinder };
enum class Combiner { unite, smooth_unite, subtract };

struct Placed {
    Shape shape;
    glm::vec3 centre;     // m
    glm::vec3 half_size;  // m; sphere: radius in x; cylinder: radius in x, half its height in y
    float rounding = 0;   // m, of a rounded box
};

// Operands count the shapes first, then the combinations.
struct Combination {
    Combiner combiner;
    int a, b;
    float smoothness = 0;  // m, of a smooth union
};

struct CsgScene {
    std::vector<Placed> shapes;
    std::vector<Combination> combinations;  // operands before their users; the last one is the scene
    glm::vec3 eye{0, 0, 0};                 // m; looks at the origin
};

// The same numbers on every machine.
class Dice {
public:
    float between(float low, float high)
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * static_cast<float>(state_ >> 40) / 16777216.0f;
    }

private:
    std::uint64_t state_ = 2024;
};

inline Placed placed_shape(Dice& dice, Shape shape, glm::vec3 centre)
{
    for (int axis = 0; axis < 3; ++axis) centre[axis] += dice.between(-0.2f, 0.2f);
    Placed placed{shape, centre, {dice.between(0.3f, 0.5f), dice.between(0.25f, 0.5f), dice.between(0.25f, 0.5f)}};
    if (shape == Shape::rounded_box) placed.rounding = dice.between(0.02f, 0.1f);
    return placed;
}

// Halves the shapes along their longest extent, so that what is combined is near.
inline int combine(CsgScene& scene, Dice& dice, std::span<int> indices)
{
    if (indices.size() == 1) return indices[0];
    glm::vec3 low(1e6f), high(-1e6f);
    for (int index : indices) {
        const glm::vec3& centre = scene.shapes[static_cast<std::size_t>(index)].centre;
        low = glm::min(low, centre);
        high = glm::max(high, centre);
    }
    glm::vec3 extent = high - low;
    int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    auto along_axis = [&](int index) { return scene.shapes[static_cast<std::size_t>(index)].centre[axis]; };
    std::sort(indices.begin(), indices.end(), [&](int a, int b) { return along_axis(a) < along_axis(b); });
    int a = combine(scene, dice, indices.first(indices.size() / 2));
    int b = combine(scene, dice, indices.subspan(indices.size() / 2));
    float draw = dice.between(0, 1);
    Combiner combiner = draw < 1.0f / 3.0f ? Combiner::smooth_unite : Combiner::unite;
    if (indices.size() == 2 && draw > 0.8f) combiner = Combiner::subtract;
    scene.combinations.push_back(
        {combiner, a, b, combiner == Combiner::smooth_unite ? dice.between(0.1f, 0.25f) : 0.0f});
    return static_cast<int>(scene.shapes.size() + scene.combinations.size()) - 1;
}

inline CsgScene csg_scene(int count)
{
    CsgScene scene;
    Dice dice;
    int side = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(count))));
    float middle = 0.5f * static_cast<float>(side - 1);
    for (int i = 0; i < count; ++i) {
        glm::vec3 cell(i % side, i / (side * side), i / side % side);
        scene.shapes.push_back(placed_shape(dice, static_cast<Shape>(i % 3), cell - middle));
    }
    std::vector<int> indices(static_cast<std::size_t>(count));
    std::iota(indices.begin(), indices.end(), 0);
    combine(scene, dice, indices);
    scene.eye = static_cast<float>(side) * glm::vec3(0.9f, 0.7f, 1.35f);
    return scene;
}

// Grows a document node by node: ids in sequence, parameters by the library's defaults.
class SceneWriter {
public:
    explicit SceneWriter(std::shared_ptr<const graph::Library> library) : library_(std::move(library)) {}

    using Settings = std::initializer_list<std::pair<const char*, graph::Value>>;
    using Wires = std::initializer_list<std::pair<const char*, graph::NodeId>>;  // sorted by name

    graph::NodeId add(const char* type_name, const Settings& settings, const Wires& wires = {})
    {
        const graph::NodeType* type = library_->type(type_name);
        if (!type) throw graph::Failure(1, std::string("the benchmark's scene needs the node type ") + type_name);
        graph::Node node;
        node.id = {document_.next_id++};
        node.type = type_name;
        for (const graph::Parameter& parameter : type->parameters)
            if (parameter.value_index >= 0) node.parameters.emplace_back(parameter.name, parameter.initial);
        for (const auto& [name, value] : settings) set(node, name, value);
        node.inputs.assign(wires.begin(), wires.end());
        document_.root.nodes.push_back(std::move(node));
        return document_.root.nodes.back().id;
    }

    graph::Document finish() { return std::move(document_); }

private:
    static void set(graph::Node& node, std::string_view name, const graph::Value& value)
    {
        for (auto& [known, stored] : node.parameters) {
            if (known != name) continue;
            stored = value;
            return;
        }
        throw graph::Failure(1, "the node type " + node.type + " has no parameter " + std::string(name));
    }

    std::shared_ptr<const graph::Library> library_;
    graph::Document document_;
};

inline graph::NodeId add_shape(SceneWriter& writer, const Placed& placed)
{
    graph::NodeId shape;
    switch (placed.shape) {
        case Shape::sphere: shape = writer.add("sphere", {{"radius", placed.half_size.x}}); break;
        case Shape::rounded_box:
            shape = writer.add("rounded_box", {{"half_size", placed.half_size}, {"rounding", placed.rounding}});
            break;
        case Shape::cylinder:
            shape = writer.add("cylinder", {{"radius", placed.half_size.x}, {"height", 2.0f * placed.half_size.y}});
            break;
    }
    return writer.add("translate", {{"offset", placed.centre}}, {{"d", shape}});
}

inline graph::NodeId add_combination(SceneWriter& writer, const Combination& combination, graph::NodeId a,
                                     graph::NodeId b)
{
    switch (combination.combiner) {
        case Combiner::unite: return writer.add("union", {}, {{"a", a}, {"b", b}});
        case Combiner::smooth_unite:
            return writer.add("smooth_union", {{"smoothness", combination.smoothness}}, {{"a", a}, {"b", b}});
        case Combiner::subtract: break;
    }
    return writer.add("subtract", {}, {{"a", a}, {"b", b}});
}

// A shape and its translation are added one after the other, from 1 on.
inline int shape_node_id(int shape) { return 2 * shape + 1; }

// Combines the shapes, and adds what every scene has.
inline graph::Document combined(SceneWriter& writer, const CsgScene& scene, std::vector<graph::NodeId> operands)
{
    for (const Combination& combination : scene.combinations) {
        graph::NodeId a = operands[static_cast<std::size_t>(combination.a)];
        graph::NodeId b = operands[static_cast<std::size_t>(combination.b)];
        operands.push_back(add_combination(writer, combination, a, b));
    }
    writer.add("sun", {{"shadow", std::string("hard")}});
    graph::NodeId camera = writer.add("perspective", {{"position", scene.eye}, {"target", glm::vec3(0.0f)}});
    graph::NodeId sky = writer.add("gradient", {});
    writer.add("output", {}, {{"camera", camera}, {"d", operands.back()}, {"sky", sky}});
    return writer.finish();
}

inline graph::Document csg_document(const CsgScene& scene, const std::shared_ptr<const graph::Library>& library)
{
    SceneWriter writer(library);
    std::vector<graph::NodeId> operands;
    for (const Placed& placed : scene.shapes) operands.push_back(add_shape(writer, placed));
    return combined(writer, scene, std::move(operands));
}

// Every other shape is a mirror, the rest is glass: rays go on wherever they arrive, as often as they may.
inline graph::Document csg_of_glass(const CsgScene& scene, int bounces,
                                    const std::shared_ptr<const graph::Library>& library)
{
    SceneWriter writer(library);
    graph::NodeId materials[] = {writer.add("glass", {{"depth", 4.0f}}),
                                 writer.add("metallic_roughness", {{"roughness", 0.05f}})};
    std::vector<graph::NodeId> operands;
    for (const Placed& placed : scene.shapes) {
        graph::NodeId material = materials[operands.size() % 2];
        operands.push_back(writer.add("paint", {}, {{"d", add_shape(writer, placed)}, {"material", material}}));
    }
    graph::Document document = combined(writer, scene, std::move(operands));
    document.bounces = bounces;
    return document;
}

}  // namespace fieldwright::bench
