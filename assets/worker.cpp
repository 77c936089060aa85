// Starts a worker, feeds it, listens, and kills it when its time is over.
#include "assets/worker.h"

#include "assets/worker_message.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

extern char** environ;

namespace fieldwright::assets {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto look_around = std::chrono::milliseconds(20);  // for a stop that was asked for

class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    void hold(int number)
    {
        close();
        number_ = number;
    }
    void close()
    {
        if (is_open()) ::close(std::exchange(number_, -1));
    }

private:
    int number_;
};

// How a worker is started: its input from a socket, which unlike a pipe can be written to without a signal when
// nobody reads; its output to a pipe; signals as in a new session; no other file of ours.
class SpawnRecipe {
public:
    SpawnRecipe(int input, int output)
    {
        ::posix_spawn_file_actions_init(&files_);
        ::posix_spawn_file_actions_adddup2(&files_, input, STDIN_FILENO);
        ::posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
        ::posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
        ::posix_spawnattr_init(&attributes_);
        sigset_t none, all;
        ::sigemptyset(&none);
        ::sigfillset(&all);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setsigdefault(&attributes_, &all);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnRecipe()
    {
        ::posix_spawn_file_actions_destroy(&files_);
        ::posix_spawnattr_destroy(&attributes_);
    }
    SpawnRecipe(const SpawnRecipe&) = delete;
    SpawnRecipe& operator=(const SpawnRecipe&) = delete;

    // The error number.
    int spawn(pid_t& child, const std::string& program, std::vector<std::string> words) const
    {
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        return ::posix_spawn(&child, program.c_str(), &files_, &attributes_, arguments.data(), environ);
    }

private:
    posix_spawn_file_actions_t files_;
    posix_spawnattr_t attributes_;
};

std::string seconds(double count)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g s", count);
    return buffer;
}

const char* signal_words(int signal)
{
    switch (signal) {
        case SIGSEGV:
        case SIGBUS: return "it reached for memory that is not its own";
        case SIGABRT: return "it gave up";
        case SIGFPE: return "an impossible calculation";
        case SIGILL: return "an impossible instruction";
        case SIGKILL: return "the system stopped it";
        default: return "a signal stopped it";
    }
}

// One process at work.
class Child {
public:
    Child(const std::string& program, const WorkerJob& job)
        : job_(job),
          deadline_(Clock::now() +
                    std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(job.limits.wall_s)))
    {
        start(program);
    }
    ~Child() { kill(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    WorkerAnswer answer(const std::stop_token& stop)
    {
        if (start_error_ != 0)
            return why(Ending::not_started,
                       "waits: no process can be started for it (" + std::string(std::strerror(start_error_)) + ")");
        while (output_.is_open() || !ended_) {
            if (stop.stop_requested()) return why(Ending::cancelled, "was given up");
            if (Clock::now() >= deadline_)
                return why(Ending::too_slow, "takes longer than " + seconds(job_.limits.wall_s));
            if (received_.size() > message_header + job_.limits.answer_bytes)
                return why(Ending::nonsense, "made the process that works on it answer without end");
            if (output_.is_open()) exchange();
            else std::this_thread::sleep_for(std::chrono::milliseconds(1));
            look_for_end();
        }
        return judged();
    }

private:
    void start(const std::string& program)
    {
        int input[2], output[2];
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0) {
            start_error_ = errno;
            return;
        }
        Descriptor its_input(input[1]);
        input_.hold(input[0]);
        if (::pipe2(output, O_CLOEXEC) != 0) {
            start_error_ = errno;
            return;
        }
        Descriptor its_output(output[1]);
        output_.hold(output[0]);
        ::fcntl(input_.number(), F_SETFL, O_NONBLOCK);
        ::fcntl(output_.number(), F_SETFL, O_NONBLOCK);
        const WorkerLimits& limits = job_.limits;
        start_error_ = SpawnRecipe(its_input.number(), its_output.number())
                           .spawn(child_, program,
                                  {"fieldwright", "--worker", job_.name, std::to_string(limits.memory_bytes),
                                   std::to_string(limits.address_bytes), std::to_string(limits.cpu_s)});
        if (start_error_ != 0) child_ = 0;
    }

    // Sends and receives what can be, and waits a little when nothing can.
    void exchange()
    {
        pollfd ends[2] = {{output_.number(), POLLIN, 0}, {input_.number(), POLLOUT, 0}};
        auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now());
        auto wait = std::clamp<Clock::rep>(left.count(), 0, look_around.count());
        if (::poll(ends, input_.is_open() ? 2 : 1, static_cast<int>(wait)) <= 0) return;
        if (ends[0].revents) receive();
        if (input_.is_open() && ends[1].revents) send();
    }

    void send()
    {
        std::string_view rest = std::string_view(job_.input).substr(sent_);
        ssize_t count = rest.empty() ? 0 : ::send(input_.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
        if (count > 0) sent_ += static_cast<std::size_t>(count);
        bool broken = count < 0 && errno != EAGAIN && errno != EINTR;
        if (broken || sent_ == job_.input.size()) input_.close();
    }

    void receive()
    {
        char buffer[1 << 16];
        ssize_t count = ::read(output_.number(), buffer, sizeof buffer);
        if (count > 0) received_.append(buffer, static_cast<std::size_t>(count));
        else if (count == 0 || (errno != EAGAIN && errno != EINTR)) output_.close();
    }

    // A worker's helpers may keep its output open: what was written until its end is all there is.
    void look_for_end()
    {
        if (ended_) {
            output_.close();
            return;
        }
        if (::waitpid(child_, &status_, WNOHANG) != child_) return;
        ended_ = true;
        std::size_t before = 0;
        do {
            before = received_.size();
            if (output_.is_open()) receive();
        } while (received_.size() > before && received_.size() <= message_header + job_.limits.answer_bytes);
    }

    WorkerAnswer judged()
    {
        if (WIFSIGNALED(status_)) return of_signal(WTERMSIG(status_));
        int code = WEXITSTATUS(status_);
        if (code == out_of_memory_code)
            return why(Ending::out_of_memory,
                       "needs more than " + std::to_string(job_.limits.memory_bytes >> 20) + " MB of memory");
        if (code != 0)
            return why(Ending::died,
                       "ended the process that works on it without an answer (exit code " + std::to_string(code) + ")");
        std::optional<WorkerMessage> message = message_from(std::move(received_));
        if (!message) return why(Ending::nonsense, "made the process that works on it answer nonsense");
        if (message->refused) return why(Ending::refused, message->bytes);
        return {Ending::answered, std::move(message->bytes), {}};
    }

    WorkerAnswer of_signal(int signal) const
    {
        if (signal == SIGXCPU)
            return why(Ending::too_slow, "takes more than " + seconds(job_.limits.cpu_s) + " of computing");
        return why(Ending::died, std::string("crashed the process that works on it (") + signal_words(signal) + ")");
    }

    WorkerAnswer why(Ending ending, const std::string& reason) const
    {
        return {ending, {}, job_.subject + " " + reason};
    }

    void kill()
    {
        if (child_ == 0 || ended_) return;
        ::kill(child_, SIGKILL);
        while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    const WorkerJob& job_;
    Clock::time_point deadline_;
    pid_t child_ = 0;
    int start_error_ = 0;
    Descriptor input_, output_;
    std::size_t sent_ = 0;
    std::string received_;
    bool ended_ = false;
    int status_ = 0;
};

}  // namespace

WorkerAnswer Worker::run(const WorkerJob& job, const std::stop_token& stop) const
{
    return Child(program_.string(), job).answer(stop);
}

}  // namespace fieldwright::assets
