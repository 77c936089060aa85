// What a node may hold that cannot be used: each time one sentence on the node, the document as it was, the rest drawn,
// and everything well again once it is put right.
#include "app/picture_shelf.h"
#include "app/session.h"
#include "app/shown_scene.h"
#include "graph/neighbours.h"
#include "graph/own_type_edits.h"
#include "renderer/devices.h"
#include "tests/app/program.h"
#include "tests/support/scene.h"

#include <fstream>

namespace fieldwright::tests {
namespace {

class BadContents : public InFolder {
protected:
    // A ball beside the solid that the node makes.
    NodeId beside(std::string_view type, std::initializer_list<Scene::Setting> settings)
    {
        NodeId node = scene.node(type, settings);
        bool flat = scene.type(node).output == graph::SocketKind::field2d;
        NodeId solid = flat ? scene.node("extrude", {{"d", node}}) : node;
        NodeId moved = scene.node("translate", {{"d", solid}, {"offset", glm::vec3(3, 0, 0)}});
        scene.show(scene.node("union", {{"a", scene.node("sphere")}, {"b", moved}}));
        return node;
    }

    graph::BakedImages images()
    {
        graph::BakedImages made;
        app::ImageMaker maker{assets::Worker{FIELDWRIGHT_BINARY}};
        for (const graph::ImageRequest& request : graph::image_requests(scene.document, *scene.library)) {
            std::filesystem::path file = app::picture_path(request, folder_);
            made[request] = maker.make(file, request, app::file_stamp(file));
        }
        return made;
    }

    // What the editor says of the node, as long as it draws the ball and leaves the document alone.
    std::vector<std::string> said_of(NodeId node)
    {
        graph::Document before = scene.document;
        shown.update(scene.document, scene.library, images());
        EXPECT_TRUE(before == scene.document);
        std::vector<std::string> sentences;
        for (const graph::Problem& problem : shown.problems()) {
            EXPECT_EQ(problem.node, node) << problem.sentence;
            sentences.push_back(problem.sentence);
        }
        if (shown.program()->gpu_only) return sentences;
        renderer::Frame frame = renderer::render_on_cpu(*shown.program(), {.width = 32, .height = 18});
        EXPECT_GT(std::count_if(frame.node_id.begin(), frame.node_id.end(), [](int id) { return id > 0; }), 0);
        return sentences;
    }

    void expect_one(NodeId node, const std::string& part)
    {
        std::vector<std::string> sentences = said_of(node);
        ASSERT_EQ(sentences.size(), 1u);
        EXPECT_NE(sentences[0].find(part), std::string::npos) << sentences[0];
        EXPECT_EQ(sentences[0].find('\n'), std::string::npos) << sentences[0];
    }

    void write(const std::string& name, const std::string& bytes)
    {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }

    Scene scene;
    app::ShownScene shown;
};

TEST_F(BadContents, a_missing_font)
{
    NodeId text = beside("text", {{"font", std::string("No Such Font")}});
    expect_one(text, "`No Such Font` is not installed");
    scene.set(text, "font", std::string());
    EXPECT_TRUE(said_of(text).empty());
}

TEST_F(BadContents, a_picture_that_cannot_be_read)
{
    write("words.png", "no picture at all");
    NodeId image = beside("image", {{"picture", std::string("words.png")}});
    expect_one(image, "words.png");
    scene.set(image, "picture", std::string("gone.png"));
    expect_one(image, "gone.png is not there");
    scene.set(image, "picture", std::string());
    EXPECT_TRUE(said_of(image).empty());
}

// 200,000 pixels a side, in a file of a few bytes.
TEST_F(BadContents, a_picture_that_is_a_bomb)
{
    constexpr char bytes[] =
        "\x89PNG\r\n\x1a\n"
        "\0\0\0\rIHDR\0\x3\r@\0\x3\r@\x1\0\0\0\0\xd1@\xb5\xa7"
        "\0\0\0\0IDAT\x35\xaf\x06\x1e"
        "\0\0\0\0IEND\xae"
        "B`\x82";
    write("bomb.png", std::string(bytes, sizeof bytes - 1));
    NodeId image = beside("image", {{"picture", std::string("bomb.png")}});
    expect_one(image, "200000 x 200000");
}

TEST_F(BadContents, an_outline_that_touches_itself)
{
    graph::PointList bow = {{0, 0, 0, 0}, {2, 2, 0, 0}, {2, 0, 0, 0}, {0, 2, 0, 0}};
    NodeId polygon = beside("polygon", {{"points", bow}});
    expect_one(polygon, "its outline meets itself at (1, 1)");
    scene.set(polygon, "points", graph::PointList{{0, 0, 0, 0}, {2, 0, 0, 0}, {2, 2, 0, 0}, {0, 2, 0, 0}});
    EXPECT_TRUE(said_of(polygon).empty());
}

TEST_F(BadContents, a_formula_with_a_mistake_says_the_column)
{
    NodeId implicit = beside("implicit", {{"formula", std::string("x^2 + (y - 1")}});
    expect_one(implicit, "its formula cannot be read, column 7:");
    scene.set(implicit, "formula", std::string("x^2 + (y - 1) - 0.3"));
    EXPECT_TRUE(said_of(implicit).empty());
}

TEST_F(BadContents, a_macro_bomb_in_own_code)
{
    const std::string head = "// Lump: round.\n// field: exact\n";
    const std::string good =
        "float lump_distance(vec3 p)\n{\n    return length(p) - 0.5f;\n}\n"
        "Box lump_bounds() { return make_box(vec3(0.0f), vec3(0.5f)); }\n";
    std::string bomb;
    for (int i = 1; i < 30; ++i)
        bomb += "#define M" + std::to_string(i) + " M" + std::to_string(i - 1) + " M" + std::to_string(i - 1) + "\n";
    app::EditSession session(graph::Library::embedded());
    graph::Document& document = session.document();
    ASSERT_EQ(graph::add_own_type(document, *session.library(), {"lump", head + good}), std::nullopt);
    session.follow_types();
    NodeId lump = graph::add_node(document, *session.library(), "lump");
    NodeId both = graph::add_node(document, *session.library(), "union"),
           ball = graph::add_node(document, *session.library(), "sphere");
    NodeId output = graph::shown_output(document, *session.library())->id;
    for (auto [from, to, socket] :
         {std::tuple(ball, both, "a"), std::tuple(lump, both, "b"), std::tuple(both, output, "d")})
        ASSERT_EQ(graph::connect(document, *session.library(), from, to, socket), std::nullopt);
    session.settle("Add");

    graph::set_own_type_text(document, "lump", head + bomb + good);
    session.follow_types();
    scene.document = document;
    scene.library = session.library();
    expect_one(lump, "line 3, column 1: preprocessor lines are not part of the dialect");
    EXPECT_EQ(document.root.find(both)->input("b"), lump);

    graph::set_own_type_text(document, "lump", head + good);
    session.follow_types();
    EXPECT_FALSE(session.library()->left_out("lump"));
    EXPECT_EQ(graph::validate(document, *session.library()), std::nullopt);
}

}  // namespace
}  // namespace fieldwright::tests
