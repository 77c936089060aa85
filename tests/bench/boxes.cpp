// Seed 003's claim: about 500 boxes at interactive speed. Its scene in a window that is orbited by a hand at 60 Hz.
#include "field/evaluator.h"
#include "graph/scene_file.h"
#include "tests/bench/picture_window.h"

#include <cmath>

namespace fieldwright::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int width = 512, height = 512;                    // the seed's picture
constexpr double orbit_seconds = 4, interactive_rate = 10;  // pictures per second
constexpr double turn_per_second_rad = 0.8;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::size_t count_boxes(const graph::Document& document)
{
    std::size_t boxes = 0;
    for (const graph::Node& node : document.root.nodes)
        if (const graph::Value* list = node.parameter("rectangles")) boxes += std::get<graph::PointList>(*list).size();
    return boxes;
}

renderer::ViewCamera orbiting(double seconds)
{
    auto angle = static_cast<float>(turn_per_second_rad * seconds);
    renderer::ViewCamera camera;
    camera.position = {5.2f * std::sin(angle), 2.3f, 5.2f * std::cos(angle)};
    camera.field_of_view_rad = 0.56f;
    return camera;
}

// Points all over the solid and around it, in one thread.
double picoseconds_per_distance(const graph::Program& program)
{
    std::vector<glm::vec3> points;
    for (int i = 0; i < 32 * 32 * 32; ++i)
        points.emplace_back(glm::vec3(i % 32, i / 32 % 32, i / 1024) / 31.0f * 3.0f - 1.5f);
    std::vector<float> block = field::evaluate_frame(program, 0);
    std::vector<double> seconds;
    for (int turn = 0; turn < repetitions; ++turn)
        seconds.push_back(
            processor_seconds_of(CLOCK_THREAD_CPUTIME_ID, [&] { field::distances(program, block, points); }));
    return 1e12 * summary(seconds).minimum / static_cast<double>(points.size());
}

void measure_orbit(PictureWindow& window, const std::shared_ptr<const graph::Program>& program)
{
    std::vector<int> divisors;
    double longest = 0;
    auto start = Clock::now(), last = start, next = start;
    while (seconds_since(start) < orbit_seconds) {
        window.ask(program, true, orbiting(seconds_since(start)));
        next += std::chrono::microseconds(16667);
        while (std::optional<renderer::DrawnPicture> drawn =
                   window.picture(std::chrono::duration<double>(next - Clock::now()).count())) {
            divisors.push_back(drawn->divisor);
            longest = std::max(longest, seconds_since(last));
            last = Clock::now();
        }
    }
    double rate = static_cast<double>(divisors.size()) / seconds_since(start);
    demand(!divisors.empty(), "an orbit shows pictures");
    std::sort(divisors.begin(), divisors.end());
    std::printf("orbit: %.1f pictures per second (>= %.0f): %s; at 1/%d (median; 1/%d to 1/%d), longest wait %.0f ms\n",
                rate, interactive_rate, verdict(rate >= interactive_rate), divisors[divisors.size() / 2],
                divisors.front(), divisors.back(), 1e3 * longest);
}

void run()
{
    auto library = graph::Library::embedded();
    graph::Document scene =
        graph::open_scene(FIELDWRIGHT_SOURCE_DIR "/examples/seeds/003_three_circles.scene.json", *library);
    auto program = std::make_shared<const graph::Program>(graph::lower(scene, library));
    std::printf("%zu boxes, %.0f ps per distance in one thread, %dx%d\n", count_boxes(scene),
                picoseconds_per_distance(*program), width, height);
    PictureWindow window(renderer::Device::cpu, width, height);
    window.ask(program, false, orbiting(0));
    auto start = Clock::now();
    window.picture_of(window.generation(), true);
    std::printf("at rest: full picture after %.2f s\n", seconds_since(start));
    measure_orbit(window, program);
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
