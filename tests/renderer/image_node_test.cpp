// The image node on both machines: the shape that was in the picture, never overshot.
#include "assets/image_bake.h"
#include "codegen/glsl.h"
#include "tests/support/fields.h"
#include "tests/support/glslang.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

constexpr int side = 100;             // px
constexpr float height = 2;           // m
constexpr float radius = 0.6f;        // m
const glm::vec2 centre{0.1f, -0.2f};  // m

assets::Pixels disc()
{
    assets::Pixels pixels{side, side, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            glm::vec2 p = (height / side) * (glm::vec2(x, side - 1 - y) + 0.5f) - 0.5f * height;
            float grey = std::clamp(0.5f + (glm::distance(p, centre) - radius) * side / height, 0.0f, 1.0f);
            pixels.rgba.insert(pixels.rgba.end(), {grey, grey, grey, 1});
        }
    return pixels;
}

struct ImageScene {
    explicit ImageScene(const graph::BakedImage& image, int detail = side)
    {
        graph::ImageRequest request{.path = "disc.png", .detail = detail};
        images[request] = std::make_shared<const graph::BakedImage>(image);
        node = scene.node("image", {{"picture", std::string("disc.png")}, {"detail", detail}, {"height", height}});
        scene.show(scene.node("extrude", {{"d", node}}));
    }
    graph::Program program(bool own = true) const
    {
        return scene.program({.bounds = own, .root = own ? node : NodeId{}, .images = &images});
    }

    Scene scene;
    NodeId node;
    graph::BakedImages images;
};

ImageScene disc_scene(int detail = side) { return ImageScene(assets::baked(disc(), {.detail = detail}, "it"), detail); }

std::vector<glm::vec3> plane_points(Random& random, float reach, std::size_t count)
{
    std::vector<glm::vec3> points;
    while (points.size() < count) points.emplace_back(random.between(-reach, reach), random.between(-reach, reach), 0);
    return points;
}

TEST(ImageNode, is_the_circle_that_was_drawn)
{
    Random random(1);
    Field field(disc_scene().program());
    std::vector<glm::vec3> points = plane_points(random, 0.99f, 4000);
    std::vector<float> distances = field.at(points);
    float pixel = height / side;
    for (std::size_t i = 0; i < points.size(); ++i) {
        float circle = glm::distance(glm::vec2(points[i]), centre) - radius;
        if (circle < 10 * pixel - radius) continue;  // the tip of the cone is rounded
        EXPECT_NEAR(field.lipschitz() * distances[i], circle, 0.15f * pixel) << points[i].x << ", " << points[i].y;
    }
    EXPECT_LT(field.lipschitz(), 1.25f);
}

TEST(ImageNode, never_overshoots_outside_of_its_picture)
{
    Random random(2);
    Field field(disc_scene().program());
    std::vector<glm::vec3> points = plane_points(random, 6, 4000);
    std::vector<float> distances = field.at(points);
    float pixel = height / side;
    for (std::size_t i = 0; i < points.size(); ++i) {
        float circle = glm::distance(glm::vec2(points[i]), centre) - radius;
        if (circle < 0) continue;
        EXPECT_LE(distances[i], circle + 0.15f * pixel) << points[i].x << ", " << points[i].y;
        EXPECT_TRUE(circle < 1 || distances[i] > 0.6f * circle) << points[i].x << ", " << points[i].y;
    }
}

TEST(ImageNode, is_nowhere_steeper_than_one)
{
    Random random(3);
    assets::Pixels noise{30, 20, {}};
    for (int i = 0; i < 600; ++i) {
        float grey = random.between(0, 1);
        noise.rgba.insert(noise.rgba.end(), {grey, grey, grey, 1});
    }
    Field field(ImageScene(assets::baked(noise, {.detail = 30}, "it"), 30).program());
    std::vector<glm::vec3> from = plane_points(random, 2.5f, 20000), to;
    for (const glm::vec3& p : from) to.push_back(p + std::pow(10.0f, random.between(-3, -1)) * random.direction());
    for (glm::vec3& p : to) p.z = 0;
    std::vector<float> here = field.at(from), there = field.at(to);
    for (std::size_t i = 0; i < from.size(); ++i)
        EXPECT_LE(std::abs(there[i] - here[i]), 1.0001f * glm::distance(from[i], to[i]) + 2e-5f);
}

TEST(ImageNode, is_alike_on_both_machines)
{
    Random random(4);
    Field field(disc_scene().program());
    std::vector<glm::vec3> points = plane_points(random, 2, 4096);
    renderer::GpuDevice gpu;
    Agreement agreement = compare_machines(field, points, gpu.distances(field.program, field.time, points));
    EXPECT_EQ(agreement.differing, 0u) << agreement.worst;
    EXPECT_GE(agreement.compared, 4000u);
}

TEST(ImageNode, shares_one_list_with_those_that_ask_alike)
{
    ImageScene one = disc_scene();
    std::size_t single = one.program(false).list_data.size();
    NodeId other = one.scene.node("image", {{"picture", std::string("disc.png")}, {"detail", side}});
    NodeId both = one.scene.node("union", {{"a", one.node}, {"b", other}});
    one.scene.show(one.scene.node("extrude", {{"d", both}}));
    EXPECT_EQ(one.program(false).list_data.size(), single);
}

TEST(ImageNode, a_picture_that_is_not_there_is_a_problem_and_the_rest_is_drawn)
{
    ImageScene broken(graph::BakedImage{{}, "the picture disc.png is not there; choose another file"});
    NodeId box = broken.scene.node("box");
    NodeId extruded = broken.scene.node("extrude", {{"d", broken.node}});
    broken.scene.show(broken.scene.node("union", {{"a", extruded}, {"b", box}}));
    graph::Program program = broken.program(false);
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0],
              (graph::Problem{broken.node, "the picture disc.png is not there; choose another file"}));
    EXPECT_NEAR(Field(program).at(std::vector<glm::vec3>{{2, 0, 0}})[0], 1.5f, 0.01f);
}

TEST(ImageNode, a_picture_still_being_read_is_a_note)
{
    ImageScene waiting = disc_scene();
    waiting.images.clear();
    graph::Program program = waiting.program(false);
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].sentence, "reading the picture disc.png");
    EXPECT_EQ(program.problems[0].severity, graph::Problem::Severity::note);
}

TEST(ImageNode, exports_with_few_samples_and_says_so_with_many)
{
    ImageScene small = disc_scene();
    graph::Program program = small.program(false);
    ASSERT_EQ(codegen::export_refusal(program), "");
    Field field(program);
    std::string text = codegen::print_export(program, small.scene.document, field.block, "glsl");
    EXPECT_EQ(glslang_errors({text}), "");
    graph::Program large = disc_scene(400).program(false);
    EXPECT_NE(codegen::export_refusal(large).find("lower the detail of its pictures"), std::string::npos);
}

}  // namespace
}  // namespace fieldwright::tests
