// What `render` was asked for.
#pragma once

#include "app/display_arguments.h"
#include "app/scene_arguments.h"
#include "renderer/picture_file.h"

namespace fieldwright::app {

struct RenderArguments {
    SceneArguments scene;
    std::filesystem::path output;
    DisplayArguments display;
    std::string size = "960x540", device = "auto";
    std::string tile;    // empty: the whole picture
    int grid = 0;        // n: n x n samples on a grid
    int enlarge = 1;     // n: n x n pixels of the file for one
    std::string frames;  // empty: the one moment of `scene.time`
    // Instead of the scene's own.
    std::optional<int> samples;
    std::optional<float> frames_per_second, exposure, shutter;
    std::string tone_map, backdrop, anti_aliasing;  // empty: the scene's
    bool sheet = false, keep_scene = false, skip_existing = false, keep_going = false, json = false, quiet = false;

    renderer::PictureFormat format() const { return *renderer::picture_format(output); }
    bool has_stereo() const { return display.stereo != "off"; }
};

void add_render_options(CLI::App& command, RenderArguments& arguments);

std::string size_error(const std::string& text);           // empty: it is a size
std::pair<int, int> parsed_size(const std::string& text);  // of a size that was checked

// Failure 2 for options that do not go together.
void require_sense(const RenderArguments& arguments);
// The document's march, picture and animation as the options change them. Failure 2.
void change_settings(graph::Document& document, const RenderArguments& arguments);

}  // namespace fieldwright::app
