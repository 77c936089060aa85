// Work that may crash, hang or fill the memory, done by a child process of this program under limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>

namespace fieldwright::assets {

struct WorkerLimits {
    std::int64_t memory_bytes = std::int64_t(1) << 30;  // what it may write to
    std::int64_t address_bytes = 0;                     // what it may map, written to or not; 0 = anything
    int cpu_s = 10;                                     // of all its threads together
    double wall_s = 30;                                 // on a busy machine much longer than cpu_s
    std::size_t answer_bytes = std::size_t(256) << 20;
};

// One job of worker_jobs, by its name, and its input. Sentences begin with the subject: "The picture face.png".
struct WorkerJob {
    std::string name, subject, input;
    WorkerLimits limits{};
};

enum class Ending {
    answered,
    refused,        // the job says why it cannot be done
    out_of_memory,  // beyond memory_bytes
    too_slow,       // beyond cpu_s or wall_s
    died,           // by a signal, or without an answer
    nonsense,       // an answer that is none
    cancelled,
    not_started,  // the system gives no process
};

struct WorkerAnswer {
    Ending ending = Ending::answered;
    std::string bytes;     // of an answer
    std::string sentence;  // why there is none: one sentence, without its full stop
    explicit operator bool() const { return ending == Ending::answered; }
};

// Threads share one. A process per job: what one job did, the next does not feel.
class Worker {
public:
    // The program that runs `serve` when called with `--worker`.
    explicit Worker(std::filesystem::path program = "/proc/self/exe") : program_(std::move(program)) {}

    // Waits for the job's end, at most `wall_s`, or until `stop` is asked for. Never throws for what the job does.
    WorkerAnswer run(const WorkerJob& job, const std::stop_token& stop = {}) const;

private:
    std::filesystem::path program_;
};

}  // namespace fieldwright::assets
