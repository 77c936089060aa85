// Pairs of scenes that mean the same: their pictures are the same.
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "graph/history.h"
#include "graph/own_type_edits.h"
#include "graph/own_types.h"
#include "graph/scene_file.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::Document;
using renderer::Picture;

// A scene with a light and a camera to its taste; `make` returns the field to show.
template <typename Make>
Scene lit(Make make)
{
    Scene scene;
    scene.node("sun");
    scene.show(make(scene));
    return scene;
}

NodeId moved(Scene& scene, NodeId field, float x, float y, float z)
{
    return scene.node("translate", {{"d", field}, {"offset", glm::vec3(x, y, z)}});
}

// Three shapes that overlap.
NodeId left_ball(Scene& scene) { return moved(scene, scene.node("sphere", {{"radius", 0.8f}}), -0.6f, 0.1f, 0.2f); }
NodeId block(Scene& scene)
{
    return moved(scene, scene.node("box", {{"half_size", glm::vec3(0.55f, 0.4f, 0.45f)}}), 0.3f, -0.2f, 0);
}
NodeId ring(Scene& scene)
{
    return moved(scene, scene.node("torus", {{"major", 0.9f}, {"minor", 0.2f}}), 0.1f, 0.4f, 0.1f);
}

NodeId pair(Scene& scene, std::string_view type, NodeId a, NodeId b) { return scene.node(type, {{"a", a}, {"b", b}}); }

void expect_same(const Scene& one, const Scene& other)
{
    Picture first = picture_of(one), second = picture_of(other);
    EXPECT_TRUE(first.rgb == second.rgb) << "apart: " << share_apart(first, second);
}

void expect_alike(const Scene& one, const Scene& other)
{
    EXPECT_LE(share_apart(picture_of(one), picture_of(other)), 0.001);
}

TEST(Metamorphic, the_scene_of_these_tests_shows_something)
{
    Scene scene = lit([](Scene& s) { return pair(s, "union", left_ball(s), block(s)); });
    renderer::Frame frame = frame_of(scene);
    auto seen = std::count_if(frame.node_id.begin(), frame.node_id.end(), [](int id) { return id > 0; });
    EXPECT_GT(seen, picture_side * picture_side / 20);
    EXPECT_LT(seen, picture_side * picture_side);
}

TEST(Metamorphic, unions_commute)
{
    for (const char* type : {"union", "intersect"})
        expect_same(lit([&](Scene& s) { return pair(s, type, left_ball(s), block(s)); }),
                    lit([&](Scene& s) { return pair(s, type, block(s), left_ball(s)); }));
}

// What is read right after a repeat must have lived through it.
TEST(Metamorphic, unions_with_a_repeat_commute)
{
    auto copies = [](Scene& s) { return s.node("repeat_limited", {{"d", ring(s)}}); };
    auto mirrored = [](Scene& s, NodeId field) { return s.node("mirror", {{"d", field}}); };
    expect_same(lit([&](Scene& s) { return mirrored(s, pair(s, "union", copies(s), s.node("cylinder"))); }),
                lit([&](Scene& s) { return mirrored(s, pair(s, "union", s.node("cylinder"), copies(s))); }));
}

TEST(Metamorphic, smooth_unions_commute)
{
    for (const char* type : {"smooth_union", "smooth_intersect"})
        expect_alike(lit([&](Scene& s) { return pair(s, type, left_ball(s), block(s)); }),
                     lit([&](Scene& s) { return pair(s, type, block(s), left_ball(s)); }));
}

TEST(Metamorphic, unions_associate)
{
    for (const char* type : {"union", "intersect"})
        expect_same(lit([&](Scene& s) { return pair(s, type, pair(s, type, left_ball(s), block(s)), ring(s)); }),
                    lit([&](Scene& s) { return pair(s, type, left_ball(s), pair(s, type, block(s), ring(s))); }));
}

TEST(Metamorphic, a_union_of_many_is_unions_of_two_in_any_order)
{
    Scene of_two = lit([](Scene& s) { return pair(s, "union", pair(s, "union", left_ball(s), block(s)), ring(s)); });
    expect_same(of_two, lit([](Scene& s) {
                    return s.node("union_many", {{"a", left_ball(s)}, {"b", block(s)}, {"shape_3", ring(s)}});
                }));
    expect_same(of_two, lit([](Scene& s) {
                    return s.node("union_many", {{"a", ring(s)}, {"shape_5", left_ball(s)}, {"shape_16", block(s)}});
                }));
}

TEST(Metamorphic, a_smooth_union_of_many_is_smooth_unions_of_pairs)
{
    auto two = [](Scene& s, NodeId a, NodeId b) { return pair(s, "smooth_union", a, b); };
    auto ball_above = [](Scene& s) { return moved(s, s.node("sphere", {{"radius", 0.5f}}), 0.2f, 1.0f, 0); };
    expect_same(lit([&](Scene& s) { return two(s, left_ball(s), block(s)); }), lit([&](Scene& s) {
                    return s.node("smooth_union_many", {{"b", left_ball(s)}, {"shape_7", block(s)}});
                }));
    expect_same(lit([&](Scene& s) { return two(s, two(s, left_ball(s), block(s)), two(s, ring(s), ball_above(s))); }),
                lit([&](Scene& s) {
                    return s.node(
                        "smooth_union_many",
                        {{"a", left_ball(s)}, {"b", block(s)}, {"shape_3", ring(s)}, {"shape_4", ball_above(s)}});
                }));
}

TEST(Metamorphic, union_with_itself_changes_nothing)
{
    Scene alone = lit([](Scene& s) { return block(s); });
    expect_same(alone, lit([](Scene& s) { return pair(s, "union", block(s), block(s)); }));
    expect_same(alone, lit([](Scene& s) {
                    NodeId shared = block(s);
                    return pair(s, "union", shared, shared);
                }));
}

TEST(Metamorphic, subtracting_what_is_far_away_changes_nothing)
{
    expect_same(lit([](Scene& s) { return block(s); }),
                lit([](Scene& s) { return pair(s, "subtract", block(s), moved(s, s.node("sphere"), 0, 50, 0)); }));
}

TEST(Metamorphic, an_unconnected_side_changes_nothing)
{
    expect_same(lit([](Scene& s) { return block(s); }), lit([](Scene& s) {
                    return s.node("smooth_union", {{"b", block(s)}});
                }));
}

TEST(Metamorphic, inverting_twice_changes_nothing)
{
    auto inverted = [](Scene& s, NodeId field) { return s.node("invert", {{"d", field}}); };
    expect_same(lit([](Scene& s) { return block(s); }),
                lit([&](Scene& s) { return inverted(s, inverted(s, block(s))); }));
}

TEST(Metamorphic, subtracting_is_sharing_with_the_inverse)
{
    expect_same(lit([](Scene& s) {
                    return s.node("subtract", {{"a", block(s)}, {"b", left_ball(s)}});
                }),
                lit([](Scene& s) {
                    return pair(s, "intersect", block(s), s.node("invert", {{"d", left_ball(s)}}));
                }));
}

TEST(Metamorphic, mirroring_twice_is_mirroring_once)
{
    auto mirrored = [](Scene& s, NodeId field) { return s.node("mirror", {{"d", field}, {"offset", 0.0f}}); };
    expect_same(lit([&](Scene& s) { return mirrored(s, ring(s)); }),
                lit([&](Scene& s) { return mirrored(s, mirrored(s, ring(s))); }));
}

TEST(Metamorphic, growing_and_shrinking_changes_nothing)
{
    auto grown = [](Scene& s, NodeId field, float by) { return s.node("offset", {{"d", field}, {"amount", by}}); };
    expect_alike(lit([](Scene& s) { return ring(s); }),
                 lit([&](Scene& s) { return grown(s, grown(s, ring(s), 0.15f), -0.15f); }));
}

TEST(Metamorphic, a_morph_is_one_shape_at_each_end)
{
    auto morphed = [](Scene& s, float amount) {
        return s.node("morph", {{"a", block(s)}, {"b", ring(s)}, {"amount", amount}});
    };
    expect_alike(lit([](Scene& s) { return block(s); }), lit([&](Scene& s) { return morphed(s, 0.0f); }));
    expect_alike(lit([](Scene& s) { return ring(s); }), lit([&](Scene& s) { return morphed(s, 1.0f); }));
}

TEST(Metamorphic, translating_there_and_back_changes_nothing)
{
    expect_alike(lit([](Scene& s) { return ring(s); }),
                 lit([](Scene& s) { return moved(s, moved(s, ring(s), 0.7f, -0.3f, 1.1f), -0.7f, 0.3f, -1.1f); }));
}

TEST(Metamorphic, rotating_there_and_back_changes_nothing)
{
    auto turned = [](Scene& s, NodeId field, float degrees) {
        return s.node("rotate", {{"d", field}, {"angles", glm::vec3(0, degrees, 0)}});
    };
    expect_alike(lit([](Scene& s) { return block(s); }),
                 lit([&](Scene& s) { return turned(s, turned(s, block(s), 33.0f), -33.0f); }));
}

TEST(Metamorphic, rotating_all_the_way_changes_nothing)
{
    expect_alike(lit([](Scene& s) { return block(s); }), lit([](Scene& s) {
                     return s.node("rotate", {{"d", block(s)}, {"angles", glm::vec3(0, 0, 360.0f)}});
                 }));
}

TEST(Metamorphic, scaling_there_and_back_changes_nothing)
{
    auto scaled = [](Scene& s, NodeId field, float factor) {
        return s.node("scale", {{"d", field}, {"factor", factor}});
    };
    expect_alike(lit([](Scene& s) { return ring(s); }),
                 lit([&](Scene& s) { return scaled(s, scaled(s, ring(s), 2.5f), 0.4f); }));
}

TEST(Metamorphic, a_scaled_sphere_is_a_larger_sphere)
{
    expect_alike(lit([](Scene& s) {
                     return s.node("sphere", {{"radius", 1.0f}});
                 }),
                 lit([](Scene& s) {
                     return s.node("scale", {{"d", s.node("sphere", {{"radius", 0.5f}})}, {"factor", 2.0f}});
                 }));
}

TEST(Metamorphic, rounding_by_nothing_changes_nothing)
{
    expect_same(lit([](Scene& s) { return block(s); }), lit([](Scene& s) {
                    return s.node("round", {{"d", block(s)}, {"radius", 0.0f}});
                }));
}

TEST(Metamorphic, smoothing_by_almost_nothing_is_hard)
{
    for (auto [hard, smooth] : {std::pair("union", "smooth_union"), std::pair("subtract", "smooth_subtract"),
                                std::pair("intersect", "smooth_intersect")}) {
        Scene soft;
        const graph::Parameter& width = *soft.library->type(smooth)->parameter("smoothness");
        float smallest = std::max(1e-5f, static_cast<float>(width.minimum));
        expect_alike(lit([&](Scene& s) { return pair(s, hard, left_ball(s), block(s)); }), lit([&](Scene& s) {
                         return s.node(smooth, {{"a", left_ball(s)}, {"b", block(s)}, {"smoothness", smallest}});
                     }));
    }
}

TEST(Metamorphic, muting_is_bypassing)
{
    for (const char* type : {"round", "translate", "twist", "scale", "repeat"})
        expect_same(lit([](Scene& s) { return block(s); }), lit([&](Scene& s) {
                        NodeId muted = s.node(type, {{"d", block(s)}});
                        graph::set_muted(s.document, muted, true);
                        return muted;
                    }));
}

TEST(Metamorphic, grouping_changes_nothing)
{
    NodeId top;
    Scene flat = lit([&](Scene& s) {
        NodeId pieces = pair(s, "smooth_union", left_ball(s), ring(s));
        top = pair(s, "union", pieces, block(s));
        return top;
    });
    Scene grouped = flat;
    std::set<NodeId> inner;
    for (const graph::Node& node : flat.document.root.nodes)
        if (flat.type(node.id).is_field() && node.type != "output" && node.id != top) inner.insert(node.id);
    // The block and what moves it stay outside.
    for (NodeId id : {flat.document.root.find(top)->input("b"),
                      flat.document.root.find(flat.document.root.find(top)->input("b"))->input("d")})
        inner.erase(id);
    ASSERT_EQ(graph::group_nodes(grouped.document, *grouped.library, inner).refusal, std::nullopt);
    expect_same(flat, grouped);
}

TEST(Metamorphic, setting_a_number_from_outside_of_a_group_is_setting_it)
{
    auto ball = [](float radius) {
        return lit([&](Scene& s) { return moved(s, s.node("sphere", {{"radius", radius}}), 0.2f, 0.1f, 0); });
    };
    Scene flat = ball(0.9f), grouped = ball(0.4f);
    NodeId sphere, translate;
    for (const graph::Node& node : grouped.document.root.nodes) {
        if (node.type == "sphere") sphere = node.id;
        if (node.type == "translate") translate = node.id;
    }
    graph::Placed placed = graph::group_nodes(grouped.document, *grouped.library, {sphere, translate}, "Ball");
    ASSERT_EQ(placed.refusal, std::nullopt);
    grouped.library = graph::with_groups(*grouped.library, grouped.document);
    ASSERT_EQ(graph::expose(grouped.document, *grouped.library, "Ball", sphere, "radius"), std::nullopt);
    grouped.library = graph::with_groups(*grouped.library, grouped.document);
    grouped.set(placed.node, "radius", 0.9f);
    expect_same(flat, grouped);
}

// The text of a built-in node under another name, as its user's own.
TEST(Metamorphic, a_copy_of_a_node_as_an_own_type_changes_nothing)
{
    renderer::GpuDevice gpu;
    auto draw = [&](const Scene& scene) {
        renderer::FrameRequest request{.width = picture_side, .height = picture_side};
        return renderer::picture(gpu.render(scene.program(), request), renderer::View::beauty,
                                 scene.document.march.step_limit);
    };
    Scene built_in = lit([](Scene&s) { return pair(s, "smooth_union", block(s), ring(s)); }), own = built_in;
    for (const char* name : {"smooth_union", "torus", "box"}) {
        graph::OwnType copy = graph::renamed({name, own.library->type(name)->source.text}, std::string("my_") + name);
        ASSERT_EQ(graph::add_own_type(own.document, *own.library, copy), std::nullopt);
        for (graph::Node& node : own.document.root.nodes)
            if (node.type == name) node.type = copy.name;
    }
    own.library = graph::with_own_types(*graph::Library::embedded(), own.document.own_types);
    ASSERT_TRUE(own.program().gpu_only);
    EXPECT_TRUE(draw(built_in).rgb == draw(own).rgb) << "apart: " << share_apart(draw(built_in), draw(own));
}

TEST(Metamorphic, saving_and_opening_changes_nothing)
{
    Scene saved = lit([](Scene&s) { return pair(s, "smooth_union", left_ball(s), ring(s)); }), opened = saved;
    opened.document = graph::read_scene(graph::write_scene(saved.document, *saved.library), *saved.library);
    expect_same(saved, opened);
}

TEST(Metamorphic, undo_and_redo_change_nothing)
{
    Scene before = lit([](Scene&s) { return pair(s, "union", left_ball(s), block(s)); }), after = before;
    after.show(ring(after));
    graph::History history(before.document);
    history.record(after.document, "show the ring");
    ASSERT_TRUE(history.undo());
    Scene undone = before, redone = before;
    undone.document = history.current();
    expect_same(before, undone);
    ASSERT_TRUE(history.redo());
    redone.document = history.current();
    expect_same(after, redone);
}

// The other machine sees the same.
TEST(Metamorphic, the_gpu_draws_the_same_pairs)
{
    renderer::GpuDevice gpu;
    auto draw = [&](const Scene& scene) {
        renderer::FrameRequest request{.width = picture_side, .height = picture_side, .time = 0.6f};
        return renderer::picture(gpu.render(scene.program(), request), renderer::View::beauty,
                                 scene.document.march.step_limit);
    };
    Scene one = lit([](Scene& s) { return pair(s, "union", left_ball(s), block(s)); });
    Scene other = lit([](Scene& s) { return pair(s, "union", block(s), left_ball(s)); });
    EXPECT_TRUE(draw(one).rgb == draw(other).rgb);
    EXPECT_LE(share_apart(draw(one), picture_of(one)), 0.001);
}

}  // namespace
}  // namespace fieldwright::tests
