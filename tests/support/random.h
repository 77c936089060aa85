// Random numbers that are the same everywhere, random values of parameters and random valid documents.
#pragma once

#include "tests/support/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldwright::tests {

// SplitMix64 (Steele, Lea, Flood 2014): tiny, and equal on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits()
    {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    float unit() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }  // [0, 1)
    float between(float low, float high) { return low + (high - low) * unit(); }
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
    bool chance(float probability) { return unit() < probability; }
    glm::vec3 in_cube(float half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    glm::vec3 direction()
    {
        while (true) {
            glm::vec3 v = in_cube(1);
            if (float length = glm::length(v); length > 0.1f && length <= 1) return v / length;
        }
    }
    template <typename T>
    const T& pick(const std::vector<T>& from)
    {
        return from[static_cast<std::size_t>(below(static_cast<int>(from.size())))];
    }

private:
    std::uint64_t state_;
};

// Within the soft range, and not so far from the default that single precision is the only thing tested.
inline float random_component(Random& random, const graph::Parameter& parameter, float initial)
{
    bool angle = parameter.kind == graph::ParameterKind::angle || parameter.kind == graph::ParameterKind::angles;
    double reach = angle ? 180 : std::max(2.0, 3 * std::abs(static_cast<double>(initial)));
    auto low = static_cast<float>(std::max(parameter.soft_minimum, initial - reach));
    auto high = static_cast<float>(std::min(parameter.soft_maximum, initial + reach));
    return std::clamp(random.between(low, high), static_cast<float>(parameter.minimum),
                      static_cast<float>(parameter.maximum));
}

inline std::string random_words(Random& random, const graph::Parameter& parameter)
{
    static const std::vector<std::string> texts = {"", "Ag", "a \"b\" \\ */ #define",
                                                   "Gr\u00fc\u00dfe\n\u03b1\u03b2 \U0001f600"};
    static const std::vector<std::string> formulas = {"x", "0.5", "sin(3 * x) * cos(y - z) + time", "x^2 + y^2 - z",
                                                      "max(abs(x), y) / (z^2 + 1) - 0.7"};
    if (parameter.kind == graph::ParameterKind::image) return {};  // no file
    if (parameter.kind == graph::ParameterKind::text) return random.pick(texts);
    return random.pick(parameter.kind == graph::ParameterKind::formula ? formulas : parameter.choices);
}

inline graph::Value random_value(Random& random, const graph::Parameter& parameter)
{
    auto component = [&](float initial) { return random_component(random, parameter, initial); };
    graph::Value value = parameter.initial;
    if (auto* flag = std::get_if<bool>(&value)) *flag = random.chance(0.5f);
    else if (auto* number = std::get_if<float>(&value)) *number = component(*number);
    else if (auto* pair = std::get_if<glm::vec2>(&value)) *pair = {component(pair->x), component(pair->y)};
    else if (auto* triple = std::get_if<glm::vec3>(&value))
        *triple = {component(triple->x), component(triple->y), component(triple->z)};
    else if (auto* word = std::get_if<std::string>(&value)) *word = random_words(random, parameter);
    else if (auto* whole = std::get_if<int>(&value)) {
        auto low = static_cast<int>(std::max(parameter.soft_minimum, *whole - 4.0));
        auto high = static_cast<int>(std::min(parameter.soft_maximum, *whole + 4.0));
        *whole = low + random.below(high - low + 1);
    } else if (auto* points = std::get_if<graph::PointList>(&value)) {
        points->clear();
        for (int count = 3 + random.below(5); count > 0; --count)
            points->emplace_back(random.between(-1.5f, 1.5f), random.between(-1.5f, 1.5f), 0.0f, 0.0f);
    }
    return value;
}

inline void set_random_parameters(Random& random, Scene& scene, NodeId id)
{
    for (const graph::Parameter& parameter : scene.type(id).parameters)
        if (parameter.kind != graph::ParameterKind::material)
            scene.set(id, parameter.name, random_value(random, parameter));
}

// Grows one document from its output downwards.
class RandomGraph {
public:
    RandomGraph(std::uint64_t seed, std::shared_ptr<const graph::Library> library, int node_limit = 25)
        : scene_(std::move(library)), random_(seed), node_limit_(4 + random_.below(node_limit - 3))
    {
        NodeId output = scene_.show(field(3, 6));
        wire_others(output);
        for (int count = random_.below(4); count > 0; --count) leaf_of(graph::SocketKind::light);
        scene_.document.root.find(output)->name = "*/ #define float vec3";
    }

    Scene take() { return std::move(scene_); }

private:
    using Types = std::vector<const graph::NodeType*>;

    bool room() const { return static_cast<int>(scene_.document.root.nodes.size()) < node_limit_; }

    static bool gives(const graph::NodeType& type, int dimension)
    {
        return type.output == graph::SocketKind::field_any ||
               type.output == (dimension == 2 ? graph::SocketKind::field2d : graph::SocketKind::field3d);
    }

    static int field_inputs(const graph::NodeType& type)
    {
        return static_cast<int>(std::count_if(type.inputs.begin(), type.inputs.end(),
                                              [](const graph::Socket& socket) { return is_field(socket.kind); }));
    }

    // A block within a block multiplies: one on each way down is enough here.
    NodeId field(int dimension, int depth, bool in_block = false)
    {
        auto& made = made_[static_cast<std::size_t>(dimension - 2)];
        if (!made.empty() && random_.chance(0.1f)) return random_.pick(made);
        bool leaf = depth == 0 || !room() || random_.chance(0.15f);
        Types choices;
        for (const graph::NodeType* type : scene_.library->types())
            if (type->category != "output" && gives(*type, dimension) && (field_inputs(*type) == 0) == leaf &&
                !(in_block && type->copies > 1))
                choices.push_back(type);
        const graph::NodeType& type = *random_.pick(choices);
        NodeId id = add(type);
        for (const graph::Socket& socket : type.inputs) {
            if (!is_field(socket.kind) || (field_inputs(type) > 1 && random_.chance(0.05f))) continue;
            int inner = socket.kind == graph::SocketKind::field_any ? dimension
                        : socket.kind == graph::SocketKind::field2d ? 2
                                                                    : 3;
            scene_.wire(field(inner, depth - 1, in_block || type.copies > 1), id, socket.name);
        }
        wire_others(id);
        if (random_.chance(0.05f)) graph::set_muted(scene_.document, id, true);
        if (!in_block && type.copies == 1) made.push_back(id);
        return id;
    }

    NodeId add(const graph::NodeType& type)
    {
        NodeId id = scene_.node(type.name);
        set_random_parameters(random_, scene_, id);
        return id;
    }

    // Numbers now and then, materials mostly, camera and sky nearly always.
    void wire_others(NodeId id)
    {
        for (const graph::Socket& socket : scene_.type(id).inputs) {
            using graph::SocketKind;
            if (is_field(socket.kind)) continue;
            bool thing = socket.kind == SocketKind::camera || socket.kind == SocketKind::sky;
            if (!random_.chance(thing ? 0.9f : socket.kind == SocketKind::material ? 0.7f : 0.12f)) continue;
            if (!thing && !room()) continue;
            if (NodeId source = leaf_of(socket.kind)) scene_.wire(source, id, socket.name);
        }
    }

    static bool feeds(graph::SocketKind from, graph::SocketKind to)
    {
        using graph::SocketKind;
        bool vector = to == SocketKind::vec2 || to == SocketKind::vec3 || to == SocketKind::colour;
        return from == to || (from == SocketKind::number && vector) ||
               (from == SocketKind::vec3 && to == SocketKind::colour);
    }

    NodeId leaf_of(graph::SocketKind kind)
    {
        Types choices;
        for (const graph::NodeType* type : scene_.library->types())
            if (feeds(type->output, kind)) choices.push_back(type);
        if (choices.empty()) return {};
        NodeId id = add(*random_.pick(choices));
        wire_others(id);
        return id;
    }

    Scene scene_;
    Random random_;
    int node_limit_;
    std::array<std::vector<NodeId>, 2> made_;  // finished fields, by dimension: what may be shared
};

// A valid document over all types of the library whose distance takes at most `cost_limit` primitives.
inline Scene random_graph(std::uint64_t seed, const std::shared_ptr<const graph::Library>& library,
                          std::int64_t cost_limit = 128)
{
    for (int node_limit = 22;; node_limit = std::max(4, node_limit - 3)) {
        Scene scene = RandomGraph(seed, library, node_limit).take();
        graph::Program program = scene.program({.cost_limit = cost_limit});
        auto is_error = [](const graph::Problem& problem) {
            return problem.severity == graph::Problem::Severity::error;
        };
        if (std::none_of(program.problems.begin(), program.problems.end(), is_error)) return scene;
        seed += 1u << 20;
    }
}

}  // namespace fieldwright::tests
