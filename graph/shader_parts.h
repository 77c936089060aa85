// Parts of the shading library's texts that only some shaders have: lines between `#if NAME`, `#else` and `#endif`.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace fieldwright::graph {

using ShaderParts = std::set<std::string_view>;

// The text with these parts and without the others.
std::string with_parts(std::string_view text, const ShaderParts& parts);
// Which line of `text`, from 1, is line `line` of with_parts(text, parts), from 1.
int line_of_whole(std::string_view text, const ShaderParts& parts, int line);
// With every part and no alternative to one; lines keep their numbers.
std::string with_all_parts(std::string_view text);

}  // namespace fieldwright::graph
