// Programs without ids draw what those with ids draw, on both devices.
#include "renderer/devices.h"
#include "tests/support/pictures.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>
#include <set>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

constexpr FrameRequest request{.width = 96, .height = 64, .time = 0.6f};

NodeId painted(Scene& s, NodeId field, const Scene::Setting& albedo)
{
    return s.node("paint", {{"d", field}, {"material", s.node("phong", {albedo})}});
}

NodeId moved(Scene& s, NodeId field, vec3 offset) { return s.node("translate", {{"d", field}, {"offset", offset}}); }

void look_at(Scene& s, NodeId field, vec3 eye)
{
    s.wire(s.node("perspective", {{"position", eye}, {"target", vec3(0)}}), s.show(field), "camera");
    s.wire(s.node("gradient"), s.show(field), "sky");
    s.node("sun");
}

// Two materials melt into each other over a floor of a third one; one of them has a bite of a fourth.
Scene melting()
{
    Scene s;
    NodeId ball = painted(s, moved(s, s.node("sphere"), vec3(-0.6f, 0, 0)), {"albedo", vec3(0.8f, 0.1f, 0.1f)});
    NodeId box = painted(s, moved(s, s.node("box"), vec3(0.7f, 0, 0)), {"albedo", vec3(0.1f, 0.6f, 0.1f)});
    NodeId bite = painted(s, moved(s, s.node("sphere", {{"radius", 0.7f}}), vec3(1.0f, 0.3f, 0.9f)),
                          {"albedo", vec3(0.1f, 0.1f, 0.9f)});
    NodeId bitten =
        s.node("smooth_subtract", {{"a", box}, {"b", bite}, {"smoothness", 0.1f}, {"cut_face", std::string("b")}});
    NodeId body = s.node("smooth_union", {{"a", ball}, {"b", bitten}, {"smoothness", 0.6f}});
    NodeId floor = painted(s, moved(s, s.node("plane"), vec3(0, -0.8f, 0)), {"albedo", vec3(0.4f)});
    look_at(s, s.node("union", {{"a", floor}, {"b", body}}), {1.5f, 2, 4});
    return s;
}

// Copies of two solids in one block: one has a colour by its cell, the other is bare.
Scene repeated()
{
    Scene s;
    NodeId shade = s.node("random", {{"place", s.node("cell")}});
    NodeId ball = painted(s, s.node("sphere", {{"radius", 0.4f}}), {"albedo", shade});
    NodeId cone = moved(s, s.node("cone", {{"bottom_radius", 0.3f}}), vec3(0.5f, 0, 0.5f));
    NodeId both = s.node("smooth_union", {{"a", ball}, {"b", cone}, {"smoothness", 0.2f}});
    NodeId all = s.node(
        "union", {{"a", s.node("repeat_limited", {{"d", both}})}, {"b", moved(s, s.node("box"), vec3(0, -2, 0))}});
    look_at(s, all, {3, 4, 6});
    return s;
}

// One material: nothing of its field is left to a surface without ids.
Scene plain()
{
    Scene s;
    NodeId ball = moved(s, s.node("sphere"), vec3(-0.6f, 0, 0));
    NodeId cut = s.node("subtract", {{"a", s.node("union", {{"a", ball}, {"b", s.node("box")}})},
                                     {"b", s.node("cylinder", {{"radius", 0.2f}})}});
    look_at(s, s.node("repeat", {{"d", cut}, {"spacing", vec3(3, 0, 3)}}), {1.5f, 2, 4});
    return s;
}

graph::Program program_of(const Scene& scene, bool ids)
{
    graph::LowerOptions options;
    options.ids = ids;
    return scene.program(options);
}

// How many ids are in the picture; 0 is none.
std::size_t seen(const std::vector<int>& ids)
{
    std::set<int> different(ids.begin(), ids.end());
    return different.size() - different.count(0);
}

void expect_same_views(const Frame& with, const Frame& without, int step_limit)
{
    for (View view : {View::beauty, View::steps, View::normal, View::depth})
        EXPECT_EQ(picture(with, view, step_limit).rgb, picture(without, view, step_limit).rgb)
            << view_names()[static_cast<std::size_t>(view)];
    EXPECT_EQ(with.exhausted, without.exhausted);
    EXPECT_EQ(seen(without.node_id), 0u);
    EXPECT_EQ(seen(without.material_id), 0u);
}

void expect_same_without(const Scene& scene, GpuDevice& gpu, std::size_t node_ids, std::size_t material_ids)
{
    graph::Program with = program_of(scene, true), without = program_of(scene, false);
    Frame frame = render_on_cpu(with, request);
    EXPECT_GE(seen(frame.node_id), node_ids);
    EXPECT_GE(seen(frame.material_id), material_ids);
    expect_same_views(frame, render_on_cpu(without, request), with.march.step_limit);
    expect_same_views(gpu.render(with, request), gpu.render(without, request), with.march.step_limit);
}

TEST(WithoutIds, pictures_are_the_same)
{
    GpuDevice gpu;
    expect_same_without(melting(), gpu, 4, 4);
    expect_same_without(repeated(), gpu, 3, 1);
    expect_same_without(plain(), gpu, 2, 0);
}

TEST(WithoutIds, pictures_of_random_graphs_are_the_same)
{
    GpuDevice gpu;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        SCOPED_TRACE(seed);
        expect_same_without(random_graph(seed, graph::Library::embedded(), 32), gpu, 0, 0);
    }
}

TEST(WithoutIds, the_surface_of_one_material_computes_nothing)
{
    graph::Program with = program_of(plain(), true), without = program_of(plain(), false);
    EXPECT_GT(with.surface.last - with.surface.first, 6);
    EXPECT_EQ(without.surface.last, without.surface.first);
    EXPECT_EQ(with.distance.last - with.distance.first, without.distance.last - without.distance.first);
}

TEST(WithoutIds, the_surface_keeps_the_combiners_of_different_materials)
{
    graph::Program without = program_of(melting(), false);
    std::multiset<std::string> called;
    for (std::int32_t i = without.surface.first; i < without.surface.last; ++i)
        called.insert(without.instructions[static_cast<std::size_t>(i)].function->name);
    EXPECT_EQ(called.count("mix_material"), 3u);
    EXPECT_EQ(called.count("choose_id"), 0u);
    EXPECT_EQ(called.count("smooth_union_distance"), 1u);  // the floor's blend reads it
    EXPECT_EQ(called.count("union_distance"), 0u);         // nobody reads the whole scene's distance
}

}  // namespace
}  // namespace fieldwright::tests
