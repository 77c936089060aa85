// The examples that the window offers: what they are called, what they show, and their pictures as textures.
#pragma once

#include "app/example_files.h"
#include "graph/document.h"
#include "graph/library.h"
#include "renderer/gl_handles.h"

#include <imgui.h>

#include <string>
#include <vector>

namespace fieldwright::app {

struct Example {
    ExampleFile file;
    std::string title, sentence;
};
std::vector<Example> examples();  // the best to begin with first

graph::Document example_scene(const ExampleFile& file, const graph::Library& library);  // graph::Failure

// Needs a GL context, which must be current again when it dies.
class ExamplePictures {
public:
    ImTextureID texture(const ExampleFile& file);  // of the file's picture; null when it cannot be decoded

private:
    std::vector<renderer::Texture> textures_;
};

}  // namespace fieldwright::app
