// Cutting a line of text into its parts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::graph {

std::string_view trim(std::string_view text);                           // without blanks at both ends
std::vector<std::string> split(std::string_view text, char separator);  // trimmed; without empty parts

}  // namespace fieldwright::graph
