// What the canvas says of things beside their names: hints, values and field qualities in words that fit a node.
#pragma once

#include "graph/document.h"
#include "graph/library.h"
#include "graph/words.h"

namespace fieldwright::ui {

using graph::category_title;
using graph::node_title;
using graph::socket_label;

std::string node_hint(const graph::Node& node, const graph::NodeType* type);    // for a tooltip: title, type, help
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
