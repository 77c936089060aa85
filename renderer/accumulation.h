// Further samples of a finished picture, while nothing else is asked for.
#pragma once

#include "renderer/picture_pass.h"

namespace fieldwright::renderer {

class Accumulation {
public:
    // Adds samples until there are as many as the job wants, and delivers their mean now and then. What was added before
    // for the same frames counts. False when it was stopped.
    bool go_on(RenderDesk& desk, FramePool& frames, Device device, const Job& job, const DrawFrame& draw_frame);

private:
    using Clock = std::chrono::steady_clock;

    // The sums of one eye, and the frame of its first sample, whose other buffers stay.
    struct View {
        Accumulator sums;
        std::shared_ptr<const Frame> first;
    };

    void start(const Job& job, const RenderDesk::Shown& shown);
    bool add_sample(RenderDesk& desk, FramePool& frames, Device device, const Job& job, const DrawFrame& draw_frame);
    void add(View& eye, const std::shared_ptr<const Frame>& sample);
    std::shared_ptr<const Frame> mean(const View& eye, FramePool& frames) const;
    void deliver(RenderDesk& desk, FramePool& frames, Device device, const Job& job) const;

    std::shared_ptr<const PictureRequest> request_;  // whose samples these are
    View left_, right_;                              // right_: of stereo
};

}  // namespace fieldwright::renderer
