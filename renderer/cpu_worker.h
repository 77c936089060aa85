// The thread that draws pictures on all cores.
#pragma once

#include "renderer/accumulation.h"
#include "renderer/quiet_arena.h"

namespace fieldwright::renderer {

class CpuWorker {
public:
    explicit CpuWorker(RenderDesk& desk) : desk_(desk) {}
    void run();  // until the desk is closed

private:
    bool draw(const Job& job);
    bool draw_passes(const Job& job);
    double expected_seconds_per_pixel(const graph::Program& program) const;
    void fail(const Job& job, const std::string& sentence);

    RenderDesk& desk_;
    QuietArena arena_;
    Pace pace_;
    FramePool frames_;
    Accumulation accumulation_;
    std::string last_failure_;  // said once, until something is drawn
};

}  // namespace fieldwright::renderer
