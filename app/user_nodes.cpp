// Reads and writes the user's node files.
#include "app/user_nodes.h"

#include "app/user_folders.h"
#include "graph/limits.h"
#include "graph/problem.h"
#include "graph/scene_file.h"

#include <fstream>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t file_limit = 1000;

// One byte more than a text may have shows that it is too long.
std::string read_text(const fs::path& path)
{
    std::string text(graph::own_text_limit + 1, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

std::map<std::string, std::string> node_texts(const fs::path& folder)
{
    std::map<std::string, std::string> texts;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code unreadable;
        bool node = it->path().extension() == ".glsl" && it->is_regular_file(unreadable);
        if (node && texts.size() < file_limit)
            texts[it->path().lexically_relative(folder).generic_string()] = read_text(it->path());
    }
    return texts;
}

}  // namespace

std::shared_ptr<const graph::Library> with_user_nodes(const graph::Library& library, const fs::path& folder)
{
    return graph::with_user_nodes(library, node_texts(folder));
}

std::shared_ptr<const graph::Library> user_library(const fs::path& shaders)
{
    auto library = shaders.empty() ? graph::Library::embedded() : graph::Library::load(shaders);
    std::optional<fs::path> folder = user_node_folder();
    return folder && fs::exists(*folder) ? with_user_nodes(*library, *folder) : library;
}

fs::path save_user_node(const fs::path& folder, const graph::NodeType& type)
{
    fs::path path = folder / type.category / (type.name + ".glsl");
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw graph::Failure(5, path.parent_path().string() + ": cannot be made: " + error.message());
    if (fs::exists(path, error)) throw graph::Failure(5, path.string() + ": exists already; rename the node first");
    graph::save_atomically(path, type.source.text);
    return path;
}

}  // namespace fieldwright::app
