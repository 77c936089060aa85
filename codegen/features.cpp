// Looks at the functions of the nodes that a program calls.
#include "codegen/features.h"

#include <algorithm>
#include <unordered_map>

namespace fieldwright::codegen {
namespace {

using graph::Instruction;
using graph::Program;

constexpr int most_bits = 31;  // of hard shadows: what an int holds

constexpr std::string_view parts_word = "// Parts: ";

// A call of a node that makes a material, and the text of its file.
struct MaterialCall {
    const Instruction& call;
    const std::string& text;

    bool mentions(std::initializer_list<std::string_view> words) const
    {
        return std::any_of(words.begin(), words.end(),
                           [&](std::string_view word) { return text.find(word) != std::string::npos; });
    }
};

// Those of nodes: the shading library's own functions mix and choose what nodes made.
std::vector<MaterialCall> material_calls(const Program& program)
{
    std::unordered_map<std::string_view, const std::string*> texts;
    for (const graph::NodeType* type : program.library->types()) texts[type->source.path] = &type->source.text;
    std::vector<MaterialCall> calls;
    for (const Instruction& instruction : program.instructions) {
        if (!instruction.function || instruction.function->result.name != "Material") continue;
        auto text = texts.find(instruction.function->file);
        if (text != texts.end()) calls.push_back({instruction, *text->second});
    }
    return calls;
}

bool sets_microfacets(const MaterialCall& made)
{
    return made.mentions({"with_microfacets(", ".microfacet", ".roughness"});
}

bool sets_members_of_reflection(const MaterialCall& made)
{
    return made.mentions({".reflection", ".transmission", ".refraction_index", ".absorption"});
}

// Whether the argument of that name is a constant 0.
bool turned_off(const Program& program, const Instruction& call, std::string_view name, std::span<const float> block)
{
    const auto& arguments = call.function->arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        auto id = program.arguments[static_cast<std::size_t>(call.first_argument) + i];
        const graph::ProgramValue& value = program.values[static_cast<std::size_t>(id)];
        if (arguments[i].name == name && value.rate == graph::Rate::constant)
            return block[static_cast<std::size_t>(value.slot)] == 0.0f;
    }
    return false;
}

bool reflects(const Program& program, const MaterialCall& made, std::span<const float> block)
{
    if (made.mentions({"with_transmission("}) || sets_members_of_reflection(made)) return true;
    bool mirrors = made.mentions({"with_reflection(", "with_microfacets("});
    return mirrors && !turned_off(program, made.call, "reflection", block);
}

bool transmits(const MaterialCall& made) { return made.mentions({"with_transmission(", ".transmission"}); }

bool tints_shadows(const Program& program, const MaterialCall& made, std::span<const float> block)
{
    return transmits(made) && !turned_off(program, made.call, "shadow", block);
}

// Whether where rays cross the lens matters.
bool has_lens(const Program& program, std::span<const float> block)
{
    auto first = program.instructions.begin() + program.ray.first;
    return std::any_of(first, program.instructions.begin() + program.ray.last, [&](const Instruction& call) {
        if (!call.function) return false;
        const auto& arguments = call.function->arguments;
        bool takes_it = std::any_of(arguments.begin(), arguments.end(),
                                    [](const graph::Argument& argument) { return argument.name == "lens"; });
        return takes_it && !turned_off(program, call, "aperture", block);
    });
}

}  // namespace

Features features_of(const Program& program, std::span<const float> block, bool layers, bool counts)
{
    const std::vector<MaterialCall> materials = material_calls(program);
    auto any = [&](const auto& test) { return std::any_of(materials.begin(), materials.end(), test); };
    Features features;
    features.microfacets = any(sets_microfacets);
    features.bounces =
        program.bounces > 0 && any([&](const MaterialCall& made) { return reflects(program, made, block); });
    features.reflection = features.bounces || any(sets_members_of_reflection);
    features.transmission =
        any([&](const MaterialCall& made) { return transmits(made) || made.mentions({"with_shadow("}); });
    features.tinted_shadows = features.bounces && graph::shadow_count(program) > 0 &&
                              any([&](const MaterialCall& made) { return tints_shadows(program, made, block); });
    features.lens = has_lens(program, block);
    features.fog = program.fog.density > 0.0f;
    features.bisects = program.march.constant_steps;
    features.cones = layers || graph::tracks_cone(program) || graph::shadow_count(program) > most_bits;
    features.coverage = program.march.coverage;
    features.layers = layers;
    features.counts = counts || layers;
    return features;
}

graph::ShaderParts shader_parts(const Features& features)
{
    graph::ShaderParts parts;
    auto add = [&](bool wanted, std::string_view name) {
        if (wanted) parts.insert(name);
    };
    add(features.microfacets, "MICROFACETS");
    add(features.reflection, "REFLECTION");
    add(features.bounces, "BOUNCES");
    add(features.transmission, "TRANSMISSION");
    add(features.tinted_shadows, "TINTED_SHADOWS");
    add(features.lens, "LENS");
    add(features.fog, "FOG");
    add(features.bisects, "BISECTS");
    add(features.cones, "CONES");
    add(features.coverage, "COVERAGE");
    add(features.layers, "LAYERS");
    add(features.counts, "COUNTS");
    return parts;
}

std::string parts_comment(const graph::ShaderParts& parts)
{
    std::string comment;
    for (std::string_view part : parts)
        comment += (comment.empty() ? std::string(parts_word) : " ") + std::string(part);
    return comment.empty() ? comment : comment + "\n";
}

graph::ShaderParts parts_of_shader(std::string_view shader)
{
    graph::ShaderParts parts;
    std::size_t at = shader.find(parts_word);
    if (at == shader.npos) return parts;
    std::string_view names = shader.substr(at + parts_word.size());
    names = names.substr(0, names.find('\n'));
    while (!names.empty()) {
        std::size_t end = std::min(names.find(' '), names.size());
        parts.insert(names.substr(0, end));
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return parts;
}

}  // namespace fieldwright::codegen
