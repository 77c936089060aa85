// Estimates of drawing times.
#include "renderer/pace.h"

#include "codegen/features.h"

#include <algorithm>
#include <array>

namespace fieldwright::renderer {
namespace {

constexpr std::array divisors = {1, 2, 3, 4, 6, 8, 12, 16};

// In primitives; marching and shading cost as much as a dozen. What mirrors is rarely more than a part of the picture.
double cost_of(const graph::Program& program)
{
    bool bounces = program.bounces > 0 && codegen::features_of(program, program.block).bounces;
    double rays = bounces ? 1.0 + 0.5 * program.bounces : 1.0;
    return rays * (12.0 + static_cast<double>(program.expanded_cost));
}

}  // namespace

void Pace::note(const graph::Program& program, double seconds, std::int64_t pixels)
{
    double measured = seconds / static_cast<double>(std::max<std::int64_t>(pixels, 1));
    double expected = known_near(program) ? seconds_per_pixel(program) : 0;
    cost_ = cost_of(program);
    seconds_per_pixel_ = measured > expected ? measured : 0.6 * expected + 0.4 * measured;
}

bool Pace::known_near(const graph::Program& program) const
{
    double growth = cost_of(program) / cost_;
    return known() && growth < 1.5 && growth > 1 / 1.5;
}

double Pace::seconds_per_pixel(const graph::Program& program) const
{
    return seconds_per_pixel_ * cost_of(program) / cost_;
}

// Two cores of 2023: what is wrong here is right after one picture.
double guessed_cpu_seconds_per_pixel(const graph::Program& program) { return 1e-8 * cost_of(program); }

// Measured with 3, 30, 300 and 600 primitives: 1.1, 1.0, 1.1, 1.6; the examples lie between 0.5 and 2.7.
double guessed_software_gl_ratio(const graph::Program& program) { return 1.0 + cost_of(program) / 1000.0; }

FrameRequest divided(const FrameRequest& request, int divisor)
{
    FrameRequest smaller = request;
    smaller.width = std::max(1, (request.width + divisor - 1) / divisor);
    smaller.height = std::max(1, (request.height + divisor - 1) / divisor);
    return smaller;
}

std::int64_t pixel_count(const FrameRequest& request) { return std::int64_t{request.width} * request.height; }

int affordable_divisor(const FrameRequest& request, double seconds_per_pixel, double seconds)
{
    auto affordable = [&](int divisor) {
        return seconds_per_pixel * static_cast<double>(pixel_count(divided(request, divisor))) <= seconds;
    };
    auto found = std::find_if(divisors.begin(), divisors.end(), affordable);
    return found == divisors.end() ? divisors.back() : *found;
}

}  // namespace fieldwright::renderer
