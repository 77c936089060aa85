// Colours as people write them: sRGB and its hex words, to and from the linear Rec.709 of documents.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::ui {

glm::vec3 srgb_from_linear(glm::vec3 linear);
glm::vec3 linear_from_srgb(glm::vec3 srgb);

// "#c8503c"; what lies outside 0 .. 1 is clamped.
std::string hex_text(glm::vec3 srgb);
// "#c8503c", "c8503c" or "#c53"; nothing for anything else.
std::optional<glm::vec3> parse_hex(std::string_view text);

}  // namespace fieldwright::ui
