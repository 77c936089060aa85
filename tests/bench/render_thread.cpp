// What a window waits for: the first picture after an edit while a shader compiles, pictures while a value is dragged,
// and nothing once the picture is there.
#include "renderer/devices.h"
#include "tests/bench/csg_scene.h"
#include "tests/bench/picture_window.h"
#include "tests/bench/processor.h"
#include "tests/bench/timing.h"

#include <cmath>
#include <thread>

namespace fieldwright::bench {
namespace {

using namespace renderer;
using Clock = std::chrono::steady_clock;

constexpr int primitives = 300, width = 1280, height = 720;
constexpr double drag_seconds = 3, idle_seconds = 2;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Scenes {
public:
    Scenes() : library_(graph::Library::embedded()), scene_(csg_scene(primitives)) {}

    // Another count of shapes is another topology.
    std::shared_ptr<const graph::Program> edited(int edit) const
    {
        CsgScene scene = csg_scene(primitives - edit);
        return lowered(csg_document(scene, library_));
    }

    std::shared_ptr<const graph::Program> dragged(float amount)
    {
        scene_.shapes[0].half_size.x = 0.3f + 0.2f * amount;
        return lowered(csg_document(scene_, library_));
    }

private:
    std::shared_ptr<const graph::Program> lowered(const graph::Document& document) const
    {
        auto program = std::make_shared<const graph::Program>(graph::lower(document, library_));
        demand(program->problems.empty(), "the scene lowers without problems");
        return program;
    }

    std::shared_ptr<const graph::Library> library_;
    CsgScene scene_;
};

void measure_edits(PictureWindow& window, const Scenes& scenes)
{
    std::vector<double> seconds;
    int coarsest = 1, finest = 16;
    Compiling compiling(scenes.edited(0));
    for (int edit = 0; edit < repetitions + 1; ++edit) {
        auto program = scenes.edited(edit);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));  // in the midst of finer pictures of the last edit
        auto start = Clock::now();
        window.ask(program, false);
        DrawnPicture drawn = window.picture_of(window.generation(), false);
        if (edit == 0) continue;  // of a program just started
        seconds.push_back(seconds_since(start));
        coarsest = std::max(coarsest, drawn.divisor);
        finest = std::min(finest, drawn.divisor);
    }
    Times times = summary(seconds);
    double worst = *std::max_element(seconds.begin(), seconds.end());
    std::printf(
        "first picture after an edit, while compiling: %.0f / %.0f / %.0f ms (min, median, max of %zu), at 1/%d to "
        "1/%d\n",
        1e3 * times.minimum, 1e3 * times.median, 1e3 * worst, seconds.size(), finest, coarsest);
    std::printf("median <= 100 ms: %s; all: %s\n", verdict(times.median <= 0.1), verdict(worst <= 0.1));
}

// A hand moves at 60 Hz.
void measure_drag(PictureWindow& window, Scenes& scenes)
{
    int links = window.status().links, pictures = 0;
    std::vector<int> divisors;
    std::vector<double> drawing;
    double longest = 0;
    auto start = Clock::now(), last = start, next = start;
    for (int frame = 0; seconds_since(start) < drag_seconds; ++frame) {
        window.ask(scenes.dragged(0.5f + 0.5f * static_cast<float>(std::sin(0.1 * frame))), true);
        next += std::chrono::microseconds(16667);
        while (std::optional<DrawnPicture> drawn =
                   window.picture(std::chrono::duration<double>(next - Clock::now()).count())) {
            ++pictures;
            divisors.push_back(drawn->divisor);
            drawing.push_back(1e-3 * drawn->ms);
            longest = std::max(longest, seconds_since(last));
            last = Clock::now();
        }
    }
    double rate = pictures / seconds_since(start);
    links = window.status().links - links;
    demand(!divisors.empty(), "a drag shows pictures");
    std::sort(divisors.begin(), divisors.end());
    std::printf("a value dragged: %.1f pictures per second (>= 10): %s\n", rate, verdict(rate >= 10));
    std::printf("  at 1/%d (median; 1/%d to 1/%d), drawn in %.0f ms (median), longest wait %.0f ms\n",
                divisors[divisors.size() / 2], divisors.front(), divisors.back(), 1e3 * summary(drawing).median,
                1e3 * longest);
    std::printf("programs linked in it: %d (0): %s\n", links, verdict(links == 0));
}

void measure_rest(PictureWindow& window, Scenes& scenes)
{
    auto start = Clock::now();
    window.ask(scenes.dragged(0.25f), false);
    DrawnPicture drawn = window.picture_of(window.generation(), true);
    std::printf("full picture after it: %.2f s, by the %s\n", seconds_since(start),
                drawn.device == renderer::Device::gpu ? "GPU" : "CPU");
    while (window.status().busy) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    double before = processor_seconds();
    std::this_thread::sleep_for(std::chrono::duration<double>(idle_seconds));
    double share = (processor_seconds() - before) / idle_seconds;
    std::printf("idle: %.2f %% of a core (< 2 %%): %s\n", 100 * share, verdict(share < 0.02));
}

void run()
{
    Scenes scenes;
    PictureWindow window(Device::automatic, width, height);
    window.ask(scenes.edited(1), false);
    window.picture_of(window.generation(), true);
    RenderStatus status = window.status();
    std::printf("csg(%d), %dx%d, CPU and %s\n", primitives, width, height,
                status.gpu.empty() ? "no GPU" : status.gpu.c_str());
    measure_edits(window, scenes);
    measure_drag(window, scenes);
    measure_rest(window, scenes);
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
