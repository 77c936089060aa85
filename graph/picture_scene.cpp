// Walks the chunks of a PNG.
#include "graph/picture_scene.h"

#include "graph/json.h"

#include <cstdint>
#include <fstream>

namespace fieldwright::graph {
namespace {

constexpr std::string_view keyword("fieldwright:graph\0", 18);
constexpr std::size_t length_and_type = 8, checksum = 4;

std::size_t big_endian(std::string_view bytes)
{
    std::size_t number = 0;
    for (char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

}  // namespace

std::optional<std::string> scene_in_png(std::string_view bytes)
{
    if (!bytes.starts_with(png_signature)) return std::nullopt;
    for (bytes.remove_prefix(png_signature.size()); bytes.size() >= length_and_type;) {
        std::size_t length = big_endian(bytes);
        std::string_view type = bytes.substr(4, 4), rest = bytes.substr(length_and_type);
        if (rest.size() < length + checksum) return std::nullopt;
        if (type == "tEXt" && rest.substr(0, length).starts_with(keyword))
            return std::string(rest.substr(keyword.size(), length - keyword.size()));
        bytes = rest.substr(length + checksum);
    }
    return std::nullopt;
}

bool holds_scene(const std::filesystem::path& picture)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(picture, error)) return false;
    std::ifstream stream(picture, std::ios::binary);
    std::string bytes(json_text_limit, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return scene_in_png(bytes).has_value();
}

}  // namespace fieldwright::graph
