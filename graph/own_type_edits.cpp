// Edits of own types.
#include "graph/own_type_edits.h"

#include "graph/groups.h"
#include "graph/json.h"
#include "graph/limits.h"
#include "graph/own_types.h"

#include <algorithm>
#include <cctype>

namespace fieldwright::graph {
namespace {

std::vector<OwnType>::const_iterator place_of(const Document& document, std::string_view name)
{
    return std::lower_bound(document.own_types.begin(), document.own_types.end(), name,
                            [](const OwnType& type, std::string_view wanted) { return type.name < wanted; });
}

OwnType* find(Document& document, std::string_view name) { return const_cast<OwnType*>(find_own_type(document, name)); }

std::string no_type(std::string_view name) { return "the scene has no own type " + in_quotes(name); }

Refusal text_error(std::string_view text)
{
    if (text.size() > own_text_limit) return "the text of a node has at most 64 KB; shorten it";
    if (!is_utf8(text)) return "the text of a node is not UTF-8";
    return std::nullopt;
}

Refusal name_error(const Document& document, const Library& library, std::string_view name)
{
    if (find_own_type(document, name)) return "the scene has an own type " + in_quotes(name) + " already";
    if (std::string error = own_name_error(library, name); !error.empty())
        return "the name " + in_quotes(name) + " " + error;
    return std::nullopt;
}

// Without the number at the end, which counts on.
std::string plain_stem(std::string_view wish)
{
    std::string stem;
    for (char c : wish.substr(0, wish.find_last_not_of("0123456789") + 1)) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9' && !stem.empty());
        if (kept) stem += c;
        else if (!stem.empty() && stem.back() != '_') stem += '_';
        if (stem.size() == 32) break;
    }
    while (stem.ends_with('_')) stem.pop_back();
    return stem.empty() || std::isdigit(static_cast<unsigned char>(stem.front())) ? "custom" : stem;
}

bool is_word_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

const OwnType* find_own_type(const Document& document, std::string_view name)
{
    auto place = place_of(document, name);
    return place != document.own_types.end() && place->name == name ? &*place : nullptr;
}

std::size_t uses_of_own_type(const Document& document, std::string_view name)
{
    std::size_t uses = 0;
    for_each_graph(document, [&](const Graph& graph) {
        uses += static_cast<std::size_t>(
            std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) { return node.type == name; }));
    });
    return uses;
}

Refusal add_own_type(Document& document, const Library& library, OwnType type)
{
    if (document.own_types.size() >= own_type_limit) return "a scene has at most 256 own types; remove some";
    if (Refusal refusal = name_error(document, library, type.name)) return refusal;
    if (Refusal refusal = text_error(type.text)) return refusal;
    document.own_types.insert(place_of(document, type.name), std::move(type));
    return std::nullopt;
}

Refusal set_own_type_text(Document& document, std::string_view name, std::string text)
{
    OwnType* type = find(document, name);
    if (!type) return no_type(name);
    if (Refusal refusal = text_error(text)) return refusal;
    type->text = std::move(text);
    return std::nullopt;
}

Refusal rename_own_type(Document& document, const Library& library, std::string_view name, std::string_view new_name)
{
    const OwnType* type = find_own_type(document, name);
    if (!type) return no_type(name);
    if (name == new_name) return std::nullopt;
    if (Refusal refusal = name_error(document, library, new_name)) return refusal;
    bool kept_as_text = false;
    for_each_graph(document, [&](const Graph& graph) {
        for (const Node& node : graph.nodes)
            kept_as_text = kept_as_text || (node.type == name && !node.unknown_source.empty());
    });
    if (kept_as_text) return "the text of " + in_quotes(name) + " is broken; repair it first";
    OwnType moved = renamed(*type, new_name);
    document.own_types.erase(place_of(document, name));
    for_each_graph(document, [&](Graph& graph) {
        for (Node& node : graph.nodes)
            if (node.type == name) node.type = moved.name;
    });
    document.own_types.insert(place_of(document, moved.name), std::move(moved));
    return std::nullopt;
}

Refusal remove_own_type(Document& document, std::string_view name)
{
    if (!find_own_type(document, name)) return no_type(name);
    if (std::size_t uses = uses_of_own_type(document, name))
        return in_quotes(name) + " is used by " + std::to_string(uses) + (uses == 1 ? " node" : " nodes") +
               "; remove " + (uses == 1 ? "it" : "them") + " first";
    document.own_types.erase(place_of(document, name));
    return std::nullopt;
}

Refusal make_type_single(Document& document, const Library& library, NodeId id)
{
    Node* node = document.root.find(id);
    if (!node) return "there is no node " + std::to_string(id.number);
    const OwnType* type = find_own_type(document, node->type);
    if (!type) return no_type(node->type);
    if (!node->unknown_source.empty()) return "the text of " + in_quotes(node->type) + " is broken; repair it first";
    OwnType copy = renamed(*type, fresh_own_name(document, library, node->type));
    if (Refusal refusal = add_own_type(document, library, copy)) return refusal;
    node->type = copy.name;
    return std::nullopt;
}

std::string fresh_own_name(const Document& document, const Library& library, std::string_view wish)
{
    if (!name_error(document, library, wish)) return std::string(wish);
    std::string stem = plain_stem(wish);
    for (int number = 2;; ++number)
        if (std::string name = stem + "_" + std::to_string(number); !name_error(document, library, name)) return name;
}

OwnType renamed(const OwnType& type, std::string_view new_name)
{
    OwnType result{std::string(new_name), {}};
    std::string prefix = type.name + "_";
    for (std::size_t at = 0; at < type.text.size();) {
        bool begins = at == 0 || !is_word_part(type.text[at - 1]);
        if (begins && std::string_view(type.text).substr(at).starts_with(prefix)) {
            result.text += result.name + "_";
            at += prefix.size();
        } else {
            result.text += type.text[at++];
        }
    }
    return result;
}

}  // namespace fieldwright::graph
