// What the canvas calls things: titles, sockets, values and field qualities in words that fit a node.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

namespace fieldwright::ui {

// The user's name, else the type's title, else the type's word.
std::string node_title(const graph::Node& node, const graph::NodeType* type);
std::string node_hint(const graph::Node& node, const graph::NodeType* type);  // for a tooltip: title, type, help
std::string spaced_words(std::string_view identifier);                        // "half_size" as "Half size"
std::string category_title(std::string_view category);                        // "shape2d" as "2D shape"
std::string socket_label(const graph::NodeType* type, std::string_view socket);
std::string socket_hint(const graph::NodeType* type, std::string_view socket);  // for a tooltip: kind, unit, help
std::string output_hint(const graph::NodeType* type);
// Short: "0.25 m", "30°", "1, 0, 0"; empty for what has no short form.
std::string value_text(const graph::Parameter& parameter, const graph::Value& value);

struct QualityWords {
    const char* sign;
    std::string sentence;
};
QualityWords quality_words(const graph::NodeType& type);  // of a field node: the worse of its two sides

}  // namespace fieldwright::ui
