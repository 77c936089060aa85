// The child's side: the jobs a worker knows, and doing one of them.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>

namespace fieldwright::assets {

// From a job's input to its answer. Throws graph::Failure with a reason that follows the subject: "is damaged".
using WorkerFunction = std::function<std::string(const std::string& input)>;
using WorkerJobs = std::map<std::string, WorkerFunction, std::less<>>;

// The main function of a worker: sets its own limits, reads a job's input from standard input to its end, and writes
// the message. `words` follow `--worker`: job, memory and address space in bytes, seconds of computing. The exit code.
int serve(std::span<char* const> words, const WorkerJobs& jobs);

}  // namespace fieldwright::assets
