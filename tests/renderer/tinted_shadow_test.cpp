// Shadows of glass against Beer and Lambert's law and Schlick's formula, and that edges and what stands behind glass stay.
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

constexpr int columns = 200;
constexpr float seen_width = 2;  // m of the floor, from x = -1
constexpr float clear = 1.5f;    // refraction index
const vec3 bottle(0.3f, 0.7f, 0.5f);
constexpr float depth = 0.4f;  // m of glass that leave that colour

float x_of(int column) { return -1 + seen_width * (static_cast<float>(column) + 0.5f) / columns; }

float schlick(float cosine) { return 0.04f + 0.96f * std::pow(1 - cosine, 5.0f); }

// What a straight ray keeps: two surfaces at that cosine, and the way inside.
vec3 kept(float cosine, float way)
{
    return (1 - schlick(cosine)) * (1 - schlick(cosine)) * pow(bottle, vec3(way / depth));
}

NodeId glass(Scene& s, const std::string& shadow = "transmitted", float transmission = 1)
{
    return s.node("glass", {{"refraction_index", clear},
                            {"colour", bottle},
                            {"depth", depth},
                            {"transmission", transmission},
                            {"specular", 0.0f},
                            {"shadow", shadow}});
}

NodeId lifted(Scene& s, NodeId field, float height, NodeId material)
{
    NodeId moved = s.node("translate", {{"d", field}, {"offset", vec3(0, height, 0)}});
    return s.node("paint", {{"d", moved}, {"material", material}});
}

// A pane 2 h thick, over all the floor.
NodeId pane(Scene& s, float height, float half_thickness, NodeId material)
{
    return lifted(s, s.node("box", {{"half_size", vec3(40, half_thickness, 40)}}), height, material);
}

NodeId with_floor(Scene& s, NodeId field) { return s.node("union", {{"a", s.node("plane")}, {"b", field}}); }

// Straight down from half a metre above the floor, along x.
FrameRequest row_of_floor()
{
    FrameRequest request{.width = columns, .height = 2};
    request.camera = ViewCamera{.position = {0, 0.5f, 0},
                                .target = {0, 0, 0},
                                .up = {0, 0, -1},
                                .orthographic_height = seen_width * 2 / columns};
    return request;
}

std::vector<vec3> floor_colours(const Scene& scene)
{
    Frame frame = render_on_cpu(scene.program(), row_of_floor());
    return {frame.colour.begin(), frame.colour.begin() + columns};
}

struct Sun {
    const char* shadow = "hard";
    float elevation = 90;
    float sharpness = 8;
};

// The share of a sun's light that reaches the floor, by column.
std::vector<vec3> light_behind(const std::function<NodeId(Scene&)>& make, const Sun& sun = {})
{
    Scene s;
    s.document.bounces = 2;
    s.wire(s.node("gradient", {{"strength", 0.0f}}), s.show(with_floor(s, make(s))), "sky");
    NodeId light = s.node("sun", {{"elevation", sun.elevation}, {"sharpness", sun.sharpness}});
    s.set(light, "shadow", std::string("off"));
    std::vector<vec3> open = floor_colours(s);
    s.set(light, "shadow", std::string(sun.shadow));
    std::vector<vec3> seen = floor_colours(s);
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] /= open[i];
    return seen;
}

void expect_near(vec3 a, vec3 b, float tolerance, const std::string& what)
{
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << what << ", channel " << k;
}

TEST(TintedShadows, behind_a_pane_are_what_beer_lambert_and_schlick_leave)
{
    for (float elevation : {90.0f, 60.0f, 35.0f})
        for (float half_thickness : {0.02f, 0.15f})
            for (const char* shadow : {"hard", "soft", "soft_corrected"}) {
                float cosine = std::sin(glm::radians(elevation));
                std::vector<vec3> seen = light_behind([&](Scene& s) { return pane(s, 1, half_thickness, glass(s)); },
                                                      {shadow, elevation, 16});
                // Flat ground under a low sun darkens by itself (docs/shadows.md).
                float flat = std::string(shadow) == "hard" ? 0.003f : 0.02f;
                expect_near(seen[columns / 2], kept(cosine, 2 * half_thickness / cosine), flat,
                            std::string(shadow) + " at " + std::to_string(elevation));
            }
}

TEST(TintedShadows, of_a_ball_follow_its_chords)
{
    constexpr float radius = 0.4f;
    std::vector<vec3> seen = light_behind([&](Scene& s) {
        return lifted(s, s.node("sphere", {{"radius", radius}}), 1.2f, glass(s));
    });
    for (int i = 0; i < columns; ++i) {
        float x = x_of(i), half_chord = std::sqrt(std::max(radius * radius - x * x, 0.0f));
        if (std::abs(x) > radius + 0.005f) expect_near(seen[static_cast<std::size_t>(i)], vec3(1), 0.001f, "outside");
        if (std::abs(x) > 0.97f * radius) continue;
        expect_near(seen[static_cast<std::size_t>(i)], kept(half_chord / radius, 2 * half_chord), 0.01f,
                    "at " + std::to_string(x));
    }
}

TEST(TintedShadows, of_panes_behind_one_another_multiply)
{
    std::vector<vec3> seen = light_behind([](Scene& s) {
        NodeId second = s.node("union", {{"a", pane(s, 1, 0.05f, glass(s))}, {"b", pane(s, 1.5f, 0.05f, glass(s))}});
        return s.node("union", {{"a", second}, {"b", pane(s, 2, 0.05f, glass(s))}});
    });
    expect_near(seen[7], kept(1, 0.1f) * kept(1, 0.1f) * kept(1, 0.1f), 0.005f, "three panes");
}

TEST(TintedShadows, are_full_or_none_where_the_material_says_so_and_milk_dims_twice)
{
    auto behind = [](const std::string& shadow, float transmission, const char* kind) {
        return light_behind([&](Scene& s) { return pane(s, 1, 0.1f, glass(s, shadow, transmission)); }, {kind})[9];
    };
    for (const char* kind : {"hard", "soft", "soft_corrected"}) {
        expect_near(behind("full", 1, kind), vec3(0), 1e-6f, kind);
        expect_near(behind("none", 1, kind), vec3(1), 1e-3f, kind);
        expect_near(behind("transmitted", 0.5f, kind), 0.25f * kept(1, 0.2f), 0.003f, kind);
    }
}

// Left half of the sky.
NodeId plate(Scene& s, float height)
{
    NodeId box = s.node("box", {{"half_size", vec3(4, 0.001f, 9)}});
    NodeId moved = s.node("translate", {{"d", box}, {"offset", vec3(-4, height, 0)}});
    return s.node("paint", {{"d", moved}, {"material", s.node("phong")}});
}

TEST(TintedShadows, leave_soft_edges_before_and_behind_a_pane_as_they_are)
{
    for (const char* shadow : {"soft", "soft_corrected"}) {
        Sun sun{shadow};
        std::vector<vec3> open = light_behind([](Scene& s) { return plate(s, 1); }, sun);
        for (float height : {0.7f, 1.6f}) {
            std::vector<vec3> seen = light_behind(
                [&](Scene& s) {
                    return s.node("union", {{"a", plate(s, 1)}, {"b", pane(s, height, 0.05f, glass(s))}});
                },
                sun);
            for (std::size_t i = 0; i < columns; ++i)
                expect_near(seen[i], open[i] * kept(1, 0.1f), 0.03f,
                            std::string(shadow) + " pane at " + std::to_string(height) + ", x " +
                                std::to_string(x_of(static_cast<int>(i))));
        }
    }
}

// Half of a pane, its edge at x = 0.
NodeId half_pane(Scene& s, float height)
{
    NodeId box = s.node("box", {{"half_size", vec3(4, 0.05f, 9)}});
    return lifted(s, s.node("translate", {{"d", box}, {"offset", vec3(-4, 0, 0)}}), height, glass(s));
}

TEST(TintedShadows, keep_the_soft_edge_of_a_plate_that_a_panes_edge_is_nearer_to)
{
    Sun sun{"soft_corrected"};
    std::vector<vec3> alone = light_behind([](Scene& s) { return plate(s, 1); }, sun);
    std::vector<vec3> both = light_behind(
        [](Scene& s) {
            return s.node("union", {{"a", plate(s, 1)}, {"b", half_pane(s, 2)}});
        },
        sun);
    for (int i = 0; i < columns; ++i) {
        if (x_of(i) < 0.01f) continue;
        float plain = alone[static_cast<std::size_t>(i)].g, seen = both[static_cast<std::size_t>(i)].g;
        EXPECT_LT(seen, plain + 0.02f) << x_of(i);
        EXPECT_GT(seen, std::min(plain, 0.92f) - 0.02f) << x_of(i);
    }
}

TEST(TintedShadows, fade_at_a_soft_edge_to_what_the_glass_lets_through)
{
    std::vector<vec3> seen = light_behind([](Scene& s) { return half_pane(s, 1); }, {"soft_corrected"});
    for (int i = 0; i < columns; ++i) {
        float x = x_of(i);
        vec3 light = seen[static_cast<std::size_t>(i)];
        if (x < -0.01f) {
            expect_near(light, kept(1, 0.1f), 0.005f, "below " + std::to_string(x));
        } else if (x > 0.15f) {
            expect_near(light, vec3(1), 0.005f, "beside " + std::to_string(x));
        } else if (x > 0.01f) {
            EXPECT_GT(light.g, 0.96f * 0.96f - 0.005f) << x;
        }
    }
}

TEST(Devices, agree_on_tinted_shadows)
{
    GpuDevice gpu;
    Scene s;
    s.document.bounces = 3;
    NodeId ball = lifted(s, s.node("sphere", {{"radius", 0.5f}}), 0.8f, glass(s));
    NodeId ring = lifted(s, s.node("torus", {{"major", 0.9f}, {"minor", 0.15f}}), 1.5f, glass(s, "transmitted", 0.7f));
    NodeId all = with_floor(s, s.node("smooth_union", {{"a", ball}, {"b", ring}}));
    s.wire(s.node("gradient"), s.show(s.node("union", {{"a", all}, {"b", plate(s, 2.2f)}})), "sky");
    FrameRequest request{.width = 160, .height = 90, .counts = true};
    request.camera = ViewCamera{.position = {1.5f, 2, 5}, .target = {0, 0.5f, 0}};
    NodeId sun = s.node("sun", {{"elevation", 55.0f}});
    s.node("point", {{"position", vec3(-2, 3, 1)}});
    for (const char* shadow : {"hard", "soft", "soft_corrected"}) {
        s.set(sun, "shadow", std::string(shadow));
        graph::Program program = s.program();
        for (bool layers : {false, true}) {
            request.layers = layers;
            Frame on_cpu = render_on_cpu(program, request), on_gpu = gpu.render(program, request);
            EXPECT_LE(share_apart(picture(on_cpu, View::beauty, 256), picture(on_gpu, View::beauty, 256)), 0.005)
                << shadow;
            EXPECT_NEAR(static_cast<double>(on_gpu.evaluations) / static_cast<double>(on_cpu.evaluations), 1, 0.002);
            if (!layers) continue;
            EXPECT_LE(share_apart(picture(on_cpu, View::shadow, 256), picture(on_gpu, View::shadow, 256)), 0.01)
                << shadow;
        }
    }
}

}  // namespace
}  // namespace fieldwright::tests
