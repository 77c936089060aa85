// The clipboard: what is copied comes back, foreign text is refused politely, bad text changes nothing.
#include "graph/fragment.h"
#include "graph/scene_file.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <map>

namespace fieldwright::graph {
namespace {

std::set<NodeId> all_of(const Document& document)
{
    std::set<NodeId> ids;
    for (const Node& node : document.root.nodes) ids.insert(node.id);
    return ids;
}

// The nodes with ids, wires and places as they would be under other names.
std::vector<Node> renamed(const std::vector<Node>& nodes, const std::map<NodeId, NodeId>& names, glm::vec2 shift)
{
    std::vector<Node> result = nodes;
    for (Node& node : result) {
        node.id = names.at(node.id);
        node.position += shift;
        for (auto& [socket, source] : node.inputs) source = names.at(source);
    }
    return result;
}

class Clipboard : public testing::Test {
protected:
    const Node& node(NodeId id) { return *document.root.find(id); }
    std::string refused(std::string_view text)
    {
        Document before = document;
        Pasted pasted = paste_nodes(document, library, text, {0, 0});
        EXPECT_EQ(document, before);
        EXPECT_TRUE(pasted.nodes.empty());
        return pasted.refusal.value_or("accepted");
    }

    tests::Scene scene;
    Document& document = scene.document;
    const Library& library = *scene.library;
};

TEST_F(Clipboard, a_paste_into_an_empty_scene_is_isomorphic)
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        tests::Scene from = tests::RandomGraph(seed, scene.library).take();
        for (Node& one : from.document.root.nodes)
            one.position = glm::vec2(one.id.number % 5, one.id.number % 7) * 16.0f;
        Document to;
        to.next_id = 1000;
        Pasted pasted = paste_nodes(to, library, copy_nodes(from.document, library, all_of(from.document)), {0, 0});
        ASSERT_EQ(pasted.refusal, std::nullopt);
        ASSERT_EQ(validate(to, library), std::nullopt);
        std::map<NodeId, NodeId> names;
        ASSERT_EQ(pasted.nodes.size(), from.document.root.nodes.size());
        for (std::size_t i = 0; i < pasted.nodes.size(); ++i) names[from.document.root.nodes[i].id] = pasted.nodes[i];
        glm::vec2 corner(1e6f);
        for (const Node& one : from.document.root.nodes) corner = glm::min(corner, one.position);
        EXPECT_EQ(to.root.nodes, renamed(from.document.root.nodes, names, -corner)) << "seed " << seed;
    }
}

TEST_F(Clipboard, a_copy_is_the_text_of_scene_files_and_complete)
{
    NodeId ball = scene.node("sphere", {{"radius", Value(0.75f)}});
    rename_node(document, ball, "a \"ball\"");
    EXPECT_EQ(copy_nodes(document, library, {ball}), R"({
  "format": "fieldwright-nodes",
  "version": 1,
  "nodes": {
    "1": {
      "type": "sphere",
      "name": "a \"ball\"",
      "position": [0, 0],
      "muted": false,
      "parameters": {
        "radius": 0.75
      },
      "inputs": {}
    }
  }
}
)");
    EXPECT_EQ(copy_nodes(document, library, {{99}}), "");
    EXPECT_EQ(copy_nodes(document, library, {}), "");
}

TEST_F(Clipboard, paste_keeps_internal_wires_and_incoming_ones_on_request)
{
    NodeId box = scene.node("box"), ball = scene.node("sphere"), round = scene.node("round", {{"d", box}});
    NodeId both = scene.node("union", {{"a", round}, {"b", ball}});
    scene.show(both);
    std::string text = copy_nodes(document, library, {round, both});
    Pasted plain = paste_nodes(document, library, text, {0, 0});
    ASSERT_EQ(plain.nodes.size(), 2u);
    EXPECT_TRUE(node(plain.nodes[0]).inputs.empty());
    EXPECT_EQ(node(plain.nodes[1]).inputs, (decltype(Node::inputs){{"a", plain.nodes[0]}}));
    Pasted kept = paste_nodes(document, library, text, {0, 0}, Incoming::keep);
    EXPECT_EQ(node(kept.nodes[0]).input("d"), box);
    EXPECT_EQ(node(kept.nodes[1]).input("b"), ball);
    EXPECT_EQ(node(kept.nodes[1]).input("a"), kept.nodes[0]);
    remove_node(document, ball);
    Pasted gone = paste_nodes(document, library, text, {0, 0}, Incoming::keep);
    EXPECT_EQ(node(gone.nodes[1]).input("b"), NodeId{});
    EXPECT_EQ(validate(document, library), std::nullopt);
}

TEST_F(Clipboard, incoming_wires_that_do_not_fit_here_are_left_out)
{
    NodeId box = scene.node("box"), round = scene.node("round", {{"d", box}});
    std::string text = copy_nodes(document, library, {round});
    Document other;
    ASSERT_EQ(add_node(other, library, "sun"), box) << "the same id, another kind";
    Pasted pasted = paste_nodes(other, library, text, {0, 0}, Incoming::keep);
    ASSERT_EQ(pasted.refusal, std::nullopt);
    EXPECT_TRUE(other.root.find(pasted.nodes[0])->inputs.empty());
    // Ids beyond what the document had are not those of the copies either.
    Document empty;
    ASSERT_EQ(paste_nodes(empty, library, text, {0, 0}, Incoming::keep).refusal, std::nullopt);
    EXPECT_TRUE(empty.root.nodes.front().inputs.empty());
}

TEST_F(Clipboard, the_corner_of_what_is_pasted_comes_to_the_position)
{
    NodeId output = scene.show(scene.node("box")), ball = scene.node("sphere"), sun = scene.node("sun");
    move_node(document, output, {-500, -500});
    move_node(document, ball, {100, 300});
    move_node(document, sun, {200, 250});
    Pasted pasted = paste_nodes(document, library, copy_nodes(document, library, {output, ball, sun}), {10, 20});
    ASSERT_EQ(pasted.nodes.size(), 2u) << "a second output is left out";
    EXPECT_EQ(node(pasted.nodes[0]).position, glm::vec2(10, 70));
    EXPECT_EQ(node(pasted.nodes[1]).position, glm::vec2(110, 20));
}

TEST_F(Clipboard, an_output_is_pasted_once)
{
    NodeId output = scene.show(scene.node("box"));
    std::string text = copy_nodes(document, library, {output});
    EXPECT_NE(refused(text).find("one output"), std::string::npos);
    Document empty;
    EXPECT_EQ(paste_nodes(empty, library, text, {0, 0}).nodes.size(), 1u);
}

TEST_F(Clipboard, nodes_of_unknown_type_are_neither_copied_nor_pasted)
{
    Document future = read_scene(R"({"format": "fieldwright", "version": 1, "next_id": 9, "graphs": {"root": {"nodes": {
        "1": {"type": "warp", "inputs": {"d": 2}}, "2": {"type": "box"}, "3": {"type": "round", "inputs": {"d": 1}}}}}})",
                                 library);
    EXPECT_EQ(copy_nodes(future, library, {{1}}), "");
    std::string text = R"({"format": "fieldwright-nodes", "version": 1, "nodes": {
        "1": {"type": "warp", "inputs": {"d": 77, "e": {}}}, "3": {"type": "round", "inputs": {"d": 1}}}})";
    Pasted pasted = paste_nodes(document, library, text, {0, 0});
    ASSERT_EQ(pasted.nodes.size(), 1u) << pasted.refusal.value_or("");
    EXPECT_TRUE(node(pasted.nodes[0]).inputs.empty());
    EXPECT_NE(refused(R"({"format": "fieldwright-nodes", "version": 1, "nodes": {"1": {"type": "warp"}}})")
                  .find("no nodes of a type known here"),
              std::string::npos);
    std::size_t count = future.root.nodes.size();
    EXPECT_EQ(duplicate_nodes(future, library, {{1}, {3}}, {0, 0}, Incoming::keep).nodes.size(), 1u);
    EXPECT_EQ(future.root.nodes.size(), count + 1);
}

TEST_F(Clipboard, foreign_text_is_refused_politely)
{
    for (const char* text : {"", "hello", "{}", "[1, 2]", "{\"format\": \"fieldwright\", \"version\": 1}", "\xff\xfe"})
        EXPECT_EQ(refused(text), "the clipboard holds no nodes; copy some first") << text;
}

TEST_F(Clipboard, bad_text_is_refused_with_place_and_reason)
{
    auto nodes = [](const std::string& inner) {
        return "{\"format\": \"fieldwright-nodes\", \"version\": 1, \"nodes\": {" + inner + "}}";
    };
    auto says = [&](const std::string& text, std::string_view what) {
        std::string sentence = refused(text);
        EXPECT_TRUE(sentence.starts_with("the nodes cannot be pasted: clipboard:1:")) << sentence;
        EXPECT_NE(sentence.find(what), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos);
    };
    says("fieldwright-nodes", "");
    says("[\"fieldwright-nodes\"]", "object");
    says("{\"format\": \"other\", \"x\": \"fieldwright-nodes\"}", "not made of copied nodes");
    says("{\"format\": \"fieldwright-nodes\", \"version\": 2, \"nodes\": {}}", "another version");
    says("{\"format\": \"fieldwright-nodes\", \"version\": 1}", "lacks its member `nodes`");
    says("{\"format\": \"fieldwright-nodes\", \"version\": 1, \"nodes\": {}, \"more\": 1}", "not known here");
    says(nodes(R"("1": {"type": "sphere", "parameters": {"radius": 1e9}})"), "must lie between");
    says(nodes(R"("1": {"type": "sphere", "inputs": {"nose": 5}})"), "has no socket `nose`");
    says(nodes(R"("1": {"type": "sphere"}, "1": {"type": "box"})"), "");
    says(nodes(R"("0": {"type": "sphere"})"), "is not an id");
    says(nodes(R"("1": {"type": "circle"}, "2": {"type": "twist", "inputs": {"d": 1}})"), "2D");
    says(nodes(R"("1": {"type": "round", "inputs": {"d": 2}}, "2": {"type": "round", "inputs": {"d": 1}})"), "cycle");
    says(nodes(R"("1": {"type": "sphere", "name": ")" + std::string(300, 'x') + "\"}"), "256 bytes");
    says(nodes(R"("1": {"type": "sphere"})").substr(0, 60), "");
    EXPECT_NE(refused(nodes("")).find("no nodes"), std::string::npos);
}

TEST_F(Clipboard, a_scene_that_is_full_takes_no_more)
{
    for (int i = 0; i < 19'999; ++i) add_node(document, library, "number");
    EXPECT_NE(refused(copy_nodes(document, library, {{1}, {2}})).find("at most 20000 nodes"), std::string::npos);
}

TEST_F(Clipboard, duplicates_stand_beside_and_keep_what_they_are)
{
    NodeId box = scene.node("box"), round = scene.node("round", {{"d", box}, {"radius", Value(0.25f)}});
    NodeId output = scene.show(round);
    set_muted(document, round, true);
    Pasted copies = duplicate_nodes(document, library, {round, output}, {30, 40}, Incoming::keep);
    ASSERT_EQ(copies.nodes.size(), 1u);
    const Node& copy = node(copies.nodes[0]);
    EXPECT_EQ(copy.position, node(round).position + glm::vec2(30, 40));
    EXPECT_EQ(copy.parameters, node(round).parameters);
    EXPECT_EQ(copy.inputs, node(round).inputs);
    EXPECT_TRUE(copy.muted);
    copies = duplicate_nodes(document, library, {round}, {30, 40});
    EXPECT_TRUE(node(copies.nodes[0]).inputs.empty());
    Document before = document;
    EXPECT_EQ(duplicate_nodes(document, library, {round, {99}}, {0, 0}).refusal, "there is no node 99");
    EXPECT_NE(duplicate_nodes(document, library, {output}, {0, 0}).refusal, std::nullopt);
    EXPECT_NE(duplicate_nodes(document, library, {}, {0, 0}).refusal, std::nullopt);
    EXPECT_EQ(document, before);
}

}  // namespace
}  // namespace fieldwright::graph
