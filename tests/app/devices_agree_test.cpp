// Every example and seed scene, in every view, on both devices: the same picture.
#include "graph/scene_file.h"
#include "renderer/slice.h"
#include "tests/app/program.h"
#include "tests/support/pictures.h"

#include <algorithm>

namespace fieldwright::tests {
namespace {

using namespace renderer;

// Of pixels. What most of the work goes into is held to less in the examples, which are larger here than the seeds.
constexpr double allowed_apart = 0.005, allowed_apart_in_examples = 0.001;

double allowed_in_examples(const std::string& view)
{
    constexpr std::string_view strict[] = {"beauty", "steps", "normal", "depth", "id"};
    bool is_strict = std::find(std::begin(strict), std::end(strict), view) != std::end(strict);
    return is_strict ? allowed_apart_in_examples : allowed_apart;
}

std::vector<std::filesystem::path> every_scene()
{
    std::vector<std::filesystem::path> scenes;
    for (const auto& file : std::filesystem::recursive_directory_iterator(source_folder() / "examples"))
        if (file.path().string().ends_with(".scene.json")) scenes.push_back(file.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

class EveryScene : public testing::TestWithParam<std::filesystem::path> {
protected:
    bool is_seed() const { return GetParam().parent_path().filename() == "seeds"; }
    FrameRequest request() const
    {
        return is_seed() ? FrameRequest{.width = 160, .height = 90, .time = 0.6f}
                         : FrameRequest{.width = 240, .height = 135, .time = 0.6f};
    }

    std::shared_ptr<const graph::Library> library_ = graph::Library::embedded();
    graph::Program program_ = graph::lower(graph::open_scene(GetParam(), *library_), library_);
    GpuDevice gpu_;
};

TEST_P(EveryScene, is_the_same_on_both_devices_in_every_view)
{
    FrameRequest layered = request();
    layered.layers = true;
    Frame on_cpu = render_on_cpu(program_, layered), on_gpu = gpu_.render(program_, layered);
    for (const std::string& name : view_names()) {
        View view = *view_from_name(name);
        int step_limit = program_.march.step_limit;
        EXPECT_LE(share_apart(picture(on_cpu, view, step_limit), picture(on_gpu, view, step_limit)),
                  is_seed() ? allowed_apart : allowed_in_examples(name))
            << name;
    }
}

TEST_P(EveryScene, is_the_same_on_both_devices_as_a_slice_in_every_style)
{
    FrameRequest plane{.width = 160, .height = 90, .time = 0.6f};
    for (const std::string& style : slice_style_names()) {
        plane.slice = slice_of(*graph::find_slice_plane("xy"), 0.1f);
        plane.slice->style = *slice_style_from_name(style);
        Picture on_cpu = picture(render_on_cpu(program_, plane), View::slice, program_.march.step_limit);
        Picture on_gpu = picture(gpu_.render(program_, plane), View::slice, program_.march.step_limit);
        EXPECT_LE(share_apart(on_cpu, on_gpu), allowed_apart) << style;
    }
}

// Of an example: mixing needs no devices, but both eyes do.
class EveryExample : public EveryScene {};

TEST_P(EveryExample, is_the_same_on_both_devices_in_every_stereo_mode)
{
    FrameRequest left = request(), right = left;
    left.eye = Eye::left, right.eye = Eye::right;
    Frame cpu_left = render_on_cpu(program_, left), cpu_right = render_on_cpu(program_, right);
    Frame gpu_left = gpu_.render(program_, left), gpu_right = gpu_.render(program_, right);
    for (const std::string& name : stereo_names()) {
        Display display{.stereo = *stereo_from_name(name)};
        int step_limit = program_.march.step_limit;
        EXPECT_LE(share_apart(picture(cpu_left, cpu_right, display, step_limit),
                              picture(gpu_left, gpu_right, display, step_limit)),
                  allowed_apart)
            << name;
    }
}

// Rays that graze a surface end a step sooner on one device than on the other.
TEST_P(EveryExample, is_drawn_by_as_many_evaluations_on_both_devices)
{
    for (bool layers : {false, true}) {
        FrameRequest counted = request();
        counted.layers = layers, counted.counts = true;
        Frame on_gpu = gpu_.render(program_, counted), on_cpu = render_on_cpu(program_, counted);
        ASSERT_GT(on_cpu.evaluations, 0);
        EXPECT_NEAR(static_cast<double>(on_gpu.evaluations) / static_cast<double>(on_cpu.evaluations), 1, 0.001);
    }
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& scene)
{
    return "scene_" + scene.param.stem().stem().string();
}

INSTANTIATE_TEST_SUITE_P(Devices, EveryScene, testing::ValuesIn(every_scene()), name_of);
INSTANTIATE_TEST_SUITE_P(Devices, EveryExample, testing::ValuesIn(example_scenes()), name_of);

}  // namespace
}  // namespace fieldwright::tests
