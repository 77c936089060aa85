// Domain operators and modifiers: where they put surfaces, against what is known about them without their formulas.
#include "tests/support/fields.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace fieldwright::tests {
namespace {

using glm::vec2;
using glm::vec3;
using Settings = std::initializer_list<Scene::Setting>;

const vec3 half(0.3f, 0.5f, 0.2f);

float box_at(vec3 p)
{
    vec3 q = glm::abs(p) - half;
    return glm::length(glm::max(q, vec3(0))) + std::min(std::max({q.x, q.y, q.z}), 0.0f);
}

std::vector<vec3> places()
{
    Random random(21);
    return sample_points(random, 3000);
}

std::vector<float> distances(Scene& scene, NodeId subject, const std::vector<vec3>& at)
{
    scene.show(subject);
    return Field(scene.program({.root = subject})).at(at);
}

// An operator on the box.
std::vector<float> of_box(std::string_view type, Settings settings, const std::vector<vec3>& at)
{
    Scene scene;
    NodeId subject = scene.node(type, settings);
    scene.wire(scene.node("box", {{"half_size", half}}), subject, "d");
    return distances(scene, subject, at);
}

template <typename Expected>
void expect_everywhere(std::string_view type, Settings settings, const Expected& expected, bool outside_only = false)
{
    std::vector<vec3> at = places();
    std::vector<float> found = of_box(type, settings, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
        float distance = expected(at[i]);
        if (outside_only && distance <= 0) continue;
        ASSERT_NEAR(found[i], distance, 2e-5f) << type << " at " << at[i].x << " " << at[i].y << " " << at[i].z;
    }
}

vec3 turned(vec3 p, float degrees, vec3 axis)
{
    return vec3(glm::rotate(glm::mat4(1), glm::radians(degrees), axis) * glm::vec4(p, 1));
}

TEST(Domain, rotates_about_any_axis_by_the_right_hand)
{
    vec3 axis(1, -2, 0.5f);
    expect_everywhere("rotate_axis", {{"axis", axis}, {"angle", 70.0f}},
                      [&](vec3 p) { return box_at(turned(p, -70, axis)); });
}

// Calls of the distance entry at every point.
std::size_t calls(const graph::Program& program)
{
    return static_cast<std::size_t>(program.distance.last - program.distance.first);
}

TEST(Moves, of_a_chain_become_one_that_means_the_same)
{
    Scene scene;
    NodeId top = scene.node("box", {{"half_size", half}});
    std::size_t movers = 0;
    for (const graph::NodeType* type : scene.library->types())
        if (type->affine) top = scene.node(type->name, {{"d", top}}), ++movers;
    EXPECT_GE(movers, 8u);
    scene.show(top);
    Field folded(scene.program({.root = top})), unfolded(scene.program({.root = top, .fold_moves = false}));
    EXPECT_EQ(calls(folded.program) + movers - 1, calls(unfolded.program));
    std::vector<vec3> at = places();
    std::vector<float> expected = unfolded.at(at), found = folded.at(at);
    for (std::size_t i = 0; i < at.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 2e-5f * (1 + glm::length(at[i])))
            << at[i].x << " " << at[i].y << " " << at[i].z;
}

TEST(Moves, that_differ_from_point_to_point_are_left_alone)
{
    Scene scene;
    NodeId place = scene.node("position");
    NodeId inner = scene.node("translate", {{"d", scene.node("box")}, {"offset", place}});
    NodeId outer = scene.node("translate", {{"d", inner}});
    scene.show(outer);
    std::size_t moves = 0;
    graph::Program program = scene.program({.root = outer});
    for (std::int32_t i = program.distance.first; i < program.distance.last; ++i)
        moves += program.instructions[static_cast<std::size_t>(i)].function->name == "translate_point" ? 1 : 0;
    EXPECT_EQ(moves, 2u);
}

TEST(Domain, looks_at_its_target_and_stays_upright)
{
    vec3 target(1, 2, -0.5f), forward = glm::normalize(target);
    Scene scene;
    NodeId arm = scene.node("translate", {{"d", scene.node("sphere", {{"radius", 0.1f}})}, {"offset", vec3(0, 0, 2)}});
    NodeId aimed = scene.node("look_at", {{"d", arm}, {"target", target}});
    EXPECT_NEAR(distances(scene, aimed, {2.0f * forward})[0], -0.1f, 1e-5f);
    vec3 right = glm::normalize(glm::cross(vec3(0, 1, 0), forward)), up = glm::cross(forward, right);
    expect_everywhere("look_at", {{"target", target}}, [&](vec3 p) {
        return box_at({glm::dot(p, right), glm::dot(p, up), glm::dot(p, forward)});
    });
}

TEST(Domain, transforms_as_scale_then_rotate_then_translate)
{
    Scene scene;
    NodeId box = scene.node("box", {{"half_size", half}});
    NodeId scaled = scene.node("scale", {{"d", box}, {"factor", 1.7f}});
    NodeId rotated = scene.node("rotate", {{"d", scaled}, {"angles", vec3(20, 30, 40)}});
    NodeId moved = scene.node("translate", {{"d", rotated}, {"offset", vec3(1, 2, 3)}});
    std::vector<float> expected = distances(scene, moved, places());
    std::vector<float> found =
        of_box("transform", {{"offset", vec3(1, 2, 3)}, {"angles", vec3(20, 30, 40)}, {"factor", 1.7f}}, places());
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-5f);
}

// The nearest of the copies, each for itself.
float nearest(vec3 p, const std::vector<vec3>& copies)
{
    float distance = 1e6f;
    for (const vec3& copy : copies) distance = std::min(distance, box_at(p - copy));
    return distance;
}

TEST(Domain, repeats_in_rows_exactly)
{
    std::vector<vec3> copies;
    for (int i = 0; i < 4; ++i) copies.emplace_back(0, 0, 0.7f * static_cast<float>(i) - 1.05f);
    expect_everywhere(
        "repeat_1d", {{"axis", std::string("z")}, {"spacing", 0.7f}, {"count", 4}},
        [&](vec3 p) { return nearest(p, copies); }, true);
}

TEST(Domain, repeats_in_honeycombs_exactly)
{
    std::vector<vec3> copies;
    for (int row = -12; row <= 12; ++row)
        for (int i = -16; i <= 16; ++i)
            copies.emplace_back(0.8f * (static_cast<float>(i) + (row % 2 ? 0.5f : 0.0f)), 0,
                                0.8f * 0.8660254f * static_cast<float>(row));
    expect_everywhere(
        "repeat_hexagonal", {{"spacing", 0.8f}}, [&](vec3 p) { return nearest(p, copies); }, true);
}

TEST(Domain, repeats_flat_shapes_exactly)
{
    Scene scene;
    NodeId block = scene.node(
        "repeat_2d",
        {{"d", scene.node("circle", {{"radius", 0.3f}})}, {"spacing", vec2(0.9f, 0.8f)}, {"count", vec2(3, 2)}});
    NodeId solid = scene.node("extrude", {{"d", block}});
    scene.show(solid);
    Field field(scene.program({.root = block}));
    for (vec3 p : places()) {
        p.z = 0;
        float expected = 1e6f;
        for (float x : {-0.9f, 0.0f, 0.9f})
            for (float y : {-0.4f, 0.4f}) expected = std::min(expected, glm::distance(p, vec3(x, y, 0)) - 0.3f);
        if (expected <= 0) continue;
        ASSERT_NEAR(field.at(std::vector<vec3>{p})[0], expected, 1e-5f) << p.x << " " << p.y;
    }
}

TEST(Domain, mirrors_show_the_same_on_both_sides)
{
    std::vector<vec3> at = places(), opposite;
    vec3 normal = glm::normalize(vec3(1, 2, 3));
    for (const vec3& p : at) opposite.push_back(p - 2 * glm::dot(p, normal) * normal);
    Settings plane = {{"normal", vec3(1, 2, 3)}, {"offset", 0.4f}};
    std::vector<float> here = of_box("mirror_plane", plane, at), there = of_box("mirror_plane", plane, opposite);
    for (std::size_t i = 0; i < at.size(); ++i) {
        ASSERT_NEAR(here[i], there[i], 2e-5f);
        float side = glm::dot(at[i], normal);
        if (side <= 0) continue;
        ASSERT_NEAR(here[i], box_at(at[i] - 0.4f * normal), 2e-5f);
    }
    expect_everywhere("symmetry_three_axes", {{"offset", vec3(1, 2, 0.5f)}},
                      [](vec3 p) { return box_at(glm::abs(p) - vec3(1, 2, 0.5f)); });
    expect_everywhere("symmetry_two_axes", {{"axes", std::string("xy")}, {"offset", vec2(1, 0.5f)}},
                      [](vec3 p) { return box_at(vec3(std::abs(p.x) - 1, std::abs(p.y) - 0.5f, p.z)); });
}

TEST(Domain, the_symmetry_of_a_cube_ignores_order_and_sign_of_coordinates)
{
    std::vector<vec3> at = places(), other;
    for (const vec3& p : at) other.emplace_back(-p.z, p.x, -p.y);
    Settings settings = {{"offset", vec3(0.8f, 0.3f, 0.1f)}};
    EXPECT_EQ(of_box("symmetry_cube", settings, at), of_box("symmetry_cube", settings, other));
    EXPECT_LT(of_box("symmetry_cube", settings, {vec3(0.1f, -0.3f, 0.8f)})[0], 0);
}

TEST(Domain, mirrored_cells_meet_at_their_borders)
{
    expect_everywhere("repeat_mirrored", {{"spacing", vec3(1.2f, 0, 0)}}, [](vec3 p) {
        float turn = std::fmod(std::abs(p.x + 0.6f), 2.4f);
        return box_at({turn < 1.2f ? turn - 0.6f : 1.8f - turn, p.y, p.z});
    });
}

TEST(Domain, twists_and_bends_are_the_same_on_every_axis)
{
    Scene scene;
    NodeId box = scene.node("box", {{"half_size", half}});
    NodeId twist = scene.node("twist", {{"d", box}, {"turn", 80.0f}});
    std::vector<float> expected = distances(scene, twist, places());
    std::vector<float> found = of_box("twist_axis", {{"axis", std::string("y")}, {"turn", 80.0f}}, places());
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-5f);
    // A box that lies along another axis, seen with exchanged coordinates.
    const std::vector<std::pair<std::string, std::array<int, 3>>> ways = {{"x_to_y", {0, 1, 2}}, {"x_to_z", {0, 2, 1}},
                                                                          {"y_to_x", {1, 0, 2}}, {"y_to_z", {1, 2, 0}},
                                                                          {"z_to_x", {2, 0, 1}}, {"z_to_y", {2, 1, 0}}};
    for (const auto& [way, order] : ways) {
        SCOPED_TRACE(way);
        Scene lying;
        NodeId bend = lying.node("bend", {{"d", lying.node("box", {{"half_size", half}})}, {"turn", 50.0f}});
        expected = distances(lying, bend, places());
        vec3 size;
        std::vector<vec3> at;
        for (const vec3& p : places()) {
            vec3 q;
            for (int i = 0; i < 3; ++i) q[order[static_cast<std::size_t>(i)]] = p[i];
            at.push_back(q);
        }
        for (int i = 0; i < 3; ++i) size[order[static_cast<std::size_t>(i)]] = half[i];
        Scene other;
        NodeId turned_bend =
            other.node("bend_axis", {{"d", other.node("box", {{"half_size", size}})}, {"axes", way}, {"turn", 50.0f}});
        found = distances(other, turned_bend, at);
        for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-5f);
    }
}

TEST(Domain, an_inverted_ball_is_a_ball)
{
    Scene scene;
    NodeId ball = scene.node("sphere", {{"radius", 0.5f}});
    NodeId inverted = scene.node("inversion", {{"d", ball}, {"radius", 2.0f}, {"offset", vec3(1.5f, 0, 0)}});
    // It spans 1 to 2, so its image spans 4 / 2 to 4 / 1.
    std::vector<vec3> at = places();
    std::vector<float> found = distances(scene, inverted, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
        float truth = glm::distance(at[i], vec3(3, 0, 0)) - 1.0f;
        ASSERT_LE(std::abs(found[i]), std::abs(truth) + 1e-4f);
        if (std::abs(truth) < 1e-3f) continue;
        ASSERT_EQ(found[i] < 0, truth < 0);
    }
}

TEST(Domain, a_wind_holds_the_foot_and_pushes_the_top_by_its_whole_length)
{
    Settings wind = {{"push", vec2(0.6f, 0.2f)}, {"base", -0.5f}, {"height", 1.0f}};
    std::vector<float> found = of_box("wind_bend", wind, {vec3(0.31f, -0.5f, 0), vec3(0.89f, 0.499f, 0.2f)});
    EXPECT_GT(found[0], 0);
    EXPECT_LT(found[1], 0);
}

TEST(Domain, a_taper_has_the_given_width_at_both_ends)
{
    Settings taper = {{"top", 0.5f}, {"height", 1.0f}};
    std::vector<float> found =
        of_box("taper", taper,
               {vec3(0.29f, -0.49f, 0), vec3(0.31f, -0.49f, 0), vec3(0.145f, 0.49f, 0), vec3(0.16f, 0.49f, 0)});
    EXPECT_LT(found[0], 0);
    EXPECT_GT(found[1], 0);
    EXPECT_LT(found[2], 0);
    EXPECT_GT(found[3], 0);
}

TEST(Domain, rings_of_the_logarithm_are_similar)
{
    Settings rings = {{"radius", 1.0f}, {"count", 5}, {"ratio", 2.0f}, {"rings", 5}};
    std::vector<vec3> at, inner;
    for (const vec3& p : places())
        if (glm::length(p) < 1.3f && glm::length(p) > 0.75f) at.push_back(p), inner.push_back(p / 4.0f);
    std::vector<float> outer = of_box("log_polar", rings, at), small = of_box("log_polar", rings, inner);
    ASSERT_GT(at.size(), 100u);
    for (std::size_t i = 0; i < at.size(); ++i) ASSERT_NEAR(outer[i], 4 * small[i], 1e-4f);
}

TEST(Modify, clips_keep_what_they_say)
{
    vec3 middle(0.2f, 0.3f, 0);
    auto ball = [&](vec3 p) { return glm::distance(p, middle) - 0.3f; };
    for (bool inside : {true, false})
        expect_everywhere("clip_sphere",
                          {{"keep", std::string(inside ? "inside" : "outside")}, {"centre", middle}, {"radius", 0.3f}},
                          [&](vec3 p) { return std::max(box_at(p), inside ? ball(p) : -ball(p)); });
    expect_everywhere("clip_plane", {{"normal", vec3(0, 2, 0)}, {"offset", 0.1f}},
                      [](vec3 p) { return std::max(box_at(p), p.y - 0.1f); });
    expect_everywhere("clip_box", {{"keep", std::string("inside")}, {"centre", vec3(0)}, {"half_size", half}},
                      [](vec3 p) { return box_at(p); });
}

// Where the twisted box says little, the guard says how far it is at least.
TEST(Modify, a_guard_tells_more_about_steep_fields_far_away)
{
    Scene scene;
    NodeId box = scene.node("box", {{"half_size", half}});
    NodeId twist = scene.node("twist", {{"d", box}, {"turn", 300.0f}});
    NodeId guard = scene.node("box", {{"half_size", vec3(0.5f)}});
    NodeId guarded = scene.node("bounded", {{"a", twist}, {"b", guard}, {"margin", 0.1f}});
    vec3 far(4, 0, 0);
    EXPECT_LT(distances(scene, twist, {far})[0], 2.5f);
    EXPECT_NEAR(distances(scene, guarded, {far})[0], 3.4f, 1e-5f);
}

TEST(Modify, an_onion_has_its_layers_at_their_depths)
{
    Settings onion = {{"layers", 2}, {"spacing", 0.1f}, {"thickness", 0.02f}};
    std::vector<vec3> down;
    for (float depth : {0.0f, 0.05f, 0.1f, 0.15f, 0.195f}) down.emplace_back(0, 0, half.z - depth);
    std::vector<float> found = of_box("nested_shells", onion, down);
    EXPECT_NEAR(found[0], -0.01f, 1e-5f);
    EXPECT_NEAR(found[1], 0.04f, 1e-5f);
    EXPECT_NEAR(found[2], -0.01f, 1e-5f);
    EXPECT_NEAR(found[3], 0.04f, 1e-5f);
    EXPECT_NEAR(found[4], 0.085f, 1e-5f);
}

TEST(Modify, offsets_and_inverts)
{
    expect_everywhere("offset", {{"amount", -0.1f}}, [](vec3 p) { return box_at(p) + 0.1f; });
    expect_everywhere("invert", {}, [](vec3 p) { return -box_at(p); });
}

}  // namespace
}  // namespace fieldwright::tests
