// What benchmarks have in common: timing of two rivals in turn, A B A B ..., so that what slows the machine slows both,
// and what a program does around its measure.
#pragma once

#include "graph/problem.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

namespace fieldwright::bench {

inline constexpr int repetitions = 9;

struct Times {
    double minimum = 0, median = 0;  // s
};

template <typename Work>
double seconds_of(const Work& work)
{
    auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Seconds of processor time by CLOCK_THREAD_CPUTIME_ID or CLOCK_PROCESS_CPUTIME_ID: what else the machine does, does
// not count.
template <typename Work>
double processor_seconds_of(clockid_t clock, const Work& work)
{
    auto now = [&] {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    double start = now();
    work();
    return now() - start;
}

inline Times summary(std::vector<double> seconds)
{
    std::sort(seconds.begin(), seconds.end());
    return {seconds.front(), seconds[seconds.size() / 2]};
}

// Each argument does its work once and returns the seconds it took.
template <typename A, typename B>
std::pair<Times, Times> interleaved(const A& a, const B& b, int count = repetitions)
{
    std::vector<double> a_seconds, b_seconds;
    for (int i = 0; i < count; ++i) {
        a_seconds.push_back(a());
        b_seconds.push_back(b());
    }
    return {summary(a_seconds), summary(b_seconds)};
}

// Ends the benchmark when what it compares is not equal.
inline void demand(bool equal, const char* sentence)
{
    if (equal) return;
    std::fflush(stdout);
    std::fprintf(stderr, "not equal: %s\n", sentence);
    std::_Exit(1);  // threads may be drawing
}

inline const char* verdict(bool reached) { return reached ? "reached" : "MISSED"; }

// The whole of a benchmark's `main`; the exit code. Lines are seen as they are printed.
inline int run_benchmark(void (*measure)())
{
    setvbuf(stdout, nullptr, _IOLBF, 0);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // what is cached is not compiled
    try {
        measure();
        return 0;
    } catch (const graph::Failure& failure) {
        std::fprintf(stderr, "%s\n", failure.what());
        return failure.exit_code;
    }
}

}  // namespace fieldwright::bench
