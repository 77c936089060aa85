// Limits, input, job, message.
#include "assets/worker_jobs.h"

#include "assets/worker_message.h"
#include "graph/problem.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <new>
#include <string_view>

namespace fieldwright::assets {
namespace {

constexpr int usage_code = 2, broken_pipe_code = 5;

// The sanitizers reserve more addresses than there is memory.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif

template <typename Resource>
void limit(Resource resource, rlim_t value, rlim_t grace = 0)
{
    rlimit now{};
    if (::getrlimit(resource, &now) != 0) return;
    rlimit wanted{std::min(value, now.rlim_max), std::min(value + grace, now.rlim_max)};
    ::setrlimit(resource, &wanted);
}

void limit_all(std::uint64_t memory_bytes, std::uint64_t address_bytes, std::uint64_t cpu_s)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, cpu_s, 1);  // past the first comes SIGXCPU, past the second SIGKILL
    if (limits_memory) {
        limit(RLIMIT_DATA, memory_bytes);
        if (address_bytes > 0) limit(RLIMIT_AS, address_bytes);
    }
    std::set_new_handler([] { ::_exit(out_of_memory_code); });
}

std::uint64_t number(std::string_view word)
{
    std::uint64_t value = 0;
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
}

std::string standard_input()
{
    std::string input;
    char buffer[1 << 16];
    while (true) {
        ssize_t count = ::read(STDIN_FILENO, buffer, sizeof buffer);
        if (count == 0 || (count < 0 && errno != EINTR)) return input;
        if (count > 0) input.append(buffer, static_cast<std::size_t>(count));
    }
}

// Libraries print to standard output as they like: theirs leads nowhere, ours goes on under another number.
int private_output()
{
    int output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
    return output;
}

bool write_all(int output, std::string_view bytes)
{
    while (!bytes.empty()) {
        ssize_t count = ::write(output, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

WorkerMessage done(const WorkerFunction& job, const std::string& input)
{
    try {
        return {false, job(input)};
    } catch (const graph::Failure& failure) {
        return {true, failure.what()};
    } catch (const std::bad_alloc&) {
        ::_exit(out_of_memory_code);
    } catch (const std::exception& error) {
        return {true, std::string("cannot be worked on (") + error.what() + ")"};
    }
}

}  // namespace

int serve(std::span<char* const> words, const WorkerJobs& jobs)
{
    auto job = words.size() == 4 ? jobs.find(std::string_view(words[0])) : jobs.end();
    if (job == jobs.end()) return usage_code;
    limit_all(number(words[1]), number(words[2]), number(words[3]));
    int output = private_output();
    WorkerMessage message = done(job->second, standard_input());
    bool written = write_all(output, header_of(message)) && write_all(output, message.bytes);
    // Drivers and libraries may crash in what they do at exit; the answer is given, so nothing of theirs runs.
    ::_exit(written ? 0 : broken_pipe_code);
}

}  // namespace fieldwright::assets
