// How long something takes: by the clock, and of the processor by the thread that does it.
#pragma once

#include <chrono>
#include <ctime>

namespace fieldwright::app {

struct Taken {
    double wall_s = 0;
    double processor_s = 0;  // what other threads and programs do meanwhile does not count
};

// Of one thread, from when it is made.
class Stopwatch {
public:
    Taken taken() const
    {
        std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
        return {wall.count(), processor_seconds() - processor_s_};
    }

private:
    static double processor_seconds()
    {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
    double processor_s_ = processor_seconds();
};

}  // namespace fieldwright::app
