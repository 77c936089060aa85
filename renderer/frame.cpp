// Buffers of a size.
#include "renderer/frame.h"

namespace fieldwright::renderer {

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
