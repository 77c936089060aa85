// Paths without touching files.
#include "app/picture_paths.h"

#include "graph/groups.h"
#include "graph/image_request.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fieldwright::app {

namespace fs = std::filesystem;

std::string stored_picture_path(const fs::path& file, const fs::path& scene_folder)
{
    fs::path absolute = fs::absolute(file).lexically_normal();
    if (scene_folder.empty()) return absolute.string();
    fs::path relative = absolute.lexically_relative(fs::absolute(scene_folder).lexically_normal());
    auto ups = std::count(relative.begin(), relative.end(), fs::path(".."));
    return relative.empty() || ups > 2 ? absolute.string() : relative.string();
}

void move_picture_paths(graph::Document& document, const graph::Library& library, const fs::path& from,
                        const fs::path& to)
{
    graph::for_each_graph(document, [&](graph::Graph& graph) {
        for (graph::Node& node : graph.nodes) {
            const graph::NodeType* type = library.type(node.type);
            auto request = type ? graph::image_request(node, *type) : std::nullopt;
            if (!request) continue;
            for (auto& [name, value] : node.parameters)
                if (name == graph::image_parameter(*type)->name) value = stored_picture_path(from / request->path, to);
        }
    });
}

bool is_picture_name(const fs::path& file)
{
    constexpr std::array<std::string_view, 8> ends = {".png", ".jpg", ".jpeg", ".hdr", ".exr", ".tif", ".tiff", ".jpe"};
    std::string end = file.extension().string();
    std::transform(end.begin(), end.end(), end.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
    return std::find(ends.begin(), ends.end(), end) != ends.end();
}

}  // namespace fieldwright::app
