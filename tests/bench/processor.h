// The processor's time, and a thread that takes it: compiling a scene at the lowest priority without end.
#pragma once

#include "renderer/devices.h"
#include "renderer/low_priority.h"

#include <sys/resource.h>
#include <atomic>
#include <memory>
#include <thread>

namespace fieldwright::bench {

// Of this process so far.
inline double processor_seconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// A second thread compiles the scene without end, as the window's own does after an edit.
class Compiling {
public:
    explicit Compiling(std::shared_ptr<const graph::Program> program) : thread_([this, program] { compile(*program); })
    {
    }
    ~Compiling()
    {
        stopped_ = true;
        thread_.join();
    }
    int compiled() const { return compiled_; }

private:
    void compile(const graph::Program& program)
    {
        renderer::lower_priority("compiling", renderer::Priority::compile);
        renderer::GpuDevice gpu;
        std::string text = gpu.shader_text(program, {});
        while (!stopped_) {
            gpu.ready_seconds(text);
            ++compiled_;
        }
    }

    std::atomic<bool> stopped_ = false;
    std::atomic<int> compiled_ = 0;
    std::thread thread_;
};

}  // namespace fieldwright::bench
