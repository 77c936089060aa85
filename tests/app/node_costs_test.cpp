// What nodes cost: pictures without them.
#include "app/node_costs.h"

#include "graph/edits.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace fieldwright::tests {
namespace {

using glm::vec3;

struct Fractal {
    Fractal()
    {
        ball = scene.node("translate", {{"d", scene.node("sphere")}, {"offset", vec3(-1.6f, 0, 0)}});
        sponge = scene.node("translate", {{"d", scene.node("mandelbulb")}, {"offset", vec3(1.2f, 0, 0)}});
        scene.show(scene.node("union", {{"a", ball}, {"b", sponge}}));
    }
    app::CostTask task() const { return {scene.document, scene.library, {}, {.width = 64, .height = 36}}; }

    Scene scene;
    NodeId ball, sponge;
};

TEST(NodeCosts, a_node_gives_way_to_a_box_around_it)
{
    Fractal fractal;
    graph::Document without = app::without_node(fractal.task(), fractal.ball);
    EXPECT_EQ(graph::validate(without, *fractal.scene.library), std::nullopt);
    for (const graph::Node& node : without.root.nodes)
        for (const auto& [socket, source] : node.inputs) EXPECT_NE(source, fractal.ball) << socket;
    auto is_box = [](const graph::Node& node) { return node.type == "box"; };
    EXPECT_EQ(std::count_if(without.root.nodes.begin(), without.root.nodes.end(), is_box), 1);
}

TEST(NodeCosts, a_node_without_end_gives_way_to_nothing)
{
    Scene scene;
    NodeId floor = scene.node("plane");
    NodeId all = scene.node("union", {{"a", scene.node("sphere")}, {"b", floor}});
    scene.show(all);
    app::CostTask task{scene.document, scene.library, {}, {.width = 64, .height = 36}};
    graph::Document without = app::without_node(task, floor);
    EXPECT_EQ(graph::validate(without, *scene.library), std::nullopt);
    EXPECT_FALSE(without.root.find(all)->input("b"));
}

TEST(NodeCosts, a_fractal_is_dearer_than_a_ball)
{
    Fractal fractal;
    app::CostTask task = fractal.task();
    double whole = app::picture_ms(task, task.document);
    double without_ball = app::picture_ms(task, app::without_node(task, fractal.ball));
    double without_sponge = app::picture_ms(task, app::without_node(task, fractal.sponge));
    EXPECT_GT(whole, 0);
    EXPECT_GT(whole - without_sponge, 2 * (whole - without_ball));
}

TEST(NodeCostMeter, measures_every_shape_once_and_forgets)
{
    Fractal fractal;
    app::NodeCostMeter meter([] {});
    EXPECT_FALSE(meter.costs().measuring);
    meter.measure(fractal.task());
    EXPECT_TRUE(meter.costs().measuring);
    while (meter.costs().measuring) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ui::NodeCosts costs = meter.costs();
    EXPECT_TRUE(costs.failure.empty()) << costs.failure;
    EXPECT_GT(costs.picture_ms, 0);
    EXPECT_EQ(costs.by_node.size(), 5u) << "two shapes, their moves, and the union";
    for (const auto& [node, ms] : costs.by_node) EXPECT_GE(ms, 0);
    meter.forget();
    EXPECT_TRUE(meter.costs().by_node.empty());
}

}  // namespace
}  // namespace fieldwright::tests
