// The folders of the user: $XDG_CONFIG_HOME, $XDG_STATE_HOME and $XDG_DATA_HOME, or their places in the home folder.
#include "app/user_folders.h"

#include "graph/problem.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

// An absolute path; relative ones count as unset.
std::optional<fs::path> path_from_environment(const char* variable)
{
    const char* text = std::getenv(variable);
    if (!text || !fs::path(text).is_absolute()) return std::nullopt;
    return text;
}

fs::path home()
{
    if (auto path = path_from_environment("HOME")) return *path;
    const passwd* user = ::getpwuid(::getuid());
    if (user && fs::path(user->pw_dir).is_absolute()) return user->pw_dir;
    throw graph::Failure(5, "there is no home folder to keep settings in; set HOME to an absolute path");
}

fs::path base(const char* variable, const char* in_home)
{
    std::optional<fs::path> path = path_from_environment(variable);
    return path ? *path : home() / in_home;
}

void make_private(const fs::path& folder)
{
    std::error_code error;
    if (fs::is_directory(folder, error)) return;
    if (folder.has_parent_path() && folder.parent_path() != folder) make_private(folder.parent_path());
    if (::mkdir(folder.c_str(), 0700) == 0 || (errno == EEXIST && fs::is_directory(folder, error))) return;
    throw graph::Failure(5, folder.string() + ": cannot be made: " + std::strerror(errno));
}

std::optional<fs::path> data_folder(const char* name, const std::optional<fs::path>& root)
{
    if (root) return *root / "data" / name;
    try {
        return base("XDG_DATA_HOME", ".local/share") / "fieldwright" / name;
    } catch (const graph::Failure&) {
        return std::nullopt;
    }
}

}  // namespace

UserFolders user_folders(const std::optional<fs::path>& root)
{
    UserFolders folders;
    folders.config = root ? *root / "config" : base("XDG_CONFIG_HOME", ".config") / "fieldwright";
    folders.state = root ? *root / "state" : base("XDG_STATE_HOME", ".local/state") / "fieldwright";
    make_private(folders.config);
    make_private(folders.state);
    return folders;
}

std::optional<fs::path> user_node_folder(const std::optional<fs::path>& root) { return data_folder("nodes", root); }

std::optional<fs::path> user_group_folder(const std::optional<fs::path>& root) { return data_folder("groups", root); }

}  // namespace fieldwright::app
