// Progress on stderr, at most ten times a second on a terminal and every five seconds in a log.
#include "app/progress_line.h"

#include <unistd.h>
#include <cstdio>

namespace fieldwright::app {

ProgressLine::ProgressLine(bool wanted)
    : start_(Clock::now()), shown_(start_), wanted_(wanted), terminal_(isatty(STDERR_FILENO) != 0)
{
}

void ProgressLine::show(float fraction)
{
    using namespace std::chrono_literals;
    Clock::time_point now = Clock::now();
    if (!wanted_ || now - shown_ < (terminal_ ? 100ms : 5000ms)) return;
    shown_ = now;
    std::fprintf(stderr, terminal_ ? "\rrendering %3d%%" : "rendering %d%%\n", static_cast<int>(100 * fraction));
    std::fflush(stderr);
}

void ProgressLine::finish(const std::string& result)
{
    if (!wanted_) return;
    double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    std::fprintf(stderr, "%s%s in %.2f s\n", terminal_ ? "\r\033[K" : "", result.c_str(), seconds);
}

}  // namespace fieldwright::app
