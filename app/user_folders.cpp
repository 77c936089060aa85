// The folders of the user: $XDG_CONFIG_HOME and $XDG_STATE_HOME, or their places in the home folder.
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

}  // namespace fieldwright::app
