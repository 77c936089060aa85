// The one list of views, and where their pixels come from.
#include "renderer/view.h"

#include <algorithm>
#include <iterator>

namespace fieldwright::renderer {
namespace {

constexpr ViewKind kinds[] = {
    {.name = "beauty", .title = "Beauty", .help = "Surfaces in their light.", .light = true, .mean = true},
    {.name = "steps",
     .title = "Steps heatmap",
     .help = "How many steps the ray of each pixel took; magenta where it ran out of them.",
     .scale_title = "Steps per ray"},
    {.name = "glow",
     .title = "Beauty with glow",
     .help = "The picture, and over it a magenta light that grows with the steps of each ray.",
     .light = true,
     .mean = true},
    {.name = "normal", .title = "Normals", .help = "Which way surfaces face, as colours."},
    {.name = "depth", .title = "Depth", .help = "How far surfaces are, near ones bright."},
    {.name = "id", .title = "Node colours", .help = "Each node's surface in a colour of its own."},
    {.name = "material", .title = "Material colours", .help = "Each material in a colour of its own."},
    {.name = "position",
     .title = "Position",
     .help = "Where surfaces are: x, y and z as red, green and blue, anew in every metre.",
     .layers = true},
    {.name = "albedo", .title = "Albedo", .help = "The colour of surfaces without light.", .layers = true},
    {.name = "ambient",
     .title = "Ambient light",
     .help = "What the sky gives to the picture.",
     .layers = true,
     .mean = true},
    {.name = "diffuse",
     .title = "Diffuse light",
     .help = "What surfaces scatter of the lights.",
     .layers = true,
     .mean = true},
    {.name = "specular",
     .title = "Specular light",
     .help = "What surfaces mirror of the lights.",
     .layers = true,
     .mean = true},
    {.name = "reflection",
     .title = "Reflections",
     .help = "What further rays bring, mirrored or through glass.",
     .layers = true,
     .mean = true},
    {.name = "emission",
     .title = "Emission",
     .help = "What shines by itself: surfaces, fog, and the sky where nothing is.",
     .layers = true,
     .mean = true},
    {.name = "shadow",
     .title = "Shadow",
     .help = "How much of the lights each place sees; white is all.",
     .layers = true},
    {.name = "occlusion",
     .title = "Occlusion",
     .help = "How open each place is to the sky; white is all open.",
     .layers = true},
    {.name = "shadow_steps",
     .title = "Shadow steps heatmap",
     .help = "How many steps the shadow rays of each pixel took.",
     .layers = true,
     .scale_title = "Shadow steps"},
    {.name = "cone_ratio",
     .title = "Cone ratio heatmap",
     .help = "How near each ray passed to a surface: the least distance by the way to it.",
     .layers = true,
     .scale_title = "Least distance / way",
     .scale_end = 0.1f},
    {.name = "gradient",
     .title = "Gradient heatmap",
     .help = "Length of the field's gradient at the surface: 1 where it is a true distance.",
     .layers = true,
     .scale_title = "Gradient length",
     .scale_end = 2},
    {.name = "slice",
     .title = "Distance slice",
     .help = "The field on a plane: how far each of its points is from the surface."},
};

}  // namespace

std::span<const ViewKind> views() { return kinds; }

const ViewKind& kind_of(View view) { return kinds[static_cast<std::size_t>(view)]; }

const std::vector<std::string>& view_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const ViewKind& kind : kinds) list.emplace_back(kind.name);
        list.pop_back();
        return list;
    }();
    return names;
}

std::optional<View> view_from_name(std::string_view name)
{
    auto found = std::find_if(std::begin(kinds), std::end(kinds), [&](const ViewKind& k) { return k.name == name; });
    if (found == std::end(kinds)) return std::nullopt;
    return static_cast<View>(found - std::begin(kinds));
}

ViewSource source_of(const Frame& frame, View view)
{
    if (kind_of(view).layers && !frame.layers) return {};
    switch (view) {
        case View::beauty:
        case View::glow:
        case View::slice: return {.colours = &frame.colour};
        case View::steps: return {.counts = &frame.steps};
        case View::normal: return {.colours = &frame.normal};
        case View::depth: return {.numbers = &frame.depth};
        case View::id: return {.counts = &frame.node_id};
        case View::material: return {.counts = &frame.material_id};
        case View::position: return {.colours = &frame.layers->position};
        case View::albedo: return {.colours = &frame.layers->albedo};
        case View::ambient: return {.colours = &frame.layers->ambient};
        case View::diffuse: return {.colours = &frame.layers->diffuse};
        case View::specular: return {.colours = &frame.layers->specular};
        case View::reflection: return {.colours = &frame.layers->reflection};
        case View::emission: return {.colours = &frame.layers->emission};
        case View::shadow: return {.numbers = &frame.layers->shadow};
        case View::occlusion: return {.numbers = &frame.layers->occlusion};
        case View::shadow_steps: return {.counts = &frame.layers->shadow_steps};
        case View::cone_ratio: return {.numbers = &frame.layers->minimum_cone_ratio};
        case View::gradient: return {.numbers = &frame.layers->gradient_length};
    }
    return {};
}

}  // namespace fieldwright::renderer
