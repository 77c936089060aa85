// What both devices need to know of a request, and buffers of a size.
#include "renderer/frame.h"

#include <algorithm>

namespace fieldwright::renderer {

float eye_side(Eye eye) { return eye == Eye::left ? -1.0f : (eye == Eye::right ? 1.0f : 0.0f); }

int shadow_count(const graph::Program& program)
{
    auto is_shadowed = [](const graph::LightEntry& light) { return light.shadow; };
    return static_cast<int>(std::count_if(program.lights.begin(), program.lights.end(), is_shadowed));
}

Frame::Frame(int frame_width, int frame_height) : width(frame_width), height(frame_height)
{
    auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    colour.resize(pixels);
    depth.resize(pixels, std::numeric_limits<float>::infinity());
    normal.resize(pixels);
    node_id.resize(pixels);
    material_id.resize(pixels);
    steps.resize(pixels);
    exhausted.resize(pixels);
}

}  // namespace fieldwright::renderer
