// Samples of a pixel: where they lie, what their mean comes to, and parts of a picture.
#include "renderer/samples.h"

#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec2;
using glm::vec3;

using Draw = std::function<Frame(const FrameRequest&)>;

Frame mean_of(const FrameRequest& request, const Exposure& exposure, const Draw& draw)
{
    Frame first = draw(request);
    Accumulator sums;
    for (int i = 0; i < sample_count(exposure); ++i) {
        FrameRequest sample = sample_of(request, exposure, i);
        Frame frame = draw(sample);
        lay_backdrop(frame, {0, 0, frame.width, frame.height}, exposure, drawn_area(sample));
        sums.add(frame, exposure);
    }
    sums.resolve(first, exposure);
    return first;
}

Draw on_cpu(const graph::Program& program)
{
    return [&](const FrameRequest& request) { return render_on_cpu(program, request); };
}

double mean_difference(const Frame& a, const Frame& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.colour.size(); ++i)
        for (int k = 0; k < 3; ++k) sum += std::abs(a.colour[i][k] - b.colour[i][k]);
    return sum / static_cast<double>(3 * a.colour.size());
}

// What glows white on a black sky, seen without perspective from z = 6: the picture is 2 m high.
Scene glowing(const std::function<NodeId(Scene&)>& make)
{
    Scene s;
    NodeId light = s.node("phong", {{"albedo", vec3(0)}, {"glow", vec3(1)}, {"emission", 1.0f}});
    NodeId output = s.show(s.node("paint", {{"d", make(s)}, {"material", light}}));
    NodeId camera = s.node("orthographic", {{"position", vec3(0, 0, 6)}, {"target", vec3(0)}, {"height", 2.0f}});
    s.wire(camera, output, "camera");
    s.wire(s.node("gradient", {{"strength", 0.0f}}), output, "sky");
    return s;
}

NodeId left_half(Scene& s) { return s.node("plane", {{"normal", vec3(1, 0, 0)}}); }
NodeId disc(Scene& s) { return s.node("sphere", {{"radius", 0.7f}}); }

TEST(Samples, begin_in_the_middle_of_pixel_lens_and_exposure)
{
    FrameRequest request{.width = 32, .height = 18, .time = 0.7f};
    EXPECT_EQ(sample_of(request, {.samples = 16, .shutter = 0.5f}, 0), request);
}

TEST(Samples, lie_evenly_in_the_pixel_and_within_lens_and_shutter)
{
    std::array<int, 16> in_cell{};
    vec2 on_lens(0);
    double time = 0;
    for (int i = 0; i < 64; ++i) {
        FrameRequest sample = sample_of({}, {.samples = 64, .shutter = 2}, i);
        vec2 cell = 4.0f * (sample.offset + 0.5f);
        ASSERT_TRUE(cell.x >= 0 && cell.x < 4 && cell.y >= 0 && cell.y < 4);
        ++in_cell[static_cast<std::size_t>(cell.x) + 4 * static_cast<std::size_t>(cell.y)];
        EXPECT_LE(glm::length(sample.lens), 1.0f);
        EXPECT_LE(std::abs(sample.time), 1.0f);
        on_lens += sample.lens / 64.0f;
        time += static_cast<double>(sample.time) / 64;
    }
    for (int count : in_cell) EXPECT_NEAR(count, 4, 2);
    EXPECT_LT(glm::length(on_lens), 0.05f);
    EXPECT_NEAR(time, 0, 0.05);
}

TEST(Samples, on_a_grid_are_the_middles_of_its_cells)
{
    Exposure exposure{.grid = 2};
    ASSERT_EQ(sample_count(exposure), 4);
    EXPECT_EQ(sample_of({}, exposure, 0).offset, vec2(-0.25f, -0.25f));
    EXPECT_EQ(sample_of({}, exposure, 3).offset, vec2(0.25f, 0.25f));
}

TEST(Samples, of_a_pixel_that_an_edge_halves_give_half)
{
    Scene scene = glowing(left_half);
    graph::Program program = scene.program();
    // Three pixels of 2 m; the edge runs through the middle one's centre.
    FrameRequest request{.width = 3, .height = 1};
    Frame grid = mean_of(request, {.grid = 16, .backdrop = graph::Backdrop::transparent}, on_cpu(program));
    EXPECT_EQ(grid.alpha, (std::vector<float>{1.0f, 0.5f, 0.0f}));
    EXPECT_NEAR(grid.colour[1].r, 0.5f, 1e-3f) << "multiplied by the share";
    Frame spread = mean_of(request, {.samples = 64, .backdrop = graph::Backdrop::transparent}, on_cpu(program));
    EXPECT_NEAR(spread.alpha[1], 0.5f, 0.03f);
    EXPECT_EQ(spread.alpha[0], 1.0f);
    EXPECT_EQ(spread.alpha[2], 0.0f);
    EXPECT_TRUE(mean_of(request, {.samples = 4}, on_cpu(program)).alpha.empty()) << "a sky is opaque";
}

TEST(Samples, converge_to_the_supersampled_picture)
{
    Scene scene = glowing(disc);
    graph::Program program = scene.program();
    FrameRequest request{.width = 24, .height = 16};
    Frame reference = mean_of(request, {.grid = 16}, on_cpu(program));
    auto off_by = [&](int samples) {
        return mean_difference(mean_of(request, {.samples = samples}, on_cpu(program)), reference);
    };
    double one = off_by(1), few = off_by(8), many = off_by(64);
    EXPECT_LT(few, 0.4 * one);
    EXPECT_LT(many, 0.4 * few);
    EXPECT_LT(many, 0.002);
}

TEST(Samples, are_the_same_on_both_devices)
{
    Scene scene = glowing(disc);
    graph::Program program = scene.program();
    GpuDevice gpu;
    FrameRequest request{.width = 48, .height = 32};
    Exposure exposure{.samples = 8};
    Frame cpu = mean_of(request, exposure, on_cpu(program));
    Frame drawn = mean_of(request, exposure, [&](const FrameRequest& sample) { return gpu.render(program, sample); });
    EXPECT_LE(share_apart(picture(cpu, View::beauty, 256), picture(drawn, View::beauty, 256)), 0.001);
    EXPECT_EQ(gpu.links(), 1) << "a sample is no new shader";
}

TEST(Samples, in_time_blur_what_moves)
{
    Scene scene = glowing([](Scene& s) {
        NodeId way = s.node("vector");
        s.wire(s.node("time"), way, "x");
        NodeId moved = s.node("translate", {{"d", disc(s)}});
        s.wire(way, moved, "offset");
        return moved;
    });
    graph::Program program = scene.program();
    FrameRequest request{.width = 48, .height = 16};
    auto greys = [&](float shutter) {
        Frame frame = mean_of(request, {.samples = 32, .shutter = shutter}, on_cpu(program));
        return std::count_if(frame.colour.begin(), frame.colour.end(),
                             [](const vec3& colour) { return colour.r > 0.05f && colour.r < 0.95f; });
    };
    EXPECT_GT(greys(0.8f), 2 * greys(0));
}

TEST(Backdrop, of_a_colour_is_seen_where_nothing_was_hit)
{
    Scene scene = glowing(left_half);
    Exposure exposure{.backdrop = graph::Backdrop::colour, .backdrop_colour = vec3(0.1f, 0.2f, 0.3f)};
    Frame frame = mean_of({.width = 3, .height = 1}, exposure, on_cpu(scene.program()));
    EXPECT_EQ(frame.colour[2], exposure.backdrop_colour);
    EXPECT_NEAR(frame.colour[0].r, 1.0f, 1e-3f);
}

TEST(Parts, of_a_picture_are_its_pixels_to_the_bit)
{
    Scene scene = glowing(disc);
    scene.node("sun");
    graph::Program program = scene.program();
    GpuDevice gpu;
    for (const Draw& draw :
         {on_cpu(program), Draw([&](const FrameRequest& request) { return gpu.render(program, request); })}) {
        FrameRequest request{.width = 61, .height = 37};
        request.offset = {0.3f, -0.2f};
        Frame whole = draw(request);
        for (Area part : {Area{0, 0, 61, 10}, Area{13, 9, 20, 28}, Area{60, 36, 1, 1}}) {
            request.part = part;
            Frame piece = draw(request);
            ASSERT_EQ(piece.width, part.width);
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x) {
                    auto at = static_cast<std::size_t>(y * part.width + x);
                    auto from = static_cast<std::size_t>((part.y + y) * 61 + part.x + x);
                    ASSERT_EQ(piece.colour[at], whole.colour[from]) << x << " " << y;
                    ASSERT_EQ(piece.depth[at], whole.depth[from]) << x << " " << y;
                }
        }
    }
}

}  // namespace
}  // namespace fieldwright::tests
