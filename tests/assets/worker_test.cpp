// Whatever a job does, the caller gets an answer or one sentence, in time, and lives.
#include "assets/worker.h"

#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cerrno>
#include <chrono>
#include <thread>

namespace fieldwright::assets {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

WorkerAnswer run(const std::string& job, const std::string& input = {}, WorkerLimits limits = {})
{
    return Worker().run({job, "The thing", input, limits});
}

int open_files()
{
    int count = 0;
    DIR* folder = ::opendir("/proc/self/fd");
    while (::readdir(folder)) ++count;
    ::closedir(folder);
    return count;
}

bool has_children() { return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD; }

TEST(Worker, gives_the_answer_of_a_job)
{
    std::string large(3 << 20, 'q');
    large[77] = '\0';
    EXPECT_EQ(run("echo", large).bytes, large);
    EXPECT_EQ(run("echo").bytes, "");
    EXPECT_TRUE(run("echo"));
}

TEST(Worker, does_not_take_what_libraries_print_for_the_answer) { EXPECT_EQ(run("print", "it").bytes, "it was heard"); }

TEST(Worker, says_why_a_job_refuses)
{
    WorkerAnswer answer = run("refuse");
    EXPECT_EQ(answer.ending, Ending::refused);
    EXPECT_EQ(answer.sentence, "The thing is not what it seems");
    EXPECT_EQ(run("throw").sentence, "The thing cannot be worked on (odd)");
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Worker, ends_a_job_that_allocates_without_end)
{
    WorkerAnswer answer = run("allocate", {}, {.memory_bytes = 64 << 20});
    EXPECT_EQ(answer.ending, Ending::out_of_memory);
    EXPECT_EQ(answer.sentence, "The thing needs more than 64 MB of memory");
}
#endif

TEST(Worker, ends_a_job_that_computes_without_end)
{
    auto start = std::chrono::steady_clock::now();
    WorkerAnswer answer = run("loop", {}, {.cpu_s = 1, .wall_s = 30});
    EXPECT_EQ(answer.ending, Ending::too_slow);
    EXPECT_EQ(answer.sentence, "The thing takes more than 1 s of computing");
    EXPECT_LT(seconds_since(start), 25);
}

TEST(Worker, ends_a_job_that_waits_without_end)
{
    auto start = std::chrono::steady_clock::now();
    WorkerAnswer answer = run("sleep", {}, {.wall_s = 0.3});
    EXPECT_EQ(answer.ending, Ending::too_slow);
    EXPECT_EQ(answer.sentence, "The thing takes longer than 0.3 s");
    EXPECT_LT(seconds_since(start), 5);
}

TEST(Worker, outlives_a_job_that_crashes)
{
    WorkerAnswer aborted = run("abort"), crashed = run("crash"), left = run("leave");
    EXPECT_EQ(aborted.ending, Ending::died);
    EXPECT_EQ(aborted.sentence, "The thing crashed the process that works on it (it gave up)");
    EXPECT_EQ(crashed.ending, Ending::died);
#if !defined(__SANITIZE_ADDRESS__)
    EXPECT_EQ(crashed.sentence,
              "The thing crashed the process that works on it (it reached for memory that is not its own)");
#endif
    EXPECT_EQ(left.ending, Ending::died);
    EXPECT_EQ(left.sentence, "The thing ended the process that works on it without an answer (exit code 3)");
}

TEST(Worker, takes_no_garbage_for_an_answer)
{
    WorkerAnswer garbage = run("garbage"), flood = run("flood", {}, {.answer_bytes = 1 << 20});
    EXPECT_EQ(garbage.ending, Ending::nonsense);
    EXPECT_EQ(garbage.sentence, "The thing made the process that works on it answer nonsense");
    EXPECT_EQ(flood.ending, Ending::nonsense);
    EXPECT_EQ(flood.sentence, "The thing made the process that works on it answer without end");
}

TEST(Worker, says_when_it_knows_no_such_job_or_there_is_no_such_program)
{
    EXPECT_EQ(run("unheard of").ending, Ending::died);
    WorkerAnswer answer = Worker("/no/such/program").run({"echo", "The thing", ""});
    EXPECT_EQ(answer.ending, Ending::not_started);
    EXPECT_EQ(answer.sentence, "The thing waits: no process can be started for it (No such file or directory)");
}

TEST(Worker, outlives_a_worker_that_reads_nothing)
{
    WorkerAnswer answer = Worker("/bin/true").run({"echo", "The thing", std::string(8 << 20, 'x')});
    EXPECT_EQ(answer.ending, Ending::nonsense);
}

TEST(Worker, can_be_told_to_give_up)
{
    std::stop_source source;
    std::jthread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        source.request_stop();
    });
    auto start = std::chrono::steady_clock::now();
    WorkerAnswer answer = Worker().run({"sleep", "The thing", "", {.wall_s = 30}}, source.get_token());
    EXPECT_EQ(answer.ending, Ending::cancelled);
    EXPECT_LT(seconds_since(start), 5);
}

TEST(Worker, serves_several_threads_at_once)
{
    Worker worker;
    std::vector<std::string> answers(6);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < answers.size(); ++i)
            threads.emplace_back([&, i] {
                std::string input(1 << 18, static_cast<char>('a' + i));
                answers[i] = worker.run({"echo", "The thing", input}).bytes;
            });
    }
    for (std::size_t i = 0; i < answers.size(); ++i)
        EXPECT_EQ(answers[i], std::string(1 << 18, static_cast<char>('a' + i)));
}

TEST(Worker, leaves_no_process_and_no_open_file_behind)
{
    run("echo");
    int before = open_files();
    for (const char* job : {"echo", "abort", "garbage", "refuse"}) run(job);
    run("sleep", {}, {.wall_s = 0.05});
    EXPECT_EQ(open_files(), before);
    EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace fieldwright::assets
