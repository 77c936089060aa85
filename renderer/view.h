// Views: which of a frame's buffers a picture shows, and how they are read.
#pragma once

#include "renderer/frame.h"

#include <span>
#include <string>
#include <string_view>

namespace fieldwright::renderer {

// In the order of views().
enum class View {
    beauty,
    steps,
    glow,
    normal,
    depth,
    id,
    material,
    position,
    albedo,
    ambient,
    diffuse,
    specular,
    reflection,
    emission,
    shadow,
    occlusion,
    shadow_steps,
    cone_ratio,
    gradient,
    slice  // of frames of FrameRequest::slice
};

struct ViewKind {
    const char *name, *title, *help;
    bool light = false;   // what eyes see; the colours of the others are data, which glasses would falsify
    bool layers = false;  // of those that a frame has only when asked for
    bool mean = false;    // of light: the mean of a pixel's samples; the others show the middle one
    const char* scale_title = nullptr;  // of numbers shown by a colour map
    float scale_end = 0;                // the number at the map's end; 0 = of steps
};

std::span<const ViewKind> views();
const ViewKind& kind_of(View view);
std::optional<View> view_from_name(std::string_view name);
const std::vector<std::string>& view_names();  // all but the slice, which is no view of rays

// The rows that a view reads: one of them, or none where the frame lacks the layer.
struct ViewSource {
    const std::vector<glm::vec3>* colours = nullptr;
    const std::vector<float>* numbers = nullptr;
    const std::vector<int>* counts = nullptr;
};
ViewSource source_of(const Frame& frame, View view);

}  // namespace fieldwright::renderer
