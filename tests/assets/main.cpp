// This test program is its own worker: the tests' bad jobs, and the real ones of the room.
#include "assets/picture_file.h"
#include "assets/worker_jobs.h"
#include "graph/problem.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using namespace fieldwright;

std::string allocate(const std::string&)
{
    std::vector<std::string> kept;
    while (true) kept.emplace_back(1 << 20, 'x');
}

std::string loop(const std::string&)
{
    while (std::getenv("NO_SUCH_VARIABLE") == nullptr) {
    }
    return {};
}

std::string sleep_for_ever(const std::string&)
{
    while (true) ::pause();
}

// To the worker's own output, which is the first number free when it began to listen.
std::string write_garbage(const std::string&)
{
    for (int i = 0; i < 100; ++i)
        if (::write(3, "garbage", 7) < 0) break;
    ::_exit(0);
}

std::string write_without_end(const std::string&)
{
    std::string page(1 << 16, 'x');
    while (::write(3, page.data(), page.size()) > 0) {
    }
    ::_exit(0);
}

std::string print(const std::string& input)
{
    if (::write(STDOUT_FILENO, "chatter", 7) != 7) std::abort();
    return input + " was heard";
}

const assets::WorkerJobs jobs = {
    {"echo", [](const std::string& input) { return input; }},
    {"print", print},
    {"allocate", allocate},
    {"loop", loop},
    {"sleep", sleep_for_ever},
    {"abort", [](const std::string&) -> std::string { std::abort(); }},
    {"crash",
     [](const std::string&) -> std::string {
         ::raise(SIGSEGV);
         return {};
     }},
    {"leave", [](const std::string&) -> std::string { ::_exit(3); }},
    {"garbage", write_garbage},
    {"flood", write_without_end},
    {"refuse", [](const std::string&) -> std::string { throw graph::Failure(3, "is not what it seems"); }},
    {"throw", [](const std::string&) -> std::string { throw std::runtime_error("odd"); }},
    {std::string(assets::picture_job), assets::decode_picture},
};

}  // namespace

int main(int argc, char** argv)
{
    std::span<char*> words(argv, static_cast<std::size_t>(argc));
    if (words.size() > 1 && std::string_view(words[1]) == "--worker") return assets::serve(words.subspan(2), jobs);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
