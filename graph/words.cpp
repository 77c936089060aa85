// Naming things.
#include "graph/words.h"

#include "graph/json.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <cctype>

namespace fieldwright::graph {
namespace {

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

// Two and three numbers are no "a".
std::string with_article(std::string_view words)
{
    bool counted = words.starts_with("two ") || words.starts_with("three ");
    return (counted || words == "nothing" ? "" : "a ") + std::string(words);
}

}  // namespace

std::string in_words(std::string_view identifier)
{
    std::string words = as_sentence(identifier);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string inside_a_sentence(std::string_view title)
{
    std::string words(title);
    if (words.size() > 1 && is_upper(words[0]) && words[1] >= 'a' && words[1] <= 'z')
        words[0] = static_cast<char>(words[0] + ('a' - 'A'));
    return words;
}

std::string as_sentence(std::string_view text)
{
    std::string sentence(text);
    if (!sentence.empty()) sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    return sentence;
}

std::string node_title(const Node& node, const NodeType* type)
{
    return !node.name.empty() ? node.name : type ? type->title : node.type;
}

std::string title_of(const Node& node, const Library& library) { return node_title(node, library.type(node.type)); }

std::string title_inside(const Node& node, const Library& library)
{
    return node.name.empty() ? inside_a_sentence(title_of(node, library)) : node.name;
}

std::string socket_label(const NodeType* type, std::string_view socket)
{
    if (type && type->parameter(socket)) return in_words(socket);
    if (const Socket* found = type ? type->input(socket) : nullptr; found && !found->title.empty()) return found->title;
    if (type && type->most_inputs > 0 && socket == "a") return "Shape 1";
    if (type && type->most_inputs > 0 && socket == "b") return "Shape 2";
    if (socket == "d") return "Shape";
    if (socket == "a") return "First shape";
    if (socket == "b") return "Second shape";
    if (socket == "c") return "Third shape";
    return in_words(socket);
}

std::string category_title(std::string_view category)
{
    return category == "shape2d" ? "2D shape" : in_words(category);
}

std::string_view kind_words(SocketKind kind)
{
    switch (kind) {
        case SocketKind::field2d: return "flat shape";
        case SocketKind::field3d: return "solid";
        case SocketKind::field_any: return "shape, flat or solid";
        case SocketKind::number: return "number";
        case SocketKind::vec2: return "two numbers";
        case SocketKind::vec3: return "three numbers";
        case SocketKind::colour: return "colour";
        case SocketKind::material: return "material";
        case SocketKind::camera: return "camera";
        case SocketKind::sky: return "sky";
        case SocketKind::light: return "light";
        case SocketKind::none: break;
    }
    return "nothing";
}

std::string titled(std::string_view title) { return "“" + std::string(title) + "”"; }

std::string named(Wording wording, const Node& node, const NodeType* type)
{
    return wording == Wording::titles ? titled(node_title(node, type)) : described(node);
}

std::string named(Wording wording, const NodeType* type, std::string_view socket)
{
    return wording == Wording::titles ? titled(socket_label(type, socket)) : in_quotes(socket);
}

std::string kind_named(Wording wording, SocketKind kind, int dimension)
{
    bool field = carries_field(kind);
    if (field && dimension) kind = dimension == 2 ? SocketKind::field2d : SocketKind::field3d;
    if (wording == Wording::file)
        return "a " +
               (field && dimension ? std::to_string(dimension) + "D field" : std::string(socket_kind_name(kind)));
    return kind == SocketKind::field_any ? "a shape" : with_article(kind_words(kind));
}

}  // namespace fieldwright::graph
