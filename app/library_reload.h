// The node library read again after its files changed.
#pragma once

#include "graph/library.h"

namespace fieldwright::app {

struct LibraryReload {
    std::shared_ptr<const graph::Library> library;  // null when there is an error: the old one goes on
    std::string error;                              // one sentence with file and line
};

// `shaders`: the folder instead of what is built in, unless empty; `user_nodes`: the user's own folder.
LibraryReload reload_library(const std::filesystem::path& shaders,
                             const std::optional<std::filesystem::path>& user_nodes = std::nullopt);

}  // namespace fieldwright::app
