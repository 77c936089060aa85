// Groups to files and back.
#include "app/group_library.h"

#include "graph/group_edits.h"
#include "graph/scene_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t size_limit = 1u << 20;

std::vector<fs::path> files_in(const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (it->path().extension() == ".json" && it->is_regular_file(ignored)) files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    if (files.size() > GroupLibrary::file_limit) files.resize(GroupLibrary::file_limit);
    return files;
}

std::string text_of(const fs::path& path)
{
    std::error_code error;
    if (fs::file_size(path, error) > size_limit || error)
        throw graph::Failure(3, path.string() + ": cannot be read, or is larger than 1 MB; no group is");
    std::ifstream stream(path, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    if (!stream) throw graph::Failure(3, path.string() + ": cannot be read; check its permissions");
    return text.str();
}

ui::SavedGroup saved_group(const fs::path& path, const graph::Library& library)
{
    std::string text = text_of(path);
    graph::SavedGroupText saved = graph::read_saved_group(text, library, path.string());
    saved.type.name = "my_group:" + saved.name;
    saved.type.category = "my_groups";
    saved.type.help = "A group of your library.";
    return {std::move(saved.type), std::move(text)};
}

// A name on every disk: what separates folders, or hides a file, is none.
std::string file_name(std::string name)
{
    for (char& c : name)
        if (c == '/' || c == '\\') c = '_';
    if (name.front() == '.') name.front() = '_';
    return name + ".json";
}

}  // namespace

std::vector<ui::SavedGroup> GroupLibrary::read(const graph::Library& library, std::string& failure) const
{
    std::vector<ui::SavedGroup> groups;
    if (!folder_) return groups;
    for (const fs::path& path : files_in(*folder_)) {
        try {
            groups.push_back(saved_group(path, library));
        } catch (const graph::Failure& reason) {
            if (failure.empty()) failure = reason.what();
        }
    }
    return groups;
}

bool GroupLibrary::save(const std::string& name, std::string_view text) const
{
    if (!folder_) throw graph::Failure(5, "there is no home folder to keep groups in; set HOME to an absolute path");
    std::error_code error;
    fs::create_directories(*folder_, error);
    fs::path path = *folder_ / file_name(name);
    bool replaces = fs::exists(path, error);
    graph::save_atomically(path, text);
    return replaces;
}

}  // namespace fieldwright::app
