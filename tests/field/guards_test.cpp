// Guarded parts of unions: they stand behind their rivals, are left out where they do not matter, and change nothing.
#include "field/steps.h"
#include "tests/support/fields.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace fieldwright::tests {
namespace {

using field::Step;
using glm::vec3;

// A twisted, carved bar in a guard of a ball.
struct Guarded {
    NodeId part, ball, whole;
};

Guarded guarded(Scene& scene)
{
    NodeId bar = scene.node("subtract", {{"a", scene.node("box", {{"half_size", vec3(0.3f, 0.8f, 0.3f)}})},
                                         {"b", scene.node("cylinder", {{"radius", 0.2f}, {"height", 3.0f}})}});
    NodeId part = scene.node("twist", {{"d", bar}, {"turn", 120.0f}});
    NodeId ball = scene.node("sphere", {{"radius", 1.0f}});
    return {part, ball, scene.node("bounded", {{"a", part}, {"b", ball}, {"margin", 0.05f}})};
}

NodeId moved(Scene& scene, NodeId field, vec3 offset)
{
    return scene.node("translate", {{"d", field}, {"offset", offset}});
}

NodeId floor_of(Scene& scene) { return scene.node("plane", {{"height", -1.0f}}); }

std::vector<vec3> points_around(vec3 middle, float reach)
{
    Random random(7);
    std::vector<vec3> points;
    for (int i = 0; i < 2000; ++i) points.push_back(middle + random.in_cube(reach));
    return points;
}

std::vector<float> distances(const Scene& scene, NodeId root, const std::vector<vec3>& points)
{
    return Field(scene.program({.root = root})).at(points);
}

int count(const field::Plan& plan, Step::Kind kind)
{
    return static_cast<int>(
        std::count_if(plan.steps.begin(), plan.steps.end(), [&](const Step& step) { return step.kind == kind; }));
}

TEST(Guards, a_union_is_the_same_to_the_bit)
{
    Scene scene;
    Guarded bar = guarded(scene);
    NodeId ground = floor_of(scene), both = scene.node("union", {{"a", bar.whole}, {"b", ground}});
    // Rows far from the guard and near the ground, rows within it, and rows of both.
    for (vec3 middle : {vec3(6, -0.5f, 0), vec3(0), vec3(1, 0, 0)}) {
        std::vector<vec3> points = points_around(middle, 1);
        std::vector<float> whole = distances(scene, bar.whole, points), low = distances(scene, ground, points);
        std::vector<float> found = distances(scene, both, points);
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i], std::min(whole[i], low[i]));
    }
}

TEST(Guards, the_guarded_part_stands_behind_its_rivals)
{
    Scene scene;
    NodeId bar = guarded(scene).whole;
    NodeId both = scene.node("union", {{"a", bar}, {"b", floor_of(scene)}});
    graph::Program program = scene.program({.root = both});
    field::Plan plan = field::plan_of(program, program.distance);
    ASSERT_EQ(plan.guards.size(), 1u);
    ASSERT_EQ(plan.guards[0].rivals.size(), 1u);
    auto step_of = [&](auto is) { return std::find_if(plan.steps.begin(), plan.steps.end(), is) - plan.steps.begin(); };
    auto begin = step_of([](const Step& step) { return step.kind == Step::Kind::begin_guard; });
    auto rival = step_of(
        [&](const Step& step) { return step.instruction && step.instruction->result == plan.guards[0].rivals[0]; });
    auto guarded_call = step_of(
        [&](const Step& step) { return step.instruction && step.instruction->result == plan.guards[0].guarded; });
    auto end = step_of([](const Step& step) { return step.kind == Step::Kind::end_guard; });
    EXPECT_LT(rival, begin);
    EXPECT_LT(begin, guarded_call);
    EXPECT_LT(guarded_call, end);
}

TEST(Guards, many_in_one_union_are_each_others_rivals)
{
    Scene scene;
    NodeId all = floor_of(scene);
    for (float x : {-4.0f, 0.0f, 4.0f})
        all = scene.node("union", {{"a", moved(scene, guarded(scene).whole, {x, 0, 0})}, {"b", all}});
    graph::Program program = scene.program({.root = all});
    field::Plan plan = field::plan_of(program, program.distance);
    ASSERT_EQ(plan.guards.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(plan.guards[i].rivals.size(), i + 1);
}

TEST(Guards, work_inside_repeats_and_around_them)
{
    Scene scene;
    NodeId cell = scene.node("union", {{"a", guarded(scene).whole}, {"b", scene.node("sphere", {{"radius", 0.4f}})}});
    NodeId field = scene.node("repeat_limited", {{"d", cell}, {"spacing", vec3(3)}});
    NodeId box = scene.node("box", {{"half_size", vec3(5, 1.2f, 5)}});
    NodeId around = scene.node("bounded", {{"a", field}, {"b", box}, {"margin", 0.1f}});
    NodeId ground = floor_of(scene), all = scene.node("union", {{"a", around}, {"b", ground}});
    graph::Program program = scene.program({.root = all});
    field::Plan plan = field::plan_of(program, program.distance);
    EXPECT_EQ(count(plan, Step::Kind::begin_guard), 2);
    EXPECT_EQ(count(plan, Step::Kind::end_guard), 2);
    for (vec3 middle : {vec3(0, 0, 0), vec3(3, 0, 3), vec3(0, -0.9f, 20)}) {
        std::vector<vec3> points = points_around(middle, 2);
        std::vector<float> parts = distances(scene, around, points), low = distances(scene, ground, points);
        std::vector<float> found = distances(scene, all, points);
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i], std::min(parts[i], low[i]));
    }
}

// What is used elsewhere as well is needed in any case.
TEST(Guards, what_others_use_too_is_not_left_out)
{
    Scene scene;
    Guarded bar = guarded(scene);
    NodeId upper = scene.node("intersect", {{"a", bar.part}, {"b", scene.node("box")}});
    NodeId both = scene.node("union", {{"a", bar.whole}, {"b", upper}});
    graph::Program program = scene.program({.root = both});
    EXPECT_TRUE(field::plan_of(program, program.distance).guards.empty());
}

}  // namespace
}  // namespace fieldwright::tests
