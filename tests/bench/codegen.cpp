// From document to shader text: microseconds per node, and that they do not grow with the scene.
#include "codegen/glsl.h"
#include "graph/program.h"
#include "tests/bench/csg_scene.h"
#include "tests/bench/timing.h"

#include <algorithm>

namespace fieldwright::bench {
namespace {

struct Size {
    graph::Document document;
    std::vector<double> lowering, printing;  // s
    std::size_t bytes = 0;

    double nodes() const { return static_cast<double>(document.root.nodes.size()); }
};

Size make_size(int shapes, const std::shared_ptr<const graph::Library>& library)
{
    return {csg_document(csg_scene(shapes), library), {}, {}, 0};
}

std::string print(const graph::Program& program)
{
    return codegen::print_fragment_shader(program, program.block, codegen::Placement::literals);
}

// The same document must give the same text.
void measure(Size& size, const std::shared_ptr<const graph::Library>& library)
{
    graph::LowerOptions options{.cost_limit = 1'000'000};
    graph::Program program;
    std::string text;
    size.lowering.push_back(processor_seconds_of(CLOCK_THREAD_CPUTIME_ID,
                                                 [&] { program = graph::lower(size.document, library, options); }));
    size.printing.push_back(processor_seconds_of(CLOCK_THREAD_CPUTIME_ID, [&] { text = print(program); }));
    demand(program.problems.empty(), "the scene lowers without problems");
    demand(size.bytes == 0 || size.bytes == text.size(), "texts of the same document");
    size.bytes = text.size();
}

Times total_per_node(const Size& size)
{
    std::vector<double> total;
    for (std::size_t i = 0; i < size.lowering.size(); ++i) total.push_back(size.lowering[i] + size.printing[i]);
    Times times = summary(total);
    return {1e6 * times.minimum / size.nodes(), 1e6 * times.median / size.nodes()};
}

void print_row(const Size& size)
{
    Times total = total_per_node(size);
    std::printf("%8.0f %12.3f %12.3f %12.3f %12.3f %12.0f\n", size.nodes(),
                1e6 * summary(size.lowering).minimum / size.nodes(),
                1e6 * summary(size.printing).minimum / size.nodes(), total.minimum, total.median,
                static_cast<double>(size.bytes) / size.nodes());
}

void run()
{
    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    std::vector<Size> sizes;
    for (int shapes : {32, 332, 3332}) sizes.push_back(make_size(shapes, library));
    for (int i = 0; i < repetitions; ++i)
        for (Size& size : sizes) measure(size, library);

    std::printf("%8s %12s %12s %12s %12s %12s\n", "nodes", "lower us", "print us", "total us", "(median)", "bytes");
    std::printf("%8s %51s %12s\n", "", "each per node, minimum", "per node");
    for (const Size& size : sizes) print_row(size);
    Times small = total_per_node(sizes[1]), large = total_per_node(sizes[2]);
    double worst = std::max(small.minimum, large.minimum);
    double growth = large.minimum / small.minimum;
    std::printf("lowering plus printing, 1,000 to 10,000 nodes: %.2f us per node (<= 2): %s\n", worst,
                verdict(worst <= 2));
    std::printf("10,000 nodes against 1,000, per node: %.2fx, median %.2fx (linear: <= 1.2x): %s\n", growth,
                large.median / small.median, verdict(growth <= 1.2));
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
