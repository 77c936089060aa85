// What the window is told of the pictures that two devices draw.
#include "renderer/devices.h"
#include "renderer/picture_pass.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using namespace renderer;

PictureRequest small_request()
{
    Scene s;
    s.show(s.node("sphere"));
    PictureRequest request{.program = std::make_shared<const graph::Program>(s.program())};
    request.frame.width = 16, request.frame.height = 9;
    request.generation = 1;
    return request;
}

// The GPU takes over what the CPU drew, and shows it once more in another view before it has drawn anything.
TEST(RenderDesk, says_who_drew_a_picture_that_another_device_shows_again)
{
    RenderDesk desk([] {}, true, true);
    PictureRequest request = small_request();
    desk.put(request);
    Job first = *desk.wait_for_job(Device::gpu);
    FramePool frames;
    ASSERT_TRUE(PicturePass(desk, frames, Device::cpu, first, {1, false}).draw(draw_on_cpu));
    EXPECT_EQ(std::get<DrawnPicture>(*desk.take()).device, Device::cpu);

    request.display.view = View::normal;
    request.generation = 2;
    desk.put(request);
    Job second = *desk.wait_for_job(Device::gpu);
    ASSERT_TRUE(desk.claim(second));
    ASSERT_TRUE(show_again(desk, Device::gpu, second));
    auto again = std::get<DrawnPicture>(*desk.take());
    EXPECT_EQ(again.generation, 2u);
    EXPECT_EQ(again.device, Device::cpu);

    auto draw_as_gpu = [](Frame& frame, const graph::Program& program, const FrameRequest& of, const Watch& watch) {
        return draw_on_cpu(frame, program, of, watch);
    };
    ASSERT_TRUE(PicturePass(desk, frames, Device::gpu, second, {1, false}).draw(draw_as_gpu));
    EXPECT_EQ(std::get<DrawnPicture>(*desk.take()).device, Device::gpu);
}

}  // namespace
}  // namespace fieldwright::tests
