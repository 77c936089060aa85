// The CPU evaluator against the same scene printed as C++ and compiled for this processor: distances per second.
#include "field/evaluator.h"
#include "codegen/glsl.h"
#include "tests/bench/csg_scene.h"
#include "tests/bench/timing.h"

#include <dlfcn.h>
#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <thread>

namespace fieldwright::bench {
namespace {

constexpr int primitives = 100;
constexpr std::size_t point_count = 65536;

using Points = std::span<const glm::vec3>;

// A folder that goes with the benchmark.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "fieldwright_bench_XXXXXX").string();
        if (!mkdtemp(name.data())) throw graph::Failure(5, name + ": cannot make a temporary folder; set TMPDIR");
        path_ = name;
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const char* name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

// What field/CMakeLists.txt compiles the kernels with.
std::string compiler_flags()
{
    std::string flags =
        "-std=c++20 -O3 -fno-thread-jumps -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffinite-math-only "
        "-ffp-contract=off";
    std::string_view set = field::kernels().instruction_set;
    if (set == "avx2") flags += " -mavx2";
    if (set == "avx512") flags += " -mavx512f -mavx512dq -mavx512bw -mavx512vl -mprefer-vector-width=512";
    return flags;
}

const char* const cpp_head = R"(#include "field/dialect.h"
namespace scene {
namespace {
FIELDWRIGHT_DIALECT_TYPES
#include "field/dialect_functions.inc"
)";

const char* const cpp_tail = R"(}
}
extern "C" __attribute__((flatten)) void scene_row(
    float* __restrict result, const float* __restrict x, const float* __restrict y, const float* __restrict z, int count)
{
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) result[i] = scene::scene_distance(glm::vec3(x[i], y[i], z[i]));
}
)";

// All of the scene inlined into one loop over the points of a row; without names that others could see, nothing stops
// the compiler.
std::string scene_as_cpp(const graph::Program& program)
{
    return cpp_head + codegen::print_scene(program, program.block, codegen::Placement::literals) + cpp_tail;
}

// The scene as a shared library made by the system's compiler.
class CompiledScene {
public:
    explicit CompiledScene(const graph::Program& program)
    {
        std::ofstream(folder_.file("scene.cpp")) << scene_as_cpp(program);
        std::string command = std::string("${CXX:-c++} ") + compiler_flags() +
                              " -w -shared -fPIC -I'" FIELDWRIGHT_SOURCE_DIR "' '" + folder_.file("scene.cpp") +
                              "' -o '" + folder_.file("scene.so") + "'";
        if (std::system(command.c_str()) != 0) throw graph::Failure(1, "the scene's C++ does not compile: " + command);
        library_ = dlopen(folder_.file("scene.so").c_str(), RTLD_NOW);
        if (!library_) throw graph::Failure(1, dlerror());
        row_ = reinterpret_cast<Row>(dlsym(library_, "scene_row"));
    }
    ~CompiledScene() { dlclose(library_); }
    CompiledScene(const CompiledScene&) = delete;
    CompiledScene& operator=(const CompiledScene&) = delete;

    std::vector<float> distances(Points points) const
    {
        std::vector<float> result(points.size());
        float x[field::row_width], y[field::row_width], z[field::row_width];
        for (std::size_t first = 0; first < points.size(); first += field::row_width) {
            std::size_t count = std::min<std::size_t>(field::row_width, points.size() - first);
            for (std::size_t i = 0; i < count; ++i) {
                x[i] = points[first + i].x;
                y[i] = points[first + i].y;
                z[i] = points[first + i].z;
            }
            row_(result.data() + first, x, y, z, static_cast<int>(count));
        }
        return result;
    }

private:
    using Row = void (*)(float*, const float*, const float*, const float*, int);
    TemporaryFolder folder_;
    void* library_ = nullptr;
    Row row_ = nullptr;
};

std::vector<glm::vec3> random_points(float reach)
{
    Dice dice;
    std::vector<glm::vec3> points(point_count);
    for (glm::vec3& point : points)
        for (int axis = 0; axis < 3; ++axis) point[axis] = dice.between(-reach, reach);
    return points;
}

float largest_difference(const std::vector<float>& a, const std::vector<float>& b)
{
    float largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

// Processor seconds of each thread, the points shared among them.
template <typename Distances>
double seconds_on(int threads, Points points, const Distances& distances)
{
    double seconds = processor_seconds_of(CLOCK_PROCESS_CPUTIME_ID, [&] {
        std::size_t share = points.size() / static_cast<std::size_t>(threads);
        std::vector<std::jthread> workers;
        for (int i = 0; i < threads; ++i)
            workers.emplace_back([&, i] { distances(points.subspan(static_cast<std::size_t>(i) * share, share)); });
    });
    return seconds / threads;
}

void print_row(const char* name, int threads, const Times& times)
{
    double evaluations = static_cast<double>(point_count) / 1e6;
    std::printf("%-24s %7d %12.2f %12.2f %16.2f\n", name, threads, evaluations / times.minimum,
                evaluations / times.median, evaluations * primitives / times.minimum / 1e3);
}

void run()
{
    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    graph::Program program = graph::lower(csg_document(csg_scene(primitives), library), library);
    demand(program.problems.empty(), "the scene lowers without problems");
    std::vector<float> block = field::evaluate_frame(program, 0);
    program.block = block;
    CompiledScene compiled(program);
    std::vector<glm::vec3> points = random_points(4);
    auto by_evaluator = [&](Points share) { return field::distances(program, block, share); };
    auto by_compiler = [&](Points share) { return compiled.distances(share); };
    float difference = largest_difference(by_evaluator(points), by_compiler(points));
    demand(difference <= 1e-5f, "distances of the evaluator and of the compiled scene");

    std::printf("csg(%d), %zu points, %s, processor time; largest difference %.1e m\n", primitives, point_count,
                std::string(field::kernels().instruction_set).c_str(), static_cast<double>(difference));
    std::printf("%-24s %7s %12s %12s %16s\n", "", "threads", "Mevals/s", "(median)", "Gprim-evals/s");
    for (int threads : {1, 2}) {
        auto [evaluator, scene] = interleaved([&] { return seconds_on(threads, points, by_evaluator); },
                                              [&] { return seconds_on(threads, points, by_compiler); });
        print_row("evaluator", threads, evaluator);
        print_row("scene compiled as C++", threads, scene);
        double ratio = scene.minimum / evaluator.minimum;
        std::printf("evaluator against compiled, %d thread(s): %.2fx, median %.2fx (>= 0.6x): %s\n", threads, ratio,
                    scene.median / evaluator.median, verdict(ratio >= 0.6));
    }
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
