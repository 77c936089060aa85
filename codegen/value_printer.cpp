// Names, literals, and places in the block.
#include "codegen/value_printer.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace fieldwright::codegen {
namespace {

using graph::BaseType;
using graph::Rate;
using graph::ValueId;

void append_integer(std::string& out, std::int64_t number)
{
    char buffer[24];
    char* end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    out.append(buffer, static_cast<std::size_t>(end - buffer));
}

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

ValuePrinter::ValuePrinter(const graph::Program& program, std::span<const float> block, Placement placement,
                           std::vector<graph::StructDeclaration> structs, NodeName node_name)
    : program_(program),
      block_(block),
      placement_(placement),
      structs_(std::move(structs)),
      node_name_(std::move(node_name))
{
}

// Never the user's words, except through node_name_, which makes them safe.
void ValuePrinter::name(std::string& out, ValueId id) const
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

void ValuePrinter::reference(std::string& out, ValueId id)
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
void ValuePrinter::members(std::string& out, const graph::Type& type, const Print& print) const
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

void ValuePrinter::literal(std::string& out, const graph::Type& type, const float*& lanes) const
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

void ValuePrinter::block_read(std::string& out, const graph::Type& type, std::int32_t& slot)
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
