// What the window and the two drawing threads share: the newest request, who draws it, and the results.
#pragma once

#include "renderer/render_thread.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>

namespace fieldwright::renderer {

// A request with its place in the order of requests.
struct Job {
    std::shared_ptr<const PictureRequest> request;
    std::uint64_t serial = 0;
};

// Same buffers, whatever view of them is shown; both eyes count as one more buffer.
// Whether frames drawn for `a` are what `b` asks for.
bool same_frames(const PictureRequest& a, const PictureRequest& b);
bool same_content(const PictureRequest& a, const PictureRequest& b);

// Every function takes the lock for a moment; only those called `wait_...` may take long.
class RenderDesk {
public:
    RenderDesk(std::function<void()> on_ready, bool with_cpu, bool with_gpu);

    // The window's side.
    void put(PictureRequest request);
    std::optional<RenderResult> take();
    void wait_for_result(std::uint64_t generation, double seconds);
    RenderStatus status() const;
    void close();  // the threads' waits end, and what they draw stops

    // The next job that the device has not done; none once the desk is closed.
    std::optional<Job> wait_for_job(Device device);
    // Until something of the job was shown, or there is something newer.
    void wait_for_first_picture(const Job& job);
    void done(Device device, const Job& job);

    // A coarse picture is finished while newer ones are asked for, or a drag would show none.
    bool stops_coarse(Device device, const Job& job) const;
    bool stops_fine(Device device, const Job& job) const;

    // On software GL the window's own drawing wants all cores: finer pictures pause for it, between tiles and strips.
    void set_window_drawing(bool drawing);
    void wait_for_window() const;

    // The GPU takes a job over from the CPU, and gives it back. Until it has `decided` the CPU waits, unless it is
    // `absent`: compiling.
    bool claim(const Job& job);
    void release(const Job& job);
    void decided(const Job& job);
    void set_absent(bool absent);
    void set_compiling(bool compiling);
    void set_gpu(const std::string& name, bool software);
    void give_up_gpu(const std::string& reason);
    bool has_gpu() const;  // or will have one

    // `complete`: all of its pixels are of the job. Dropped when something newer or finer was shown.
    void deliver(Device device, const Job& job, DrawnPicture picture, bool complete);
    void report(RenderResult result);
    // The last complete picture and whose it is; null request when there is none.
    struct Shown {
        std::shared_ptr<const PictureRequest> request;
        DrawnPicture picture;
    };
    Shown shown() const;

    void note_pace(Device device, double seconds_per_pixel);
    double pace(Device device) const;  // 0: not measured
    void note_links(int links);

private:
    using Clock = std::chrono::steady_clock;

    bool newer_than(const Job& job) const { return closed_ || job.serial != newest_.serial; }
    bool is_lead(Device device, const Job& job) const { return claimed_ == job.serial ? device == Device::gpu : true; }
    bool has_work(Device device) const;
    bool repeats_final() const;
    bool repeats_newest(const PictureRequest& request) const;

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::function<void()> on_ready_;

    // Serials count from 1; 0 is none.
    Job newest_;
    bool newest_is_edit_ = false;                // of another program than the one before
    std::uint64_t cpu_done_ = 0, gpu_done_ = 0;  // serial of the last job that needs nothing more of the device
    std::uint64_t claimed_ = 0;                  // by the GPU
    std::uint64_t decided_ = 0;
    std::uint64_t delivered_ = 0;  // serial of the newest picture
    std::uint64_t final_ = 0;      // serial of the newest final one
    bool with_cpu_, with_gpu_;
    bool gpu_absent_ = true;  // until its context is made
    bool closed_ = false;
    bool window_drawing_ = false;  // and on software GL

    std::optional<DrawnPicture> picture_;  // newest, not polled yet
    std::deque<RenderResult> reports_;
    Shown shown_;
    Clock::time_point last_delivery_{};
    RenderStatus status_;
    double cpu_pace_ = 0, gpu_pace_ = 0;  // s per pixel
};

}  // namespace fieldwright::renderer
