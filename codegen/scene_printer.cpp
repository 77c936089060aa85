// The scene part of every shader.
#include "codegen/scene_printer.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace fieldwright::codegen {
namespace {

using graph::Instruction;
using graph::Rate;
using graph::ValueId;

void append_indent(std::string& out, int indent) { out.append(static_cast<std::size_t>(indent) * 4, ' '); }

}  // namespace

ScenePrinter::ScenePrinter(const graph::Program& program, std::span<const float> block, Placement placement,
                           std::vector<graph::StructDeclaration> structs, NodeName node_name)
    : program_(program), values_(program, block, placement, std::move(structs), std::move(node_name))
{
}

std::string ScenePrinter::node_functions() const
{
    std::unordered_set<std::string_view> wanted;
    for (const Instruction& instruction : program_.instructions)
        if (instruction.function) wanted.insert(instruction.function->name);
    std::string text;
    for (const graph::NodeType* type : program_.library->types()) {
        std::vector<const graph::Function*> used;
        const auto& functions = type->source.functions;
        for (auto function = functions.rbegin(); function != functions.rend(); ++function) {
            auto calls_it = [&](const graph::Function* caller) {
                return caller->text.find(function->name + "(") != std::string::npos;
            };
            if (wanted.contains(function->name) || std::any_of(used.begin(), used.end(), calls_it))
                used.push_back(&*function);
        }
        if (used.empty()) continue;
        text += "// " + type->category + "/" + type->name + "\n";
        for (const std::string& constant : type->source.constants) text += constant + "\n";
        for (auto function = used.rbegin(); function != used.rend(); ++function) text += (*function)->text + "\n";
        text += "\n";
    }
    return text;
}

std::string ScenePrinter::scene_functions()
{
    functions_.clear();
    functions_.reserve(64 * program_.instructions.size());
    part_count_ = 0;
    function("float", "scene_distance", program_.distance);
    function("Surface", "scene_surface", program_.surface);
    function("Ray", "scene_ray", program_.ray);
    function("vec3", "scene_sky", program_.sky);
    std::string choose = "Light scene_light(int index, vec3 p)\n{\n";
    for (std::size_t i = 0; i < program_.lights.size(); ++i) {
        std::string name = "scene_light_" + std::to_string(i);
        function("Light", name, program_.lights[i].entry);
        choose += "    if (index == " + std::to_string(i) + ") return " + name + "(p);\n";
    }
    choose += "    return Light(vec3(0.0f, 1.0f, 0.0f), 0.0f, vec3(0.0f, 0.0f, 0.0f), 1.0f);\n}\n\n";
    functions_ += choose + shadow_kinds() + "const int LIGHT_COUNT = " + std::to_string(program_.lights.size()) +
                  ";\nconst int SHADOW_COUNT = " + std::to_string(graph::shadow_count(program_)) + ";\n\n";
    return std::move(functions_);
}

// Of the shadowed lights. Where all are alike, compilers see one constant.
std::string ScenePrinter::shadow_kinds() const
{
    auto kind = [](graph::Shadow shadow) { return std::to_string(static_cast<int>(shadow)); };
    graph::Shadow usual = program_.lights.empty() ? graph::Shadow::hard : program_.lights.front().shadow;
    std::string text = "int scene_shadow(int index)\n{\n";
    for (std::size_t i = 0; i < program_.lights.size(); ++i) {
        graph::Shadow shadow = program_.lights[i].shadow;
        if (shadow == usual || shadow == graph::Shadow::off) continue;
        text += "    if (index == " + std::to_string(i) + ") return " + kind(shadow) + ";\n";
    }
    return text + "    return " + kind(usual) + ";\n}\n\n";
}

std::string ScenePrinter::frame_globals()
{
    values_.use_frame_globals();
    std::string globals, body;
    auto frame_only = [&](const Instruction& instruction) { return value(instruction.result).rate == Rate::frame; };
    for (std::int32_t i = program_.frame.first; i < program_.frame.last; ++i) {
        const Instruction& instruction = program_.instructions[static_cast<std::size_t>(i)];
        if (!frame_only(instruction)) continue;
        globals += value(instruction.result).type->name + " ";
        values_.name(globals, instruction.result);
        globals += ";\n";
        body += "    ";
        values_.name(body, instruction.result);
        body += " = ";
        call(body, instruction);
        body += ";\n";
    }
    return globals + "\nvoid update_frame()\n{\n" + body + "}\n\n";
}

void ScenePrinter::function(std::string_view result_type, std::string_view function_name, const graph::Entry& entry)
{
    std::string text(result_type);
    text += ' ';
    text += function_name;
    text += '(';
    for (std::size_t i = 0; i < entry.inputs.size(); ++i) {
        if (i > 0) text += ", ";
        text += value(entry.inputs[i]).type->name + " ";
        values_.name(text, entry.inputs[i]);
    }
    text += ")\n{\n";
    level(text, entry.first, entry.last, entry.results, 1);
    text += "    return " + entry_result(entry, result_type) + ";\n}\n\n";
    functions_ += text;
}

std::string ScenePrinter::entry_result(const graph::Entry& entry, std::string_view result_type)
{
    std::string text;
    if (entry.results.size() == 1) {
        values_.reference(text, entry.results[0]);
        return text;
    }
    text = std::string(result_type) + "(";
    for (std::size_t i = 0; i < entry.results.size(); ++i) {
        if (i > 0) text += ", ";
        values_.reference(text, entry.results[i]);
    }
    return text + ")";
}

void ScenePrinter::level(std::string& out, std::int32_t first, std::int32_t last, std::span<const ValueId> results,
                         int indent)
{
    std::vector<Item> all = items_of(program_, first, last);
    if (all.size() <= largest_part) {
        for (const Item& item : all) statement(out, item, indent);
        return;
    }
    for (const Part& part : parts_of(program_, all, results)) {
        part_function(all, part);
        part_call(out, part, indent);
        ++part_count_;
    }
}

void ScenePrinter::part_function(const std::vector<Item>& items, const Part& part)
{
    std::string number = std::to_string(part_count_), text, body;
    body.reserve(128 * (part.last - part.first));
    for (std::size_t i = part.first; i < part.last; ++i) statement(body, items[i], 1);
    bool single = part.outputs.size() == 1;
    std::string type = single ? value(part.outputs[0]).type->name : "Part" + number;
    if (!single) {
        text += "struct " + type + " {\n";
        for (ValueId id : part.outputs) {
            text += "    " + value(id).type->name + " ";
            values_.name(text, id);
            text += ";\n";
        }
        text += "};\n\n";
    }
    text += type + " scene_part_" + number + "(";
    for (std::size_t i = 0; i < part.inputs.size(); ++i) {
        text += (i > 0 ? ", " : "") + value(part.inputs[i]).type->name + " ";
        values_.name(text, part.inputs[i]);
    }
    body += "    return ";
    if (!single) body += type + "(";
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
        if (i > 0) body += ", ";
        values_.name(body, part.outputs[i]);
    }
    functions_ += text + ")\n{\n";
    functions_ += body;
    functions_ += single ? ";\n}\n\n" : ");\n}\n\n";
}

void ScenePrinter::part_call(std::string& out, const Part& part, int indent)
{
    std::string number = std::to_string(part_count_);
    bool single = part.outputs.size() == 1;
    append_indent(out, indent);
    out += single ? value(part.outputs[0]).type->name + " " : "Part" + number + " part_" + number;
    if (single) values_.name(out, part.outputs[0]);
    out += " = scene_part_" + number + "(";
    for (std::size_t i = 0; i < part.inputs.size(); ++i) {
        if (i > 0) out += ", ";
        values_.name(out, part.inputs[i]);
    }
    out += ");\n";
    if (single) return;
    for (ValueId id : part.outputs) {
        append_indent(out, indent);
        out += value(id).type->name + " ";
        values_.name(out, id);
        out += " = part_" + number + ".";
        values_.name(out, id);
        out += ";\n";
    }
}

void ScenePrinter::statement(std::string& out, const Item& item, int indent)
{
    const Instruction& instruction = program_.instructions[static_cast<std::size_t>(item.instruction)];
    if (instruction.is_block()) return block(out, item, indent);
    append_indent(out, indent);
    out += value(instruction.result).type->name;
    out += ' ';
    values_.name(out, instruction.result);
    out += " = ";
    call(out, instruction);
    out += ";\n";
}

void ScenePrinter::call(std::string& out, const Instruction& instruction)
{
    out += instruction.function->name;
    out += '(';
    const char* separator = "";
    for (ValueId argument : arguments_of(program_, instruction)) {
        out += std::exchange(separator, ", ");
        values_.reference(out, argument);
    }
    out += ')';
}

void ScenePrinter::block(std::string& out, const Item& item, int indent)
{
    const Instruction& instruction = program_.instructions[static_cast<std::size_t>(item.instruction)];
    std::span<const graph::Carried> carried = carried_of(program_, instruction);
    std::vector<ValueId> next;
    for (const graph::Carried& pair : carried) {
        append_indent(out, indent);
        out += value(pair.accumulator).type->name + " ";
        values_.name(out, pair.accumulator);
        out += " = ";
        values_.reference(out, pair.initial);
        out += ";\n";
        next.push_back(pair.next);
    }
    std::string copy;
    values_.name(copy, instruction.copy);
    append_indent(out, indent);
    out += "for (int " + copy + " = 0; " + copy + " < " + std::to_string(instruction.copies) + "; " + copy + "++) {\n";
    level(out, item.instruction + 1, item.end, next, indent + 1);
    for (const graph::Carried& pair : carried) {
        append_indent(out, indent + 1);
        values_.name(out, pair.accumulator);
        out += " = ";
        values_.reference(out, pair.next);
        out += ";\n";
    }
    append_indent(out, indent);
    out += "}\n";
}

}  // namespace fieldwright::codegen
