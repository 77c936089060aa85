// A thousand sizes of a window: neither memory nor objects of the driver are left behind.
#include "renderer/devices.h"
#include "renderer/render_thread.h"
#include "tests/support/pictures.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <chrono>
#include <fstream>
#include <thread>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int sizes = 1000, settled = 100;  // sizes after which everything has been as large as it gets

std::shared_ptr<const graph::Program> one_ball()
{
    Scene s;
    s.show(s.node("sphere"));
    return std::make_shared<const graph::Program>(s.program());
}

// All different for a while, large and small in turn.
FrameRequest size_of(int i)
{
    FrameRequest request;
    request.width = 32 + 7 * (i % 13);
    request.height = 90 - 5 * (i % 11);
    return request;
}

double resident_megabytes()
{
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

bool draw(RenderThread& thread, PictureRequest request)
{
    thread.request(request);
    for (auto until = Clock::now() + 60s; Clock::now() < until;) {
        thread.wait(request.generation, 1);
        std::optional<RenderResult> result = thread.poll();
        auto* drawn = result ? std::get_if<DrawnPicture>(&*result) : nullptr;
        if (drawn && drawn->final && drawn->generation == request.generation) return true;
    }
    return false;
}

TEST(ManySizes, leave_no_memory_behind_in_the_render_thread)
{
    std::shared_ptr<const graph::Program> program = one_ball();
    for (Device device : {Device::cpu, Device::gpu}) {
        RenderThread thread({.device = device});
        double before = 0;
        for (int i = 0; i < sizes; ++i) {
            PictureRequest request{.program = program, .frame = size_of(i)};
            request.generation = static_cast<std::uint64_t>(i) + 1;
            ASSERT_TRUE(draw(thread, request)) << "size " << i;
            if (i == settled) before = resident_megabytes();
        }
        EXPECT_LT(resident_megabytes() - before, 4) << "MB more after 900 sizes";
        EXPECT_LE(thread.status().links, 1);
    }
}

// Of every kind in the current context.
int living_objects()
{
    constexpr GLuint names = 20'000;
    int living = 0;
    for (GLuint name = 1; name < names; ++name)
        for (auto is : {glIsTexture, glIsBuffer, glIsFramebuffer, glIsVertexArray, glIsProgram, glIsShader})
            living += is(name) == GL_TRUE;
    return living;
}

TEST(ManySizes, leave_no_objects_of_the_driver_behind)
{
    std::shared_ptr<const graph::Program> program = one_ball();
    GpuDevice gpu;
    int before = 0;
    for (int i = 0; i < sizes; ++i) {
        gpu.render(*program, size_of(i));
        if (i == settled) before = living_objects();
    }
    EXPECT_GT(before, 0);
    EXPECT_EQ(living_objects(), before);
}

}  // namespace
}  // namespace fieldwright::tests
