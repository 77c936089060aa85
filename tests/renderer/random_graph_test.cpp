// Random documents over all node types: every one compiles everywhere and means the same on both machines.
// FIELDWRIGHT_SOAK=1 takes 20,000 of them.
#include "codegen/glsl.h"
#include "graph/scene_file.h"
#include "tests/support/fields.h"
#include "tests/support/glslang.h"

#include <gtest/gtest.h>
#include <cstdlib>

namespace fieldwright::tests {
namespace {

std::uint64_t graph_count() { return std::getenv("FIELDWRIGHT_SOAK") ? 20'000 : 3'000; }

constexpr std::size_t point_count = 1024;

TEST(RandomGraphs, are_valid_and_survive_saving)
{
    auto library = graph::Library::embedded();
    for (std::uint64_t seed = 0; seed < graph_count(); ++seed) {
        Scene scene = random_graph(seed, library);
        ASSERT_EQ(graph::validate(scene.document, *library), std::nullopt) << "seed " << seed;
        graph::Document read = graph::read_scene(graph::write_scene(scene.document, *library), *library);
        ASSERT_TRUE(read == scene.document) << "seed " << seed;
    }
}

TEST(RandomGraphs, compile_under_glslang)
{
    auto library = graph::Library::embedded();
    std::vector<std::string> shaders;
    for (std::uint64_t seed = 0; seed < graph_count(); ++seed) {
        Scene scene = random_graph(seed, library);
        graph::Program program = scene.program();
        std::vector<float> block = field::evaluate_frame(program, 0.6f);
        if (seed % 4 == 3) shaders.push_back(codegen::print_export(program, scene.document, block, "glsl"));
        else {
            auto placement = seed % 2 == 0 ? codegen::Placement::literals : codegen::Placement::buffer;
            shaders.push_back(codegen::print_fragment_shader(program, block, placement));
        }
        if (shaders.size() < 1000 && seed + 1 < graph_count()) continue;
        ASSERT_EQ(glslang_errors(shaders), "") << "seeds up to " << seed;
        shaders.clear();
    }
}

// Shaders take long to compile: in parts, so that all cores take part and none takes too long.
constexpr std::uint64_t part_count = 8;

class RandomGraphsInParts : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Part, RandomGraphsInParts, testing::Range(std::uint64_t{0}, part_count));

TEST_P(RandomGraphsInParts, give_the_same_distances_on_both_machines)
{
    auto library = graph::Library::embedded();
    renderer::GpuDevice gpu;
    std::size_t compared = 0;
    for (std::uint64_t seed = GetParam(); seed < graph_count(); seed += part_count) {
        Field field(random_graph(seed, library).program());
        Random random(seed);
        std::vector<glm::vec3> points = sample_points(random, point_count);
        Agreement agreement = compare_machines(field, points, gpu.distances(field.program, field.time, points));
        EXPECT_EQ(agreement.differing, 0u) << "seed " << seed << " " << agreement.worst;
        compared += agreement.compared;
    }
    EXPECT_GE(compared, graph_count() / part_count * point_count * 8 / 10);
}

TEST(RandomGraphs, give_the_same_distances_on_every_instruction_set)
{
    auto library = graph::Library::embedded();
    int count = 0;
    const field::KernelTable* const* tables = field::runnable_kernels(count);
    for (std::uint64_t seed = 0; seed < graph_count(); ++seed) {
        Field field(random_graph(seed, library).program());
        Random random(seed);
        std::vector<glm::vec3> points = sample_points(random, point_count);
        std::vector<float> widest = field::distances(field.program, field.block, points, *tables[0]);
        for (int i = 1; i < count; ++i)
            EXPECT_EQ(widest, field::distances(field.program, field.block, points, *tables[i])) << "seed " << seed;
    }
}

}  // namespace
}  // namespace fieldwright::tests
