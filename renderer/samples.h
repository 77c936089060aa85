// A pixel's samples: where they lie in the pixel, on the lens and in time, and their mean.
#pragma once

#include "renderer/frame.h"

namespace fieldwright::renderer {

// How the samples of a picture are taken.
struct Exposure {
    int samples = 1;    // of a pixel
    int grid = 0;       // n: n x n samples on a regular grid instead
    float shutter = 0;  // s, around the request's time
    graph::Backdrop backdrop = graph::Backdrop::sky;
    glm::vec3 backdrop_colour{0};
    bool checkered = false;  // on a screen: what is transparent shows a checkerboard
    bool operator==(const Exposure&) const = default;
};

Exposure exposure_of(const graph::PictureSettings& settings);
int sample_count(const Exposure& exposure);
bool shows_sky(const Exposure& exposure);  // no backdrop is laid: FrameRequest::sky

// The request for a sample, from 0. Without a grid sample 0 is the picture's own: the middle of pixel, lens and exposure.
// On the way to the device each pixel turns the lens by an angle of its own (shaders/render/lens.glsl).
// Further ones follow the additive recurrences R2 (pixel) and R3 (lens, time) of M. Roberts, "The unreasonable
// effectiveness of quasirandom sequences" (2018), so that any number of them lies evenly.
FrameRequest sample_of(const FrameRequest& picture, const Exposure& exposure, int sample);

// Draws a request into a frame of its size; false when it was stopped.
using DrawRequest = std::function<bool(Frame& frame, const FrameRequest& request)>;
// A sample into a frame of the picture's size. With a shutter each pixel of a square of four sees its own moments: but for
// sample 0, four lattices are drawn, and woven.
bool draw_sample(Frame& frame, const FrameRequest& picture, const Exposure& exposure, int sample,
                 const DrawRequest& draw);

// What shows where a drawn sample met nothing, unless that is the sky. `area`: of the frame, which is `part` of a picture.
void lay_backdrop(Frame& frame, const Area& area, const Exposure& exposure, const Area& part);

// Sums of colours in linear light and of the layers they are made of, and of hits. One sum per pixel, in the order of the samples: the bytes are the same
// however many threads add.
class Accumulator {
public:
    void clear() { count_ = 0; }
    // A sample with its backdrop laid; of one size until it is cleared.
    void add(const Frame& sample, const Exposure& exposure);
    int count() const { return count_; }
    // Makes the light in a frame of that size and those layers the mean, and its alpha the share of hits where that is wanted.
    void resolve(Frame& frame, const Exposure& exposure) const;

private:
    std::vector<std::vector<glm::vec3>> sums_;  // by light_buffers, by pixel
    std::vector<float> hits_;
    int count_ = 0;
};

}  // namespace fieldwright::renderer
