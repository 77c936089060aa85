// Formulas in programs: the machine computes what the text says, and a text that cannot be read costs one node.
#include "graph/formula.h"
#include "graph/curve.h"
#include "tests/support/fields.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using glm::vec3;
using Severity = graph::Problem::Severity;

// The numbers an expression gives at points, as the height of a plane over them.
struct Heights {
    explicit Heights(std::string_view formula, std::initializer_list<Scene::Setting> numbers = {})
    {
        expression = scene.node("expression", numbers);
        scene.set(expression, "formula", std::string(formula));
        plane = scene.node("plane", {{"height", expression}});
        scene.show(plane);
    }

    std::vector<float> at(const std::vector<vec3>& points, float time = 0) const
    {
        Field field(scene.program({.root = plane}), time);
        std::vector<float> heights = field.at(points);
        for (std::size_t i = 0; i < points.size(); ++i) heights[i] = points[i].y - heights[i] * field.lipschitz();
        return heights;
    }

    Scene scene;
    NodeId expression, plane;
};

std::vector<graph::Problem> errors_of(const graph::Program& program)
{
    std::vector<graph::Problem> errors;
    for (const graph::Problem& problem : program.problems)
        if (problem.severity == Severity::error) errors.push_back(problem);
    return errors;
}

std::vector<vec3> some_points(std::size_t count, float reach = 2)
{
    Random random(21);
    std::vector<vec3> points;
    while (points.size() < count) points.push_back(random.in_cube(reach));
    return points;
}

const char* const formulas[] = {
    "x * y - z / (2 + x * x) + 0.25",
    "sin(3 * x) * cos(2 * y + 1) + tan(z / 2)",
    "asin(x / 2) + acos(y / 3) + atan(z) + atan2(y, x)",
    "sqrt(x^2 + z^2) - abs(y) + sqrt(abs(z))",
    "min(x, y, z) * max(x, 0.5) + clamp(z, -0.5, 0.25)",
    "mix(x, y, 0.3) + floor(2 * z) + fract(y)",
    "mod(x, 0.7) + sign(y) * exp(z) - log(2.5 + y)",
    "abs(x)^1.7 + x^5 - 2^y + z^-2 / 100",
    "x < y ? x : y >= z ? smoothstep(-1, 1, z) : step(0, x)",
    "a * x + b * length(x, y, z) - c * time + d",
};

TEST(Formulas, the_machine_computes_what_the_text_says)
{
    std::vector<vec3> points = some_points(3000);
    Scene probe;
    const graph::NodeType& type = *probe.library->type("expression");
    for (const char* text : formulas) {
        Heights heights(text, {{"a", 1.5f}, {"b", -0.5f}, {"c", 2.0f}, {"d", 0.125f}});
        std::vector<float> found = heights.at(points, 0.75f);
        auto formula = std::get<graph::Formula>(graph::parse_formula(text, type));
        int apart = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const vec3& p = points[i];
            double expected = graph::evaluate(formula, std::vector<double>{p.x, p.y, p.z, 0.75, 1.5, -0.5, 2, 0.125});
            expected = std::clamp(expected, -1000.0, 1000.0);
            // At a jump, single precision may stand on the other side.
            apart += std::abs(static_cast<double>(found[i]) - expected) <= 2e-5 * (1 + std::abs(expected)) ? 0 : 1;
        }
        EXPECT_LE(apart, 3) << text;
    }
}

TEST(Formulas, are_as_constant_as_what_they_use)
{
    auto rate = [](std::string_view text) {
        Heights heights(text);
        graph::Program program = heights.scene.program({.root = heights.plane});
        graph::Rate highest = graph::Rate::constant;
        for (const graph::Instruction& instruction : program.instructions)
            if (instruction.node == heights.expression)
                highest = std::max(highest, program.values[static_cast<std::size_t>(instruction.result)].rate);
        return highest;
    };
    EXPECT_EQ(rate("a * sin(b) + 2"), graph::Rate::constant);
    EXPECT_EQ(rate("a * sin(time)"), graph::Rate::frame);
    EXPECT_EQ(rate("a * sin(x)"), graph::Rate::point);
}

TEST(Formulas, a_wire_that_the_formula_does_not_use_costs_nothing)
{
    Heights heights("a + 1");
    heights.scene.wire(heights.scene.node("component", {{"vector", heights.scene.node("position")}}),
                       heights.expression, "b");
    graph::Program program = heights.scene.program({.root = heights.plane});
    EXPECT_EQ(program.distance.last - program.distance.first, 1 + 1) << "the plane, and the division by its slope";
}

TEST(Formulas, one_that_cannot_be_read_costs_its_node_only)
{
    Heights heights("sin(x");
    NodeId ball = heights.scene.node("sphere");
    NodeId both = heights.scene.node("union", {{"a", heights.plane}, {"b", ball}});
    heights.scene.show(both);
    graph::Program program = heights.scene.program();
    ASSERT_EQ(errors_of(program).size(), 1u);
    EXPECT_EQ(errors_of(program)[0].node, heights.expression);
    EXPECT_EQ(errors_of(program)[0].sentence,
              "its formula cannot be read, column 4: a bracket is not closed; the node counts as unconnected");
    EXPECT_NEAR(Field(std::move(program)).at(std::vector<vec3>{vec3(0, 0.5f, 0)})[0], -0.5f, 1e-6f);
}

TEST(Formulas, an_implicit_surface_that_cannot_be_read_leaves_the_rest)
{
    Scene scene;
    NodeId broken = scene.node("implicit", {{"formula", std::string("x^2 + ")}});
    NodeId ball = scene.node("sphere", {{"radius", 0.5f}});
    scene.show(scene.node("union", {{"a", broken}, {"b", ball}}));
    graph::Program program = scene.program();
    ASSERT_EQ(errors_of(program).size(), 1u);
    EXPECT_EQ(errors_of(program)[0].node, broken);
    EXPECT_NEAR(Field(std::move(program)).at(std::vector<vec3>{vec3(2, 0, 0)})[0], 1.5f, 1e-6f);
}

TEST(Formulas, an_implicit_sphere_is_a_sphere_in_its_box)
{
    Scene scene;
    NodeId ball = scene.node("implicit", {{"formula", std::string("sqrt(x^2 + y^2 + z^2) - k")}, {"k", 0.75f}});
    scene.set(ball, "half_size", vec3(0.8f, 0.8f, 0.5f));
    scene.show(ball);
    Field field(scene.program());
    EXPECT_TRUE(field.program.problems.empty());
    std::vector<vec3> points = {vec3(0), vec3(0.5f, 0, 0), vec3(0, 0.78f, 0), vec3(0.3f, 0.2f, 0.5f), vec3(0, 0, 1.5f)};
    std::vector<float> distances = field.at(points);
    EXPECT_NEAR(distances[0], -0.5f, 1e-5f) << "the box is nearer than the ball";
    EXPECT_NEAR(distances[1], -0.25f, 1e-5f);
    EXPECT_NEAR(distances[2], 0.03f, 1e-5f);
    EXPECT_NEAR(distances[3], 0, 1e-5f) << "on the box";
    EXPECT_NEAR(distances[4], 1, 1e-5f);
}

TEST(Formulas, a_slope_without_a_bound_is_told)
{
    Scene scene;
    NodeId node = scene.node("implicit", {{"formula", std::string("y - sqrt(x)")}});
    scene.show(node);
    graph::Program program = scene.program();
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].severity, Severity::note);
    EXPECT_NE(program.problems[0].sentence.find("steeper than any number"), std::string::npos);
}

TEST(Curves, the_one_that_is_drawn_is_the_one_that_is_computed)
{
    Random random(4);
    for (int round = 0; round < 40; ++round) {
        graph::PointList points;
        for (int count = random.below(8); count >= 0; --count)
            points.emplace_back(0.25f * static_cast<float>(random.below(round % 2 ? 9 : 900)) * (round % 2 ? 1 : 0.01f),
                                random.between(-1, 1), 0, 0);
        bool smooth = random.chance(0.5f);
        Scene scene;
        NodeId place = scene.node("component", {{"vector", scene.node("position")}, {"axis", std::string("x")}});
        NodeId curve = scene.node("curve", {{"x", place}, {"points", points}});
        scene.set(curve, "style", std::string(smooth ? "smooth" : "linear"));
        NodeId plane = scene.node("plane", {{"height", curve}});
        scene.show(plane);
        Field field(scene.program({.root = plane}));
        std::vector<vec3> at;
        for (int i = 0; i < 300; ++i) at.emplace_back(random.between(-0.5f, 2.75f), 0, 0);
        std::vector<float> found = field.at(at);
        for (std::size_t i = 0; i < at.size(); ++i)
            ASSERT_NEAR(-found[i] * field.lipschitz(), graph::curve_at(points, smooth, at[i].x), 1e-4f)
                << "round " << round << " at " << at[i].x;
    }
}

TEST(Curves, a_smooth_one_passes_its_points_and_never_overshoots)
{
    graph::PointList points = {{0, 0, 0, 0}, {0.2f, 1, 0, 0}, {0.5f, 1, 0, 0}, {0.6f, 0.1f, 0, 0}, {1, 0.4f, 0, 0}};
    for (const glm::vec4& point : points) EXPECT_NEAR(graph::curve_at(points, true, point.x), point.y, 1e-6f);
    for (int i = 0; i <= 1000; ++i) {
        float x = 0.001f * static_cast<float>(i), y = graph::curve_at(points, true, x);
        std::size_t next = 1;
        while (next + 1 < points.size() && points[next].x < x) ++next;
        EXPECT_GE(y, std::min(points[next - 1].y, points[next].y) - 1e-5f) << x;
        EXPECT_LE(y, std::max(points[next - 1].y, points[next].y) + 1e-5f) << x;
    }
    EXPECT_EQ(graph::curve_at(points, true, -1), 0);
    EXPECT_EQ(graph::curve_at(points, true, 2), 0.4f);
    EXPECT_EQ(graph::curve_at({}, true, 2), 0);
}

TEST(Bands, the_eye_of_a_robot_has_hard_rings)
{
    auto colour = [](float x) {
        Scene scene;
        vec3 result;
        for (int axis = 0; axis < 3; ++axis) {
            const char* names[] = {"x", "y", "z"};
            NodeId bands = scene.node("colour_bands", {{"x", x},
                                                       {"first", vec3(0.5f)},
                                                       {"second", vec3(0.005f)},
                                                       {"third", vec3(0.2f)},
                                                       {"fourth", vec3(0.005f)}});
            NodeId part = scene.node("component", {{"vector", bands}, {"axis", std::string(names[axis])}});
            NodeId plane = scene.node("plane", {{"height", part}});
            scene.show(plane);
            result[axis] = -Field(scene.program({.root = plane})).at(std::vector<vec3>{vec3(0)})[0];
        }
        return result;
    };
    EXPECT_NEAR(colour(0.889f).x, 0.5f, 1e-6f);
    EXPECT_NEAR(colour(0.895f).x, 0.005f, 1e-6f);
    EXPECT_NEAR(colour(0.99f).x, 0.2f, 1e-6f);
    EXPECT_NEAR(colour(0.996f).x, 0.005f, 1e-6f);
}

}  // namespace
}  // namespace fieldwright::tests
