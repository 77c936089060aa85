// How fast a device draws, and what resolution that allows.
#pragma once

#include "renderer/frame.h"

namespace fieldwright::renderer {

// Seconds per pixel, as measured for the last program; for others in proportion to their cost.
class Pace {
public:
    // Believes slowness at once and speed by and by: a late picture is worse than a coarse one.
    void note(const graph::Program& program, double seconds, std::int64_t pixels);
    bool known() const { return seconds_per_pixel_ > 0; }
    bool known_near(const graph::Program& program) const;           // measured on something of about this cost
    double seconds_per_pixel(const graph::Program& program) const;  // 0 when nothing was measured

private:
    double seconds_per_pixel_ = 0;
    double cost_ = 1;
};

// Before anything is measured.
double guessed_cpu_seconds_per_pixel(const graph::Program& program);
// How many times longer software GL takes for a pixel than the CPU device.
double guessed_software_gl_ratio(const graph::Program& program);

// A width and height divided by 1, 2, 3, ... 16; at least one pixel.
FrameRequest divided(const FrameRequest& request, int divisor);
std::int64_t pixel_count(const FrameRequest& request);
// The finest of these that takes at most `seconds`.
int affordable_divisor(const FrameRequest& request, double seconds_per_pixel, double seconds);

}  // namespace fieldwright::renderer
