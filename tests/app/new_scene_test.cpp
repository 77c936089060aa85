// The scene that a new document begins with.
#include "app/new_scene.h"

#include "graph/edits.h"
#include "graph/program.h"
#include "renderer/devices.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace fieldwright::app {
namespace {

using graph::Node;

TEST(NewScene, is_valid_complete_and_without_problems)
{
    auto library = graph::Library::embedded();
    graph::Document document = new_scene(*library);
    EXPECT_EQ(graph::validate(document, *library), std::nullopt);
    EXPECT_EQ(graph::lower(document, library).problems, std::vector<graph::Problem>{});
    std::set<std::string> categories;
    for (const Node& node : document.root.nodes) categories.insert(library->type(node.type)->category);
    for (const char* category : {"primitive", "material", "light", "camera", "sky", "output"})
        EXPECT_TRUE(categories.contains(category)) << category;
}

// As the canvas draws them: 180 px wide, a 28 px header, a row of 24 px for the output, each socket and parameter.
TEST(NewScene, nodes_read_from_left_to_right_and_do_not_overlap)
{
    auto library = graph::Library::embedded();
    graph::Document document = new_scene(*library);
    auto height = [&](const Node& node) {
        std::set<std::string> rows;
        for (const auto& socket : library->type(node.type)->inputs) rows.insert(socket.name);
        for (const auto& parameter : library->type(node.type)->parameters) rows.insert(parameter.name);
        return 28.0f + 24.0f * static_cast<float>(rows.size() + 1);
    };
    for (const Node& a : document.root.nodes) {
        for (const auto& [socket, source] : a.inputs)
            EXPECT_GE(a.position.x, document.root.find(source)->position.x + 180 + 40) << a.name << " " << socket;
        for (const Node& b : document.root.nodes) {
            bool beside = a.position.x + 180 < b.position.x || b.position.x + 180 < a.position.x;
            bool above = a.position.y + height(a) < b.position.y || b.position.y + height(b) < a.position.y;
            EXPECT_TRUE(a.id == b.id || beside || above) << a.name << " over " << b.name;
        }
    }
}

TEST(NewScene, fills_the_picture_well_and_is_well_lit)
{
    auto library = graph::Library::embedded();
    graph::Document document = new_scene(*library);
    renderer::FrameRequest request;
    request.width = 96;
    request.height = 54;
    renderer::Frame frame = renderer::render_on_cpu(graph::lower(document, library), request);
    std::map<std::string, int> pixels;
    float brightness = 0;
    int solid_on_the_border = 0;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            auto i = static_cast<std::size_t>(y * frame.width + x);
            const Node* node = document.root.find({frame.node_id[i]});
            std::string type = node ? node->type : "sky";
            ++pixels[type == "plane" || type == "sky" ? "backdrop" : "solid"];
            bool border = x == 0 || y == 0 || x + 1 == frame.width || y + 1 == frame.height;
            if (border && type != "plane" && type != "sky") ++solid_on_the_border;
            brightness += (frame.colour[i].r + frame.colour[i].g + frame.colour[i].b) / 3;
        }
    const float area = 96 * 54;
    EXPECT_EQ(solid_on_the_border, 0);
    EXPECT_GT(static_cast<float>(pixels["solid"]) / area, 0.12f);
    EXPECT_LT(static_cast<float>(pixels["solid"]) / area, 0.4f);
    EXPECT_GT(brightness / area, 0.15f);
    EXPECT_LT(brightness / area, 0.6f);
    int sunlit = 0, shaded = 0;
    for (std::size_t i = 0; i < frame.colour.size(); ++i) (frame.colour[i].r > 0.2f ? sunlit : shaded) += 1;
    EXPECT_GT(static_cast<float>(shaded) / area, 0.05f) << "a shadow shows where the light comes from";
    EXPECT_GT(static_cast<float>(sunlit) / area, 0.5f);
}

TEST(NewScene, does_without_what_the_library_lacks)
{
    auto texts = graph::embedded_texts();
    for (const char* type : {"sphere", "paint", "sun"})
        texts.erase(graph::Library::embedded()->type(type)->source.path);
    auto library = graph::Library::from_texts(texts, graph::embedded_texts());
    graph::Document document = new_scene(*library);
    EXPECT_EQ(graph::validate(document, *library), std::nullopt);
    EXPECT_GT(document.root.nodes.size(), 5u);
}

}  // namespace
}  // namespace fieldwright::app
