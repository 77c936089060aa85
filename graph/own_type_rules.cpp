// The rules, one function each.
#include "graph/own_type_rules.h"

#include "graph/wire_rules.h"

#include <algorithm>
#include <cctype>

namespace fieldwright::graph {
namespace {

constexpr int loop_limit = 4096;       // iterations of one call
constexpr int inlined_limit = 50'000;  // tokens of one function with those it calls in their places
constexpr std::size_t parameter_limit = 24;

// What a function of a meaning returns, and which reserved arguments it may receive.
struct Meaning {
    std::string_view suffix;
    std::vector<std::string_view> results;
    std::vector<Role> roles;
};

const std::vector<Meaning>& meanings()
{
    using enum Role;
    static const std::vector<Meaning> list = {
        {"distance", {"float"}, {p, d, a, b, c, acc, cell, time}},
        {"least", {"float"}, {b}},
        {"point", {"vec3", "vec2"}, {p, copy, cell, time}},
        {"cell", {"vec3"}, {p, copy, cell, time}},
        {"copies", {"int"}, {time}},
        {"blend", {"float"}, {p, d, a, b, acc, cell, time}},
        {"shows_b", {"bool"}, {p, d, a, b, acc, cell, time}},
        {"bounds", {"Box"}, {child, box_a, box_b, time}},
        {"lipschitz", {"float"}, {child, box_a, box_b, time}},
        {"stretch", {"float"}, {child, box_a, box_b, time}},
        {"value", {"float", "vec2", "vec3"}, {p, cell, time}},
        {"material", {"Material"}, {p, cell, time}},
        {"light", {"Light"}, {p, time}},
        {"ray", {"Ray"}, {uv, lens, time}},
        {"sky", {"vec3"}, {direction, time}},
    };
    return list;
}

// The types in which a reserved argument comes.
std::vector<std::string_view> types_of(Role role)
{
    switch (role) {
        case Role::p: return {"vec3", "vec2"};
        case Role::copy: return {"int"};
        case Role::cell:
        case Role::direction: return {"vec3"};
        case Role::uv:
        case Role::lens: return {"vec2"};
        case Role::child:
        case Role::box_a:
        case Role::box_b: return {"Box"};
        default: return {"float"};
    }
}

template <typename List, typename Item>
bool contains(const List& list, const Item& item)
{
    return std::find(list.begin(), list.end(), item) != list.end();
}

std::string joined(const std::vector<std::string_view>& words)
{
    std::string text;
    for (std::string_view word : words) text += (text.empty() ? "`" : " or `") + std::string(word) + "`";
    return text;
}

[[noreturn]] void fail(const NodeType& type, int line, const std::string& rule)
{
    throw DialectError(type.source.path, line, rule);
}

int line_of(const SourceFile& file, std::string_view part)
{
    std::size_t at = std::min(file.text.find(part), file.text.size());
    return 1 +
           static_cast<int>(std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// Of `const float NAME = ...;`
std::string constant_name(std::string_view constant)
{
    std::string_view before = constant.substr(0, constant.find('='));
    while (!before.empty() && std::isspace(static_cast<unsigned char>(before.back()))) before.remove_suffix(1);
    return std::string(before.substr(before.find_last_of(" \t\n") + 1));
}

void check_arguments(const NodeType& type, const Function& function, const Meaning& meaning)
{
    for (const Argument& argument : function.arguments) {
        if (argument.role == Role::parameter) continue;
        if (!contains(meaning.roles, argument.role))
            fail(type, argument.line,
                 "`" + argument.name + "` is a reserved name, which `_" + std::string(meaning.suffix) +
                     "` does not receive; use another");
        if (std::vector<std::string_view> types = types_of(argument.role); !contains(types, argument.type.name))
            fail(type, argument.line, "`" + argument.name + "` is a reserved name and of type " + joined(types));
    }
}

void check_meaning(const NodeType& type, const Function& function)
{
    std::string_view suffix = std::string_view(function.name).substr(type.name.size() + 1);
    for (const Meaning& meaning : meanings()) {
        if (meaning.suffix != suffix) continue;
        if (!contains(meaning.results, function.result.name))
            fail(type, function.line, "`" + function.name + "` returns " + joined(meaning.results));
        check_arguments(type, function, meaning);
    }
}

void check_names(const NodeType& type, const TakenNames& taken)
{
    if (!type.source.structs.empty())
        fail(type, type.source.structs.front().line, "a node declares no struct; use those of the shading library");
    for (const Function& function : type.source.functions)
        if (taken.function(function.name))
            fail(type, function.line, "another node has a function `" + function.name + "`; use another name");
    for (const std::string& constant : type.source.constants)
        if (std::string name = constant_name(constant); taken.constant(name) || taken.function(name))
            fail(type, line_of(type.source, constant), "`" + name + "` exists already elsewhere; use another name");
}

void check_size(const NodeType& type, const Function& function)
{
    if (function.loop_iterations > loop_limit)
        fail(type, function.line,
             "`" + function.name + "` loops " + std::to_string(function.loop_iterations) + " times a call, at most " +
                 std::to_string(loop_limit) + " are allowed");
    if (function.inlined_tokens > inlined_limit)
        fail(type, function.line,
             "`" + function.name + "` is too long with all the functions it calls; write a loop or call fewer");
}

void check_sockets(const NodeType& type)
{
    if (type.parameters.size() > parameter_limit) fail(type, 1, "a node has at most 24 parameters");
    if (type.input("camera") || type.input("sky")) fail(type, 1, "only the output node reads a camera or a sky");
    if (type.scaling != Scaling::none && !(type.input("a") && type.input("b")))
        fail(type, 1, "`combiner` is for nodes that read `a` and `b`");
}

}  // namespace

TakenNames::TakenNames(const Library& library)
{
    for (const SourceFile& file : library.render_files()) add(file);
    for (const NodeType* type : library.types()) add(*type);
}

void TakenNames::add(const NodeType& type) { add(type.source); }

void TakenNames::add(const SourceFile& file)
{
    for (const Function& function : file.functions) functions_.insert(function.name);
    for (const std::string& constant : file.constants) constants_.insert(constant_name(constant));
}

void check_own_rules(const NodeType& type, const TakenNames& taken)
{
    check_names(type, taken);
    check_sockets(type);
    for (const Function& function : type.source.functions) {
        check_meaning(type, function);
        check_size(type, function);
    }
}

std::string category_of_meaning(const NodeType& type)
{
    switch (type.output) {
        case SocketKind::material: return "material";
        case SocketKind::light: return "light";
        case SocketKind::camera: return "camera";
        case SocketKind::sky: return "sky";
        default: break;
    }
    if (!type.is_field()) return "value";
    std::vector<SocketKind> fields;
    for (const Socket& socket : type.inputs)
        if (carries_field(socket.kind)) fields.push_back(socket.kind);
    if (fields.empty()) return type.output == SocketKind::field2d ? "shape2d" : "primitive";
    if (type.function("point")) return fields.front() == type.output ? "domain" : "convert";
    return fields.size() > 1 ? "combine" : "modify";
}

}  // namespace fieldwright::graph
