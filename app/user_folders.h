// Where this user's settings and this program's memory lie, by the XDG base directory rules.
#pragma once

#include <filesystem>
#include <optional>

namespace fieldwright::app {

struct UserFolders {
    std::filesystem::path config;  // what the user chose: settings, keys
    std::filesystem::path state;   // what the program remembers: recent files, window, autosave
};

// Both exist afterwards; folders made for it have mode 0700. With `root`, they lie in it and the environment is not asked.
// Failure 5 when there is no place for them.
UserFolders user_folders(const std::optional<std::filesystem::path>& root = std::nullopt);

// Where groups of the user's library lie ($XDG_DATA_HOME); makes nothing. Nothing when there is no home folder.
std::optional<std::filesystem::path> user_group_folder(const std::optional<std::filesystem::path>& root = std::nullopt);

// Where the user keeps own node files ($XDG_DATA_HOME); makes nothing. Nothing when there is no home folder.
std::optional<std::filesystem::path> user_node_folder(const std::optional<std::filesystem::path>& root = std::nullopt);

}  // namespace fieldwright::app
