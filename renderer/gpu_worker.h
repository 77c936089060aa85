// The thread that owns a GL context, compiles and draws with it.
#pragma once

#include "renderer/accumulation.h"
#include "renderer/devices.h"
#include "renderer/quiet_arena.h"

#include <map>
#include <string>

namespace fieldwright::renderer {

// Losses of the GPU that are too many: two within two minutes.
class LossRecord {
public:
    using Clock = std::chrono::steady_clock;
    bool too_many(Clock::time_point lost_at);

private:
    std::optional<Clock::time_point> last_;
};

class GpuWorker {
public:
    // `alone`: no CPU device draws.
    GpuWorker(RenderDesk& desk, bool alone) : desk_(desk), alone_(alone) {}
    void run();  // until the desk is closed or the GPU given up

private:
    void open_device();
    bool must_draw(const Job& job) const { return alone_ || !runs_on_cpu(*job.request->program); }
    bool work(const Job& job);
    void draw(const Job& job);
    bool make_ready(const Job& job, const std::string& text);
    bool expected_to_pay(const Job& job) const;
    double expected_cpu_seconds(const graph::Program& program) const;
    void try_pace(const Job& job);
    bool is_faster(const Job& job) const;
    void draw_passes(const Job& job);
    DrawFrame draw_frame();
    void lose(const Job& job);

    RenderDesk& desk_;
    bool alone_;
    QuietArena arena_;
    std::optional<GpuDevice> device_;
    int past_links_ = 0;  // of devices that were lost
    Pace pace_;
    FramePool frames_;
    Accumulation accumulation_;
    std::map<std::string, std::string> refused_;  // texts, and why
    LossRecord losses_;
};

}  // namespace fieldwright::renderer
