// How scenes name their pictures' files, and keep them when they move.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <filesystem>

namespace fieldwright::app {

// Relative to the scene's folder where the file is in it or near it, else absolute; absolute without a folder.
std::string stored_picture_path(const std::filesystem::path& file, const std::filesystem::path& scene_folder);
// Makes a document of one folder mean the same files from another. An empty folder is the current one.
void move_picture_paths(graph::Document& document, const graph::Library& library, const std::filesystem::path& from,
                        const std::filesystem::path& to);

// By the end of its name: what may be dropped on the window to become an image.
bool is_picture_name(const std::filesystem::path& file);

}  // namespace fieldwright::app
