// Starts the drawing threads and ends them.
#include "renderer/render_thread.h"

#include "renderer/cpu_worker.h"
#include "renderer/gpu_worker.h"

#include <thread>

namespace fieldwright::renderer {

struct RenderThread::State {
    explicit State(RenderOptions options)
        : desk(std::move(options.on_ready), options.device != Device::gpu, options.device != Device::cpu)
    {
        if (options.device != Device::gpu) cpu = std::thread([this] { CpuWorker(desk).run(); });
        bool alone = options.device == Device::gpu;
        if (options.device != Device::cpu) gpu = std::thread([this, alone] { GpuWorker(desk, alone).run(); });
    }
    ~State()
    {
        desk.close();
        if (cpu.joinable()) cpu.join();
        if (gpu.joinable()) gpu.join();
    }

    RenderDesk desk;
    std::thread cpu, gpu;
};

RenderThread::RenderThread(RenderOptions options) : state_(std::make_unique<State>(std::move(options))) {}
RenderThread::~RenderThread() = default;

void RenderThread::request(PictureRequest request) { state_->desk.put(std::move(request)); }
std::optional<RenderResult> RenderThread::poll() { return state_->desk.take(); }
void RenderThread::wait(std::uint64_t generation, double seconds) { state_->desk.wait_for_result(generation, seconds); }
void RenderThread::set_window_drawing(bool drawing) { state_->desk.set_window_drawing(drawing); }
RenderStatus RenderThread::status() const { return state_->desk.status(); }

}  // namespace fieldwright::renderer
