// Distance slices: points, distances and colours; both devices draw the same.
#include "renderer/devices.h"
#include "renderer/picture.h"
#include "renderer/slice_tile.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

constexpr int side = 120;

Scene ball_beside_a_box()
{
    Scene s;
    NodeId ball = s.node("translate", {{"d", s.node("sphere", {{"radius", 0.5f}})}, {"offset", vec3(-0.6f, 0.2f, 0)}});
    NodeId box = s.node("translate", {{"d", s.node("box")}, {"offset", vec3(0.7f, 0, 0.3f)}});
    s.show(s.node("union", {{"a", ball}, {"b", box}}));
    return s;
}

Scene ball(float radius = 1)
{
    Scene s;
    s.show(s.node("sphere", {{"radius", radius}}));
    return s;
}

FrameRequest request_of(SliceStyle style, const char* plane = "xy", float offset = 0)
{
    FrameRequest request{.width = side, .height = side};
    request.slice = slice_of(*graph::find_slice_plane(plane), offset);
    request.slice->style = style;
    return request;
}

std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x); }

TEST(Slice, holds_the_distance_of_every_point_of_its_plane)
{
    FrameRequest request = request_of(SliceStyle::sign, "yz", 0.25f);
    Frame frame = render_on_cpu(ball().program(), request);
    for (int y = 0; y < side; y += 7)
        for (int x = 0; x < side; x += 7) {
            vec3 point = slice_point(*request.slice, glm::vec2(x, y) + 0.5f, {side, side});
            EXPECT_NEAR(point.x, 0.25f, 1e-6f);
            EXPECT_NEAR(frame.depth[index(x, y)], glm::length(point) - 1, 1e-5f);
        }
}

TEST(Slice, is_seen_as_the_axis_views_see_it)
{
    // A picture's right and top, by the plane.
    const std::pair<const char*, std::pair<vec3, vec3>> planes[] = {
        {"xy", {{1, 0, 0}, {0, 1, 0}}}, {"yz", {{0, 0, -1}, {0, 1, 0}}}, {"zx", {{1, 0, 0}, {0, 0, -1}}}};
    for (const auto& [name, ways] : planes) {
        Slice slice = slice_of(*graph::find_slice_plane(name), 2);
        vec3 middle = slice_point(slice, {50, 50}, {100, 100});
        EXPECT_NEAR(glm::length(middle), 2, 1e-6f) << name;
        EXPECT_GT(glm::dot(slice_point(slice, {99, 50}, {100, 100}) - middle, ways.first), 1.9f) << name;
        EXPECT_GT(glm::dot(slice_point(slice, {50, 1}, {100, 100}) - middle, ways.second), 1.9f) << name;
    }
}

TEST(Slice, is_blue_inside_and_amber_outside_and_white_on_the_surface)
{
    Frame frame = render_on_cpu(ball().program(), request_of(SliceStyle::sign));
    vec3 middle = frame.colour[index(side / 2, side / 2)], corner = frame.colour[index(2, 2)];
    EXPECT_GT(middle.b, 1.5f * middle.r);
    EXPECT_GT(corner.r, 1.5f * corner.b);
    vec3 brightest(0);
    for (int x = 0; x < side; ++x) brightest = glm::max(brightest, frame.colour[index(x, side / 2)]);
    EXPECT_GT(glm::min(brightest.r, glm::min(brightest.g, brightest.b)), 0.7f);
}

TEST(Slice, has_darker_lines_where_the_distance_is_a_multiple_of_the_spacing)
{
    FrameRequest request = request_of(SliceStyle::sign);
    request.slice->spacing = 0.4f;
    Frame frame = render_on_cpu(ball().program(), request);
    auto brightness = [&](float distance) {
        std::size_t nearest = index(side / 2, side / 2);
        for (int x = side / 2; x < side; ++x)
            if (std::abs(frame.depth[index(x, side / 2)] - distance) < std::abs(frame.depth[nearest] - distance))
                nearest = index(x, side / 2);
        return glm::dot(frame.colour[nearest], vec3(1));
    };
    for (float line : {-0.4f, 0.4f, 0.8f})
        EXPECT_LT(brightness(line), 0.8f * std::min(brightness(line - 0.1f), brightness(line + 0.1f))) << line;
    EXPECT_GT(brightness(0.6f), 0.9f * std::min(brightness(0.5f), brightness(0.7f))) << "no line in between";
}

TEST(Grey, is_the_distance_either_side_by_a_gamma)
{
    FrameRequest request = request_of(SliceStyle::grey);
    Picture shown = picture(render_on_cpu(ball().program(), request), View::slice, 256);
    for (int x = 1; x < side; x += 5) {
        vec3 point = slice_point(*request.slice, glm::vec2(x, side / 2) + 0.5f, {side, side});
        float distance = std::abs(glm::length(point) - 1);
        float stored = std::pow(std::min(distance, 1.0f), 1 / 2.2f);
        EXPECT_NEAR(shown.rgb[3 * index(x, side / 2)], 255 * stored, 1.01f) << x;
    }
}

TEST(Contour, is_a_thin_line_at_the_surface_and_nothing_else)
{
    FrameRequest request = request_of(SliceStyle::contour);
    Frame frame = render_on_cpu(ball().program(), request);
    float pixel_m = request.slice->height / side;
    for (std::size_t i = 0; i < frame.colour.size(); ++i) {
        bool bright = frame.colour[i].g > 0.05f;
        EXPECT_TRUE(!bright || std::abs(frame.depth[i]) < 2 * pixel_m) << i;
        EXPECT_TRUE(bright || std::abs(frame.depth[i]) > 0.4f * pixel_m) << i;
    }
}

TEST(GradientError, is_dark_for_a_true_distance_and_bright_for_a_stretched_one)
{
    Frame exact = render_on_cpu(ball().program(), request_of(SliceStyle::gradient));
    Scene s;
    s.show(s.node("scale_axes", {{"d", s.node("sphere")}, {"factors", vec3(0.25f, 1, 1)}}));
    Frame stretched = render_on_cpu(s.program(), request_of(SliceStyle::gradient));
    auto apart = [](const Frame& frame) {
        std::size_t count = 0;
        vec3 dark = map_colour(ColourMap::viridis, 0.02f);
        for (const vec3& colour : frame.colour) count += glm::distance(colour, dark) > 0.02f ? 1 : 0;
        return static_cast<double>(count) / static_cast<double>(frame.colour.size());
    };
    EXPECT_LT(apart(exact), 0.1);  // the white surface, and the ball's middle
    EXPECT_GT(apart(stretched), 0.3);
}

TEST(Slice, is_the_same_on_both_devices_in_every_style_and_plane)
{
    GpuDevice gpu;
    graph::Program program = ball_beside_a_box().program();
    for (const graph::SlicePlane& plane : graph::slice_planes)
        for (const std::string& style : slice_style_names()) {
            FrameRequest request = request_of(*slice_style_from_name(style), plane.name, 0.1f);
            Picture on_cpu = picture(render_on_cpu(program, request), View::slice, 256);
            Picture on_gpu = picture(gpu.render(program, request), View::slice, 256);
            EXPECT_LE(share_apart(on_cpu, on_gpu), 0.005) << plane.name << " " << style;
        }
}

TEST(Lines, lie_at_round_distances)
{
    EXPECT_FLOAT_EQ(graph::line_spacing(4), 0.2f);
    EXPECT_FLOAT_EQ(graph::line_spacing(1.6f), 0.1f);
    EXPECT_FLOAT_EQ(graph::line_spacing(80), 5);
}

}  // namespace
}  // namespace fieldwright::tests
