// Processor seconds of one thread for a picture on the CPU device: every example, and csg(300).
#include "field/kernel.h"
#include "graph/scene_file.h"
#include "renderer/devices.h"
#include "tests/bench/csg_scene.h"
#include "tests/bench/timing.h"

#include <tbb/global_control.h>
#include <algorithm>
#include <filesystem>

namespace fieldwright::bench {
namespace {

constexpr int primitives = 300, width = 528, height = 244;

void measure(const std::string& name, const graph::Program& program)
{
    renderer::FrameRequest request{.width = width, .height = height, .time = 0.6f};
    std::vector<double> seconds;
    for (int i = 0; i < repetitions; ++i)
        seconds.push_back(
            processor_seconds_of(CLOCK_PROCESS_CPUTIME_ID, [&] { renderer::render_on_cpu(program, request); }));
    Times times = summary(seconds);
    std::printf("%-24s %10.1f %10.1f\n", name.c_str(), 1e3 * times.minimum, 1e3 * times.median);
}

void run()
{
    tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    std::printf("%dx%d, one thread, %s\n%-24s %10s %10s\n", width, height,
                std::string(field::kernels().instruction_set).c_str(), "", "ms", "(median)");
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(FIELDWRIGHT_SOURCE_DIR "/examples"))
        if (entry.path().extension() == ".json") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    for (const std::filesystem::path& path : scenes)
        measure(path.stem().stem().string(), graph::lower(graph::open_scene(path, *library), library));
    measure("csg(" + std::to_string(primitives) + ")",
            graph::lower(csg_document(csg_scene(primitives), library), library));
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
