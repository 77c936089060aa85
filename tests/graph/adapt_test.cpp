// Documents under another node library.
#include "graph/adapt.h"

#include "graph/edits.h"
#include "graph/scene_file.h"

#include <gtest/gtest.h>

#include <set>

namespace fieldwright::graph {
namespace {

using Texts = std::map<std::string, std::string>;

std::shared_ptr<const Library> library_of(const Texts& texts) { return Library::from_texts(texts, embedded_texts()); }

// The built-in library with one passage of one file replaced.
std::shared_ptr<const Library> changed(const std::string& file, const std::string& passage, const std::string& by)
{
    Texts texts = embedded_texts();
    std::string& text = texts.at(file);
    std::size_t place = text.find(passage);
    if (place == std::string::npos) throw std::runtime_error(file + " lacks " + passage);
    text.replace(place, passage.size(), by);
    return library_of(texts);
}

Document example(const std::string& name)
{
    return open_scene(std::filesystem::path(FIELDWRIGHT_SOURCE_DIR) / "examples" / (name + ".scene.json"),
                      *Library::embedded());
}

const std::string torus_file = "nodes/primitive/torus.glsl";
const std::string minor_line = "    float minor)  // 0.25 [0.001, 100] [0.01, 2] m  Radius of the tube.\n";

Document one_torus()
{
    Document document;
    NodeId torus = add_node(document, *Library::embedded(), "torus");
    EXPECT_EQ(set_parameter(document, *Library::embedded(), torus, "major", 3.0f), std::nullopt);
    EXPECT_EQ(set_parameter(document, *Library::embedded(), torus, "minor", 0.125f), std::nullopt);
    return document;
}

TEST(Adapted, a_document_that_fits_is_unchanged)
{
    for (const char* name : {"first", "profiles", "repetition", "orthographic_room"}) {
        Document document = example(name);
        EXPECT_EQ(adapted(document, *Library::embedded()), document) << name;
    }
}

TEST(Adapted, a_type_that_vanishes_and_returns_changes_neither_the_document_nor_its_file)
{
    for (const char* name : {"first", "profiles"}) {
        const Document document = example(name);
        const std::string text = write_scene(document, *Library::embedded());
        std::set<std::string> types;
        for (const Node& node : document.root.nodes) types.insert(node.type);
        for (const std::string& type : types) {
            Texts texts = embedded_texts();
            texts.erase(Library::embedded()->type(type)->source.path);
            auto library = library_of(texts);
            Document without = adapted(document, *library);
            EXPECT_NE(without, document) << type;
            EXPECT_EQ(validate(without, *library), std::nullopt) << type;
            EXPECT_EQ(write_scene(without, *library), text) << type;
            EXPECT_EQ(read_scene(text, *library), without) << type;
            EXPECT_EQ(adapted(without, *Library::embedded()), document) << type;
        }
    }
}

TEST(Adapted, a_new_parameter_has_its_default_and_the_others_keep_their_values)
{
    auto library = changed(torus_file, minor_line,
                           "    float minor,  // 0.25 [0.001, 100] [0.01, 2] m  Radius of the tube.\n"
                           "    float lift)   // 0.5 [0, 1] m  Height.\n");
    Document document = adapted(one_torus(), *library);
    EXPECT_EQ(validate(document, *library), std::nullopt);
    const Node& torus = document.root.nodes.front();
    EXPECT_EQ(*torus.parameter("major"), Value(3.0f));
    EXPECT_EQ(*torus.parameter("minor"), Value(0.125f));
    EXPECT_EQ(*torus.parameter("lift"), Value(0.5f));
}

TEST(Adapted, a_removed_parameter_goes_with_the_wire_to_it)
{
    Texts texts = embedded_texts();
    texts[torus_file] =
        "// Torus: a ring.\n// field: exact\nfloat torus_distance(\n    vec3 p,\n"
        "    float major)  // 1.0 [0.001, 100] m  Size.\n{\n    return length(p) - major;\n}\n"
        "\nBox torus_bounds(float major)\n{\n    return make_box(vec3(0.0f), vec3(major));\n}\n";
    auto library = library_of(texts);
    Document document = one_torus();
    NodeId number = add_node(document, *Library::embedded(), "number");
    ASSERT_EQ(connect(document, *Library::embedded(), number, {1}, "minor"), std::nullopt);
    ASSERT_EQ(connect(document, *Library::embedded(), number, {1}, "major"), std::nullopt);
    document = adapted(document, *library);
    EXPECT_EQ(validate(document, *library), std::nullopt);
    EXPECT_EQ(document.root.nodes.front().parameter("minor"), nullptr);
    EXPECT_EQ(document.root.nodes.front().input("minor"), NodeId{});
    EXPECT_EQ(document.root.nodes.front().input("major"), number);
    EXPECT_EQ(*document.root.nodes.front().parameter("major"), Value(3.0f));
}

TEST(Adapted, a_value_out_of_a_new_range_moves_to_its_end_and_one_of_another_kind_to_the_default)
{
    auto narrow = changed(torus_file, "1.0 [0.001, 100] [0.05, 5]", "1.0 [0.001, 2] [0.05, 2]");
    Document document = adapted(one_torus(), *narrow);
    EXPECT_EQ(validate(document, *narrow), std::nullopt);
    EXPECT_EQ(*document.root.nodes.front().parameter("major"), Value(2.0f));

    auto other = changed("nodes/material/phong.glsl", "    float specular,   // 0.15 [0, 1]",
                         "    vec3 specular,   // (0.1, 0.2, 0.3) [0, 1]");
    document = {};
    add_node(document, *Library::embedded(), "phong");
    document = adapted(document, *other);
    EXPECT_EQ(*document.root.nodes.front().parameter("specular"), Value(glm::vec3(0.1f, 0.2f, 0.3f)));
}

TEST(Adapted, a_placeholder_is_read_as_far_as_its_type_knows_it)
{
    const std::string text = R"({"format": "fieldwright", "version": 1, "graphs": {"root": {"nodes": {
        "1": {"type": "number"},
        "2": {"type": "torus", "name": "Ring", "position": [3, 4], "future": true,
              "parameters": {"major": 2.5, "minor": "thin", "colour": [1, 2, 3]},
              "inputs": {"minor": 1, "nowhere": 1}}}}}})";
    Texts texts = embedded_texts();
    texts.erase(torus_file);
    Document document = adapted(read_scene(text, *library_of(texts)), *Library::embedded());
    EXPECT_EQ(validate(document, *Library::embedded()), std::nullopt);
    const Node& torus = *document.root.find({2});
    EXPECT_EQ(torus.name, "Ring");
    EXPECT_EQ(torus.position, glm::vec2(3, 4));
    EXPECT_EQ(*torus.parameter("major"), Value(2.5f));
    EXPECT_EQ(*torus.parameter("minor"), Value(0.25f));
    EXPECT_EQ(torus.inputs, (std::vector<std::pair<std::string, NodeId>>{{"minor", {1}}}));
}

}  // namespace
}  // namespace fieldwright::graph
