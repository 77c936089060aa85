// The table of jobs.
#include "app/worker_jobs.h"

#include "assets/picture_file.h"
#include "assets/worker_jobs.h"
#include "renderer/shader_trial.h"

#include <string_view>

namespace fieldwright::app {
namespace {

constexpr std::string_view worker_word = "--worker", shader_job = "shader";

assets::WorkerJobs jobs()
{
    return {{std::string(assets::picture_job), assets::decode_picture},
            {std::string(shader_job), [](const std::string& text) { return renderer::shader_log(text); }}};
}

}  // namespace

bool is_worker(std::span<char* const> words) { return words.size() > 1 && words[1] == worker_word; }

int work(std::span<char* const> words) { return assets::serve(words.subspan(2), jobs()); }

ShaderVerdict try_shader(const assets::Worker& worker, const std::string& fragment_text, const std::string& subject,
                         const std::stop_token& stop, const assets::WorkerLimits& limits)
{
    assets::WorkerAnswer answer = worker.run({std::string(shader_job), subject, fragment_text, limits}, stop);
    return {answer.ending, std::move(answer.bytes), std::move(answer.sentence)};
}

}  // namespace fieldwright::app
