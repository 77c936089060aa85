// Nodes written in the editor: the texts they begin with, and adding one of them to a document.
#pragma once

#include "graph/compose.h"

#include <span>

namespace fieldwright::graph {

struct CustomTemplate {
    std::string_view name;   // of its file, shaders/templates/<name>.glsl
    std::string_view title;  // "Custom shape"
    std::string_view help;
};
std::span<const CustomTemplate> custom_templates();

// An own type with the template's text under a fresh name and a node of it, placed as from the add menu.
Placed add_custom_node(Document& document, const Library& library, std::string_view template_name, glm::vec2 position,
                       const std::vector<NodeId>& selection, std::optional<glm::vec3> place = {});

// Own types that no node has.
std::vector<std::string> unused_own_types(const Document& document);
Refusal remove_unused_own_types(Document& document);  // refused when there is none

}  // namespace fieldwright::graph
