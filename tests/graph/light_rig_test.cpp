// One edit that lights a scene as outdoors.
#include "graph/light_rig.h"

#include "graph/known_types.h"
#include "graph/program.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

const Library& library() { return *Library::embedded(); }

std::size_t count_of(const Document& document, std::string_view type)
{
    const auto& nodes = document.root.nodes;
    return static_cast<std::size_t>(
        std::count_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.type == type; }));
}

TEST(LightRig, adds_a_sun_and_the_sky_that_goes_with_it)
{
    Document document;
    document.occlusion.strength = 0;
    Placed placed = add_outdoor_light(document, library(), {0, 0});
    ASSERT_EQ(placed.refusal, std::nullopt);
    EXPECT_EQ(document.root.find(placed.node)->type, known_types::sun_and_sky);
    EXPECT_EQ(count_of(document, "sun"), 1u);
    EXPECT_EQ(document.occlusion, OcclusionSettings{});
    Program program = lower(document, Library::embedded());
    ASSERT_EQ(program.lights.size(), 1u);
    EXPECT_EQ(program.lights[0].shadow, Shadow::soft_corrected);
    EXPECT_EQ(validate(document, library()), std::nullopt);
    NodeId output = document.root.nodes.back().id;
    for (const Node& node : document.root.nodes)
        if (node.type == known_types::output) output = node.id;
    EXPECT_EQ(document.root.find(output)->input("sky"), placed.node);
}

TEST(LightRig, keeps_the_sun_that_shines_and_lets_the_sky_follow_it)
{
    Document document;
    NodeId sun = add_node(document, library(), "sun");
    ASSERT_EQ(set_parameter(document, library(), sun, "elevation", 12.0f), std::nullopt);
    ASSERT_EQ(set_parameter(document, library(), sun, "azimuth", -70.0f), std::nullopt);
    Placed placed = add_outdoor_light(document, library(), {0, 0});
    ASSERT_EQ(placed.refusal, std::nullopt);
    EXPECT_EQ(count_of(document, "sun"), 1u);
    EXPECT_EQ(std::get<float>(*document.root.find(placed.node)->parameter("elevation")), 12.0f);
    EXPECT_EQ(std::get<float>(*document.root.find(placed.node)->parameter("azimuth")), -70.0f);
    set_muted(document, sun, true);
    ASSERT_EQ(add_outdoor_light(document, library(), {0, 0}).refusal, std::nullopt);
    EXPECT_EQ(count_of(document, "sun"), 2u) << "a muted one does not shine";
}

}  // namespace
}  // namespace fieldwright::graph
