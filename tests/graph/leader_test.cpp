// Nodes that follow others: a sky and the sun.
#include "graph/leader.h"

#include "graph/light_rig.h"
#include "graph/scene_file.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

// Ids of the values that a function's call receives, by the argument's name.
std::map<std::string, graph::ValueId> arguments_of(const graph::Program& program, std::string_view function)
{
    std::map<std::string, graph::ValueId> found;
    for (const graph::Instruction& call : program.instructions) {
        if (!call.function || call.function->name != function) continue;
        for (std::size_t i = 0; i < call.function->arguments.size(); ++i)
            found[call.function->arguments[i].name] =
                program.arguments[static_cast<std::size_t>(call.first_argument) + i];
    }
    return found;
}

float number(const graph::Program& program, graph::ValueId id)
{
    const graph::ProgramValue& value = program.values[static_cast<std::size_t>(id)];
    return value.rate == graph::Rate::constant ? program.block[static_cast<std::size_t>(value.slot)] : NAN;
}

struct Outdoors {
    Outdoors()
    {
        sky = s.node("sun_and_sky", {{"elevation", 70.0f}, {"azimuth", 10.0f}});
        s.wire(sky, s.show(s.node("sphere")), "sky");
    }
    float elevation_deg() const
    {
        graph::Program program = s.program();
        return glm::degrees(number(program, arguments_of(program, "sun_and_sky_sky").at("elevation")));
    }

    Scene s;
    NodeId sky;
};

TEST(Followers, take_over_the_first_unmuted_leaders_values)
{
    Outdoors scene;
    NodeId first = scene.s.node("sun", {{"elevation", 20.0f}});
    scene.s.node("sun", {{"elevation", 50.0f}});
    EXPECT_NEAR(scene.elevation_deg(), 20, 1e-3f);
    EXPECT_TRUE(scene.s.program().problems.empty());
    graph::set_muted(scene.s.document, first, true);
    EXPECT_NEAR(scene.elevation_deg(), 50, 1e-3f);
    scene.s.set(scene.sky, "follow_sun", false);
    EXPECT_NEAR(scene.elevation_deg(), 70, 1e-3f);
}

TEST(Followers, share_what_is_wired_to_the_leader)
{
    Outdoors scene;
    NodeId sun = scene.s.node("sun", {{"azimuth", -40.0f}});
    scene.s.wire(scene.s.node("time"), sun, "elevation");
    graph::Program program = scene.s.program();
    auto sky = arguments_of(program, "sun_and_sky_sky"), light = arguments_of(program, "sun_light");
    EXPECT_EQ(program.values[static_cast<std::size_t>(sky.at("elevation"))].rate, graph::Rate::frame);
    EXPECT_EQ(sky.at("azimuth"), light.at("azimuth")) << "one slot: a drag of the sun is a drag of the sky";
}

TEST(Followers, keep_what_is_wired_to_themselves)
{
    Outdoors scene;
    scene.s.node("sun", {{"elevation", 20.0f}});
    scene.s.wire(scene.s.node("time"), scene.sky, "elevation");
    graph::Program program = scene.s.program();
    EXPECT_TRUE(std::isnan(number(program, arguments_of(program, "sun_and_sky_sky").at("elevation"))));
}

TEST(Followers, without_a_leader_say_so_and_stand_alone)
{
    Outdoors scene;
    EXPECT_NEAR(scene.elevation_deg(), 70, 1e-3f);
    graph::Program program = scene.s.program();
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].node, scene.sky);
    EXPECT_EQ(program.problems[0].sentence,
              "there is no sun to follow, so its own values count: add a sun, unmute one, or turn off Follow sun");
    scene.s.set(scene.sky, "follow_sun", false);
    EXPECT_TRUE(scene.s.program().problems.empty());
}

TEST(Followers, in_files_from_before_they_could_do_not_follow)
{
    Outdoors scene;
    scene.s.node("sun", {{"elevation", 20.0f}});
    std::string text = graph::write_scene(scene.s.document, *scene.s.library);
    std::string line = "\"follow_sun\": true";
    std::size_t at = text.find(line);
    ASSERT_NE(at, text.npos);
    EXPECT_EQ(std::get<bool>(*graph::read_scene(text, *scene.s.library).root.find(scene.sky)->parameter("follow_sun")),
              true);
    std::size_t comma = text.rfind(',', at);
    text.erase(comma, at + line.size() - comma);
    graph::Document old = graph::read_scene(text, *scene.s.library);
    EXPECT_EQ(std::get<bool>(*old.root.find(scene.sky)->parameter("follow_sun")), false);
}

}  // namespace
}  // namespace fieldwright::tests
