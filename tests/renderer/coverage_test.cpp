// Coverage: pixels through which an edge passes are as the mean of many samples has them.
#include "graph/scene_file.h"
#include "renderer/samples.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec2;
using glm::vec3;

// What a scene shows of a field, from a camera.
struct Case {
    std::string title;
    std::function<NodeId(Scene&)> make;
    std::function<NodeId(Scene&)> camera;
    double most = 0.08;  // largest error of a channel, of those on edges
};

NodeId painted(Scene& s, NodeId field, vec3 colour)
{
    return s.node("paint", {{"d", field}, {"material", s.node("phong", {{"albedo", colour}, {"specular", 0.0f}})}});
}

// One colour, whatever lights it: what two faces meet in is no edge.
NodeId glowing(Scene& s, NodeId field, vec3 colour)
{
    NodeId light = s.node("phong", {{"albedo", vec3(0)}, {"specular", 0.0f}, {"glow", colour}, {"emission", 1.0f}});
    return s.node("paint", {{"d", field}, {"material", light}});
}

NodeId moved(Scene& s, NodeId field, vec3 offset) { return s.node("translate", {{"d", field}, {"offset", offset}}); }

NodeId turned_box(Scene& s)
{
    NodeId box = s.node("box", {{"half_size", vec3(0.7f, 0.5f, 0.6f)}});
    return s.node("rotate", {{"d", box}, {"angles", vec3(10, 25, 5)}});
}

NodeId ball(Scene& s) { return painted(s, s.node("sphere", {{"radius", 0.7f}}), {0.8f, 0.5f, 0.2f}); }
NodeId box(Scene& s) { return glowing(s, turned_box(s), {0.9f, 0.5f, 0.1f}); }

// Two half-spaces: a field that is a bound beside their edge, which crosses the whole picture.
NodeId wedge(Scene& s)
{
    NodeId a = s.node("plane", {{"normal", vec3(1, 0.37f, -0.5f)}}), b = s.node("plane", {{"normal", vec3(0, 0, 1)}});
    return glowing(s, s.node("intersect", {{"a", a}, {"b", b}}), {0.9f, 0.9f, 0.9f});
}

// Before a wall that fills the picture.
NodeId before_wall(Scene& s, NodeId field)
{
    NodeId wall = glowing(s, s.node("box", {{"half_size", vec3(20, 20, 0.2f)}}), {0.1f, 0.3f, 0.1f});
    return s.node("union", {{"a", field}, {"b", moved(s, wall, {0, 0, -3})}});
}

NodeId perspective(Scene& s)
{
    return s.node("perspective", {{"position", vec3(0.6f, 0.8f, 4)}, {"target", vec3(0)}, {"field_of_view", 35.0f}});
}
NodeId orthographic(Scene& s)
{
    return s.node("orthographic", {{"position", vec3(0.6f, 0.8f, 4)}, {"target", vec3(0)}, {"height", 2.4f}});
}
NodeId equal_angle(Scene& s)
{
    return s.node("equal_angle",
                  {{"position", vec3(0.3f, 0.4f, 1.2f)}, {"target", vec3(0)}, {"field_of_view", 120.0f}});
}
NodeId fisheye(Scene& s)
{
    return s.node("fisheye", {{"position", vec3(0.3f, 0.4f, 1.2f)}, {"target", vec3(0)}, {"field_of_view", 150.0f}});
}

Scene scene_of(const Case& shown)
{
    Scene s;
    NodeId output = s.show(shown.make(s));
    s.wire(shown.camera(s), output, "camera");
    s.wire(s.node("gradient"), output, "sky");
    s.node("sun", {{"shadow", std::string("off")}});
    s.document.occlusion.strength = 0;
    return s;
}

Scene smoothed(Scene scene)
{
    scene.document.march.coverage = true;
    return scene;
}

const FrameRequest small{.width = 72, .height = 72};

// The mean of 16 x 16 samples of each pixel.
Frame reference(const graph::Program& program, FrameRequest request = small)
{
    const Exposure exposure{.grid = 16};
    Frame mean = render_on_cpu(program, request);
    Accumulator sums;
    while (sums.count() < 256) sums.add(render_on_cpu(program, sample_of(request, exposure, sums.count())), exposure);
    sums.resolve(mean, exposure);
    return mean;
}

struct Error {
    double rms = 0, most = 0;
};

// Over the pixels that samples see differently from their middle; channels are clamped to what a screen shows.
Error error_of(const Frame& frame, const Frame& right, const std::vector<bool>& counts)
{
    Error error;
    int channels = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        for (int k = 0; k < 3 && counts[i]; ++k, ++channels) {
            double apart = std::abs(std::min(frame.colour[i][k], 1.0f) - std::min(right.colour[i][k], 1.0f));
            error.rms += apart * apart;
            error.most = std::max(error.most, apart);
        }
    error.rms = std::sqrt(error.rms / std::max(channels, 1));
    return error;
}

std::vector<bool> edges_of(const Frame& one, const Frame& right)
{
    std::vector<bool> edges(one.colour.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (int k = 0; k < 3; ++k) edges[i] = edges[i] || std::abs(one.colour[i][k] - right.colour[i][k]) > 0.02f;
    return edges;
}

class EdgesOf : public testing::TestWithParam<Case> {};

TEST_P(EdgesOf, are_much_nearer_to_the_mean_of_many_samples_than_one_sample_is)
{
    Scene scene = scene_of(GetParam());
    graph::Program program = scene.program();
    Frame one = render_on_cpu(program, small), smooth = render_on_cpu(smoothed(scene).program(), small);
    Frame right = reference(program);
    const std::vector<bool> edges = edges_of(one, right);
    ASSERT_GT(std::count(edges.begin(), edges.end(), true), 40);
    Error plain = error_of(one, right, edges), covered = error_of(smooth, right, edges);
    std::printf("%-32s none %.4f (%.3f)  coverage %.4f (%.3f)  %.1fx\n", GetParam().title.c_str(), plain.rms,
                plain.most, covered.rms, covered.most, plain.rms / covered.rms);
    EXPECT_LT(covered.rms, 0.2 * plain.rms);
    EXPECT_LT(covered.most, GetParam().most);
}

TEST_P(EdgesOf, are_the_same_on_both_devices)
{
    graph::Program program = smoothed(scene_of(GetParam())).program();
    GpuDevice gpu;
    Picture a = picture(render_on_cpu(program, small), View::beauty, 256),
            b = picture(gpu.render(program, small), View::beauty, 256);
    EXPECT_LE(share_apart(a, b), 0.005);
}

const Case cases[] = {
    {"ball_perspective", ball, perspective},
    {"ball_orthographic", ball, orthographic},
    {"ball_fisheye", ball, fisheye},
    {"ball_equal_angle", ball, equal_angle},
    {"box_perspective", box, perspective},
    {"box_orthographic", box, orthographic},
    {"wedge_perspective", wedge, perspective},
    {"wedge_orthographic", wedge, orthographic},
    {"ball_before_wall", [](Scene& s) { return before_wall(s, ball(s)); }, perspective},
    {"box_before_wall", [](Scene& s) { return before_wall(s, box(s)); }, orthographic},
};

INSTANTIATE_TEST_SUITE_P(Coverage, EdgesOf, testing::ValuesIn(cases),
                         [](const auto& edge) { return edge.param.title; });

// The share of a pixel beyond a line.
float square_beyond(vec2 normal, float way)
{
    Rows direction(2), distance(1), share(1);
    for (int k = 0; k < 2; ++k) direction.lane(k)[0] = normal[k];
    distance.lane(0)[0] = way;
    RowFunction("square_beyond", field::kernels())(share, 1, direction, distance);
    return share.lane(0)[0];
}

TEST(Coverage, of_a_square_is_the_area_beyond_a_line)
{
    for (int degrees = 0; degrees < 360; degrees += 15)
        for (float way : {0.0f, 0.1f, 0.25f, 0.4f, 0.49f, 0.6f, 0.69f, 0.8f}) {
            float angle = static_cast<float>(degrees) * std::numbers::pi_v<float> / 180;
            vec2 normal(std::cos(angle), std::sin(angle));
            constexpr int side = 200;
            int beyond = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x)
                    beyond += glm::dot(normal, (vec2(x, y) + 0.5f) / float(side) - 0.5f) > way ? 1 : 0;
            EXPECT_NEAR(square_beyond(normal, way), static_cast<float>(beyond) / (side * side), 0.004f)
                << degrees << " degrees, " << way;
        }
}

// White on black, without perspective: what a pixel shows is the share that is covered.
Scene white(NodeId (*make)(Scene&))
{
    Scene s;
    NodeId output = s.show(glowing(s, make(s), vec3(1)));
    NodeId camera = s.node("orthographic", {{"position", vec3(0, 0, 6)}, {"target", vec3(0)}, {"height", 2.0f}});
    s.wire(camera, output, "camera");
    s.wire(s.node("gradient", {{"strength", 0.0f}}), output, "sky");
    return smoothed(std::move(s));
}

NodeId disc(Scene& s) { return s.node("sphere", {{"radius", 0.7f}}); }
constexpr double disc_area = std::numbers::pi * 0.7 * 0.7;  // of a picture of 2 m x 2 m

TEST(Coverage, is_the_signed_ratio_of_distance_and_pixel)
{
    Frame frame = render_on_cpu(white(disc).program(), small);
    double pixel = 2.0 / small.height, sum = 0;
    int on_edge = 0;
    for (int i = 0; i < small.width * small.height; ++i) {
        double x = (i % small.width + 0.5) * pixel - 1, y = (i / small.width + 0.5) * pixel - 1;
        double ratio = (std::hypot(x, y) - 0.7) / pixel, shown = frame.colour[static_cast<std::size_t>(i)].r;
        sum += shown * pixel * pixel;
        ASSERT_NEAR(shown, frame.covered[static_cast<std::size_t>(i)], 1e-4);
        if (std::abs(ratio) > 0.72) {
            ASSERT_EQ(shown, ratio < 0 ? 1 : 0) << x << " " << y;
            continue;
        }
        ++on_edge;
        vec2 normal = glm::normalize(vec2(x, y));
        float beyond = square_beyond(normal, static_cast<float>(std::abs(ratio)));
        ASSERT_NEAR(shown, ratio < 0 ? 1 - beyond : beyond, 0.03) << x << " " << y;
    }
    EXPECT_GT(on_edge, 150);
    EXPECT_NEAR(sum, disc_area, 0.002 * disc_area);
}

TEST(Coverage, leaves_everything_but_edges_as_it_was)
{
    Case shown{"", [](Scene& s) { return before_wall(s, box(s)); }, perspective};
    Frame plain = render_on_cpu(scene_of(shown).program(), small),
          smooth = render_on_cpu(smoothed(scene_of(shown)).program(), small);
    EXPECT_TRUE(plain.covered.empty());
    EXPECT_EQ(smooth.depth, plain.depth);
    EXPECT_EQ(smooth.normal, plain.normal);
    EXPECT_EQ(smooth.node_id, plain.node_id);
    EXPECT_EQ(smooth.material_id, plain.material_id);
    EXPECT_EQ(smooth.steps, plain.steps);
    int changed = 0;
    for (std::size_t i = 0; i < plain.colour.size(); ++i) changed += plain.colour[i] != smooth.colour[i];
    EXPECT_GT(changed, 100);
    EXPECT_LT(changed, 400);
}

TEST(Coverage, lays_a_backdrop_behind_the_share_that_is_open)
{
    graph::Program program = white(disc).program();
    GpuDevice gpu;
    FrameRequest request = small;
    request.sky = false;
    for (bool layers : {false, true}) {
        request.layers = layers;
        Exposure exposure{.backdrop = graph::Backdrop::colour, .backdrop_colour = vec3(0.5f, 0, 0)};
        for (Frame frame : {render_on_cpu(program, request), gpu.render(program, request)}) {
            lay_backdrop(frame, {0, 0, frame.width, frame.height}, exposure, drawn_area(request));
            for (std::size_t i = 0; i < frame.colour.size(); ++i) {
                float covered = frame.covered[i];
                vec3 right = covered * vec3(1) + (1 - covered) * exposure.backdrop_colour;
                ASSERT_LT(glm::distance(frame.colour[i], right), 1e-3f) << layers << " " << i << " " << covered;
                if (layers) {
                    ASSERT_LT(glm::distance(frame.layers->colour(i), right), 1e-3f);
                }
            }
        }
    }
}

TEST(Coverage, makes_the_edge_of_a_transparent_picture_half_transparent)
{
    Exposure exposure{.backdrop = graph::Backdrop::transparent};
    FrameRequest request = sample_of(small, exposure, 0);
    EXPECT_FALSE(request.sky);
    Frame frame = render_on_cpu(white(disc).program(), request);
    lay_backdrop(frame, {0, 0, frame.width, frame.height}, exposure, drawn_area(request));
    Accumulator sums;
    sums.add(frame, exposure);
    sums.resolve(frame, exposure);
    EXPECT_EQ(frame.alpha, frame.covered);
    double area = 0;
    for (float alpha : frame.alpha) area += alpha * 4.0 / static_cast<double>(frame.alpha.size());
    EXPECT_NEAR(area, disc_area, 0.002 * disc_area);
}

// Glass, a mirror, fog, soft shadows and a checkered floor.
Scene with_everything()
{
    Scene s;
    NodeId glass = s.node("paint", {{"d", moved(s, s.node("sphere", {{"radius", 0.6f}}), {-0.7f, 0.7f, 0})},
                                    {"material", s.node("glass")}});
    NodeId mirror = s.node("paint", {{"d", moved(s, turned_box(s), {0.8f, 0.8f, 0})},
                                     {"material", s.node("phong", {{"reflection", 0.5f}})}});
    NodeId floor = s.node("paint", {{"d", s.node("plane")}, {"material", s.node("checker")}});
    NodeId output = s.show(s.node("union", {{"a", floor}, {"b", s.node("union", {{"a", glass}, {"b", mirror}})}}));
    s.wire(s.node("perspective", {{"position", vec3(0.5f, 2, 4)}, {"target", vec3(0, 0.6f, 0)}}), output, "camera");
    s.wire(s.node("gradient"), output, "sky");
    s.node("point", {{"shadow", std::string("soft_corrected")}});
    s.document.bounces = 3;
    s.document.fog.density = 0.05f;
    return smoothed(std::move(s));
}

TEST(Coverage, is_the_same_on_both_devices_with_everything_and_for_every_eye)
{
    graph::Program program = with_everything().program();
    GpuDevice gpu;
    for (bool layers : {false, true})
        for (Eye eye : {Eye::centre, Eye::left}) {
            FrameRequest request{.width = 128, .height = 72, .eye = eye};
            request.layers = layers;
            Frame a = render_on_cpu(program, request), b = gpu.render(program, request);
            EXPECT_LE(share_apart(picture(a, View::beauty, 256), picture(b, View::beauty, 256)), 0.005);
            std::size_t apart = 0;
            for (std::size_t i = 0; i < a.covered.size(); ++i) apart += std::abs(a.covered[i] - b.covered[i]) > 0.01f;
            EXPECT_LE(static_cast<double>(apart), 0.005 * static_cast<double>(a.covered.size()));
        }
}

// With a shutter a sample is drawn as lattices of its pixels, each at a moment of its own: where nothing moves, the same
// picture.
TEST(Coverage, is_the_same_in_the_lattices_of_a_shutter)
{
    graph::Program program = white(disc).program();
    GpuDevice gpu;
    using Device = std::function<Frame(const FrameRequest&)>;
    for (const Device& render : {Device([&](const FrameRequest& request) { return render_on_cpu(program, request); }),
                                 Device([&](const FrameRequest& request) { return gpu.render(program, request); })}) {
        Frame whole = render(sample_of(small, {}, 1)), woven(small.width, small.height);
        draw_sample(woven, small, {.shutter = 0.5f}, 1, [&](Frame& frame, const FrameRequest& request) {
            frame = render(request);
            return true;
        });
        ASSERT_EQ(woven.covered.size(), whole.covered.size());
        for (std::size_t i = 0; i < whole.covered.size(); ++i) {
            ASSERT_NEAR(woven.covered[i], whole.covered[i], 2e-3f) << i;
            ASSERT_NEAR(woven.colour[i].r, whole.colour[i].r, 2e-3f) << i;
        }
    }
}

TEST(Coverage, keeps_the_sum_of_the_layers)
{
    graph::Program program = with_everything().program();
    GpuDevice gpu;
    FrameRequest request{.width = 96, .height = 54}, layered = request;
    layered.layers = true;
    auto apart = [](const Frame& plain, const Frame& whole) {
        Frame sum(plain.width, plain.height);
        for (std::size_t i = 0; i < sum.colour.size(); ++i) sum.colour[i] = whole.layers->colour(i);
        Picture a = picture(plain, View::beauty, 256), b = picture(sum, View::beauty, 256);
        int off = 0;
        for (std::size_t i = 0; i < a.rgb.size(); ++i) off += std::abs(a.rgb[i] - b.rgb[i]) > 1;
        return off;
    };
    EXPECT_EQ(apart(render_on_cpu(program, request), render_on_cpu(program, layered)), 0);
    EXPECT_EQ(apart(gpu.render(program, request), gpu.render(program, layered)), 0);
}

// Of the bytes of two pictures.
double rms(const Picture& a, const Picture& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(a.rgb[i] - b.rgb[i], 2);
    return std::sqrt(sum / static_cast<double>(a.rgb.size()));
}

// The numbers of docs/gallery/002.md: the part of the scene that it shows, against 12 x 12 samples a pixel.
TEST(Coverage, of_the_seeds_tori_is_between_one_sample_and_many)
{
    auto library = graph::Library::embedded();
    graph::Document document =
        graph::open_scene(FIELDWRIGHT_SOURCE_DIR "/examples/seeds/002_three_tori.scene.json", *library);
    FrameRequest request{.width = 280, .height = 175};
    request.part = Area{120, 34, 84, 80};
    auto drawn = [&](bool coverage, const Exposure& exposure) {
        document.march.coverage = coverage;
        graph::Program program = graph::lower(document, library);
        Frame mean = render_on_cpu(program, request);
        Accumulator sums;
        while (sums.count() < sample_count(exposure))
            sums.add(render_on_cpu(program, sample_of(request, exposure, sums.count())), exposure);
        sums.resolve(mean, exposure);
        return picture(mean, View::beauty, 256);
    };
    Picture right = drawn(false, {.grid = 12});
    double none = rms(drawn(false, {}), right), coverage = rms(drawn(true, {}), right),
           samples = rms(drawn(false, {.samples = 16}), right);
    std::printf("root mean square error of 255: none %.1f, coverage %.1f, 16 samples %.1f\n", none, coverage, samples);
    EXPECT_LT(coverage, 0.65 * none) << "the edges of shadows are left";
    EXPECT_LT(samples, coverage);
}

}  // namespace
}  // namespace fieldwright::tests
