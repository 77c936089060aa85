// What the printed text promises: the same for the same document, untouched by drags, flat, and free of the user's words.
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "tests/support/glslang.h"
#include "tests/support/random.h"
#include "tests/support/starter.h"

#include <gtest/gtest.h>
#include <chrono>
#include <fstream>
#include <sstream>

namespace fieldwright::tests {
namespace {

using codegen::Placement;

std::string fragment(const Scene& scene, Placement placement)
{
    graph::Program program = scene.program();
    return codegen::print_fragment_shader(program, field::evaluate_frame(program, 0.6f), placement);
}

std::string exported(const Scene& scene, std::string_view target)
{
    graph::Program program = scene.program();
    return codegen::print_export(program, scene.document, field::evaluate_frame(program, 0.6f), target);
}

// The body of `float scene_distance(...)`.
std::string distance_body(const Scene& scene)
{
    graph::Program program = scene.program();
    std::string text = codegen::print_scene(program, field::evaluate_frame(program, 0), Placement::literals);
    std::size_t start = text.find("float scene_distance(");
    return text.substr(start, text.find("\n}\n", start) - start);
}

int occurrences(const std::string& text, std::string_view part)
{
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

// As the site does: its declarations, our text, nothing else.
std::string in_shadertoy_wrapper(const std::string& shader)
{
    std::stringstream wrapper;
    wrapper << std::ifstream(FIELDWRIGHT_SOURCE_DIR "/tests/app/shadertoy_wrapper.glsl").rdbuf();
    return wrapper.str() + "\n" + shader;
}

std::vector<graph::Value> dragged_values(const graph::Parameter& parameter)
{
    Random random(7);
    std::vector<graph::Value> values;
    for (int i = 0; i < 4; ++i) {
        graph::Value value = random_value(random, parameter);
        if (auto* points = std::get_if<graph::PointList>(&value)) {
            *points = std::get<graph::PointList>(parameter.initial);  // their number is structure
            for (glm::vec4& point : *points) point.x += 0.01f * static_cast<float>(i + 1);
        }
        values.push_back(std::move(value));
    }
    return values;
}

TEST(Text, is_the_same_for_the_same_document)
{
    auto library = graph::Library::embedded();
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Scene first = random_graph(seed, library), second = random_graph(seed, library);
        ASSERT_TRUE(first.document == second.document);
        for (Placement placement : {Placement::literals, Placement::buffer})
            ASSERT_EQ(fragment(first, placement), fragment(second, placement)) << "seed " << seed;
        for (const std::string& target : codegen::export_targets())
            ASSERT_EQ(exported(first, target), exported(second, target)) << "seed " << seed;
    }
}

TEST(Text, is_untouched_by_a_drag_of_any_number_of_any_type)
{
    auto library = graph::Library::embedded();
    for (const graph::NodeType* type : library->types()) {
        Starter starter(*type, library);
        for (const graph::Parameter& parameter : type->parameters) {
            if (!graph::has_range(parameter.kind)) continue;
            std::vector<graph::Value> values = dragged_values(parameter);
            // Whether there is a lens at all is structure.
            if (parameter.name == "aperture") starter.scene.set(starter.subject, parameter.name, values[0]);
            std::string before = fragment(starter.scene, Placement::buffer);
            for (const graph::Value& value : values) {
                starter.scene.set(starter.subject, parameter.name, value);
                ASSERT_EQ(fragment(starter.scene, Placement::buffer), before) << type->name << "." << parameter.name;
            }
        }
    }
}

TEST(Text, is_untouched_by_the_numbers_of_a_formula)
{
    auto library = graph::Library::embedded();
    for (const char* name : {"implicit", "expression"}) {
        Starter starter(*library->type(name), library);
        auto text = [&](const char* formula) {
            starter.scene.set(starter.subject, "formula", std::string(formula));
            return fragment(starter.scene, Placement::buffer);
        };
        std::string before = text("2 * x + sin(3 * y) - 0.5");
        EXPECT_EQ(text("0.25 * x + sin(7 * y) - 9"), before) << name;
        EXPECT_NE(text("0.25 * x + cos(7 * y) - 9"), before) << name;
    }
}

TEST(Text, has_the_operations_of_formulas_only_where_they_are_used)
{
    auto library = graph::Library::embedded();
    Starter sphere(*library->type("sphere"), library), implicit(*library->type("implicit"), library);
    EXPECT_EQ(fragment(sphere.scene, Placement::buffer).find("formula_add"), std::string::npos);
    EXPECT_NE(fragment(implicit.scene, Placement::buffer).find("formula_add"), std::string::npos);
}

TEST(Text, evaluates_a_shared_child_once)
{
    Scene scene;
    NodeId shared = scene.node("sphere"), box = scene.node("box"), torus = scene.node("torus");
    NodeId left = scene.node("smooth_union", {{"a", shared}, {"b", box}});
    NodeId right = scene.node("smooth_subtract", {{"a", torus}, {"b", shared}});
    scene.show(scene.node("union", {{"a", left}, {"b", right}}));
    EXPECT_EQ(occurrences(distance_body(scene), "sphere_distance("), 1);
    EXPECT_EQ(scene.program().expanded_cost, 3);
}

TEST(Text, evaluates_a_child_shared_through_two_points_twice)
{
    Scene scene;
    NodeId shared = scene.node("sphere");
    NodeId moved = scene.node("translate", {{"d", shared}});
    scene.show(scene.node("union", {{"a", shared}, {"b", moved}}));
    EXPECT_EQ(occurrences(distance_body(scene), "sphere_distance("), 2);
}

TEST(Cost, refuses_exponential_sharing_at_once)
{
    for (int levels = 12; levels <= 64; levels += 4) {
        Scene scene;
        NodeId field = scene.node("sphere");
        for (int level = 0; level < levels; ++level)
            field = scene.node("union", {{"a", field}, {"b", scene.node("translate", {{"d", field}})}});
        NodeId output = scene.show(field);
        auto start = std::chrono::steady_clock::now();
        graph::Program program = scene.program();
        std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        EXPECT_LT(taken.count(), 0.2) << levels;
        ASSERT_FALSE(program.problems.empty()) << levels;
        EXPECT_EQ(program.problems.back().node, output);
        EXPECT_EQ(program.problems.back().severity, graph::Problem::Severity::error);
        EXPECT_LT(program.instructions.size(), 100u) << "the refused part is not in the program";
    }
}

TEST(Cost, allows_sharing_within_the_limit)
{
    Scene scene;
    NodeId field = scene.node("sphere");
    for (int level = 0; level < 11; ++level)
        field = scene.node("union", {{"a", field}, {"b", scene.node("translate", {{"d", field}})}});
    scene.show(field);
    EXPECT_TRUE(scene.program().problems.empty());
    EXPECT_EQ(scene.program().expanded_cost, 2048);
}

// The longest chain of dependent calls of one function.
int call_depth(const graph::Program& program, std::string_view function)
{
    std::vector<int> depth(program.values.size(), 0);
    int deepest = 0;
    for (std::int32_t i = program.distance.first; i < program.distance.last; ++i) {
        const graph::Instruction& call = program.instructions[static_cast<std::size_t>(i)];
        if (call.is_block()) continue;
        int inner = 0;
        for (std::int32_t k = 0; k < call.argument_count; ++k)
            inner = std::max(
                inner,
                depth[static_cast<std::size_t>(program.arguments[static_cast<std::size_t>(call.first_argument + k)])]);
        int here = inner + (call.function->name == function ? 1 : 0);
        depth[static_cast<std::size_t>(call.result)] = here;
        deepest = std::max(deepest, here);
    }
    return deepest;
}

TEST(Text, folds_the_inputs_of_a_combiner_of_many_as_a_balanced_tree)
{
    for (const char* type : {"union_many", "smooth_union_many"}) {
        Scene scene;
        NodeId all = scene.node(type);
        const graph::NodeType& declared = scene.type(all);
        for (int i = 0; i < declared.most_inputs; ++i)
            scene.wire(scene.node("sphere"), all, declared.inputs[static_cast<std::size_t>(i)].name);
        scene.show(all);
        EXPECT_EQ(scene.program().expanded_cost, 16);
        EXPECT_EQ(call_depth(scene.program(), std::string(type) + "_distance"), 4);
    }
}

TEST(Text, makes_a_chain_of_a_thousand_unions_shallow)
{
    for (bool to_the_left : {true, false}) {
        Scene scene;
        NodeId field = scene.node("sphere");
        for (int i = 0; i < 1000; ++i) {
            NodeId next = scene.node("sphere");
            field = scene.node("union", {{"a", to_the_left ? field : next}, {"b", to_the_left ? next : field}});
        }
        scene.show(field);
        graph::Program program = scene.program();
        EXPECT_TRUE(program.problems.empty());
        EXPECT_EQ(program.expanded_cost, 1001);
        EXPECT_LE(call_depth(program, "union_distance"), 10);
        std::string text = codegen::print_fragment_shader(program, program.block, Placement::buffer);
        EXPECT_EQ(glslang_errors({text}), "");
    }
}

constexpr const char* hostile_names[] = {
    "*/ #define float vec3", "// \\", "gl_Position", "main", "sphere_distance",     "__x__",
    "\"; discard; //",       "n1_2",  "p",           "void", "snow\xe2\x98\x83man", "int",
    "scene_distance"};

TEST(Text, holds_no_words_of_the_user)
{
    Scene plain;
    NodeId field = plain.node("sphere", {{"radius", plain.node("sine")}});
    for (int i = 0; i < 14; ++i) field = plain.node("smooth_union", {{"a", field}, {"b", plain.node("box")}});
    plain.show(field);
    plain.node("sun");
    Scene named = plain;
    std::size_t next = 0;
    for (graph::Node& node : named.document.root.nodes) node.name = hostile_names[next++ % std::size(hostile_names)];
    for (Placement placement : {Placement::literals, Placement::buffer})
        EXPECT_EQ(fragment(named, placement), fragment(plain, placement));

    std::vector<std::string> exports = {exported(named, "glsl"), in_shadertoy_wrapper(exported(named, "shadertoy"))};
    for (const std::string& text : exports) EXPECT_EQ(text.find("#define float"), std::string::npos);
    EXPECT_EQ(glslang_errors(exports), "");
}

TEST(Text, compiles_as_a_shader_and_as_every_export_for_every_type)
{
    auto library = graph::Library::embedded();
    std::vector<std::string> shaders;
    for (const graph::NodeType* type : library->types()) {
        Scene scene = Starter(*type, library).scene;
        for (Placement placement : {Placement::literals, Placement::buffer})
            shaders.push_back(fragment(scene, placement));
        shaders.push_back(exported(scene, "glsl"));
        shaders.push_back(in_shadertoy_wrapper(exported(scene, "shadertoy")));
    }
    EXPECT_EQ(glslang_errors(shaders), "");
}

}  // namespace
}  // namespace fieldwright::tests
