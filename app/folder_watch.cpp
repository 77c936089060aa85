// Polls a folder of shaders.
#include "app/folder_watch.h"

namespace fieldwright::app {

namespace fs = std::filesystem;

FolderWatch::FolderWatch(fs::path folder) : folder_(std::move(folder)), reported_(look()), seen_(reported_) {}

FolderWatch::Stamps FolderWatch::look() const
{
    Stamps stamps;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        if (it->path().extension() != ".glsl") continue;
        if (std::optional<FileStamp> stamp = file_stamp(it->path())) stamps.emplace(it->path().string(), *stamp);
    }
    return stamps;
}

bool FolderWatch::changed(double now_s)
{
    if (now_s < next_look_s_) return false;
    next_look_s_ = now_s + interval_s;
    Stamps now = look();
    bool at_rest = now == seen_;
    seen_ = std::move(now);
    if (!at_rest || seen_ == reported_) return false;
    reported_ = seen_;
    return true;
}

}  // namespace fieldwright::app
