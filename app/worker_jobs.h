// What this program does as a worker (`fieldwright --worker`), and asking for what only app can: shaders.
#pragma once

#include "assets/worker.h"

#include <span>

namespace fieldwright::app {

bool is_worker(std::span<char* const> words);  // of the command line, the program's name first
int work(std::span<char* const> words);        // the exit code

// Whether this machine's driver takes a fragment shader, tried by a worker because it may crash or never end.
struct ShaderVerdict {
    assets::Ending ending = assets::Ending::answered;
    std::string log;       // answered: the driver's words against it; empty = it is good
    std::string sentence;  // else: what came of trying; begins with the subject
    bool good() const { return ending == assets::Ending::answered && log.empty(); }
};
inline constexpr assets::WorkerLimits shader_limits{
    .memory_bytes = std::int64_t(2) << 30, .cpu_s = 40, .wall_s = 30, .answer_bytes = 1 << 20};
ShaderVerdict try_shader(const assets::Worker& worker, const std::string& fragment_text, const std::string& subject,
                         const std::stop_token& stop = {}, const assets::WorkerLimits& limits = shader_limits);

}  // namespace fieldwright::app
