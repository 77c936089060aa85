// Every few pixels of a frame's steps.
#include "app/steps_texture.h"

#include <algorithm>

namespace fieldwright::app {
namespace {

constexpr int largest_width = 400;  // px

renderer::Frame thinned(const renderer::Frame& frame)
{
    int stride = (frame.width + largest_width - 1) / largest_width;
    renderer::Frame small(std::max(frame.width / stride, 1), std::max(frame.height / stride, 1));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            auto from = static_cast<std::size_t>(y * stride) * static_cast<std::size_t>(frame.width) +
                        static_cast<std::size_t>(x * stride);
            auto to = static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) + static_cast<std::size_t>(x);
            small.steps[to] = frame.steps[from];
            small.exhausted[to] = frame.exhausted[from];
        }
    return small;
}

}  // namespace

void StepsTexture::show(const std::shared_ptr<const renderer::Frame>& frame, renderer::Display display, int step_limit)
{
    display = {.view = renderer::View::steps, .colour_map = display.colour_map, .full_scale = display.full_scale};
    if (frame_ == frame && display_ == display) return;
    frame_ = frame;
    display_ = display;
    renderer::Frame small = thinned(*frame);
    picture_.show(std::make_shared<const renderer::Picture>(renderer::picture(small, small, display, step_limit)),
                  nullptr);
}

}  // namespace fieldwright::app
