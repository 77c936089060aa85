// The node reference: a page per node type, made from its file, and a picture of it.
#pragma once

#include "graph/library.h"

namespace fieldwright::app {

// Where a type's page and picture lie in the reference's folder, without what follows the dot: "primitive/torus".
std::string node_page_stem(const graph::NodeType& type);

// The page in Markdown. It shows the picture beside it.
std::string node_page(const graph::NodeType& type);
// The first page: every type by category.
std::string node_index(const graph::Library& library);

// Writes all pages and pictures. graph::Failure 5 when the folder cannot hold them.
void write_node_pages(const std::shared_ptr<const graph::Library>& library, const std::filesystem::path& folder);

}  // namespace fieldwright::app
