// Whole shaders: the shading library, the scene part and a main function, in the order compilers need.
#include "codegen/glsl.h"

#include "codegen/features.h"
#include "codegen/scene_printer.h"

#include <algorithm>
#include <map>
#include <set>

namespace fieldwright::codegen {
namespace {

// What every shader with a field needs; the rest is for shaders that draw pictures.
constexpr const char* types_file = "render/types.glsl";
constexpr const char* field_files[] = {types_file, "render/program.glsl"};
constexpr const char* eye_files[] = {"render/stereo.glsl", "render/view.glsl"};  // of devices; exports have one eye

const char* const list_reader = R"(struct List {
    int first;
    int count;
};

)";

std::string library_texts(const graph::Program& program, std::span<const char* const> files,
                          const graph::ShaderParts& parts)
{
    std::string text;
    for (const char* file : files) text += graph::with_parts(program.library->text(file), parts) + "\n";
    return text;
}

// What traces and shades a pixel, but for the scene between the dialect's files and the last one.
std::string shading_texts(const graph::Program& program, const Features& features)
{
    std::vector<const char*> files = {"render/march.glsl", "render/shading.glsl"};
    if (features.bounces) files.push_back("render/bounce.glsl");
    if (features.tinted_shadows) files.push_back("render/tinted_shadow.glsl");
    if (features.fog) files.push_back("render/fog.glsl");
    if (features.coverage) files.push_back("render/coverage.glsl");
    return library_texts(program, files, shader_parts(features));
}

std::string pixel_text(const graph::Program& program, const Features& features)
{
    std::string text;
    if (features.bounces) text += "const int BOUNCES = " + std::to_string(program.bounces) + ";\n\n";
    for (const char* file : {"gpu/sight.glsl", "gpu/pixel.glsl"})
        text += graph::with_parts(program.library->text(file), shader_parts(features)) + "\n";
    return text;
}

// As the shader declares them.
std::vector<graph::StructDeclaration> structs(const graph::Program& program, const graph::ShaderParts& parts)
{
    return graph::parse_source(types_file, graph::with_parts(program.library->text(types_file), parts)).structs;
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

// The march that a device sets, with the program's structure in it as constants: compilers leave out what it does not use.
std::string march_structure(const graph::Program& program, const Features& features)
{
    auto set = [](const char* member, bool on) {
        return "    march." + std::string(member) + (on ? " = 1;\n" : " = 0;\n");
    };
    return "March scene_march(March march)\n{\n" + set("bisects", features.bisects) +
           set("central_normals", program.march.central_normals) +
           set("smallest_occlusion", program.occlusion.smallest_ratio) + set("tracks_cone", features.cones) +
           (features.tinted_shadows ? set("tints_shadows", true) : "") +
           (program.march.own_step_scale ? "" : "    march.step_scale = 1.0;\n") + "    return march;\n}\n\n";
}

std::string device_shader(const graph::Program& program, std::span<const float> block, Placement placement,
                          const Features& features, bool picture, std::string_view main_file)
{
    const graph::ShaderParts parts = shader_parts(features);
    ScenePrinter printer(program, block, placement, structs(program, parts));
    std::string scene = printer.scene_functions();
    std::string text;
    text.reserve(scene.size() + (64u << 10));
    text += "#version 330\n\n" + parts_comment(parts) + device_inputs(program, printer.reads_block());
    text += library_texts(program, field_files, parts);
    if (picture) text += shading_texts(program, features) + library_texts(program, eye_files, parts);
    if (picture && features.lens) text += program.library->text("render/lens.glsl") + "\n";
    text += formula_texts(program);
    text += printer.node_functions();
    text += scene;
    if (picture) text += march_structure(program, features) + pixel_text(program, features);
    text += graph::with_parts(program.library->text(main_file), parts);
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

std::string march_constants(const graph::Program& program, const Features& features)
{
    const graph::MarchSettings& march = program.march;
    const graph::OcclusionSettings& occlusion = program.occlusion;
    auto flag = [](bool on) { return on ? ", 1" : ", 0"; };
    return std::string(
               "// Marching: step limit, minimum step, tolerance, near, far, out of steps hits, step scale, constant "
               "step, "
               "normal step;\n// occlusion samples, strength and radius; bisects, central normals, smallest occlusion, "
               "tracks cone") +
           (features.tinted_shadows ? ", tints shadows" : "") +
           ".\n"
           "const March MARCH = March(" +
           std::to_string(march.step_limit) + ", " + number(march.minimum_step) + ", " + number(march.tolerance) +
           ", " + number(march.near) + ", " + number(march.far) + flag(march.out_of_steps_hits) + ", " +
           number(graph::step_scale(march)) + ", " + number(march.constant_step) + ", " + number(march.normal_step) +
           ", " + std::to_string(occlusion.samples) + ", " + number(occlusion.strength) + ", " +
           number(occlusion.radius) + flag(march.constant_steps) + flag(march.central_normals) +
           flag(occlusion.smallest_ratio) + flag(graph::tracks_cone(program)) +
           (features.tinted_shadows ? flag(true) : "") +
           ");\nconst int STEP_BUDGET = " + std::to_string(program.step_budget) + ";\n\n";
}

// How its pixels are shown. Only scenes with a look of their own pay for it.
std::string look_texts(const graph::Program& program, const graph::PictureSettings& picture,
                       const graph::ShaderParts& parts)
{
    bool plain =
        picture.tone_map == graph::ToneMap::none && picture.exposure == 0 && picture.backdrop == graph::Backdrop::sky;
    if (plain) return graph::with_parts(program.library->text("export/plain.glsl"), parts) + "\n";
    bool coloured = picture.backdrop == graph::Backdrop::colour;
    glm::vec3 colour = coloured ? picture.backdrop_colour : glm::vec3(0);
    return "// Tone map: 1 Neutral, 2 AgX, 3 ACES. Backdrop: 1 a colour, 2 transparent. Exposure in stops.\n"
           "const int TONE_MAP = " +
           std::to_string(static_cast<int>(picture.tone_map)) +
           ";\nconst float EXPOSURE = " + number(picture.exposure) +
           ";\nconst int BACKDROP = " + std::to_string(static_cast<int>(picture.backdrop)) +
           ";\nconst vec3 BACKDROP_COLOUR = vec3(" + number(colour.x) + ", " + number(colour.y) + ", " +
           number(colour.z) + ");\n\n" + program.library->text("render/tone_map.glsl") + "\n" +
           graph::with_parts(program.library->text("export/look.glsl"), parts) + "\n";
}

std::string fog_constant(const graph::FogSettings& fog)
{
    return "// Fog: colour, density, start, height falloff.\nconst Fog FOG = Fog(vec3(" + number(fog.colour.r) + ", " +
           number(fog.colour.g) + ", " + number(fog.colour.b) + "), " + number(fog.density) + ", " + number(fog.start) +
           ", " + number(fog.height_falloff) + ");\n\n";
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
    const graph::ShaderParts parts = shader_parts(features_of(program, block));
    ScenePrinter printer(program, block, placement, structs(program, parts));
    return library_texts(program, field_files, parts) + formula_texts(program) + printer.node_functions() +
           printer.scene_functions();
}

std::string print_fragment_shader(const graph::Program& program, std::span<const float> block, Placement placement,
                                  bool layers, bool counts)
{
    const Features features = features_of(program, block, layers, counts);
    return device_shader(program, block, placement, features, true, "gpu/main.glsl");
}

std::string print_distance_shader(const graph::Program& program, std::span<const float> block, Placement placement)
{
    return device_shader(program, block, placement, features_of(program, block), false, "gpu/distances.glsl");
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
    const Features features = features_of(program, block);
    const graph::ShaderParts parts = shader_parts(features);
    ScenePrinter printer(program, block, Placement::literals, structs(program, parts), [&](graph::NodeId id) {
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
    text += library_texts(program, field_files, parts) + shading_texts(program, features);
    text += program.library->text("render/views.glsl") + "\n";
    text += formula_texts(program) + nodes + march_constants(program, features);
    if (features.fog) text += fog_constant(program.fog);
    text += frame + scene + pixel_text(program, features) + look_texts(program, document.picture, parts);
    text += graph::with_parts(program.library->text("export/pixel_at.glsl"), parts) + "\n";
    const char* main_file = target == "glsl" ? "export/glsl.glsl" : "export/shadertoy.glsl";
    return text + graph::with_parts(program.library->text(main_file), parts);
}

}  // namespace fieldwright::codegen
