// Random documents over all node types, own types and groups: every one compiles everywhere and means the same on both
// machines.
// FIELDWRIGHT_SOAK=1 takes 20,000 of them.
#include "codegen/glsl.h"
#include "graph/group_rules.h"
#include "graph/scene_file.h"
#include "tests/support/fields.h"
#include "tests/support/glslang.h"
#include "tests/support/random_scene.h"

#include <gtest/gtest.h>
#include <cstdlib>

namespace fieldwright::tests {
namespace {

std::uint64_t graph_count() { return std::getenv("FIELDWRIGHT_SOAK") ? 20'000 : 3'000; }

constexpr std::size_t point_count = 1024;

TEST(RandomGraphs, have_all_that_a_document_may_have)
{
    SceneGrower grower;
    std::set<std::string> own;
    int groups = 0, in_groups = 0, exposing = 0, used_twice = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        graph::Document document = grower.grown(seed).scene.document;
        for (const graph::OwnType& type : document.own_types) own.insert(type.name);
        for (const graph::Group& group : document.groups) {
            ++groups;
            in_groups += graph::groups_used_by(group.graph).empty() ? 0 : 1;
            exposing += group.exposed.empty() ? 0 : 1;
            used_twice += graph::uses_of(document, group.name) > 1 ? 1 : 0;
        }
    }
    EXPECT_GE(own.size(), 5u) << "of " << grower.twins().size();
    EXPECT_GE(groups, 60);
    EXPECT_GE(in_groups, 5);
    EXPECT_GE(exposing, 40);
    EXPECT_GE(used_twice, 10);
}

TEST(RandomGraphs, are_valid_and_survive_saving)
{
    SceneGrower grower;
    auto library = graph::Library::embedded();
    for (std::uint64_t seed = 0; seed < graph_count(); ++seed) {
        Scene scene = grower.grown(seed).scene;
        ASSERT_EQ(graph::validate(scene.document, *scene.library), std::nullopt) << "seed " << seed;
        ASSERT_EQ(graph::groups_error(scene.document, *scene.library), std::nullopt) << "seed " << seed;
        graph::Document read = graph::read_scene(graph::write_scene(scene.document, *scene.library), *library);
        ASSERT_TRUE(read == scene.document) << "seed " << seed;
    }
}

TEST(RandomGraphs, compile_under_glslang)
{
    SceneGrower grower;
    std::vector<std::string> shaders;
    for (std::uint64_t seed = 0; seed < graph_count(); ++seed) {
        Scene scene = grower.grown(seed).scene;
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
    SceneGrower grower;
    renderer::GpuDevice gpu;
    std::size_t compared = 0;
    for (std::uint64_t seed = GetParam(); seed < graph_count(); seed += part_count) {
        RandomScene random_scene = grower.grown(seed);
        Field field(random_scene.twin.program());
        graph::Program on_gpu = random_scene.scene.program();
        Random random(seed);
        std::vector<glm::vec3> points = sample_points(random, point_count);
        Agreement agreement = compare_machines(field, points, gpu.distances(on_gpu, field.time, points));
        EXPECT_EQ(agreement.differing, 0u) << "seed " << seed << " " << agreement.worst;
        compared += agreement.compared;
    }
    EXPECT_GE(compared, graph_count() / part_count * point_count * 8 / 10);
}

TEST(RandomGraphs, give_the_same_distances_on_every_instruction_set)
{
    SceneGrower grower;
    int count = 0;
    const field::KernelTable* const* tables = field::runnable_kernels(count);
    for (std::uint64_t seed = 0; seed < graph_count(); ++seed) {
        Field field(grower.grown(seed).twin.program());
        Random random(seed);
        std::vector<glm::vec3> points = sample_points(random, point_count);
        std::vector<float> widest = field::distances(field.program, field.block, points, *tables[0]);
        for (int i = 1; i < count; ++i)
            EXPECT_EQ(widest, field::distances(field.program, field.block, points, *tables[i])) << "seed " << seed;
    }
}

}  // namespace
}  // namespace fieldwright::tests
