// Options of views and stereo.
#include "app/display_arguments.h"

namespace fieldwright::app {
namespace {

void add_stereo(CLI::App& command, DisplayArguments& arguments)
{
    command.add_option("--stereo", arguments.stereo, "How the pictures of two eyes become one")
        ->check(CLI::IsMember(renderer::stereo_names()))
        ->capture_default_str();
    command.add_option("--stereo-space", arguments.stereo_space, "Anaglyphs mix light, or gamma-coded values")
        ->check(CLI::IsMember(renderer::stereo_space_names()))
        ->capture_default_str();
    command.add_option("--interaxial", arguments.interaxial, "Distance between the eyes in metres")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command.add_option("--convergence", arguments.convergence, "Distance in metres that appears on the screen")
        ->check(CLI::Range(0.01, 1000.0))
        ->capture_default_str();
    command.add_flag("--swap-eyes", arguments.swap_eyes, "The right eye's picture for the left eye, and back");
    command.add_flag("--toe-in", arguments.toe_in, "Turns the eyes towards each other, which bends the picture");
    command
        .add_option("--split", arguments.split,
                    "Share of the picture, from the left, that shows the plain anaglyph beside that of --stereo: 0.5")
        ->check(CLI::Range(0.0, 1.0));
    command.add_flag("--rivalry", arguments.rivalry, "Stripes where the eyes fight over an anaglyph's colours");
}

}  // namespace

void add_display(CLI::App& command, DisplayArguments& arguments)
{
    command.add_option("--view", arguments.view, "What the pixels show")
        ->check(CLI::IsMember(renderer::view_names()))
        ->capture_default_str();
    command.add_option("--colour-map", arguments.colour_map, "Colours of heatmaps")
        ->check(CLI::IsMember(renderer::colour_map_names()))
        ->capture_default_str();
    command.add_option("--full-scale", arguments.full_scale, "Steps at the colour map's end; 0 is the step limit")
        ->check(CLI::Range(0, 60000))
        ->capture_default_str();
    add_stereo(command, arguments);
}

renderer::Display display_of(const DisplayArguments& arguments)
{
    renderer::Display display;
    display.view = *renderer::view_from_name(arguments.view);
    display.stereo = *renderer::stereo_from_name(arguments.stereo);
    display.stereo_space = *renderer::stereo_space_from_name(arguments.stereo_space);
    display.swap_eyes = arguments.swap_eyes;
    display.split = arguments.split;
    display.rivalry = arguments.rivalry;
    display.colour_map = *renderer::colour_map_from_name(arguments.colour_map);
    display.full_scale = arguments.full_scale;
    return display;
}

void set_request(renderer::FrameRequest& request, const DisplayArguments& arguments)
{
    request.interaxial = arguments.interaxial;
    request.convergence = arguments.convergence;
    request.toe_in = arguments.toe_in;
    request.layers = renderer::kind_of(*renderer::view_from_name(arguments.view)).layers;
}

}  // namespace fieldwright::app
