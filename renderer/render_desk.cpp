// Who draws which request, and which results are worth showing.
#include "renderer/render_desk.h"

#include <algorithm>

namespace fieldwright::renderer {
namespace {

constexpr std::size_t report_limit = 16;                        // a window that does not poll gets the newest
constexpr auto patience = std::chrono::milliseconds(100);       // pictures come at least this often
constexpr auto longest_pause = std::chrono::milliseconds(100);  // for the window, which may itself be waiting

FrameRequest without_eye(FrameRequest frame)
{
    frame.eye = Eye::centre;
    return frame;
}

}  // namespace

bool same_frames(const PictureRequest& a, const PictureRequest& b)
{
    Exposure samples_of_b = b.exposure;
    samples_of_b.samples = a.exposure.samples;
    if (a.program != b.program || a.exposure != samples_of_b || is_stereo(a) != is_stereo(b)) return false;
    FrameRequest wanted = b.frame;
    wanted.counts = wanted.counts || a.frame.counts;  // what was counted in vain is no harm
    return is_stereo(a) ? without_eye(a.frame) == without_eye(wanted) : a.frame == wanted;
}

bool same_content(const PictureRequest& a, const PictureRequest& b)
{
    return same_frames(a, b) && a.display == b.display;
}

int wanted_samples(const PictureRequest& request)
{
    return kind_of(request.display.view).mean && !request.interacting ? sample_count(request.exposure) : 1;
}

RenderDesk::RenderDesk(std::function<void()> on_ready, bool with_cpu, bool with_gpu)
    : on_ready_(std::move(on_ready)), with_cpu_(with_cpu), with_gpu_(with_gpu)
{
}

// A picture that is there already needs only the new generation.
bool RenderDesk::repeats_final() const
{
    return shown_.request && shown_.picture.final && same_content(*shown_.request, *newest_.request) &&
           shown_.picture.samples >= wanted_samples(*newest_.request);
}

// Who asks for the same thing at every frame does not start it anew.
bool RenderDesk::repeats_newest(const PictureRequest& request) const
{
    return newest_.request && newest_.request->interacting == request.interacting &&
           same_content(*newest_.request, request) && newest_.request->exposure == request.exposure;
}

void RenderDesk::put(PictureRequest request)
{
    bool ready = false;
    {
        std::lock_guard lock(mutex_);
        newest_is_edit_ = newest_.request && newest_.request->program != request.program;
        std::uint64_t serial = newest_.serial + (repeats_newest(request) ? 0 : 1);
        newest_ = {std::make_shared<const PictureRequest>(std::move(request)), serial};
        if (repeats_final()) {
            shown_.picture.generation = newest_.request->generation;
            picture_ = shown_.picture;
            delivered_ = final_ = cpu_done_ = gpu_done_ = newest_.serial;
            ready = true;
        }
    }
    changed_.notify_all();
    if (ready && on_ready_) on_ready_();
}

std::optional<RenderResult> RenderDesk::take()
{
    std::lock_guard lock(mutex_);
    if (!reports_.empty()) {
        RenderResult report = std::move(reports_.front());
        reports_.pop_front();
        return report;
    }
    if (!picture_) return std::nullopt;
    RenderResult result = std::move(*picture_);
    picture_.reset();
    return result;
}

void RenderDesk::wait_for_result(std::uint64_t generation, double seconds)
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                      [&] { return !reports_.empty() || (picture_ && picture_->generation >= generation); });
}

RenderStatus RenderDesk::status() const
{
    std::lock_guard lock(mutex_);
    RenderStatus status = status_;
    bool cpu_busy = with_cpu_ && cpu_done_ != newest_.serial && is_lead(Device::cpu, newest_);
    status.busy = cpu_busy || (with_gpu_ && gpu_done_ != newest_.serial);
    status.cpu_ns_per_pixel = 1e9 * cpu_pace_;
    status.gpu_ns_per_pixel = 1e9 * gpu_pace_;
    return status;
}

void RenderDesk::close()
{
    {
        std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

bool RenderDesk::has_work(Device device) const
{
    if (device == Device::gpu) return gpu_done_ != newest_.serial;
    // An edit's text is hardly ever linked on software GL, and its thread is the last to be run.
    bool cpu_starts = status_.gpu_is_software && newest_is_edit_;
    bool gpu_decides = with_gpu_ && !gpu_absent_ && !cpu_starts && decided_ != newest_.serial;
    return cpu_done_ != newest_.serial && is_lead(device, newest_) && !gpu_decides;
}

std::optional<Job> RenderDesk::wait_for_job(Device device)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || has_work(device); });
    if (closed_) return std::nullopt;
    return newest_;
}

void RenderDesk::wait_for_first_picture(const Job& job)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return newer_than(job) || delivered_ >= job.serial || cpu_done_ >= job.serial; });
}

void RenderDesk::done(Device device, const Job& job)
{
    {
        std::lock_guard lock(mutex_);
        (device == Device::gpu ? gpu_done_ : cpu_done_) = job.serial;
        if (device == Device::gpu) decided_ = std::max(decided_, job.serial);
    }
    changed_.notify_all();
}

bool RenderDesk::stops_coarse(Device device, const Job& job) const
{
    std::lock_guard lock(mutex_);
    if (closed_ || !is_lead(device, job)) return true;
    return newer_than(job) && !newest_.request->interacting && Clock::now() - last_delivery_ < patience;
}

bool RenderDesk::stops_fine(Device device, const Job& job) const
{
    std::lock_guard lock(mutex_);
    return newer_than(job) || !is_lead(device, job);
}

void RenderDesk::set_window_drawing(bool drawing)
{
    {
        std::lock_guard lock(mutex_);
        window_drawing_ = drawing && status_.gpu_is_software;
    }
    if (!drawing) changed_.notify_all();
}

void RenderDesk::wait_for_window() const
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest_pause, [&] { return !window_drawing_ || closed_; });
}

bool RenderDesk::claim(const Job& job)
{
    {
        std::lock_guard lock(mutex_);
        decided_ = std::max(decided_, job.serial);
        if (!newer_than(job)) claimed_ = job.serial;
    }
    changed_.notify_all();
    return !stops_fine(Device::gpu, job);
}

void RenderDesk::release(const Job& job)
{
    {
        std::lock_guard lock(mutex_);
        if (claimed_ == job.serial) claimed_ = 0;
        if (cpu_done_ == job.serial) cpu_done_ = 0;
        decided_ = std::max(decided_, job.serial);
    }
    changed_.notify_all();
}

void RenderDesk::decided(const Job& job)
{
    {
        std::lock_guard lock(mutex_);
        decided_ = std::max(decided_, job.serial);
    }
    changed_.notify_all();
}

void RenderDesk::set_absent(bool absent)
{
    {
        std::lock_guard lock(mutex_);
        gpu_absent_ = absent;
    }
    changed_.notify_all();
}

void RenderDesk::set_compiling(bool compiling)
{
    {
        std::lock_guard lock(mutex_);
        gpu_absent_ = status_.compiling = compiling;
    }
    changed_.notify_all();
}

void RenderDesk::set_gpu(const std::string& name, bool software)
{
    {
        std::lock_guard lock(mutex_);
        gpu_absent_ = false;
        status_.gpu = name;
        status_.gpu_is_software = software;
    }
    changed_.notify_all();
}

// The CPU looks at the newest request once more: it may have left it to the GPU.
void RenderDesk::give_up_gpu(const std::string& reason)
{
    {
        std::lock_guard lock(mutex_);
        with_gpu_ = false;
        claimed_ = 0;
        if (final_ != newest_.serial) cpu_done_ = 0;
        status_.no_gpu = reason;
        status_.gpu.clear();
        status_.compiling = false;
    }
    changed_.notify_all();
}

bool RenderDesk::has_gpu() const
{
    std::lock_guard lock(mutex_);
    return with_gpu_;
}

void RenderDesk::deliver(Device device, const Job& job, DrawnPicture picture, bool complete)
{
    {
        std::lock_guard lock(mutex_);
        picture.generation = (job.serial == newest_.serial ? newest_ : job).request->generation;
        bool late = job.serial < delivered_ || job.serial < final_ || (job.serial == final_ && !picture.final);
        if (closed_ || late || !is_lead(device, job)) return;
        delivered_ = job.serial;
        if (picture.final) final_ = job.serial;
        last_delivery_ = Clock::now();
        if (complete) shown_ = {job.request, picture};
        picture_ = std::move(picture);
    }
    changed_.notify_all();
    if (on_ready_) on_ready_();
}

void RenderDesk::report(RenderResult result)
{
    {
        std::lock_guard lock(mutex_);
        if (reports_.size() == report_limit) reports_.pop_front();
        reports_.push_back(std::move(result));
    }
    changed_.notify_all();
    if (on_ready_) on_ready_();
}

RenderDesk::Shown RenderDesk::shown() const
{
    std::lock_guard lock(mutex_);
    return shown_;
}

void RenderDesk::note_pace(Device device, double seconds_per_pixel)
{
    std::lock_guard lock(mutex_);
    (device == Device::gpu ? gpu_pace_ : cpu_pace_) = seconds_per_pixel;
}

double RenderDesk::pace(Device device) const
{
    std::lock_guard lock(mutex_);
    return device == Device::gpu ? gpu_pace_ : cpu_pace_;
}

void RenderDesk::note_links(int links)
{
    std::lock_guard lock(mutex_);
    status_.links = links;
}

}  // namespace fieldwright::renderer
