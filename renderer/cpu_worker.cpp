// Pictures on the CPU: coarse in time, then finer while nothing new is asked for.
#include "renderer/cpu_worker.h"

#include "renderer/devices.h"

#include <tbb/parallel_for.h>

namespace fieldwright::renderer {
namespace {

constexpr double coarse_seconds = 0.035;  // while a hand moves: a third of what it notices, the machine may be busy
constexpr double first_seconds = 0.008;   // after an edit: a frame waits for it

}  // namespace

void CpuWorker::run()
{
    lower_priority("render cpu", Priority::picture);
    while (std::optional<Job> job = desk_.wait_for_job(Device::cpu)) {
        if (arena_.execute([&] { return draw(*job); })) desk_.done(Device::cpu, *job);
    }
}

// False when it was stopped.
bool CpuWorker::draw(const Job& job)
{
    try {
        if (runs_on_cpu(*job.request->program)) return draw_passes(job);
        if (!desk_.has_gpu())
            fail(job,
                 "this scene or the shading library is not the one built into this program and needs a GPU, and there "
                 "is none");
    } catch (const std::exception& failure) {
        fail(job, failure.what());
    }
    return true;
}

void CpuWorker::fail(const Job& job, const std::string& sentence)
{
    if (sentence != last_failure_) desk_.report(Failed{sentence, job.request->generation});
    last_failure_ = sentence;
}

double CpuWorker::expected_seconds_per_pixel(const graph::Program& program) const
{
    return pace_.known() ? pace_.seconds_per_pixel(program) : guessed_cpu_seconds_per_pixel(program);
}

bool CpuWorker::draw_passes(const Job& job)
{
    const PictureRequest& request = *job.request;
    std::optional<int> shown_divisor = show_again(desk_, Device::cpu, job);
    double pace = expected_seconds_per_pixel(*request.program);
    double seconds_to_first = request.interacting ? coarse_seconds : first_seconds;
    for (const PassPlan& plan : passes(request, pace, seconds_to_first, shown_divisor)) {
        std::optional<double> seconds = PicturePass(desk_, frames_, Device::cpu, job, plan).draw(draw_on_cpu);
        if (!seconds) return false;
        if (request.frame.slice) continue;  // says nothing about pictures of rays
        double eyes = is_stereo(request) ? 2 : 1;
        pace_.note(*request.program, *seconds / eyes, pixel_count(divided(request.frame, plan.divisor)));
        desk_.note_pace(Device::cpu, pace_.seconds_per_pixel(*request.program));
        last_failure_.clear();
    }
    return accumulation_.go_on(desk_, frames_, Device::cpu, job, draw_on_cpu);
}

}  // namespace fieldwright::renderer
