// A driver's line leads back to the file that somebody edits.
#include "codegen/shader_lines.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fieldwright::tests {
namespace {

// A sphere's shader, and the line of `words` in it.
struct Shader {
    graph::Program program;
    std::string text;
    int line_of(std::string_view words) const
    {
        auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(words));
        return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    }
};

Shader sphere_shader()
{
    Scene scene;
    scene.show(scene.node("sphere"));
    graph::Program program = scene.program();
    std::string text =
        codegen::print_fragment_shader(program, field::evaluate_frame(program, 0), codegen::Placement::literals);
    return {std::move(program), std::move(text)};
}

int line_in_file(const Shader& shader, std::string_view path, std::string_view words)
{
    const std::string& file = shader.program.library->text(path);
    return 1 + static_cast<int>(
                   std::count(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(file.find(words)), '\n'));
}

TEST(ShaderLines, lead_to_the_node_file)
{
    Shader shader = sphere_shader();
    constexpr std::string_view words = "return length(p) - radius;", path = "nodes/primitive/sphere.glsl";
    EXPECT_EQ(codegen::place_of_line(*shader.program.library, shader.text, shader.line_of(words)),
              std::string(path) + ":" + std::to_string(line_in_file(shader, path, words)));
}

TEST(ShaderLines, lead_to_the_shading_library)
{
    Shader shader = sphere_shader();
    constexpr std::string_view words = "struct Material", path = "render/types.glsl";
    EXPECT_EQ(codegen::place_of_line(*shader.program.library, shader.text, shader.line_of(words)),
              std::string(path) + ":" + std::to_string(line_in_file(shader, path, words)));
}

TEST(ShaderLines, lead_to_it_where_parts_of_it_are_left_out)
{
    Scene scene;
    scene.show(scene.node("sphere"));
    graph::Program program = scene.program();
    auto text_of = [&](bool layers) {
        return codegen::print_fragment_shader(program, field::evaluate_frame(program, 0), codegen::Placement::literals,
                                              layers);
    };
    constexpr std::string_view words = "struct Light", path = "render/types.glsl";
    for (bool layers : {false, true}) {
        Shader shader{program, text_of(layers)};
        EXPECT_EQ(codegen::place_of_line(*program.library, shader.text, shader.line_of(words)),
                  std::string(path) + ":" + std::to_string(line_in_file(shader, path, words)));
    }
}

TEST(ShaderLines, that_were_printed_for_the_scene_lead_nowhere)
{
    Shader shader = sphere_shader();
    EXPECT_EQ(codegen::place_of_line(*shader.program.library, shader.text, 1), std::nullopt);
    EXPECT_EQ(
        codegen::place_of_line(*shader.program.library, shader.text, shader.line_of("float scene_distance(vec3 p)")),
        std::nullopt);
}

TEST(ShaderLines, are_found_in_what_drivers_say)
{
    Shader shader = sphere_shader();
    std::string line = std::to_string(shader.line_of("return length(p) - radius;"));
    std::string place = *codegen::place_of_line(*shader.program.library, shader.text, std::stoi(line));
    auto said = [&](const std::string& complaint) {
        return codegen::with_place(complaint, *shader.program.library, shader.text);
    };
    EXPECT_EQ(said("refused: 0:" + line + "(9): error: no function"), "refused: " + place + ": error: no function");
    EXPECT_EQ(said("0(" + line + ") : error C1008: undefined"), place + " : error C1008: undefined");
    EXPECT_EQ(said("ERROR: 0:" + line + ": 'x' : undeclared"), "ERROR: " + place + ": 'x' : undeclared");
    EXPECT_EQ(said("out of memory"), "out of memory");
}

}  // namespace
}  // namespace fieldwright::tests
