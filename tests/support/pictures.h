// Small pictures of scenes and how far apart two of them are.
#pragma once

#include "renderer/devices.h"
#include "renderer/picture.h"
#include "tests/support/scene.h"

#include <cstdlib>

namespace fieldwright::tests {

constexpr int picture_side = 128;  // px

inline renderer::Frame frame_of(const Scene& scene, bool layers = false)
{
    renderer::FrameRequest request{.width = picture_side, .height = picture_side, .time = 0.6f};
    request.layers = layers;
    return renderer::render_on_cpu(scene.program(), request);
}

inline renderer::Picture picture_of(const Scene& scene, renderer::View view = renderer::View::beauty)
{
    return renderer::picture(frame_of(scene, renderer::kind_of(view).layers), view, scene.document.march.step_limit);
}

// Share of pixels with a channel more than 2/255 apart; 1 when the sizes differ.
inline double share_apart(const renderer::Picture& a, const renderer::Picture& b)
{
    if (a.rgb.size() != b.rgb.size() || a.rgb.empty()) return 1;
    std::size_t apart = 0, pixels = a.rgb.size() / 3;
    for (std::size_t i = 0; i < pixels; ++i) {
        auto differs = [&](std::size_t k) { return std::abs(a.rgb[3 * i + k] - b.rgb[3 * i + k]) > 2; };
        apart += differs(0) || differs(1) || differs(2) ? 1 : 0;
    }
    return static_cast<double>(apart) / static_cast<double>(pixels);
}

}  // namespace fieldwright::tests
