// Compound edits in random order on random documents: always valid, refusals change nothing, every step undoes.
#include "graph/compose.h"
#include "graph/fragment.h"
#include "graph/history.h"
#include "graph/layout.h"
#include "graph/scene_parts.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

namespace fieldwright::graph {
namespace {

glm::vec2 plain_size(NodeId) { return {160, 90}; }

// One random compound edit after the other, arguments good and bad.
class RandomEdits {
public:
    RandomEdits(tests::Scene& scene, std::uint64_t seed)
        : document_(scene.document), library_(*scene.library), random_(seed)
    {
    }

    // Whether the edit was refused.
    bool step()
    {
        const std::function<Refusal()> edits[] = {
            [&] { return add_primitive_to_output(document_, library_, type(), place(), world()).refusal; },
            [&] { return add_from_menu(document_, library_, type(), place(), selection(), world()).refusal; },
            [&] { return add_to_output(document_, library_, type(), place()).refusal; },
            [&] { return insert_after(document_, library_, type(), node()).refusal; },
            [&] { return combine(document_, library_, type(), node(), node()).refusal; },
            [&] { return on_wire(); },
            [&] { return dissolve(document_, library_, set()); },
            [&] { return remove_nodes(document_, set()); },
            [&] { return toggle_muted(document_, set()); },
            [&] { return move_nodes(document_, set(), place()); },
            [&] { return swap_inputs(document_, library_, node()); },
            [&] { return add_wired(document_, library_, type(), place(), end()).refusal; },
            [&] { return insert_translate(document_, library_, node()).refusal; },
            [&] { return add_material(document_, library_, type(), node()).refusal; },
            [&] { return assign_material(document_, library_, node(), node()); },
            [&] { return camera(); },
            [&] { return paste(); },
            [&] { return duplicate_nodes(document_, library_, set(), place(), incoming()).refusal; },
            [&] { return arrange(document_, set(), plain_size); },
        };
        return edits[random_.below(std::size(edits))]().has_value();
    }

private:
    std::string_view type()
    {
        return random_.chance(0.02f) ? "no_such" : std::string_view(random_.pick(library_.types())->name);
    }
    glm::vec2 place() { return {random_.between(-900, 900), random_.between(-900, 900)}; }
    std::optional<glm::vec3> world()
    {
        if (random_.chance(0.5f)) return std::nullopt;
        return random_.in_cube(3);
    }
    NodeId node()
    {
        if (document_.root.nodes.empty() || random_.chance(0.02f)) return {document_.next_id + 5};
        return random_.pick(document_.root.nodes).id;
    }
    std::set<NodeId> set()
    {
        std::set<NodeId> ids;
        for (int count = random_.below(4); count > 0; --count) ids.insert(node());
        return ids;
    }
    std::vector<NodeId> selection()
    {
        std::vector<NodeId> ids(static_cast<std::size_t>(random_.below(3)));
        for (NodeId& id : ids) id = node();
        return ids;
    }
    Incoming incoming() { return random_.chance(0.5f) ? Incoming::keep : Incoming::drop; }
    LooseEnd end()
    {
        LooseEnd loose{node(), {}};
        const Node* one = document_.root.find(loose.node);
        if (!one || random_.chance(0.5f)) return loose;
        const NodeType& of = *library_.type(one->type);
        if (!of.inputs.empty()) loose.socket = random_.pick(of.inputs).name;
        return loose;
    }
    Refusal on_wire()
    {
        NodeId target = node();
        const Node* reader = document_.root.find(target);
        std::string socket = reader && !reader->inputs.empty() ? random_.pick(reader->inputs).first : "d";
        return insert_on_wire(document_, library_, node(), target, socket);
    }
    Refusal camera()
    {
        SceneView view{random_.in_cube(9), random_.in_cube(2), random_.between(-10, 190)};
        if (random_.chance(0.5f)) view.height = random_.between(-1, 9);
        return set_scene_camera_from_view(document_, library_, view).refusal;
    }
    Refusal paste()
    {
        std::string text = copy_nodes(document_, library_, set());
        if (random_.chance(0.1f)) text = text.substr(0, text.size() / 2);
        return paste_nodes(document_, library_, text, place(), incoming()).refusal;
    }

    Document& document_;
    const Library& library_;
    tests::Random random_;
};

TEST(CompoundEdits, any_sequence_keeps_documents_valid_and_undoes_to_the_equal_document)
{
    auto library = Library::embedded();
    int refusals = 0, changes = 0;
    for (std::uint64_t seed = 0; seed < 2'000; ++seed) {
        tests::Scene scene(library);
        if (seed % 8 != 0) scene = tests::RandomGraph(seed, library, 20).take();
        std::vector<Document> before = {scene.document};
        History history(scene.document);
        RandomEdits edits(scene, seed);
        for (int step = 0; step < 10; ++step) {
            bool refused = edits.step();
            ASSERT_EQ(validate(scene.document, *library), std::nullopt) << "seed " << seed << " step " << step;
            ASSERT_TRUE(!refused || scene.document == before.back()) << "seed " << seed << " step " << step;
            (refused ? refusals : changes) += 1;
            if (scene.document == before.back()) continue;
            history.record(scene.document, "step");
            before.push_back(scene.document);
        }
        for (std::size_t i = before.size(); i-- > 0; history.undo()) ASSERT_EQ(history.current(), before[i]);
        ASSERT_FALSE(history.undo());
    }
    EXPECT_GT(refusals, 2'000) << "bad arguments were tried";
    EXPECT_GT(changes, 8'000) << "good ones too";
}

// 4,096 nodes: one box read by everything, and a chain.
Document large_document(const Library& library)
{
    Document document;
    NodeId box = add_node(document, library, "box"), last = box;
    for (int i = 1; i < 4'096; ++i) {
        NodeId next = add_node(document, library, i == 4'095 ? "output" : "union");
        Node& node = document.root.nodes.back();
        if (i == 4'095) node.inputs = {{"d", last}};
        else node.inputs = {{"a", last}, {"b", box}};
        last = next;
    }
    return document;
}

TEST(CompoundEdits, every_edit_of_four_thousand_nodes_is_fast)
{
    auto library = Library::embedded();
    const Document large = large_document(*library);
    ASSERT_EQ(validate(large, *library), std::nullopt);
    const NodeId box{1}, middle{2'000}, output{4'096};
    std::set<NodeId> all, unions;
    for (const Node& node : large.root.nodes) all.insert(node.id);
    for (std::int64_t i = 2; i < 4'096; ++i) unions.insert({i});
    Document document;
    const std::pair<const char*, std::function<Refusal()>> edits[] = {
        {"add",
         [&] {
             return add_primitive_to_output(document, *library, "star", {0, 0}, glm::vec3(1)).refusal;
         }},
        {"insert", [&] { return insert_after(document, *library, "twist", box).refusal; }},
        {"combine", [&] { return combine(document, *library, "morph", box, middle).refusal; }},
        {"dissolve", [&] { return dissolve(document, *library, unions); }},
        {"remove", [&] { return remove_nodes(document, unions); }},
        {"mute", [&] { return toggle_muted(document, all); }},
        {"move",
         [&] {
             return move_nodes(document, all, {1, 1});
         }},
        {"wired",
         [&] {
             return add_wired(document, *library, "round", {0, 0}, {middle, ""}).refusal;
         }},
        {"translate", [&] { return insert_translate(document, *library, middle).refusal; }},
        {"material", [&] { return add_material(document, *library, "phong", box).refusal; }},
        {"camera",
         [&] {
             return set_scene_camera_from_view(document, *library, {{1, 2, 3}, {}}).refusal;
         }},
        {"duplicate",
         [&] {
             return duplicate_nodes(document, *library, unions, {1, 1}, Incoming::keep).refusal;
         }},
        {"paste",
         [&] {
             return paste_nodes(document, *library, copy_nodes(document, *library, unions), {0, 0}, Incoming::keep)
                 .refusal;
         }},
        {"arrange", [&] { return arrange(document, {}, plain_size); }},
        {"swap", [&] { return swap_inputs(document, *library, middle); }},
        {"on wire",
         [&] {
             NodeId round = add_node(document, *library, "round");
             return insert_on_wire(document, *library, round, output, "d");
         }},
    };
    for (const auto& [name, edit] : edits) {
        document = large;
        auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(edit(), std::nullopt) << name;
        std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(seconds.count(), 1.0) << name;
        RecordProperty(std::string(name) + " ms", std::to_string(1e3 * seconds.count()));
        EXPECT_EQ(validate(document, *library), std::nullopt) << name;
    }
}

}  // namespace
}  // namespace fieldwright::graph
