// Names and switches of the view state as a display, eyes and a slice.
#include "app/shown_display.h"

#include "ui/slice_frame.h"
#include "ui/viewport_overlay.h"

#include "graph/slice_plane.h"

namespace fieldwright::app {
namespace {

renderer::Slice slice_of(const ui::ViewState& view, const ui::Readings& readings)
{
    ui::SliceFrame frame = ui::slice_frame(view, readings);
    renderer::Slice slice{.centre = frame.centre, .right = frame.right, .up = frame.up, .height = frame.height};
    slice.style = renderer::slice_style_from_name(view.slice.style).value_or(slice.style);
    slice.gamma = view.slice.gamma;
    slice.spacing = graph::line_spacing(frame.height);
    slice.colour_map = renderer::colour_map_from_name(view.colour_map).value_or(slice.colour_map);
    return slice;
}

void set_stereo(renderer::PictureRequest& request, const ui::ViewState& view, const ui::Readings& readings)
{
    if (!ui::has_stereo(readings, view)) return;
    const ui::StereoView& eyes = view.eyes;
    renderer::Display& display = request.display;
    display.stereo = renderer::stereo_from_name(view.stereo).value_or(renderer::Stereo::off);
    display.stereo_space = eyes.linear ? renderer::StereoSpace::linear : renderer::StereoSpace::gamma;
    display.swap_eyes = eyes.swap;
    display.rivalry = eyes.rivalry;
    display.split = eyes.split ? eyes.divider : 0;
    request.frame.interaxial = view.interaxial;
    request.frame.convergence = view.convergence;
    request.frame.toe_in = eyes.toe_in;
}

}  // namespace

void set_display(renderer::PictureRequest& request, const ui::ViewState& view, const ui::Readings& readings,
                 glm::ivec2 size_px)
{
    renderer::Display& display = request.display;
    display.view = renderer::view_from_name(view.view).value_or(renderer::View::beauty);
    display.colour_map = renderer::colour_map_from_name(view.colour_map).value_or(display.colour_map);
    display.full_scale = view.full_scale;
    if (view.view == "slice") request.frame.slice = slice_of(view, readings);
    request.frame.layers = renderer::kind_of(display.view).layers;
    request.frame.counts = view.panel == ui::Panel::cost;
    set_stereo(request, view, readings);
    const ui::StereoChoice* mode = ui::find_choice(readings.stereo_modes, view.stereo);
    bool apart = mode && display.stereo != renderer::Stereo::off;
    request.frame.width = size_px.x / (apart ? mode->across : 1);
    request.frame.height = size_px.y / (apart ? mode->down : 1);
}

}  // namespace fieldwright::app
