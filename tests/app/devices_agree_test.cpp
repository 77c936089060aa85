// Every example, view and stereo mode on both devices: the same picture.
#include "graph/scene_file.h"
#include "renderer/devices.h"
#include "renderer/picture.h"
#include "tests/app/program.h"

#include <cstdlib>

namespace fieldwright::tests {
namespace {

using namespace renderer;

// Share of pixels with a channel more than 2/255 apart.
double share_apart(const Picture& a, const Picture& b)
{
    std::size_t apart = 0, pixels = a.rgb.size() / 3;
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
            if (std::abs(a.rgb[k] - b.rgb[k]) > 2) {
                ++apart;
                break;
            }
    return static_cast<double>(apart) / static_cast<double>(pixels);
}

struct Eyes {
    Frame centre, left, right;
};

template <typename Draw>
Eyes eyes(Draw draw)
{
    FrameRequest request{.width = 240, .height = 135, .time = 0.6f};
    request.layers = true;
    Eyes frames;
    frames.centre = draw(request);
    request.eye = Eye::left;
    frames.left = draw(request);
    request.eye = Eye::right;
    frames.right = draw(request);
    return frames;
}

Picture shown(const Eyes& eyes, View view, Stereo stereo, int step_limit)
{
    const Frame& left = stereo == Stereo::off ? eyes.centre : eyes.left;
    return picture(left, eyes.right, {.view = view, .stereo = stereo}, step_limit);
}

// Of pixels. A layer such as the shadow jumps from black to white where light fades in the picture.
double allowed_apart(const std::string& view)
{
    constexpr std::string_view strict[] = {"beauty", "steps", "normal", "depth", "id"};
    return std::find(std::begin(strict), std::end(strict), view) != std::end(strict) ? 0.001 : 0.005;
}

TEST(Devices, agree_on_every_example_view_and_stereo_mode)
{
    GpuDevice gpu;
    auto library = graph::Library::embedded();
    for (const auto& scene : example_scenes()) {
        graph::Program program = graph::lower(graph::open_scene(scene, *library), library);
        Eyes on_gpu = eyes([&](const FrameRequest& request) { return gpu.render(program, request); });
        Eyes on_cpu = eyes([&](const FrameRequest& request) { return render_on_cpu(program, request); });
        for (const std::string& view : view_names())
            for (const std::string& stereo : stereo_names()) {
                auto show = [&](const Eyes& frames) {
                    return shown(frames, *view_from_name(view), *stereo_from_name(stereo), program.march.step_limit);
                };
                EXPECT_LE(share_apart(show(on_gpu), show(on_cpu)), allowed_apart(view))
                    << scene.filename() << " " << view << " " << stereo;
            }
    }
}

}  // namespace
}  // namespace fieldwright::tests
