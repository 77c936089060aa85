// Recent files as a JSON array of paths.
#include "app/recent_files.h"

#include "app/state_file.h"

#include <algorithm>

namespace fieldwright::app {

namespace fs = std::filesystem;

RecentFiles::RecentFiles(fs::path file) : file_(std::move(file)) { read(); }

void RecentFiles::read()
{
    StateJson json = read_state(file_);
    if (!json.is_array()) return;
    std::vector<fs::path> paths;
    for (const StateJson& entry : json) {
        if (!entry.is_string() || paths.size() == limit) continue;
        fs::path path = entry.get<std::string>();
        if (path.is_absolute() && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
    }
    paths_ = std::move(paths);
}

void RecentFiles::write() const
{
    StateJson json = StateJson::array();
    for (const fs::path& path : paths_) json.push_back(path.string());
    write_state(file_, json);
}

std::vector<RecentFile> RecentFiles::entries() const
{
    std::vector<RecentFile> entries;
    for (const fs::path& path : paths_) {
        std::error_code error;
        entries.push_back({path, !fs::is_regular_file(path, error)});
    }
    return entries;
}

void RecentFiles::add(const fs::path& path)
{
    read();
    fs::path absolute = fs::absolute(path).lexically_normal();
    std::erase(paths_, absolute);
    paths_.insert(paths_.begin(), absolute);
    if (paths_.size() > limit) paths_.resize(limit);
    write();
}

void RecentFiles::remove(const fs::path& path)
{
    read();
    std::erase(paths_, fs::absolute(path).lexically_normal());
    write();
}

void RecentFiles::clear()
{
    paths_.clear();
    write();
}

}  // namespace fieldwright::app
