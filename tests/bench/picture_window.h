// The window's side of a render thread: asks for pictures and waits for them.
#pragma once

#include "renderer/render_thread.h"
#include "tests/bench/timing.h"

#include <condition_variable>
#include <mutex>

namespace fieldwright::bench {

// The window's side of a render thread, woken when there is something to poll.
class PictureWindow {
public:
    PictureWindow(renderer::Device device, int width, int height)
        : width_(width), height_(height), thread_({.device = device, .on_ready = [this] { wake(); }})
    {
    }

    void ask(std::shared_ptr<const graph::Program> program, bool interacting,
             std::optional<renderer::ViewCamera> camera = std::nullopt)
    {
        renderer::PictureRequest request{
            .program = std::move(program), .interacting = interacting, .generation = ++generation_};
        request.frame.width = width_;
        request.frame.height = height_;
        request.frame.camera = camera;
        thread_.request(std::move(request));
    }

    // The newest picture that comes within the time.
    std::optional<renderer::DrawnPicture> picture(double seconds)
    {
        auto until = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                            std::chrono::duration<double>(seconds));
        for (;;) {
            while (std::optional<renderer::RenderResult> result = thread_.poll()) {
                if (auto* drawn = std::get_if<renderer::DrawnPicture>(&*result)) return std::move(*drawn);
                demand(false, "the render thread reports no failure");
            }
            std::unique_lock lock(mutex_);
            if (!changed_.wait_until(lock, until, [&] { return ready_; })) return std::nullopt;
            ready_ = false;
        }
    }

    renderer::DrawnPicture picture_of(std::uint64_t generation, bool final)
    {
        for (;;) {
            std::optional<renderer::DrawnPicture> drawn = picture(120);
            demand(drawn.has_value(), "a picture comes within two minutes");
            if (drawn->generation == generation && (drawn->final || !final)) return std::move(*drawn);
        }
    }

    std::uint64_t generation() const { return generation_; }
    renderer::RenderStatus status() const { return thread_.status(); }

private:
    void wake()
    {
        std::lock_guard lock(mutex_);
        ready_ = true;
        changed_.notify_one();
    }

    int width_, height_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool ready_ = false;
    std::uint64_t generation_ = 0;
    renderer::RenderThread thread_;
};

}  // namespace fieldwright::bench
