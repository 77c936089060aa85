// Mirrors and glass against the formulas of optics, and against each other on both devices.
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

const vec3 black(0.0f), white(1.0f);

// Looks along -z from (x, y, 5), with parallel rays; the picture is so small that all of it shows one ray's end.
FrameRequest along_z(float x, float y)
{
    return {.width = 1,
            .height = 1,
            .camera = ViewCamera{.position = {x, y, 5}, .target = {x, y, 0}, .orthographic_height = 1e-3f}};
}

vec3 seen(const Scene& scene, const FrameRequest& request) { return render_on_cpu(scene.program(), request).colour[0]; }

NodeId painted(Scene& s, NodeId field, NodeId material)
{
    return s.node("paint", {{"d", field}, {"material", material}});
}

// Nothing but its own light.
NodeId lamp_material(Scene& s, vec3 glow)
{
    return s.node("phong", {{"albedo", black}, {"specular", 0.0f}, {"glow", glow}, {"emission", 1.0f}});
}

NodeId mirror_material(Scene& s, float reflection)
{
    return s.node("phong", {{"albedo", black}, {"specular", 0.0f}, {"reflection", reflection}});
}

NodeId glass_material(Scene& s, float index, vec3 colour = white, float depth = 1)
{
    return s.node("glass", {{"refraction_index", index}, {"colour", colour}, {"depth", depth}, {"specular", 0.0f}});
}

void show(Scene& s, NodeId field, vec3 zenith, vec3 horizon, vec3 ground, int bounces)
{
    s.wire(s.node("gradient", {{"zenith", zenith}, {"horizon", horizon}, {"ground", ground}}), s.show(field), "sky");
    s.document.bounces = bounces;
}

// The gradient sky that is white below and black above.
double sky_of(double y)
{
    double x = std::clamp(-y / 0.5, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

double schlick(double index, double cosine)
{
    double straight = std::pow((1 - index) / (1 + index), 2);
    return straight + (1 - straight) * std::pow(1 - cosine, 5);
}

// What a ray sees of that sky through a sphere of radius 1, in the plane of its path: directions are angles from the z
// axis, the ray hits at the angle of incidence asin(height), and leaves by Snell's law after every chord inside.
double seen_through_sphere(double height, double index, int bounces)
{
    double incidence = std::asin(height), refraction = std::asin(height / index);
    double cosine = std::cos(incidence), mirrored = schlick(index, cosine);
    double sum = mirrored * sky_of(std::sin(2 * incidence));  // up and back to the eye
    double weight = 1 - mirrored;
    double direction = incidence - refraction;  // below the view axis
    for (int depth = 1;; ++depth) {
        if (depth > bounces) return sum + weight * sky_of(-std::sin(direction));
        double leaving = direction + incidence - refraction;
        sum += weight * (1 - mirrored) * sky_of(-std::sin(leaving));
        weight *= mirrored;
        direction += 3.14159265358979 - 2 * refraction;
    }
}

TEST(Glass, sphere_bends_light_by_the_law_of_snell)
{
    for (float index : {1.1f, 1.33f, 1.5f, 2.4f})
        for (float height : {0.2f, 0.45f, 0.7f}) {
            Scene s;
            show(s, painted(s, s.node("sphere", {{"radius", 1.0f}}), glass_material(s, index)), black, black, white, 3);
            s.document.march.minimum_step = 1e-4f;
            s.document.march.tolerance = 1e-5f;
            EXPECT_NEAR(seen(s, along_z(0, height)).g, seen_through_sphere(height, index, 3), 0.006)
                << index << " at " << height;
        }
}

// A prism over a lamp: the ray enters straight on, meets the cut at 45 degrees, and goes straight down when that is
// beyond the critical angle.
TEST(Glass, mirrors_all_light_beyond_the_critical_angle)
{
    auto down_through_prism = [](float index) {
        Scene s;
        NodeId block = s.node("box", {{"half_size", vec3(1)}});
        NodeId prism = s.node("clip_plane", {{"d", block}, {"normal", vec3(0, 1, -1)}, {"offset", 0.0f}});
        NodeId lamp = s.node("translate", {{"d", s.node("sphere")}, {"offset", vec3(0, -3, -0.3f)}});
        NodeId both = s.node("union", {{"a", painted(s, prism, glass_material(s, index))},
                                       {"b", painted(s, lamp, lamp_material(s, white))}});
        show(s, both, black, black, black, 3);
        return seen(s, along_z(0, -0.3f)).g;
    };
    double straight = 1 - schlick(1.5, 1);  // in, and out below
    EXPECT_NEAR(down_through_prism(1.5f), straight * straight, 0.01);
    EXPECT_LT(down_through_prism(1.3f), 0.15f) << "the critical angle of 1.3 is 50 degrees";
}

TEST(Glass, takes_light_away_by_the_law_of_beer_and_lambert)
{
    const vec3 colour(0.2f, 0.5f, 0.9f);
    for (float thickness : {0.1f, 0.7f, 2.0f}) {
        Scene s;
        NodeId slab = s.node("box", {{"half_size", vec3(3, 3, 0.5f * thickness)}});
        show(s, painted(s, slab, glass_material(s, 1.0f, colour, 0.5f)), white, white, white, 2);
        vec3 left = seen(s, along_z(0, 0));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(left[k], std::pow(colour[k], thickness / 0.5f), 0.005) << thickness;
    }
}

TEST(Mirror, shows_the_colour_of_what_it_faces)
{
    const vec3 glow(0.2f, 0.5f, 0.7f);
    for (float reflection : {0.25f, 1.0f}) {
        Scene s;
        NodeId mirror = s.node("plane", {{"normal", vec3(0, 1, 1)}});
        NodeId lamp = s.node("translate", {{"d", s.node("sphere", {{"radius", 1.0f}})}, {"offset", vec3(0, 4, 0)}});
        NodeId both = s.node("union", {{"a", painted(s, mirror, mirror_material(s, reflection))},
                                       {"b", painted(s, lamp, lamp_material(s, glow))}});
        show(s, both, black, black, black, 1);
        double share = reflection + (1 - reflection) * std::pow(1 - std::sqrt(0.5), 5);
        vec3 colour = seen(s, along_z(0, 0));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(colour[k], share * glow[k], 1e-3) << reflection;
    }
}

TEST(Metal, that_is_smooth_mirrors_what_it_faces_in_its_own_colour)
{
    Scene s;
    const vec3 gold(0.9f, 0.6f, 0.2f);
    NodeId metal = s.node("metallic_roughness", {{"base_colour", gold}, {"metallic", 1.0f}, {"roughness", 0.03f}});
    NodeId lamp = s.node("translate", {{"d", s.node("sphere")}, {"offset", vec3(0, 4, 0)}});
    NodeId both = s.node("union", {{"a", painted(s, s.node("plane", {{"normal", vec3(0, 1, 1)}}), metal)},
                                   {"b", painted(s, lamp, lamp_material(s, white))}});
    show(s, both, black, black, black, 1);
    vec3 colour = seen(s, along_z(0, 0));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(colour[k], 0.97f * 0.97f * gold[k], 0.01f);
}

// Two mirrors that face each other: every bounce takes the same share, and the last one sees the sky.
TEST(Bounces, are_as_many_as_the_scene_says)
{
    for (int bounces : {1, 2, 5, 8}) {
        Scene s;
        NodeId front = s.node("plane", {{"normal", vec3(0, 0, 1)}, {"height", -1.0f}});
        NodeId back = s.node("plane", {{"normal", vec3(0, 0, -1)}, {"height", -8.0f}});
        show(s, painted(s, s.node("union", {{"a", front}, {"b", back}}), mirror_material(s, 0.8f)), white, white, white,
             bounces);
        EXPECT_NEAR(seen(s, along_z(0, 0)).r, std::pow(0.8, bounces + 1), 2e-3) << bounces;
    }
}

TEST(Blend, of_a_mirror_and_paint_mirrors_in_part)
{
    auto seen_at = [](float smoothness, float x) {
        Scene s;
        NodeId left = s.node("translate", {{"d", s.node("sphere", {{"radius", 1.0f}})}, {"offset", vec3(-1, 0, 0)}});
        NodeId right = s.node("translate", {{"d", s.node("sphere", {{"radius", 1.0f}})}, {"offset", vec3(1, 0, 0)}});
        NodeId both = s.node("smooth_union", {{"a", painted(s, left, mirror_material(s, 1.0f))},
                                              {"b", painted(s, right, mirror_material(s, 0.0f))},
                                              {"smoothness", smoothness}});
        show(s, both, white, white, white, 1);
        return seen(s, along_z(x, 0)).r;
    };
    EXPECT_GT(seen_at(1.0f, -1.0f), 0.95f);
    EXPECT_NEAR(seen_at(1.0f, 0.0f), 0.5f, 0.05f);
    EXPECT_LT(seen_at(1.0f, 1.0f), 0.05f);
}

// A glass ball, a mirror, a metal block melted into paint, a milky lens, on a floor under a sun and a lamp, in fog.
Scene showroom(int bounces)
{
    Scene s;
    auto at = [&](NodeId field, vec3 offset) { return s.node("translate", {{"d", field}, {"offset", offset}}); };
    NodeId floor = painted(s, s.node("plane"), s.node("checker"));
    NodeId ball = painted(s, at(s.node("sphere", {{"radius", 0.8f}}), {-1.2f, 0.9f, 0.5f}), glass_material(s, 1.5f));
    NodeId wall =
        painted(s, at(s.node("box", {{"half_size", vec3(2.5f, 1.5f, 0.1f)}}), {0, 1.5f, -2}), mirror_material(s, 0.9f));
    NodeId block = painted(s, at(s.node("rounded_box"), {1, 0.5f, 0.3f}), s.node("metallic_roughness"));
    NodeId paint = painted(s, at(s.node("sphere"), {1.4f, 1, 0.3f}), s.node("phong"));
    NodeId melted = s.node("smooth_union", {{"a", block}, {"b", paint}});
    NodeId lens = painted(s, at(s.node("sphere", {{"radius", 0.35f}}), {0, 0.36f, 1.4f}),
                          s.node("glass", {{"colour", vec3(0.3f, 0.8f, 0.5f)}, {"transmission", 0.5f}}));
    NodeId all =
        s.node("union", {{"a", s.node("union", {{"a", floor}, {"b", wall}})},
                         {"b", s.node("union", {{"a", ball}, {"b", s.node("union", {{"a", melted}, {"b", lens}})}})}});
    NodeId output = s.show(all);
    s.wire(s.node("perspective", {{"position", vec3(1.2f, 2.2f, 6)}, {"target", vec3(0, 0.8f, 0)}}), output, "camera");
    s.wire(s.node("gradient"), output, "sky");
    s.node("sun", {{"intensity", 0.8f}});
    s.node("point", {{"position", vec3(-3, 2.5f, 2)}, {"shadow", std::string("soft")}});
    s.document.bounces = bounces;
    s.document.fog.density = 0.03f;
    s.document.fog.start = 2;
    s.document.fog.height_falloff = 0.2f;
    return s;
}

TEST(Devices, agree_on_mirrors_glass_and_fog)
{
    GpuDevice gpu;
    FrameRequest request{.width = 192, .height = 108};
    for (int bounces : {0, 1, 4}) {
        graph::Program program = showroom(bounces).program();
        Frame on_cpu = render_on_cpu(program, request), on_gpu = gpu.render(program, request);
        for (const std::string& name : view_names()) {
            View view = *view_from_name(name);
            EXPECT_LE(share_apart(picture(on_cpu, view, 256), picture(on_gpu, view, 256)), 0.005)
                << name << ", " << bounces << " bounces";
        }
    }
}

TEST(Devices, agree_when_bounces_use_up_the_budget)
{
    GpuDevice gpu;
    FrameRequest request{.width = 96, .height = 54};
    graph::Program program = showroom(4).program();
    program.step_budget = 250;
    Frame on_cpu = render_on_cpu(program, request), on_gpu = gpu.render(program, request);
    EXPECT_LE(share_apart(picture(on_cpu, View::beauty, 256), picture(on_gpu, View::beauty, 256)), 0.01);
    EXPECT_GT(std::count(on_cpu.exhausted.begin(), on_cpu.exhausted.end(), 1), 300);
}

TEST(Sphere, in_parallel_rays_is_a_disc_with_the_depth_of_a_sphere)
{
    Scene s;
    s.show(s.node("sphere", {{"radius", 1.0f}}));
    constexpr int side = 101;
    constexpr float height = 3;
    FrameRequest request{.width = side,
                         .height = side,
                         .camera = ViewCamera{.position = {0, 0, 5}, .target = {}, .orthographic_height = height}};
    Frame frame = render_on_cpu(s.program(), request);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            float u = height * (static_cast<float>(x) + 0.5f) / side - 0.5f * height;
            float v = height * (static_cast<float>(y) + 0.5f) / side - 0.5f * height;
            float squared = u * u + v * v, depth = frame.depth[static_cast<std::size_t>(y * side + x)];
            if (squared > 1.01f) {
                ASSERT_TRUE(std::isinf(depth)) << u << " " << v;
            } else if (squared < 0.99f) {
                ASSERT_NEAR(depth, 5 - std::sqrt(1 - squared), 2e-3f) << u << " " << v;
            }
        }
}

TEST(Sphere, in_perspective_has_the_depth_along_the_view_axis)
{
    Scene s;
    s.show(s.node("sphere", {{"radius", 1.0f}}));
    constexpr int side = 61;
    FrameRequest request{.width = side, .height = side, .camera = ViewCamera{.position = {0, 0, 4}, .target = {}}};
    Frame frame = render_on_cpu(s.program(), request);
    float slope = std::tan(0.5f * request.camera->field_of_view_rad);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            vec3 direction(slope * ((2.0f * static_cast<float>(x) + 1) / side - 1),
                           slope * ((2.0f * static_cast<float>(y) + 1) / side - 1), -1);
            float forward = 1 / glm::length(direction), along = 4 * forward;
            float squared = 16 - along * along, depth = frame.depth[static_cast<std::size_t>(y * side + x)];
            if (squared > 1.01f) {
                ASSERT_TRUE(std::isinf(depth));
            } else if (squared < 0.98f) {
                ASSERT_NEAR(depth, (along - std::sqrt(1 - squared)) * forward, 2e-3f);
            }
        }
}

}  // namespace
}  // namespace fieldwright::tests
