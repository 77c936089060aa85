// The scene part of every shader.
#include "codegen/scene_printer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace fieldwright::codegen {
namespace {

using graph::BaseType;
using graph::Instruction;
using graph::Rate;
using graph::ValueId;

// Instructions per function: about 32 primitives with their moves and combiners (compilers slow down beyond).
constexpr std::size_t smallest_part = 64, largest_part = 128;

void append_integer(std::string& out, std::int64_t number)
{
    char buffer[24];
    char* end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    out.append(buffer, static_cast<std::size_t>(end - buffer));
}

void append_indent(std::string& out, int indent) { out.append(static_cast<std::size_t>(indent) * 4, ' '); }

}  // namespace

void append_float(std::string& out, float number)
{
    char buffer[40];
    char* end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
    out += text;
    bool whole = std::none_of(text.begin(), text.end(), [](char c) { return c == '.' || c == 'e'; });
    if (whole) out += ".0";
    out += 'f';
}

ScenePrinter::ScenePrinter(const graph::Program& program, std::span<const float> block, Placement placement,
                           std::vector<graph::StructDeclaration> structs, NodeName node_name)
    : program_(program),
      block_(block),
      placement_(placement),
      structs_(std::move(structs)),
      node_name_(std::move(node_name))
{
}

template <typename Visit>
void ScenePrinter::for_each_use(const Item& item, const Visit& visit) const
{
    for (std::int32_t i = item.instruction; i < item.end; ++i) {
        const Instruction& instruction = program_.instructions[static_cast<std::size_t>(i)];
        for (std::int32_t k = 0; k < instruction.argument_count; ++k)
            visit(program_.arguments[static_cast<std::size_t>(instruction.first_argument + k)]);
        for (std::int32_t k = 0; k < instruction.carried_count; ++k)
            visit(program_.carried[static_cast<std::size_t>(instruction.first_carried + k)].next);
    }
}

template <typename Visit>
void ScenePrinter::for_each_definition(const Item& item, const Visit& visit) const
{
    for (std::int32_t i = item.instruction; i < item.end; ++i) {
        const Instruction& instruction = program_.instructions[static_cast<std::size_t>(i)];
        if (!instruction.is_block()) visit(instruction.result);
        else visit(instruction.copy);
        for (std::int32_t k = 0; k < instruction.carried_count; ++k)
            visit(program_.carried[static_cast<std::size_t>(instruction.first_carried + k)].accumulator);
    }
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
    frame_globals_ = true;
    std::string globals, body;
    auto frame_only = [&](const Instruction& instruction) { return value(instruction.result).rate == Rate::frame; };
    for (std::int32_t i = program_.frame.first; i < program_.frame.last; ++i) {
        const Instruction& instruction = program_.instructions[static_cast<std::size_t>(i)];
        if (!frame_only(instruction)) continue;
        globals += value(instruction.result).type->name + " ";
        name(globals, instruction.result);
        globals += ";\n";
        body += "    ";
        name(body, instruction.result);
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
        name(text, entry.inputs[i]);
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
        reference(text, entry.results[0]);
        return text;
    }
    text = std::string(result_type) + "(";
    for (std::size_t i = 0; i < entry.results.size(); ++i) {
        if (i > 0) text += ", ";
        reference(text, entry.results[i]);
    }
    return text + ")";
}

std::vector<ScenePrinter::Item> ScenePrinter::items(std::int32_t first, std::int32_t last) const
{
    std::vector<Item> result;
    for (std::int32_t i = first; i < last;) {
        const Instruction& instruction = program_.instructions[static_cast<std::size_t>(i)];
        std::int32_t end = instruction.is_block() ? instruction.body_end : i + 1;
        result.push_back({i, end});
        i = end;
    }
    return result;
}

void ScenePrinter::level(std::string& out, std::int32_t first, std::int32_t last, std::span<const ValueId> results,
                         int indent)
{
    std::vector<Item> all = items(first, last);
    if (all.size() <= largest_part) {
        for (const Item& item : all) statement(out, item, indent);
        return;
    }
    for (const Part& part : parts(all, results)) {
        part_function(all, part);
        part_call(out, part, indent);
        ++part_count_;
    }
}

// Where, 64 to 128 items on, the fewest values defined since `first` are read later; the latest such place.
std::size_t ScenePrinter::best_cut(const std::vector<Item>& items, std::size_t first,
                                   const std::vector<std::uint32_t>& last_use) const
{
    std::size_t last = first + largest_part;
    if (last >= items.size()) return items.size();
    std::array<int, largest_part + 2> change{};  // of the number of values alive, by items after first
    for (std::size_t i = first; i < last; ++i)
        for_each_definition(items[i], [&](ValueId id) {
            std::size_t end = last_use[static_cast<std::size_t>(id)];
            if (end <= i) return;
            ++change[i + 1 - first];
            if (end < last) --change[end + 1 - first];
        });
    int alive = 0, fewest = std::numeric_limits<int>::max();
    std::size_t best = last;
    for (std::size_t cut = 1; cut <= largest_part; ++cut) {
        alive += change[cut];
        if (cut >= smallest_part && alive <= fewest) fewest = alive, best = first + cut;
    }
    return best;
}

// Cuts a level into runs of items where few values are alive.
std::vector<ScenePrinter::Part> ScenePrinter::parts(const std::vector<Item>& items,
                                                    std::span<const ValueId> results) const
{
    constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> defined(program_.values.size(), never), last_use(program_.values.size(), 0);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        for_each_definition(items[i], [&](ValueId id) { defined[static_cast<std::size_t>(id)] = i; });
        for_each_use(items[i], [&](ValueId id) { last_use[static_cast<std::size_t>(id)] = i; });
    }
    for (ValueId id : results) last_use[static_cast<std::size_t>(id)] = never;

    std::vector<Part> result;
    for (std::size_t first = 0; first < items.size();) {
        std::size_t best = best_cut(items, first, last_use);
        Part part{first, best, {}, {}};
        for (std::size_t i = first; i < best; ++i) {
            for_each_use(items[i], [&](ValueId id) {
                bool outside = !in_block(id) && (defined[static_cast<std::size_t>(id)] == never ||
                                                 defined[static_cast<std::size_t>(id)] < first);
                if (outside && std::find(part.inputs.begin(), part.inputs.end(), id) == part.inputs.end())
                    part.inputs.push_back(id);
            });
            for_each_definition(items[i], [&](ValueId id) {
                if (last_use[static_cast<std::size_t>(id)] >= best) part.outputs.push_back(id);
            });
        }
        first = best;
        result.push_back(std::move(part));
    }
    return result;
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
            name(text, id);
            text += ";\n";
        }
        text += "};\n\n";
    }
    text += type + " scene_part_" + number + "(";
    for (std::size_t i = 0; i < part.inputs.size(); ++i) {
        text += (i > 0 ? ", " : "") + value(part.inputs[i]).type->name + " ";
        name(text, part.inputs[i]);
    }
    body += "    return ";
    if (!single) body += type + "(";
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
        if (i > 0) body += ", ";
        name(body, part.outputs[i]);
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
    if (single) name(out, part.outputs[0]);
    out += " = scene_part_" + number + "(";
    for (std::size_t i = 0; i < part.inputs.size(); ++i) {
        if (i > 0) out += ", ";
        name(out, part.inputs[i]);
    }
    out += ");\n";
    if (single) return;
    for (ValueId id : part.outputs) {
        append_indent(out, indent);
        out += value(id).type->name + " ";
        name(out, id);
        out += " = part_" + number + ".";
        name(out, id);
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
    name(out, instruction.result);
    out += " = ";
    call(out, instruction);
    out += ";\n";
}

void ScenePrinter::call(std::string& out, const Instruction& instruction)
{
    out += instruction.function->name;
    out += '(';
    for (std::int32_t k = 0; k < instruction.argument_count; ++k) {
        if (k > 0) out += ", ";
        reference(out, program_.arguments[static_cast<std::size_t>(instruction.first_argument + k)]);
    }
    out += ')';
}

void ScenePrinter::block(std::string& out, const Item& item, int indent)
{
    const Instruction& instruction = program_.instructions[static_cast<std::size_t>(item.instruction)];
    std::span carried(program_.carried.data() + instruction.first_carried,
                      static_cast<std::size_t>(instruction.carried_count));
    std::vector<ValueId> next;
    for (const graph::Carried& pair : carried) {
        append_indent(out, indent);
        out += value(pair.accumulator).type->name + " ";
        name(out, pair.accumulator);
        out += " = ";
        reference(out, pair.initial);
        out += ";\n";
        next.push_back(pair.next);
    }
    std::string copy;
    name(copy, instruction.copy);
    append_indent(out, indent);
    out += "for (int " + copy + " = 0; " + copy + " < " + std::to_string(instruction.copies) + "; " + copy + "++) {\n";
    level(out, item.instruction + 1, item.end, next, indent + 1);
    for (const graph::Carried& pair : carried) {
        append_indent(out, indent + 1);
        name(out, pair.accumulator);
        out += " = ";
        reference(out, pair.next);
        out += ";\n";
    }
    append_indent(out, indent);
    out += "}\n";
}

// Never the user's words, except through node_name_, which makes them safe.
void ScenePrinter::name(std::string& out, ValueId id) const
{
    const graph::ProgramValue& named = value(id);
    std::string_view word = named.name ? named.name : "";
    constexpr std::string_view inputs[] = {"p", "uv", "lens", "direction", "spread", "time"};
    if (std::find(std::begin(inputs), std::end(inputs), word) != std::end(inputs)) {
        out += word;
        return;
    }
    if (node_name_) {
        out += named.node ? node_name_(named.node) : std::string(word.empty() ? "value" : word);
    } else {
        out += 'n';
        append_integer(out, named.node.number);
    }
    out += '_';
    append_integer(out, id);
}

void ScenePrinter::reference(std::string& out, ValueId id)
{
    const graph::ProgramValue& read = value(id);
    if (read.rate == Rate::point || (frame_globals_ && read.rate == Rate::frame)) return name(out, id);
    if (placement_ == Placement::literals && read.rate == Rate::constant) {
        const float* lanes = block_.data() + read.slot;
        return literal(out, *read.type, lanes);
    }
    reads_block_ = true;
    std::int32_t slot = read.slot;
    block_read(out, *read.type, slot);
}

// A structure's constructor. What the shader leaves out is passed over: print(text, type) is called for it all the same.
template <typename Print>
void ScenePrinter::members(std::string& out, const graph::Type& type, const Print& print) const
{
    auto named = [&](const graph::StructDeclaration& declared) { return declared.name == type.name; };
    const auto& all = program_.library->structs();
    auto whole = std::find_if(all.begin(), all.end(), named);
    auto printed = std::find_if(structs_.begin(), structs_.end(), named);
    std::string left_out, separator;
    out += type.name + "(";
    for (const auto& member : whole->members) {
        bool is_printed = std::any_of(printed->members.begin(), printed->members.end(),
                                      [&](const auto& known) { return known.name == member.name; });
        if (is_printed) out += std::exchange(separator, ", ");
        print(is_printed ? out : left_out, member.type);
    }
    out += ')';
}

void ScenePrinter::literal(std::string& out, const graph::Type& type, const float*& lanes) const
{
    auto numbers = [&](int count) {
        for (int i = 0; i < count; ++i) {
            if (i > 0) out += ", ";
            append_float(out, *lanes++);
        }
        out += ')';
    };
    switch (type.base) {
        case BaseType::none: return;
        case BaseType::real: return append_float(out, *lanes++);
        case BaseType::integer: return append_integer(out, static_cast<std::int64_t>(*lanes++));
        case BaseType::boolean: out += *lanes++ > 0.5f ? "true" : "false"; return;
        case BaseType::vec2: out += "vec2("; return numbers(2);
        case BaseType::vec3: out += "vec3("; return numbers(3);
        case BaseType::vec4: out += "vec4("; return numbers(4);
        case BaseType::mat2: out += "mat2("; return numbers(4);
        case BaseType::mat3: out += "mat3("; return numbers(9);
        case BaseType::list:
            out += "List(";
            append_integer(out, static_cast<std::int64_t>(*lanes++));
            out += ", ";
            append_integer(out, static_cast<std::int64_t>(*lanes++));
            out += ')';
            return;
        case BaseType::structure: break;
    }
    members(out, type, [&](std::string& text, const graph::Type& member) { literal(text, member, lanes); });
}

void ScenePrinter::block_read(std::string& out, const graph::Type& type, std::int32_t& slot)
{
    auto lane = [&] {
        out += "block[";
        append_integer(out, slot / 4);
        out += "].";
        out += "xyzw"[slot % 4];
        ++slot;
    };
    auto lanes = [&](int count) {
        for (int i = 0; i < count; ++i) {
            if (i > 0) out += ", ";
            lane();
        }
        out += ')';
    };
    auto wrapped = [&](std::string_view open, std::string_view close) {
        out += open;
        lane();
        out += close;
    };
    switch (type.base) {
        case BaseType::none: return;
        case BaseType::real: return lane();
        case BaseType::integer: return wrapped("int(", ")");
        case BaseType::boolean: return wrapped("(", " > 0.5)");
        case BaseType::vec2: out += "vec2("; return lanes(2);
        case BaseType::vec3: out += "vec3("; return lanes(3);
        case BaseType::vec4: out += "vec4("; return lanes(4);
        case BaseType::mat2: out += "mat2("; return lanes(4);
        case BaseType::mat3: out += "mat3("; return lanes(9);
        case BaseType::list:
            out += "List(";
            wrapped("int(", "), ");
            wrapped("int(", "))");
            return;
        case BaseType::structure: break;
    }
    members(out, type, [&](std::string& text, const graph::Type& member) { block_read(text, member, slot); });
}

}  // namespace fieldwright::codegen
