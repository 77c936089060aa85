// The two devices: the same picture from the same text, whatever the threads, the budget and the eye.
#include "renderer/devices.h"

#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <atomic>
#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

FrameRequest small_request() { return {.width = 160, .height = 90, .time = 0.3f}; }

NodeId painted(Scene& s, NodeId field, vec3 albedo)
{
    return s.node("paint", {{"d", field}, {"material", s.node("phong", {{"albedo", albedo}})}});
}

// A ball melted into a box and a row of cones on a floor, under a sun and a lamp.
Scene still_life()
{
    Scene s;
    NodeId floor = painted(s, s.node("plane"), vec3(0.4f));
    NodeId ball = s.node("translate", {{"d", s.node("sphere", {{"radius", 0.8f}})}, {"offset", vec3(-0.5f, 0.8f, 0)}});
    NodeId box = s.node("translate", {{"d", s.node("rounded_box")}, {"offset", vec3(0.6f, 0.5f, 0.2f)}});
    NodeId body = painted(s, s.node("smooth_union", {{"a", ball}, {"b", box}}), vec3(0.7f, 0.2f, 0.1f));
    NodeId cones = s.node("repeat_limited", {{"d", s.node("cone")}});
    NodeId moved = s.node("translate", {{"d", cones}, {"offset", vec3(2, 0.5f, -3)}});
    NodeId all = s.node("union", {{"a", floor}, {"b", s.node("union", {{"a", body}, {"b", moved}})}});
    NodeId output = s.show(all);
    s.wire(s.node("perspective", {{"position", vec3(1.2f, 2.6f, 6.5f)}, {"target", vec3(0, 0.6f, 0)}}), output,
           "camera");
    s.wire(s.node("gradient"), output, "sky");
    s.node("sun", {{"intensity", 0.8f}});
    s.node("point", {{"position", vec3(-3, 2.5f, 2)}});
    return s;
}

void expect_equal(const Frame& a, const Frame& b)
{
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.node_id, b.node_id);
    EXPECT_EQ(a.material_id, b.material_id);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.exhausted, b.exhausted);
}

void expect_alike(const graph::Program& program, GpuDevice& gpu, const FrameRequest& request)
{
    FrameRequest counted = request;
    counted.counts = true;
    Frame on_cpu = render_on_cpu(program, counted), on_gpu = gpu.render(program, counted);
    EXPECT_NEAR(static_cast<double>(on_gpu.evaluations), static_cast<double>(on_cpu.evaluations),
                0.001 * static_cast<double>(on_cpu.evaluations));
    for (const std::string& name : view_names()) {
        View view = *view_from_name(name);
        EXPECT_LE(share_apart(picture(on_cpu, view, program.march.step_limit),
                              picture(on_gpu, view, program.march.step_limit)),
                  0.001)
            << name;
    }
}

int count_exhausted(const Frame& frame)
{
    return static_cast<int>(std::count(frame.exhausted.begin(), frame.exhausted.end(), 1));
}

TEST(Devices, draw_the_same_picture_from_every_eye)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    FrameRequest request = small_request();
    for (Eye eye : {Eye::centre, Eye::left, Eye::right}) {
        request.eye = eye;
        expect_alike(program, gpu, request);
    }
}

TEST(Devices, draw_the_same_picture_through_the_viewports_camera)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    FrameRequest request = small_request();
    request.camera = ViewCamera{.position = {-3, 2, 5}, .target = {0, 0.5f, 0}, .up = {0.3f, 1, 0.1f}};
    expect_alike(program, gpu, request);
    request.camera->orthographic_height = 4;
    request.eye = Eye::left;
    expect_alike(program, gpu, request);
    EXPECT_EQ(gpu.links(), 1);
}

TEST(ViewCamera, equal_to_the_scenes_gives_the_scenes_picture)
{
    graph::Program program = still_life().program();
    FrameRequest request = small_request();
    Picture of_scene = picture(render_on_cpu(program, request), View::normal, 256);
    request.camera =
        ViewCamera{.position = {1.2f, 2.6f, 6.5f}, .target = {0, 0.6f, 0}, .field_of_view_rad = glm::radians(45.0f)};
    EXPECT_LE(share_apart(of_scene, picture(render_on_cpu(program, request), View::normal, 256)), 0.001);
    request.camera->position.x = 2.5f;
    EXPECT_GT(share_apart(of_scene, picture(render_on_cpu(program, request), View::normal, 256)), 0.1);
}

// Lamps of every kind with every kind of shadow over the still life.
Scene many_lights(std::string_view sky)
{
    Scene s = still_life();
    auto kind = [](const char* word) { return graph::Value(std::string(word)); };
    s.node("point", {{"position", vec3(2, 1.5f, 3)}, {"shadow", kind("soft")}, {"falloff", kind("power")}});
    s.node("spot", {{"position", vec3(1, 3, 3)}, {"shadow", kind("soft_corrected")}});
    s.node("sphere_area", {{"position", vec3(-2, 3, 0)}, {"falloff", kind("none")}, {"intensity", 0.4f}});
    s.node("sun", {{"azimuth", -60.0f}, {"intensity", 0.3f}, {"shadow", kind("off")}});
    for (const graph::Node& node : s.document.root.nodes)
        if (node.type == "output") {
            s.wire(s.node(sky), node.id, "sky");
            break;
        }
    return s;
}

TEST(Devices, agree_on_every_kind_of_light_shadow_and_sky)
{
    GpuDevice gpu;
    for (const char* sky : {"sun_and_sky", "environment"}) {
        SCOPED_TRACE(sky);
        expect_alike(many_lights(sky).program(), gpu, small_request());
    }
}

TEST(Devices, agree_on_every_way_to_march_and_to_occlude)
{
    GpuDevice gpu;
    Scene s = still_life();
    s.document.march.central_normals = true;
    s.document.march.normal_step = 0.01f;
    s.document.occlusion.smallest_ratio = true;
    s.document.occlusion.samples = 9;
    expect_alike(s.program(), gpu, small_request());
    s = many_lights("gradient");
    s.document.march.constant_steps = true;
    expect_alike(s.program(), gpu, small_request());
    s = many_lights("gradient");
    s.document.march.own_step_scale = true;
    s.document.march.step_scale = 0.6f;
    expect_alike(s.program(), gpu, small_request());
}

TEST(Devices, stop_between_tiles_and_strips)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    FrameRequest request{.width = 256, .height = 512};
    Frame frame(request.width, request.height);
    for (bool on_gpu : {false, true}) {
        std::atomic<int> parts = 0;
        Watch watch{.part_drawn = [&](const Frame&, const Area&) { ++parts; }, .cancelled = [&] { return parts >= 2; }};
        bool finished = on_gpu ? gpu.draw(frame, program, request, watch) : draw_on_cpu(frame, program, request, watch);
        EXPECT_FALSE(finished);
        EXPECT_GE(parts, 2);
        EXPECT_LE(parts, 24) << "of 64 tiles and more";
    }
}

TEST(Devices, agree_when_steps_or_budget_run_out)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    program.step_budget = 40;
    expect_alike(program, gpu, small_request());
    EXPECT_GT(count_exhausted(gpu.render(program, small_request())), 100);
    program.step_budget = 60000;
    program.march.step_limit = 12;
    for (bool hits : {false, true}) {
        program.march.out_of_steps_hits = hits;
        expect_alike(program, gpu, small_request());
        EXPECT_GT(count_exhausted(render_on_cpu(program, small_request())), 100);
    }
}

TEST(Devices, draw_a_size_that_fills_no_tile_and_no_strip)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    for (auto [width, height] : {std::pair(1, 1), std::pair(67, 35), std::pair(3, 130)})
        expect_alike(program, gpu, {.width = width, .height = height});
}

TEST(Devices, show_the_sky_of_an_empty_scene)
{
    GpuDevice gpu;
    Scene scene;
    scene.node("output");
    graph::Program program = scene.program();
    expect_alike(program, gpu, small_request());
    Frame frame = gpu.render(program, small_request());
    for (float depth : frame.depth) EXPECT_TRUE(std::isinf(depth));
    for (int id : frame.node_id) EXPECT_EQ(id, 0);
}

TEST(Devices, give_depth_along_the_view_axis_and_normals_of_unit_length)
{
    Scene s;
    NodeId wall = s.node("box", {{"half_size", vec3(50, 50, 1)}});
    NodeId output = s.show(wall);
    s.wire(s.node("perspective", {{"position", vec3(0, 0, 5)}, {"target", vec3(0)}}), output, "camera");
    Frame frame = render_on_cpu(s.program(), small_request());
    for (float depth : frame.depth) EXPECT_NEAR(depth, 4.0f, 2e-3f);
    for (const vec3& normal : frame.normal) EXPECT_LT(glm::length(normal - vec3(0, 0, 1)), 1e-2f);
}

TEST(CpuDevice, draws_the_same_with_one_thread_or_many)
{
    graph::Program program = still_life().program();
    Frame many = render_on_cpu(program, small_request());
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    expect_equal(many, render_on_cpu(program, small_request()));
}

TEST(CpuDevice, reports_progress_up_to_the_end)
{
    float last = 0;
    render_on_cpu(still_life().program(), small_request(), [&](float fraction) {
        EXPECT_GT(fraction, last);
        last = fraction;
    });
    EXPECT_FLOAT_EQ(last, 1);
}

TEST(GpuDevice, links_again_only_when_the_text_changed)
{
    GpuDevice gpu;
    Scene s = still_life();
    gpu.render(s.program(), small_request());
    FrameRequest later = small_request();
    later.time = 2;
    later.eye = Eye::left;
    gpu.render(s.program(), later);
    EXPECT_EQ(gpu.links(), 1);
    s.document.march.step_limit = 100;
    gpu.render(s.program(), later);
    EXPECT_EQ(gpu.links(), 1);
    s.show(s.node("sphere"));
    gpu.render(s.program(), later);
    EXPECT_EQ(gpu.links(), 2);
}

TEST(GpuDevice, goes_back_to_a_text_of_a_while_ago_without_a_link)
{
    GpuDevice gpu;
    auto draw = [&](const char* shape) {
        Scene s;
        s.show(s.node(shape));
        return gpu.render(s.program(), small_request());
    };
    Frame first = draw("sphere");
    draw("box");
    draw("torus");
    expect_equal(first, draw("sphere"));
    EXPECT_EQ(gpu.links(), 3);
}

TEST(GpuDevice, gives_the_distances_of_the_cpu)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    std::vector<vec3> points;
    for (int i = 0; i < 70000; ++i) {
        auto x = static_cast<float>(i);
        points.push_back({3 * std::sin(x), 2 * std::cos(1.3f * x), 3 * std::sin(0.7f * x)});
    }
    std::vector<float> on_gpu = gpu.distances(program, 0, points);
    std::vector<float> on_cpu = field::distances(program, field::evaluate_frame(program, 0), points);
    ASSERT_EQ(on_gpu.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_NEAR(on_gpu[i], on_cpu[i], 1e-5f * (1 + glm::length(points[i]))) << "point " << i;
}

TEST(GpuDevice, two_of_them_live_side_by_side)
{
    graph::Program program = still_life().program();
    GpuDevice a, b;
    Frame first = a.render(program, small_request());
    expect_equal(first, b.render(program, small_request()));
    {
        GpuDevice moved = std::move(b);
    }
    expect_equal(first, a.render(program, small_request()));
}

TEST(GpuDevice, says_how_long_a_shader_takes_to_be_ready_and_refuses_a_broken_one)
{
    GpuDevice gpu;
    graph::Program program = still_life().program();
    std::vector<float> block = field::evaluate_frame(program, 0);
    EXPECT_GT(gpu.ready_seconds(codegen::print_fragment_shader(program, block, codegen::Placement::literals)), 0);
    try {
        gpu.ready_seconds("#version 330\nvoid main() { nothing = 1; }\n");
        FAIL() << "a broken shader was taken";
    } catch (const graph::Failure& failure) {
        EXPECT_EQ(failure.exit_code, 6);
        EXPECT_NE(std::string(failure.what()).find("nothing"), std::string::npos) << failure.what();
    }
}

}  // namespace
}  // namespace fieldwright::tests
