// Draws samples, sums them and shows the mean.
#include "renderer/accumulation.h"

namespace fieldwright::renderer {
namespace {

constexpr auto show_interval = std::chrono::milliseconds(300);

}  // namespace

bool Accumulation::go_on(RenderDesk& desk, FramePool& frames, Device device, const Job& job,
                         const DrawFrame& draw_frame)
{
    int wanted = wanted_samples(*job.request);
    RenderDesk::Shown shown = desk.shown();
    bool is_shown = shown.request && shown.picture.final && same_content(*shown.request, *job.request);
    if (wanted <= 1 || (is_shown && shown.picture.samples >= wanted)) return true;
    if (!request_ || !same_frames(*request_, *job.request)) start(job, shown);
    request_ = job.request;
    auto shown_at = Clock::now();
    while (left_.sums.count() < wanted) {
        if (!add_sample(desk, frames, device, job, draw_frame)) return false;
        if (left_.sums.count() >= wanted || Clock::now() - shown_at < show_interval) continue;
        shown_at = Clock::now();
        deliver(desk, frames, device, job);
    }
    deliver(desk, frames, device, job);
    return true;
}

// The first sample is in the picture that is shown, unless another device's mean is.
void Accumulation::start(const Job& job, const RenderDesk::Shown& shown)
{
    request_ = job.request;
    left_.sums.clear();
    right_.sums.clear();
    bool is_first =
        shown.request && same_frames(*shown.request, *job.request) && shown.picture.final && shown.picture.samples == 1;
    if (!is_first) return;
    add(left_, shown.picture.frame);
    if (shown.picture.right_frame) add(right_, shown.picture.right_frame);
}

void Accumulation::add(View& eye, const std::shared_ptr<const Frame>& sample)
{
    if (eye.sums.count() == 0) eye.first = sample;
    eye.sums.add(*sample, request_->exposure);
}

// Both eyes or none.
bool Accumulation::add_sample(RenderDesk& desk, FramePool& frames, Device device, const Job& job,
                              const DrawFrame& draw_frame)
{
    FrameRequest request = job.request->frame;
    const Exposure& exposure = job.request->exposure;
    const Watch watch{.cancelled = [&] {
        desk.wait_for_window();
        return desk.stops_fine(device, job);
    }};
    bool stereo = is_stereo(*job.request);
    auto draw = [&](Eye eye) -> std::shared_ptr<const Frame> {
        if (stereo) request.eye = eye;
        std::shared_ptr<Frame> frame = frames.take(request);
        frame->alpha.clear();
        auto draw_request = [&](Frame& to, const FrameRequest& sample) {
            return draw_frame(to, *job.request->program, sample, watch);
        };
        if (!draw_sample(*frame, request, exposure, left_.sums.count(), draw_request)) return nullptr;
        lay_backdrop(*frame, drawn_area(request), exposure, drawn_area(request));
        return frame;
    };
    std::shared_ptr<const Frame> left = draw(Eye::left), right = stereo && left ? draw(Eye::right) : nullptr;
    if (!left || (stereo && !right)) return false;
    add(left_, left);
    if (stereo) add(right_, right);
    return true;
}

std::shared_ptr<const Frame> Accumulation::mean(const View& eye, FramePool& frames) const
{
    std::shared_ptr<Frame> frame = frames.take(request_->frame);
    *frame = *eye.first;
    eye.sums.resolve(*frame, request_->exposure);
    return frame;
}

void Accumulation::deliver(RenderDesk& desk, FramePool& frames, Device device, const Job& job) const
{
    bool stereo = is_stereo(*job.request);
    DrawnPicture drawn = desk.shown().picture;  // how long the first sample took, and its steps
    drawn.frame = mean(left_, frames);
    drawn.right_frame = stereo ? mean(right_, frames) : nullptr;
    drawn.picture =
        std::make_shared<const Picture>(picture(*drawn.frame, stereo ? *drawn.right_frame : *drawn.frame,
                                                job.request->display, job.request->program->march.step_limit));
    drawn.device = device;
    drawn.divisor = 1;
    drawn.final = true;
    drawn.samples = left_.sums.count();
    desk.deliver(device, job, std::move(drawn), true);
}

}  // namespace fieldwright::renderer
