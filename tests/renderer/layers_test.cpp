// Layers: what they hold, and that they add up to the picture; and fog, which lies on all of them.
#include "graph/scene_file.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

std::vector<std::filesystem::path> examples()
{
    std::vector<std::filesystem::path> files;
    for (const auto& file : std::filesystem::directory_iterator(FIELDWRIGHT_SOURCE_DIR "/examples"))
        if (file.path().filename().string().ends_with(".scene.json")) files.push_back(file.path());
    std::sort(files.begin(), files.end());
    return files;
}

// Pixels whose colour, as a screen shows it, is more than 1/255 from the sum of the layers.
int pixels_off(const Frame& plain, const Frame& layered)
{
    Frame sum(plain.width, plain.height);
    for (std::size_t i = 0; i < sum.colour.size(); ++i) sum.colour[i] = layered.layers->colour(i);
    Picture a = picture(plain, View::beauty, 256), b = picture(sum, View::beauty, 256);
    int off = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) off += std::abs(a.rgb[i] - b.rgb[i]) > 1;
    return off;
}

class EveryExample : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(EveryExample, is_the_sum_of_its_layers_on_both_devices)
{
    auto library = graph::Library::embedded();
    graph::Document document = graph::open_scene(GetParam(), *library);
    document.fog.density = 0.02f;
    graph::Program program = graph::lower(document, library);
    GpuDevice gpu;
    FrameRequest request{.width = 96, .height = 54, .time = 0.6f}, layered = request;
    layered.layers = true;
    EXPECT_EQ(pixels_off(render_on_cpu(program, request), render_on_cpu(program, layered)), 0);
    EXPECT_EQ(pixels_off(gpu.render(program, request), gpu.render(program, layered)), 0);
}

INSTANTIATE_TEST_SUITE_P(Layers, EveryExample, testing::ValuesIn(examples()),
                         [](const auto& example) { return example.param.stem().stem().string(); });

// A ball of milky glass and a mirror over a floor.
Scene still_life()
{
    Scene s;
    auto painted = [&](NodeId field, NodeId material) {
        return s.node("paint", {{"d", field}, {"material", material}});
    };
    NodeId ball = s.node("translate", {{"d", s.node("sphere", {{"radius", 0.7f}})}, {"offset", vec3(-0.8f, 0.8f, 0)}});
    NodeId cube = s.node("translate", {{"d", s.node("box")}, {"offset", vec3(0.8f, 0.5f, 0)}});
    NodeId glowing = s.node("phong", {{"reflection", 0.5f}, {"emission", 0.2f}});
    NodeId things = s.node(
        "union", {{"a", painted(ball, s.node("glass", {{"transmission", 0.7f}}))}, {"b", painted(cube, glowing)}});
    s.wire(s.node("gradient"), s.show(s.node("union", {{"a", s.node("plane")}, {"b", things}})), "sky");
    s.node("sun");
    s.node("point");
    s.document.bounces = 2;
    return s;
}

FrameRequest with_layers()
{
    FrameRequest request{.width = 128, .height = 72};
    request.layers = true;
    return request;
}

TEST(Layers, of_mirrors_and_glass_add_up_to_the_picture)
{
    Scene scene = still_life();
    scene.document.fog.density = 0.05f;
    graph::Program program = scene.program();
    FrameRequest plain = with_layers();
    plain.layers = false;
    GpuDevice gpu;
    Frame layered = render_on_cpu(program, with_layers());
    EXPECT_GT(std::count_if(layered.layers->reflection.begin(), layered.layers->reflection.end(),
                            [](const vec3& light) { return light.g > 0.1f; }),
              200);
    EXPECT_EQ(pixels_off(render_on_cpu(program, plain), layered), 0);
    EXPECT_EQ(pixels_off(gpu.render(program, plain), gpu.render(program, with_layers())), 0);
}

TEST(Layers, are_the_same_on_both_devices)
{
    graph::Program program = still_life().program();
    GpuDevice gpu;
    Frame a = render_on_cpu(program, with_layers()), b = gpu.render(program, with_layers());
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        auto near = [](float x, float y) { return std::abs(x - y) <= 0.004f * (1 + std::abs(x)); };
        auto alike = [&](const std::vector<vec3>& x, const std::vector<vec3>& y) {
            return near(x[i].r, y[i].r) && near(x[i].g, y[i].g) && near(x[i].b, y[i].b);
        };
        const Layers &l = *a.layers, &m = *b.layers;
        bool same = alike(l.ambient, m.ambient) && alike(l.diffuse, m.diffuse) && alike(l.specular, m.specular) &&
                    alike(l.reflection, m.reflection) && alike(l.emission, m.emission) && alike(l.albedo, m.albedo) &&
                    alike(l.position, m.position) && alike(a.normal, b.normal) && near(l.shadow[i], m.shadow[i]) &&
                    near(l.occlusion[i], m.occlusion[i]) && near(l.gradient_length[i], m.gradient_length[i]) &&
                    near(l.minimum_cone_ratio[i], m.minimum_cone_ratio[i]) && l.shadow_steps[i] == m.shadow_steps[i] &&
                    a.steps[i] == b.steps[i] && a.node_id[i] == b.node_id[i] && a.material_id[i] == b.material_id[i] &&
                    a.exhausted[i] == b.exhausted[i];
        apart += same ? 0 : 1;
    }
    EXPECT_LE(static_cast<double>(apart), 0.005 * static_cast<double>(a.colour.size()));
}

TEST(Layers, hold_what_their_names_say)
{
    Scene s;
    NodeId material = s.node("phong", {{"albedo", vec3(0.3f, 0.6f, 0.9f)}, {"specular", 0.0f}});
    NodeId floor = s.node("paint", {{"d", s.node("plane")}, {"material", material}});
    NodeId roof =
        s.node("translate", {{"d", s.node("box", {{"half_size", vec3(4, 0.1f, 4)}})}, {"offset", vec3(-4, 3, 0)}});
    s.show(s.node("union", {{"a", floor}, {"b", roof}}));
    s.node("sun", {{"elevation", 90.0f}, {"colour", vec3(1)}, {"intensity", 1.0f}});
    FrameRequest request = with_layers();
    request.camera = ViewCamera{.position = {0, 1, 5}, .target = {0, 0, 0}};
    Frame frame = render_on_cpu(s.program(), request);
    const Layers& layers = *frame.layers;
    int lit = 0, shadowed = 0;
    for (std::size_t i = 0; i < frame.colour.size(); ++i) {
        vec3 at = layers.position[i];
        if (frame.material_id[i] != static_cast<int>(material.number) || std::abs(at.x) < 0.05f ||
            std::max(std::abs(at.x), std::abs(at.z)) > 3)
            continue;
        bool in_shadow = at.x < 0;
        (in_shadow ? shadowed : lit)++;
        ASSERT_NEAR(at.y, 0, 1e-3f);
        ASSERT_NEAR(layers.shadow[i], in_shadow ? 0.0f : 1.0f, 1e-6f) << at.x;
        ASSERT_NEAR(layers.diffuse[i].g, in_shadow ? 0.0f : 0.6f, 1e-3f);
        ASSERT_EQ(layers.albedo[i], vec3(0.3f, 0.6f, 0.9f));
        ASSERT_NEAR(layers.gradient_length[i], 1, 5e-3f);
        ASSERT_GT(layers.shadow_steps[i], 0);
    }
    EXPECT_GT(std::min(lit, shadowed), 300);
}

TEST(Layers, of_nothing_are_its_sky)
{
    Scene s;
    s.wire(s.node("gradient"), s.node("output"), "sky");
    Frame frame = render_on_cpu(s.program(), with_layers());
    for (std::size_t i = 0; i < frame.colour.size(); ++i) {
        ASSERT_EQ(frame.layers->emission[i], frame.colour[i]);
        ASSERT_EQ(frame.layers->shadow[i], 1);
        ASSERT_EQ(frame.layers->occlusion[i], 1);
        ASSERT_EQ(frame.layers->albedo[i], vec3(0));
    }
}

TEST(Frame, has_layers_only_when_they_are_asked_for)
{
    graph::Program program = still_life().program();
    GpuDevice gpu;
    FrameRequest request{.width = 16, .height = 16};
    EXPECT_FALSE(render_on_cpu(program, request).layers);
    EXPECT_FALSE(gpu.render(program, request).layers);
    EXPECT_EQ(gpu.shader_text(program, {}).find("shadow_steps"), std::string::npos);
    request.layers = true;
    EXPECT_TRUE(gpu.render(program, request).layers);
}

// A white wall that glows, 6 m away.
vec3 wall_in_fog(const graph::FogSettings& fog, float height)
{
    Scene s;
    NodeId glow = s.node("phong", {{"albedo", vec3(0)}, {"specular", 0.0f}, {"emission", 1.0f}});
    s.show(s.node("paint", {{"d", s.node("plane", {{"normal", vec3(0, 0, 1)}})}, {"material", glow}}));
    s.document.fog = fog;
    FrameRequest request{.width = 1, .height = 1};
    request.camera = ViewCamera{.position = {0, height, 6}, .target = {0, height, 0}, .orthographic_height = 1e-3f};
    return render_on_cpu(s.program(), request).colour[0];
}

TEST(Fog, takes_light_away_by_the_law_of_beer_and_lambert_from_its_start)
{
    const vec3 colour(0.1f, 0.2f, 0.3f);
    for (float start : {0.0f, 2.0f, 9.0f}) {
        double through = std::exp(-0.25 * std::max(6.0 - start, 0.0));
        vec3 wall = wall_in_fog({.colour = colour, .density = 0.25f, .start = start}, 0);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(wall[k], through + (1 - through) * colour[k], 1e-3) << start;
    }
}

TEST(Fog, thins_out_with_height)
{
    graph::FogSettings fog{.colour = vec3(0), .density = 0.25f, .height_falloff = 0.5f};
    for (float height : {0.0f, 1.0f, 4.0f})
        EXPECT_NEAR(wall_in_fog(fog, height).r, std::exp(-0.25 * 6 * std::exp(-0.5 * height)), 1e-3) << height;
}

// Straight up the integral of the density has an end.
TEST(Fog, lets_the_sky_through_where_it_ends)
{
    Scene s;
    s.wire(s.node("gradient", {{"zenith", vec3(1)}}), s.node("output"), "sky");
    s.document.fog = {.colour = vec3(0), .density = 0.25f, .height_falloff = 0.5f};
    FrameRequest request{.width = 1, .height = 1};
    request.camera =
        ViewCamera{.position = {0, 0, 0}, .target = {0, 1, 0}, .up = {0, 0, 1}, .field_of_view_rad = 0.01f};
    EXPECT_NEAR(render_on_cpu(s.program(), request).colour[0].r, std::exp(-0.25 / 0.5), 1e-3);
}

}  // namespace
}  // namespace fieldwright::tests
