// The nodes of the user's own folder, which every scene of this user may have: <category>/<name>.glsl.
#pragma once

#include "graph/own_types.h"

#include <filesystem>
#include <memory>

namespace fieldwright::app {

// With the folder's nodes, those that are no nodes left out. A folder that is not there has none.
std::shared_ptr<const graph::Library> with_user_nodes(const graph::Library& library,
                                                      const std::filesystem::path& folder);
// What the program starts with: built in, or read from `shaders` when it is not empty; and the user's nodes.
std::shared_ptr<const graph::Library> user_library(const std::filesystem::path& shaders);

// Puts a node into the folder, in its category's; gives the file. Failure 5, also when there is a node of the name.
std::filesystem::path save_user_node(const std::filesystem::path& folder, const graph::NodeType& type);

}  // namespace fieldwright::app
