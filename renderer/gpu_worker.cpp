// Pictures on the GPU: when its shader pays, and when it is faster than the CPU.
#include "renderer/gpu_worker.h"

#include "codegen/shader_lines.h"

namespace fieldwright::renderer {
namespace {

constexpr double coarse_seconds = 0.05;
constexpr double clearly_faster = 0.85;    // of the CPU's time, or nothing changes hands
constexpr double as_likely_as_not = 1.1;   // of it, as guessed: scenes lie a factor of two to either side
constexpr double worth_compiling = 0.25;   // s of the CPU's for a full picture, on software GL
constexpr std::size_t refused_limit = 64;  // texts
constexpr int trial_divisor = 8;

}  // namespace

bool LossRecord::too_many(Clock::time_point lost_at)
{
    bool again = last_ && lost_at - *last_ < std::chrono::minutes(2);
    last_ = lost_at;
    return again;
}

void GpuWorker::run()
{
    lower_priority("render gpu", Priority::compile);  // before the driver makes its threads
    try {
        open_device();
        while (std::optional<Job> job = desk_.wait_for_job(Device::gpu)) {
            bool worked = arena_.execute([&] { return work(*job); });
            if (worked) desk_.done(Device::gpu, *job);
            else open_device();
        }
    } catch (const std::exception& failure) {
        desk_.give_up_gpu(failure.what());
        if (alone_) desk_.report(Failed{failure.what(), 0});
    }
    device_.reset();
}

void GpuWorker::open_device()
{
    device_.emplace();
    desk_.set_gpu(device_->renderer_name(), device_->software());
}

// False when the device was lost.
bool GpuWorker::work(const Job& job)
{
    try {
        draw(job);
    } catch (const ContextLost&) {
        lose(job);
        return false;
    } catch (const std::exception& failure) {
        desk_.set_compiling(false);
        desk_.release(job);
        if (must_draw(job)) desk_.report(Failed{failure.what(), job.request->generation});
    }
    return true;
}

// Throws when there were too many.
void GpuWorker::lose(const Job& job)
{
    desk_.set_compiling(false);
    desk_.set_absent(true);
    desk_.release(job);
    bool gives_up = losses_.too_many(LossRecord::Clock::now());
    past_links_ += device_->links();
    device_.reset();
    desk_.report(Lost{gives_up});
    if (gives_up) throw graph::Failure(1, "the GPU was lost twice in two minutes; the CPU draws from now on");
}

void GpuWorker::draw(const Job& job)
{
    const PictureRequest& request = *job.request;
    if (request.frame.slice && !must_draw(job))
        return desk_.decided(job);  // one distance a pixel: nothing to compile for
    std::string text = device_->shader_text(*request.program, request.frame);
    bool ready = !refused_.contains(text) && make_ready(job, text);
    if (auto refused = refused_.find(text); refused != refused_.end())
        desk_.report(CompileFailed{refused->second, request.generation});
    if (!ready) return desk_.decided(job);
    if (!must_draw(job)) {
        if (!pace_.known_near(*request.program)) try_pace(job);
        if (!is_faster(job)) return desk_.decided(job);
    }
    if (desk_.claim(job)) draw_passes(job);
}

// Whether the shader is linked; links it when that is worth the while.
bool GpuWorker::make_ready(const Job& job, const std::string& text)
{
    if (device_->linked(text)) return true;
    if (!must_draw(job)) {
        desk_.decided(job);
        if (device_->software() && !job.request->interacting) desk_.wait_for_first_picture(job);
        if (!expected_to_pay(job)) return false;
    }
    if (desk_.stops_fine(Device::gpu, job)) return false;
    desk_.set_compiling(true);
    try {
        device_->link(text, job.request->frame.layers);
    } catch (const graph::Failure& failure) {
        if (failure.exit_code != 6) throw;
        if (refused_.size() == refused_limit) refused_.clear();
        refused_[text] = codegen::with_place(failure.what(), *job.request->program->library, text);
    }
    desk_.note_links(past_links_ + device_->links());
    pace_ = {};
    desk_.set_compiling(false);
    return device_->linked(text);
}

// On software GL every changed value is a text of its own: only what rests is compiled.
bool GpuWorker::expected_to_pay(const Job& job) const
{
    if (!device_->software()) return true;
    if (job.request->interacting) return false;
    const graph::Program& program = *job.request->program;
    double cpu = expected_cpu_seconds(program);
    bool is_slow = cpu * static_cast<double>(pixel_count(job.request->frame)) > worth_compiling;
    if (!pace_.known_near(program)) return is_slow && guessed_software_gl_ratio(program) < as_likely_as_not;
    return is_slow && pace_.seconds_per_pixel(program) < clearly_faster * cpu;
}

// Per pixel.
double GpuWorker::expected_cpu_seconds(const graph::Program& program) const
{
    double measured = desk_.pace(Device::cpu);
    return measured > 0 ? measured : guessed_cpu_seconds_per_pixel(program);
}

// A small picture that nobody sees.
void GpuWorker::try_pace(const Job& job)
{
    desk_.set_absent(true);
    FrameRequest request = divided(job.request->frame, trial_divisor);
    Frame frame(request.width, request.height, request.layers);
    auto start = std::chrono::steady_clock::now();
    device_->draw(frame, *job.request->program, request, {});
    std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    pace_.note(*job.request->program, seconds.count(), pixel_count(request));
    desk_.set_absent(false);
    desk_.note_pace(Device::gpu, pace_.seconds_per_pixel(*job.request->program));
}

bool GpuWorker::is_faster(const Job& job) const
{
    const graph::Program& program = *job.request->program;
    return pace_.known_near(program) &&
           pace_.seconds_per_pixel(program) < clearly_faster * expected_cpu_seconds(program);
}

DrawFrame GpuWorker::draw_frame()
{
    return [this](Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch) {
        return device_->draw(frame, program, request, watch);
    };
}

void GpuWorker::draw_passes(const Job& job)
{
    const PictureRequest& request = *job.request;
    std::optional<int> shown_divisor = show_again(desk_, Device::gpu, job);
    double pace = pace_.known() ? pace_.seconds_per_pixel(*request.program)
                                : guessed_software_gl_ratio(*request.program) * expected_cpu_seconds(*request.program);
    for (const PassPlan& plan : passes(request, pace, coarse_seconds, shown_divisor)) {
        std::optional<double> seconds = PicturePass(desk_, frames_, Device::gpu, job, plan).draw(draw_frame());
        if (!seconds) return;
        if (request.frame.slice) continue;  // says nothing about pictures of rays
        double eyes = is_stereo(request) ? 2 : 1;
        pace_.note(*request.program, *seconds / eyes, pixel_count(divided(request.frame, plan.divisor)));
        desk_.note_pace(Device::gpu, pace_.seconds_per_pixel(*request.program));
    }
    accumulation_.go_on(desk_, frames_, Device::gpu, job, draw_frame());
}

}  // namespace fieldwright::renderer
