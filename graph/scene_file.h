// Scene JSON (*.scene.json): a strict, limited reader and an atomic writer. The format is docs/scene.schema.json.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <filesystem>

namespace fieldwright::graph {

// Reads text into a valid document. Throws Failure{3, "NAME:line:column: path: what, what to do"}.
Document read_scene(std::string_view text, const Library& library, std::string_view name = "scene");
// Deterministic text: format first, nodes by id, every parameter, floats shortest round trip, ends with a newline.
std::string write_scene(const Document& document, const Library& library);

// A parameter's value as scene JSON has it. Failure 3 when the parameter does not take it.
Value read_value(std::string_view json, const Parameter& parameter);

// Scene JSON, or a PNG that keeps one. Regular files only, at most 16 MB; refuses FIFOs, devices, folders and symlink loops without blocking. Failure 3.
Document open_scene(const std::filesystem::path& path, const Library& library);
void save_scene(const std::filesystem::path& path, const Document& document, const Library& library);  // Failure 5

// Replaces a file in one step: temporary file beside it, written, synced, re-read, renamed, folder synced. Keeps mode
// and follows symlinks. On any error the old file stays and the temporary is gone. Failure 5.
void save_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace fieldwright::graph
