// Progress on stderr: one line that redraws itself on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace fieldwright::app {

class ProgressLine {
public:
    explicit ProgressLine(bool wanted);
    void show(float fraction);
    void finish(const std::string& result);  // the result and the seconds since construction

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_, shown_;
    bool wanted_, terminal_;
};

}  // namespace fieldwright::app
