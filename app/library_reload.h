// The node library read again after its files changed.
#pragma once

#include "graph/library.h"

namespace fieldwright::app {

struct LibraryReload {
    std::shared_ptr<const graph::Library> library;  // null when there is an error: the old one goes on
    std::string error;                              // one sentence with file and line
};

LibraryReload reload_library(const std::filesystem::path& folder);

}  // namespace fieldwright::app
