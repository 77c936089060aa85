// The bounding-volume experiment of seed 001 on the CPU device: Magnemite with the volume around its magnets and screws,
// and with that node muted; alone, and in its meadow. Both must be the same picture.
#include "graph/scene_file.h"
#include "renderer/devices.h"
#include "renderer/picture.h"
#include "tests/bench/timing.h"

#include <tbb/global_control.h>
#include <functional>
#include <numeric>

namespace fieldwright::bench {
namespace {

constexpr int width = 320, height = 180, turns = 5;
constexpr double largest_share_apart = 0.005;  // of pixels, by more than 2/255: rays that graze end a step elsewhere

using Chosen = std::function<bool(const graph::Node&)>;

graph::Document muted(graph::Document document, const Chosen& chosen)
{
    graph::for_each_graph(document, [&](graph::Graph& graph) {
        for (graph::Node& node : graph.nodes)
            if (chosen(node)) node.muted = true;
    });
    return document;
}

// With their guards, which would pass on the shape that guards.
bool is_of_the_meadow(const graph::Node& node)
{
    return node.type == "group:Patch of grass" || node.type == "group:Tree" || node.name == "Only near the ground" ||
           node.name == "Below the tree tops";
}

double share_apart(const renderer::Frame& a, const renderer::Frame& b, int step_limit)
{
    renderer::Picture one = renderer::picture(a, renderer::View::beauty, step_limit);
    renderer::Picture other = renderer::picture(b, renderer::View::beauty, step_limit);
    std::size_t apart = 0;
    for (std::size_t pixel = 0; pixel < one.rgb.size(); pixel += 3) {
        int most = 0;
        for (std::size_t k = pixel; k < pixel + 3; ++k) most = std::max(most, std::abs(one.rgb[k] - other.rgb[k]));
        if (most > 2) ++apart;
    }
    return static_cast<double>(apart) / (static_cast<double>(one.rgb.size()) / 3);
}

double mean_steps(const renderer::Frame& frame)
{
    return static_cast<double>(std::accumulate(frame.steps.begin(), frame.steps.end(), std::int64_t{0})) /
           static_cast<double>(frame.steps.size());
}

void measure(const char* name, const graph::Document& scene, const std::shared_ptr<const graph::Library>& library)
{
    auto is_the_volume = [](const graph::Node& node) { return node.name == "Bounding volume"; };
    graph::Program with = graph::lower(scene, library), without = graph::lower(muted(scene, is_the_volume), library);
    renderer::FrameRequest request{.width = width, .height = height, .time = 9};
    renderer::Frame bounded, bare;
    auto timed = [&](renderer::Frame& frame, const graph::Program& program) {
        return processor_seconds_of(CLOCK_PROCESS_CPUTIME_ID,
                                    [&] { frame = renderer::render_on_cpu(program, request); });
    };
    auto [with_times, without_times] =
        interleaved([&] { return timed(bounded, with); }, [&] { return timed(bare, without); }, turns);
    double apart = share_apart(bounded, bare, with.march.step_limit);
    std::printf("%-14s %8.0f %8.0f %8.2f %8.1f %8.1f %10.3f\n", name, 1e3 * with_times.minimum,
                1e3 * without_times.minimum, without_times.minimum / with_times.minimum, mean_steps(bounded),
                mean_steps(bare), 100 * apart);
    demand(mean_steps(bounded) > 2, "a picture that rays march for");
    demand(apart <= largest_share_apart, "the pictures with and without the bounding volume");
}

void run()
{
    tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    auto library = graph::Library::embedded();
    graph::Document scene =
        graph::open_scene(FIELDWRIGHT_SOURCE_DIR "/examples/seeds/001_magnemite.scene.json", *library);
    std::printf("001_magnemite, %dx%d, one thread\n%-14s %8s %8s %8s %8s %8s %10s\n", width, height, "", "ms",
                "without", "ratio", "steps", "without", "% apart");
    measure("alone", muted(scene, is_of_the_meadow), library);
    measure("in its meadow", scene, library);
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
