// Whole shaders: the shading library, the scene part and a main function, in the order compilers need.
#include "codegen/glsl.h"

#include "codegen/scene_printer.h"

#include <algorithm>
#include <map>
#include <set>

namespace fieldwright::codegen {
namespace {

// What every shader with a field needs; the rest is for shaders that draw pictures.
constexpr const char* field_files[] = {"render/types.glsl", "render/program.glsl"};
constexpr const char* picture_files[] = {"render/march.glsl", "render/shading.glsl", "render/stereo.glsl",
                                         "render/view.glsl"};

const char* const list_reader = R"(struct List {
    int first;
    int count;
};

)";

std::string library_texts(const graph::Program& program, std::span<const char* const> files)
{
    std::string text;
    for (const char* file : files) text += program.library->text(file) + "\n";
    return text;
}

// Only scenes with formulas pay for them.
std::string formula_texts(const graph::Program& program)
{
    constexpr const char* file = "render/formula.glsl";
    auto is_of_formulas = [&](const graph::Instruction& instruction) {
        return instruction.function && instruction.function->file == file;
    };
    bool used = std::any_of(program.instructions.begin(), program.instructions.end(), is_of_formulas);
    return used ? program.library->text(file) + "\n" : std::string();
}

std::string number(float value)
{
    std::string text;
    append_float(text, value);
    return text;
}

// The block and the list texture of the GPU device.
std::string device_inputs(const graph::Program& program, bool reads_block)
{
    std::string text;
    if (reads_block)
        text += "layout(std140) uniform Parameters {\n    vec4 block[" +
                std::to_string(std::max<std::size_t>(1, program.block.size() / 4)) + "];\n};\n\n";
    text += list_reader;
    return text +
           "uniform samplerBuffer list_texture;\n\nvec4 list_at(List list, int index)\n{\n"
           "    return texelFetch(list_texture, list.first + index);\n}\n\n";
}

std::string device_shader(const graph::Program& program, std::span<const float> block, Placement placement,
                          bool picture, std::string_view main_file)
{
    ScenePrinter printer(program, block, placement);
    std::string scene = printer.scene_functions();
    std::string text;
    text.reserve(scene.size() + (64u << 10));
    text += "#version 330\n\n" + device_inputs(program, printer.reads_block());
    text += library_texts(program, field_files);
    if (picture) text += library_texts(program, picture_files);
    text += formula_texts(program);
    text += printer.node_functions();
    text += scene;
    if (picture) text += program.library->text("gpu/pixel.glsl") + "\n";
    text += program.library->text(main_file);
    return text;
}

// `Main Body 2!` -> `main_body_2`: letters, digits and single underscores, beginning with a letter.
std::string safe_name(std::string_view name, std::string_view fallback)
{
    std::string safe;
    for (char c : name) {
        bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        bool digit = c >= '0' && c <= '9';
        if (letter) safe += static_cast<char>(c | 0x20);
        else if (digit && !safe.empty()) safe += c;
        else if (!safe.empty() && safe.back() != '_') safe += '_';
        if (safe.size() >= 32) break;
    }
    while (!safe.empty() && safe.back() == '_') safe.pop_back();
    if (safe.empty() || safe.starts_with("gl_")) return std::string(fallback);
    return safe;
}

std::string export_lists(const graph::Program& program)
{
    std::vector<glm::vec4> points = program.list_data;
    if (points.empty()) points.emplace_back(0.0f);  // a shader's array holds at least one
    std::string count = std::to_string(points.size());
    std::string text = list_reader + ("const vec4 LIST_DATA[" + count + "] = vec4[" + count + "](\n");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec4& point = points[i];
        text += "    vec4(" + number(point.x) + ", " + number(point.y) + ", " + number(point.z) + ", " +
                number(point.w) + ")" + (i + 1 < points.size() ? ",\n" : ");\n\n");
    }
    return text + "vec4 list_at(List list, int index)\n{\n    return LIST_DATA[list.first + index];\n}\n\n";
}

std::string march_constants(const graph::Program& program)
{
    const graph::MarchSettings& march = program.march;
    return "// Marching: step limit, minimum step, tolerance, near, far, out of steps hits, occlusion strength and "
           "radius.\n"
           "const March MARCH = March(" +
           std::to_string(march.step_limit) + ", " + number(march.minimum_step) + ", " + number(march.tolerance) +
           ", " + number(march.near) + ", " + number(march.far) + ", " + (march.out_of_steps_hits ? "1" : "0") + ", " +
           number(program.occlusion.strength) + ", " + number(program.occlusion.radius) +
           ");\nconst int STEP_BUDGET = " + std::to_string(program.step_budget) + ";\n\n";
}

std::map<graph::NodeId, std::string> safe_names(const graph::Document& document,
                                                const std::vector<graph::InnerCopy>& copies)
{
    std::map<graph::NodeId, std::string> names;
    graph::for_each_graph(document, [&](const graph::Graph& graph) {
        for (const graph::Node& node : graph.nodes)
            names[node.id] = safe_name(node.name.empty() ? node.type : node.name, "node");
    });
    // A copy is called like the original.
    for (const graph::InnerCopy& inner : copies) names[inner.copy] = names[inner.path.back()];
    return names;
}

}  // namespace

std::string print_scene(const graph::Program& program, std::span<const float> block, Placement placement)
{
    ScenePrinter printer(program, block, placement);
    return library_texts(program, field_files) + formula_texts(program) + printer.node_functions() +
           printer.scene_functions();
}

std::string print_fragment_shader(const graph::Program& program, std::span<const float> block, Placement placement)
{
    return device_shader(program, block, placement, true, "gpu/main.glsl");
}

std::string print_distance_shader(const graph::Program& program, std::span<const float> block, Placement placement)
{
    return device_shader(program, block, placement, false, "gpu/distances.glsl");
}

const std::vector<std::string>& export_targets()
{
    static const std::vector<std::string> targets = {"glsl", "shadertoy"};
    return targets;
}

std::string export_refusal(const graph::Program& program)
{
    std::size_t count = program.list_data.size();
    if (count <= export_list_limit) return {};
    return "the lists and pictures of this scene hold " + std::to_string(count) + " vectors, more than the " +
           std::to_string(export_list_limit) + " that an exported shader can carry; lower the detail of its pictures";
}

std::string print_export(const graph::Program& program, const graph::Document& document, std::span<const float> block,
                         std::string_view target)
{
    std::map<graph::NodeId, std::string> names = safe_names(document, program.inner_copies);
    ScenePrinter printer(program, block, Placement::literals, [&](graph::NodeId id) {
        auto found = names.find(id);
        return found == names.end() ? std::string("node") : found->second;
    });
    std::string frame = printer.frame_globals();
    std::string scene = printer.scene_functions();
    std::string text;
    if (target == "glsl")
        text += "#version 330\n\nuniform vec2 resolution;  // pixels\nuniform float time;       // seconds\n\n";
    else text += "// Made with Fieldwright for Shadertoy: paste into the Image tab.\n\nfloat time;\n\n";
    std::string nodes = printer.node_functions();
    if (nodes.find("List ") != std::string::npos) text += export_lists(program);
    text += library_texts(program, field_files);
    for (const char* file : {"render/march.glsl", "render/shading.glsl", "render/views.glsl"})
        text += program.library->text(file) + "\n";
    text += formula_texts(program) + nodes + march_constants(program) + frame + scene;
    text += program.library->text("gpu/pixel.glsl") + "\n";
    return text + program.library->text(target == "glsl" ? "export/glsl.glsl" : "export/shadertoy.glsl");
}

}  // namespace fieldwright::codegen
