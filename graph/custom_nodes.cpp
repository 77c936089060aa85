// Adding a custom node: first its type, then the node under the library that knows it.
#include "graph/custom_nodes.h"

#include "graph/json.h"
#include "graph/own_type_edits.h"
#include "graph/own_types.h"

#include <algorithm>
#include <array>

namespace fieldwright::graph {
namespace {

constexpr std::array<CustomTemplate, 6> templates = {{
    {"custom_shape", "Custom shape", "A solid whose distance you write: it begins as a rounded box."},
    {"custom_profile", "Custom 2D shape", "A flat shape whose distance you write: it begins as a rounded rectangle."},
    {"custom_modifier", "Custom modifier",
     "Changes the distance of what it reads as you write it: it begins as bumps."},
    {"custom_domain", "Custom domain",
     "Moves the points at which it reads a shape as you write it: it begins as a lean."},
    {"custom_number", "Custom value", "A number over space that you write: it begins as waves."},
    {"custom_material", "Custom material", "A material that you write: it begins as rings in two colours."},
}};

const std::string* template_text(std::string_view name)
{
    auto found = embedded_texts().find("templates/" + std::string(name) + ".glsl");
    return found == embedded_texts().end() ? nullptr : &found->second;
}

}  // namespace

std::span<const CustomTemplate> custom_templates() { return templates; }

Placed add_custom_node(Document& document, const Library& library, std::string_view template_name, glm::vec2 position,
                       const std::vector<NodeId>& selection, std::optional<glm::vec3> place)
{
    const std::string* text = template_text(template_name);
    if (!text) return {{}, "there is no template " + in_quotes(template_name)};
    Document draft = document;
    OwnType type = renamed({std::string(template_name), *text}, fresh_own_name(document, library, template_name));
    if (Refusal refusal = add_own_type(draft, library, type)) return {{}, refusal};
    std::shared_ptr<const Library> known = with_own_types(library, draft.own_types);
    Placed placed = add_from_menu(draft, *known, type.name, position, selection, place);
    if (!placed.refusal) document = std::move(draft);
    return placed;
}

std::vector<std::string> unused_own_types(const Document& document)
{
    std::vector<std::string> names;
    for (const OwnType& type : document.own_types)
        if (uses_of_own_type(document, type.name) == 0) names.push_back(type.name);
    return names;
}

Refusal remove_unused_own_types(Document& document)
{
    std::vector<std::string> names = unused_own_types(document);
    if (names.empty()) return "every own type of the scene is used";
    for (const std::string& name : names)
        if (Refusal refusal = remove_own_type(document, name)) return refusal;
    return std::nullopt;
}

}  // namespace fieldwright::graph
