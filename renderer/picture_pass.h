// One picture of a request at one resolution, by either device, shown while it grows.
#pragma once

#include "renderer/pace.h"
#include "renderer/render_desk.h"

#include <atomic>
#include <shared_mutex>

namespace fieldwright::renderer {

// Draws over a frame; false when the watch cancelled it.
using DrawFrame = std::function<bool(Frame&, const graph::Program&, const FrameRequest&, const Watch&)>;

struct PassPlan {
    int divisor = 1;
    bool coarse = false;  // is finished although newer requests wait
};

// Coarse within `seconds`, half, full; what is at least as fine as `shown_divisor` is left out. Only the first when
// interacting.
std::vector<PassPlan> passes(const PictureRequest& request, double seconds_per_pixel, double seconds,
                             std::optional<int> shown_divisor);

// What is shown already goes with the new generation, in another view when another is asked for. Its divisor; none when
// the shown frame is another one.
std::optional<int> show_again(RenderDesk& desk, Device device, const Job& job);

// Frames that nobody holds any more are drawn over: fresh memory costs tens of milliseconds at full size.
class FramePool {
public:
    std::shared_ptr<Frame> take(const FrameRequest& request);  // what is in it does not matter

private:
    static constexpr std::size_t capacity = 4;  // coarse, half, full and the one shown
    std::vector<std::shared_ptr<Frame>> frames_;
};

class PicturePass {
public:
    PicturePass(RenderDesk& desk, FramePool& frames, Device device, const Job& job, PassPlan plan);

    // Delivers; the seconds it took, none when it was stopped.
    std::optional<double> draw(const DrawFrame& draw_frame);

private:
    using Clock = std::chrono::steady_clock;

    bool draw_eyes(const DrawFrame& draw_frame);
    void encode(const Area& area);
    void show_growing();
    bool stops() const;
    DrawnPicture finished(double seconds) const;

    RenderDesk& desk_;
    FramePool& frames_;
    Device device_;
    const Job& job_;
    PassPlan plan_;
    FrameRequest request_;
    PictureEncoder encoder_;
    std::shared_ptr<Frame> left_, right_;
    RenderDesk::Shown base_;  // of the same content, under what is missing
    std::shared_mutex picture_mutex_;
    std::shared_ptr<Picture> picture_;  // shared by those who encode parts of it, alone by who copies it
    std::atomic<Clock::time_point> last_shown_;
};

StepStatistics step_statistics(const Frame& frame);
// Bilinear.
Picture resized(const Picture& picture, int width, int height);

}  // namespace fieldwright::renderer
