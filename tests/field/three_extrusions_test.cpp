// Three extrusions: what is seen along the axes, and inputs left out.
#include "tests/support/fields.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using glm::vec3;

struct Views {
    Scene scene;
    NodeId node = scene.node("three_extrusions");

    std::vector<float> at(const std::vector<vec3>& points) { return Field(scene.program({.root = node})).at(points); }
    bool solid(vec3 p) { return at({p})[0] < 0; }
};

// An L in every view, so that a mirrored or turned view shows.
NodeId letter_l(Scene& scene)
{
    NodeId upright = scene.node("rectangle", {{"half_size", glm::vec2(0.2f, 1.0f)}});
    NodeId foot = scene.node("rectangle", {{"half_size", glm::vec2(0.5f, 0.2f)}});
    return scene.node("union", {{"a", scene.node("translate_2d", {{"d", upright}, {"offset", glm::vec2(-0.6f, 0)}})},
                                {"b", scene.node("translate_2d", {{"d", foot}, {"offset", glm::vec2(0.1f, -0.8f)}})}});
}

TEST(ThreeExtrusions, show_each_drawing_from_its_side)
{
    for (const char* socket : {"a", "b", "c"}) {
        Views views;
        views.scene.wire(letter_l(views.scene), views.node, socket);
        // What the viewer sees to the right and up, as points in space.
        auto seen = [&](float right, float up) {
            if (socket[0] == 'a') return views.solid({right, up, 7});
            if (socket[0] == 'b') return views.solid({7, up, -right});
            return views.solid({right, 7, -up});
        };
        EXPECT_TRUE(seen(-0.6f, 0.9f) && seen(-0.6f, -0.9f) && seen(0.5f, -0.8f)) << socket;
        EXPECT_FALSE(seen(0.5f, 0.8f) || seen(0.6f, 0.9f) || seen(-0.1f, 0)) << socket;
    }
}

TEST(ThreeExtrusions, leave_the_intersection_of_all_three)
{
    Views views;
    views.scene.set(views.node, "trim", 0.0f);
    views.scene.wire(views.scene.node("circle", {{"radius", 1.0f}}), views.node, "a");
    views.scene.wire(views.scene.node("circle", {{"radius", 1.0f}}), views.node, "b");
    views.scene.wire(views.scene.node("circle", {{"radius", 1.0f}}), views.node, "c");
    Random random(3);
    std::vector<vec3> points;
    for (int i = 0; i < 500; ++i) points.push_back(random.in_cube(1.5f));
    std::vector<float> distances = views.at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const vec3& p = points[i];
        float front = std::hypot(p.x, p.y), right = std::hypot(p.z, p.y), above = std::hypot(p.x, p.z);
        EXPECT_NEAR(distances[i], std::max({front, right, above}) - 1, 1e-5f);
    }
}

TEST(ThreeExtrusions, switched_off_or_unwired_views_cut_nothing)
{
    Views views;
    EXPECT_EQ(views.at({vec3(0)})[0], 1e6f) << "nothing wired: nothing there";
    views.scene.wire(views.scene.node("circle", {{"radius", 1.0f}}), views.node, "a");
    views.scene.wire(views.scene.node("rectangle", {{"half_size", glm::vec2(0.5f)}}), views.node, "c");
    EXPECT_FALSE(views.solid({0.8f, 0, 0}));
    EXPECT_TRUE(views.solid({0.4f, 0.8f, 0.4f}));
    views.scene.set(views.node, "above", false);
    EXPECT_TRUE(views.solid({0.8f, 0, 40}));
    views.scene.set(views.node, "front", false);
    EXPECT_EQ(views.at({vec3(0)})[0], 1e6f) << "all off: nothing there";
    views.scene.set(views.node, "above", true);
    EXPECT_TRUE(views.solid({0.4f, 30, 0.4f}));
}

// Below the upper half lies nothing but, where the views touch, a film without thickness.
TEST(ThreeExtrusions, leave_no_film_where_views_only_touch)
{
    Views views;
    auto half_plane = [&](float y) {
        NodeId box = views.scene.node("rectangle", {{"half_size", glm::vec2(1.0f)}});
        return views.scene.node("translate_2d", {{"d", box}, {"offset", glm::vec2(0, y)}});
    };
    views.scene.wire(half_plane(1), views.node, "a");
    views.scene.wire(half_plane(-1), views.node, "b");
    EXPECT_GT(views.at({vec3(0)})[0], 1e-4f);
    views.scene.set(views.node, "trim", 0.0f);
    EXPECT_EQ(views.at({vec3(0)})[0], 0);
}

TEST(ThreeExtrusions, wear_the_material_of_the_view_that_cut_them)
{
    Views views;
    std::vector<NodeId> paints;
    const char* sockets[] = {"a", "b", "c"};
    for (int i = 0; i < 3; ++i) {
        NodeId material = views.scene.node("phong", {{"albedo", vec3(i == 0, i == 1, i == 2)}});
        NodeId shape = views.scene.node("rectangle", {{"half_size", glm::vec2(0.5f + 0.1f * static_cast<float>(i))}});
        paints.push_back(shape);
        NodeId paint = views.scene.node("paint", {{"d", shape}, {"material", material}});
        views.scene.wire(paint, views.node, sockets[i]);
    }
    views.scene.show(views.node);
    graph::Program program = views.scene.program();
    std::vector<float> block = field::evaluate_frame(program, 0);
    field::Evaluator evaluator(program, program.surface);
    field::Evaluator::Workspace workspace(evaluator);
    const vec3 points[] = {{0.5f, 0, 0}, {0, 0.5f, 0}, {0, 0, 0.6f}};  // faces of a, a and b
    for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis) workspace.input(axis)[i] = points[i][axis];
    evaluator.evaluate(workspace, block, 3);
    int lanes = evaluator.result_lanes();
    EXPECT_EQ(workspace.result(lanes - 1)[0], static_cast<float>(paints[0].number));
    EXPECT_EQ(workspace.result(lanes - 1)[1], static_cast<float>(paints[0].number));
    EXPECT_EQ(workspace.result(lanes - 1)[2], static_cast<float>(paints[1].number));
    EXPECT_EQ(workspace.result(0)[0], 1);
    EXPECT_EQ(workspace.result(1)[2], 1);
}

TEST(ThreeExtrusions, name_their_inputs_by_the_view)
{
    const graph::NodeType& type = *graph::Library::embedded()->type("three_extrusions");
    EXPECT_EQ(type.output, graph::SocketKind::field3d);
    ASSERT_GE(type.inputs.size(), 3u);
    EXPECT_EQ(type.inputs[0].kind, graph::SocketKind::field2d);
    EXPECT_EQ(type.inputs[2].kind, graph::SocketKind::field2d);
    EXPECT_EQ(type.inputs[2].title, "View from above");
}

}  // namespace
}  // namespace fieldwright::tests
