// Random documents with all that a document may have: own types and groups too.
#pragma once

#include "graph/group_edits.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/own_type_edits.h"
#include "graph/own_types.h"
#include "tests/support/random.h"

namespace fieldwright::tests {

inline constexpr std::string_view own_prefix = "own_";

// Whether a text of a user's could be the node word for word and do the same: what the CPU finds out about a built-in
// node beforehand (constants, counts, matrices) it does not of an own one.
inline bool can_be_own(const graph::NodeType& type)
{
    bool plain = std::all_of(type.parameters.begin(), type.parameters.end(), [](const graph::Parameter& parameter) {
        return graph::has_range(parameter.kind) || parameter.kind == graph::ParameterKind::boolean ||
               parameter.kind == graph::ParameterKind::choice;
    });
    bool of_surfaces = type.is_field() || type.category == "material";
    return plain && of_surfaces && type.copies == 1 && !type.affine && !type.function("lipschitz") &&
           !type.function("stretch") && type.source.constants.empty() && !type.input("c") && type.category != "output";
}

// A few built-in nodes as a user might have written them: the same texts under other names.
inline std::vector<graph::OwnType> own_twins(const graph::Library& library)
{
    std::vector<graph::OwnType> twins;
    int number = 0;
    for (const graph::NodeType* type : library.types())
        if (can_be_own(*type) && number++ % 9 == 0)
            twins.push_back(graph::renamed({type->name, type->source.text}, std::string(own_prefix) + type->name));
    return twins;
}

// A document, and one that means the same without own types: what the CPU can run.
struct RandomScene {
    Scene scene, twin;
};

class SceneGrower {
public:
    SceneGrower()
        : plain_(graph::Library::embedded()),
          twins_(own_twins(*plain_)),
          with_twins_(graph::with_own_types(*plain_, twins_))
    {
    }

    const std::vector<graph::OwnType>& twins() const { return twins_; }

    RandomScene grown(std::uint64_t seed) const
    {
        Random random(seed ^ 0x67726f7570u);
        RandomScene result{random_graph(seed, plain_), Scene(plain_)};
        Scene& scene = result.scene;
        if (seed % 6 == 2 || seed % 6 == 4) take_own_types(random, scene);
        if (seed % 6 == 1 || seed % 6 == 4)
            for (int left = 1 + random.below(2); left > 0; --left) put_into_group(random, scene);
        result.twin = without_own_types(scene);
        return result;
    }

private:
    // Not where a steepness follows from the size of what is below: that of own types is not known.
    void take_own_types(Random& random, Scene& scene) const
    {
        for (const graph::Node& node : scene.document.root.nodes)
            for (const char* suffix : {"lipschitz", "stretch"})
                for (const char* box : {"child", "box_a", "box_b"})
                    if (scene.type(node.id).argument(suffix, box)) return;
        for (graph::Node& node : scene.document.root.nodes) {
            const graph::OwnType* twin = find(std::string(own_prefix) + node.type);
            if (!twin || random.chance(0.3f)) continue;
            node.type = twin->name;
            add_own(scene.document, *twin);
        }
        scene.library = with_twins_;
    }

    const graph::OwnType* find(const std::string& name) const
    {
        auto found =
            std::find_if(twins_.begin(), twins_.end(), [&](const graph::OwnType& own) { return own.name == name; });
        return found != twins_.end() && with_twins_->type(name) ? &*found : nullptr;
    }

    static void add_own(graph::Document& document, const graph::OwnType& own)
    {
        auto place = std::lower_bound(document.own_types.begin(), document.own_types.end(), own,
                                      [](const graph::OwnType& a, const graph::OwnType& b) { return a.name < b.name; });
        if (place == document.own_types.end() || place->name != own.name) document.own_types.insert(place, own);
    }

    // Some field node with some of what it is made of; then it shows something outside and is used once more.
    void put_into_group(Random& random, Scene& scene) const
    {
        std::vector<NodeId> fields;
        for (const graph::Node& node : scene.document.root.nodes)
            if (scene.type(node.id).is_field() && node.type != "output") fields.push_back(node.id);
        NodeId end = random.pick(fields);
        std::set<NodeId> inside = {end};
        gather(random, scene.document.root, end, inside);
        graph::Placed placed = graph::group_nodes(scene.document, *scene.library, inside, "Part");
        if (placed.refusal) return;
        scene.library = graph::with_groups(*scene.library, scene.document);
        std::string name = graph::group_of(scene.document, *scene.document.root.find(placed.node))->name;
        expose_some(random, scene, name);
        set_random_parameters(random, scene, placed.node);
        if (random.chance(0.4f)) use_again(random, scene, graph::group_type_name(name));
    }

    static void gather(Random& random, const graph::Graph& graph, NodeId id, std::set<NodeId>& inside)
    {
        for (const auto& [socket, source] : graph.find(id)->inputs)
            if (random.chance(0.7f) && inside.insert(source).second) gather(random, graph, source, inside);
    }

    static void expose_some(Random& random, Scene& scene, const std::string& name)
    {
        graph::Group& group = *graph::find_group(scene.document, name);
        for (const graph::Node& node : group.graph.nodes)
            for (const graph::Parameter& parameter : scene.library->type(node.type)->parameters)
                if (random.chance(0.2f) && !node.input(parameter.name))
                    group.exposed.push_back(
                        {graph::free_exposed_name(group, parameter.name), {}, node.id, parameter.name});
        scene.library = graph::settle_groups(scene.document, *scene.library);
    }

    // In the place of some wire; where it does not fit, the node stays alone.
    static void use_again(Random& random, Scene& scene, const std::string& type)
    {
        NodeId again = scene.node(type);
        const graph::Node& target = random.pick(scene.document.root.nodes);
        if (target.inputs.empty()) return;
        std::string socket = random.pick(target.inputs).first;
        graph::connect(scene.document, *scene.library, again, target.id, socket);
    }

    Scene without_own_types(const Scene& scene) const
    {
        Scene twin(plain_);
        twin.document = scene.document;
        twin.document.own_types.clear();
        graph::for_each_graph(twin.document, [](graph::Graph& graph) {
            for (graph::Node& node : graph.nodes)
                if (node.type.starts_with(own_prefix)) node.type.erase(0, own_prefix.size());
        });
        twin.library = graph::with_groups(*plain_, twin.document);
        return twin;
    }

    std::shared_ptr<const graph::Library> plain_;
    std::vector<graph::OwnType> twins_;
    std::shared_ptr<const graph::Library> with_twins_;
};

}  // namespace fieldwright::tests
