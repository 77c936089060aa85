// What nodes, sockets and kinds are called: by titles, as the window shows them, or as a scene file writes them.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

namespace fieldwright::graph {

std::string in_words(std::string_view identifier);      // "half_size" as "Half size"
std::string inside_a_sentence(std::string_view title);  // "Torus" as "torus"; "2D ring" and "XOR" stay
std::string as_sentence(std::string_view text);         // begins with a capital

// The user's name, else the type's title, else the type's word.
std::string node_title(const Node& node, const NodeType* type);
std::string title_of(const Node& node, const Library& library);
std::string title_inside(const Node& node, const Library& library);  // a sentence: a name stays, a title is "torus"
std::string socket_label(const NodeType* type, std::string_view socket);  // "a" as "First shape"
std::string category_title(std::string_view category);                    // "shape2d" as "2D shape"
// "solid", "number", "three numbers"; of a field of any dimension "shape, flat or solid".
std::string_view kind_words(SocketKind kind);
std::string titled(std::string_view title);  // “Torus”, in the middle of a sentence

// Whom a sentence is for: who edits sees titles, who mends a file sees its words.
enum class Wording { titles, file };
// “Sphere”, or: node 3 (`sphere`)
std::string named(Wording wording, const Node& node, const NodeType* type);
// “First shape”, or: `a`
std::string named(Wording wording, const NodeType* type, std::string_view socket);
// "a solid", or: a 3D field. Dimension 0: of any.
std::string kind_named(Wording wording, SocketKind kind, int dimension = 0);

}  // namespace fieldwright::graph
