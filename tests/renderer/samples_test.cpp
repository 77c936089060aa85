// Samples of a pixel: where they lie, what their mean comes to, and parts of a picture.
#include "renderer/samples.h"
#include "renderer/rows.h"

#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <set>

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
        Frame frame(first.width, first.height, request.layers);
        draw_sample(frame, request, exposure, i, [&](Frame& to, const FrameRequest& sample) {
            to = draw(sample);
            return true;
        });
        lay_backdrop(frame, {0, 0, frame.width, frame.height}, exposure, drawn_area(request));
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

// Without perspective from z = 6: the picture is 2 m high.
NodeId flat_view(Scene& s)
{
    return s.node("orthographic", {{"position", vec3(0, 0, 6)}, {"target", vec3(0)}, {"height", 2.0f}});
}

// What glows white on a black sky.
Scene glowing(const std::function<NodeId(Scene&)>& make, const std::function<NodeId(Scene&)>& view = flat_view)
{
    Scene s;
    NodeId light = s.node("phong", {{"albedo", vec3(0)}, {"glow", vec3(1)}, {"emission", 1.0f}});
    NodeId output = s.show(s.node("paint", {{"d", make(s)}, {"material", light}}));
    s.wire(view(s), output, "camera");
    s.wire(s.node("gradient", {{"strength", 0.0f}}), output, "sky");
    return s;
}

NodeId left_half(Scene& s) { return s.node("plane", {{"normal", vec3(1, 0, 0)}}); }
NodeId disc(Scene& s) { return s.node("sphere", {{"radius", 0.7f}}); }

NodeId moving_disc(Scene& s)
{
    NodeId way = s.node("vector");
    s.wire(s.node("time"), way, "x");
    NodeId moved = s.node("translate", {{"d", disc(s)}});
    s.wire(way, moved, "offset");
    return moved;
}

// A lens 1 m wide that is focused at 1.5 m: what is at z = 0 shows a blur of 1.7 m.
NodeId wide_lens(Scene& s)
{
    return s.node("perspective", {{"position", vec3(0, 0, 4)},
                                  {"target", vec3(0)},
                                  {"field_of_view", 20.0f},
                                  {"aperture", 1.0f},
                                  {"focus_distance", 1.5f}});
}

NodeId wall(Scene& s)
{
    NodeId box = s.node("box", {{"half_size", vec3(2, 3, 0.1f)}});
    return s.node("translate", {{"d", box}, {"offset", vec3(-2, 0, 0)}});
}

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
    Scene scene = glowing(moving_disc);
    graph::Program program = scene.program();
    FrameRequest request{.width = 48, .height = 16};
    auto greys = [&](float shutter) {
        Frame frame = mean_of(request, {.samples = 32, .shutter = shutter}, on_cpu(program));
        return std::count_if(frame.colour.begin(), frame.colour.end(),
                             [](const vec3& colour) { return colour.r > 0.05f && colour.r < 0.95f; });
    };
    EXPECT_GT(greys(0.8f), 2 * greys(0));
}

TEST(Samples, in_time_are_four_times_as_many_among_neighbours)
{
    std::set<float> moments;
    std::size_t pixels = 0;
    FrameRequest request{.width = 7, .height = 5, .time = 0.25f};
    mean_of(request, {.samples = 8, .shutter = 0.5f}, [&](const FrameRequest& sample) {
        DrawnPixels drawn = drawn_pixels(sample);
        moments.insert(sample.time);
        EXPECT_LE(std::abs(sample.time - 0.25f), 0.25f);
        pixels += static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(drawn.height);
        return Frame(drawn.width, drawn.height);
    });
    EXPECT_EQ(moments.size(), 1u + 4 * 7u);
    EXPECT_EQ(pixels, 35u * (1 + 8)) << "the picture itself, and each sample once";
}

// The angle by which a pixel turns its lens, in radians.
float lens_angle(int x, int y)
{
    Rows pixel(2), turn(1);
    pixel.fill(0, static_cast<float>(x));
    pixel.fill(1, static_cast<float>(y));
    RowFunction("lens_turn", field::kernels())(turn, 1, pixel);
    return 6.2831853f * turn.lane(0)[0];
}

// As if all pixels took the same samples of the lens: each is drawn alone, turned back.
std::vector<float> with_one_sequence(const graph::Program& program, const FrameRequest& request, int samples)
{
    std::vector<float> result;
    for (int y = 0; y < request.height; ++y)
        for (int x = 0; x < request.width; ++x) {
            float angle = lens_angle(x, request.height - 1 - y), sum = 0;
            for (int i = 0; i < samples; ++i) {
                FrameRequest sample = sample_of(request, {.samples = samples}, i);
                const vec2 lens = sample.lens, turned(std::cos(angle), -std::sin(angle));
                sample.lens = {turned.x * lens.x - turned.y * lens.y, turned.y * lens.x + turned.x * lens.y};
                sample.part = Area{x, y, 1, 1};
                sum += render_on_cpu(program, sample).colour[0].g;
            }
            result.push_back(sum / static_cast<float>(samples));
        }
    return result;
}

struct Errors {
    double mean = 0;           // of their sizes
    double of_neighbours = 0;  // correlation of those of pixels above each other
};

Errors errors(const std::vector<float>& values, const Frame& reference)
{
    auto width = static_cast<std::size_t>(reference.width);
    std::vector<double> off;
    for (std::size_t i = 0; i < values.size(); ++i) off.push_back(values[i] - reference.colour[i].g);
    double sizes = 0, squares = 0, products = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
        sizes += std::abs(off[i]);
        if (i < width) continue;
        squares += 0.5 * (off[i] * off[i] + off[i - width] * off[i - width]);
        products += off[i] * off[i - width];
    }
    return {sizes / static_cast<double>(off.size()), products / squares};
}

TEST(Samples, of_a_wide_lens_make_no_edges_that_all_pixels_share)
{
    graph::Program program = glowing(wall, wide_lens).program();
    FrameRequest request{.width = 32, .height = 8};
    Frame reference = mean_of(request, {.samples = 1024}, on_cpu(program));
    Frame few = mean_of(request, {.samples = 16}, on_cpu(program));
    std::vector<float> own;
    for (const vec3& colour : few.colour) own.push_back(colour.g);
    Errors with_one = errors(with_one_sequence(program, request, 16), reference), with_own = errors(own, reference);
    EXPECT_LE(with_own.mean, with_one.mean);
    EXPECT_LT(with_own.mean, 0.02);
    EXPECT_GT(with_one.of_neighbours, 0.9) << "the same steps in all rows";
    EXPECT_LT(with_own.of_neighbours, 0.3);
    EXPECT_EQ(few.colour, mean_of(request, {.samples = 16}, on_cpu(program)).colour);
}

TEST(Samples, of_lens_and_shutter_are_the_same_on_both_devices)
{
    graph::Program program = glowing(moving_disc, wide_lens).program();
    GpuDevice gpu;
    FrameRequest request{.width = 49, .height = 31};
    Exposure exposure{.samples = 6, .shutter = 0.4f};
    Frame cpu = mean_of(request, exposure, on_cpu(program));
    Frame drawn = mean_of(request, exposure, [&](const FrameRequest& sample) { return gpu.render(program, sample); });
    EXPECT_LE(share_apart(picture(cpu, View::beauty, 256), picture(drawn, View::beauty, 256)), 0.001);
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

TEST(Parts, of_a_picture_with_lens_and_shutter_are_its_pixels_too)
{
    graph::Program program = glowing(moving_disc, wide_lens).program();
    GpuDevice gpu;
    Exposure exposure{.samples = 3, .shutter = 0.4f};
    for (const Draw& draw :
         {on_cpu(program), Draw([&](const FrameRequest& request) { return gpu.render(program, request); })}) {
        FrameRequest request{.width = 61, .height = 37};
        Frame whole = mean_of(request, exposure, draw);
        for (Area part : {Area{13, 9, 20, 27}, Area{60, 36, 1, 1}}) {
            request.part = part;
            Frame piece = mean_of(request, exposure, draw);
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x)
                    ASSERT_EQ(piece.colour[static_cast<std::size_t>(y * part.width + x)],
                              whole.colour[static_cast<std::size_t>((part.y + y) * 61 + part.x + x)])
                        << x << " " << y;
        }
    }
}

}  // namespace
}  // namespace fieldwright::tests
