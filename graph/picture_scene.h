// The scene that a picture keeps beside its pixels.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::graph {

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

// The text "fieldwright:graph" of a PNG (PNG specification, tEXt chunks), unchecked; nothing when the bytes hold none.
std::optional<std::string> scene_in_png(std::string_view bytes);
// Whether the file is a PNG with such a text in its first 16 MB.
bool holds_scene(const std::filesystem::path& picture);

}  // namespace fieldwright::graph
