// What the commands that draw take in common about what the pixels show: view, colours, stereo.
#pragma once

#include "renderer/picture.h"

#include <CLI/CLI.hpp>

namespace fieldwright::app {

struct DisplayArguments {
    std::string view = "beauty", colour_map = "viridis", stereo = "off", stereo_space = "linear";
    int full_scale = 0;
    float interaxial = 0.065f, convergence = 5.0f;  // m
    float split = 0;
    bool swap_eyes = false, toe_in = false, rivalry = false;
};

void add_display(CLI::App& command, DisplayArguments& arguments);
renderer::Display display_of(const DisplayArguments& arguments);
// The eyes, all but which one it is, and the layers that the view needs.
void set_request(renderer::FrameRequest& request, const DisplayArguments& arguments);

}  // namespace fieldwright::app
