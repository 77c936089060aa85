// Shadows against what light and edge give in theory, and that nothing beyond a light casts one.
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>

namespace fieldwright::tests {
namespace {

using glm::vec3;

constexpr std::array kinds = {"hard", "soft", "soft_corrected"};
constexpr float plate_height = 1;

// A floor under a thin plate whose edge is at x = 0.
NodeId floor_and_plate(Scene& s)
{
    NodeId plate = s.node("translate", {{"d", s.node("box", {{"half_size", vec3(4, 0.001f, 9)}})},
                                        {"offset", vec3(-4, plate_height + 0.001f, 0)}});
    return s.node("union", {{"a", s.node("plane")}, {"b", plate}});
}

void darken(Scene& s, NodeId output) { s.wire(s.node("gradient", {{"strength", 0.0f}}), output, "sky"); }

constexpr int columns = 400;
constexpr float seen_width = 2;  // m of the floor, from x = -0.5

// Looks straight down from below the plate.
std::vector<float> row_of_floor(const graph::Program& program)
{
    renderer::FrameRequest request{.width = columns, .height = 2};
    request.camera = renderer::ViewCamera{.position = {0.5f, 0.5f, 0},
                                          .target = {0.5f, 0, 0},
                                          .up = {0, 0, -1},
                                          .orthographic_height = seen_width * 2 / columns};
    renderer::Frame frame = renderer::render_on_cpu(program, request);
    std::vector<float> row;
    for (int x = 0; x < columns; ++x) row.push_back(frame.colour[static_cast<std::size_t>(x)].g);
    return row;
}

float x_of(std::size_t column) { return -0.5f + seen_width * (static_cast<float>(column) + 0.5f) / columns; }

// What of a light reaches the floor, by column.
std::vector<float> visibility(const char* light, std::string_view shadow,
                              std::initializer_list<Scene::Setting> settings)
{
    Scene s;
    darken(s, s.show(floor_and_plate(s)));
    NodeId id = s.node(light, settings);
    s.set(id, "shadow", std::string("off"));
    std::vector<float> open = row_of_floor(s.program());
    s.set(id, "shadow", std::string(shadow));
    std::vector<float> seen = row_of_floor(s.program());
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] /= open[i];
    return seen;
}

float eased(float x)
{
    x = std::clamp(x, 0.0f, 1.0f);
    return x * x * (3 - 2 * x);
}

// Where the visibility passes `level`, as x on the floor.
float crossing(const std::vector<float>& visibility, float level)
{
    for (std::size_t i = 1; i < visibility.size(); ++i)
        if (visibility[i - 1] < level && visibility[i] >= level) return x_of(i);
    return -1;
}

TEST(Shadows, of_every_kind_are_dark_below_and_open_far_away)
{
    for (const char* kind : kinds) {
        std::vector<float> seen = visibility("sun", kind, {{"elevation", 90.0f}, {"sharpness", 8.0f}});
        for (std::size_t i = 0; i < seen.size(); ++i) {
            float x = x_of(i);
            if (x > -0.01f && x < 0.2f) continue;
            EXPECT_NEAR(seen[i], x > 0 ? 1 : 0, 0.02f) << kind << " " << x;
        }
    }
}

// How far the visibility is from that of the ratio beside the edge, at most.
template <typename Ratio>
float worst(const char* kind, float sharpness, const Ratio& ratio)
{
    std::vector<float> seen = visibility("sun", kind, {{"elevation", 90.0f}, {"sharpness", sharpness}});
    float apart = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (x_of(i) > 0) apart = std::max(apart, std::abs(seen[i] - eased(sharpness * ratio(x_of(i)))));
    return apart;
}

TEST(Shadows, soft_ones_follow_the_ratio_beside_an_edge)
{
    // The least ratio is the sine of the angle to the edge; at the closest approach it is the tangent.
    auto sine = [](float x) { return x / std::hypot(x, plate_height); };
    auto tangent = [](float x) { return x / plate_height; };
    for (float sharpness : {2.0f, 4.0f, 8.0f}) {
        float plain = worst("soft", sharpness, sine), corrected = worst("soft_corrected", sharpness, tangent);
        EXPECT_LT(plain, 0.005f) << sharpness;
        EXPECT_LT(corrected, 0.002f) << sharpness;
    }
    EXPECT_LT(worst("soft_corrected", 4, tangent), 0.5f * worst("soft", 4, sine)) << "steps miss the least ratio";
}

TEST(Shadows, of_a_ball_of_light_are_as_wide_as_its_penumbra)
{
    constexpr float radius = 0.15f, height = 4;
    std::vector<float> seen = visibility("sphere_area", "soft_corrected",
                                         {{"position", vec3(0, height, 0)}, {"radius", radius}, {"intensity", 20.0f}});
    // From where the whole ball is hidden to where it is seen: 2 r H / (L - H), here from the hard shadow's edge on.
    float penumbra = 2 * radius * plate_height / (height - plate_height);
    float measured = crossing(seen, 0.97f) - crossing(seen, 0.03f);
    float eased_share = 0.79f;  // of the width, between 3 % and 97 % of smoothstep
    EXPECT_NEAR(measured / eased_share, penumbra, 0.12f * penumbra);
}

TEST(Shadows, end_at_the_light)
{
    // The wall is above the lamp: it stands behind it for all of the floor.
    for (const char* light : {"point", "spot", "sphere_area"})
        for (const char* kind : kinds) {
            Scene s;
            NodeId wall = s.node(
                "translate", {{"d", s.node("box", {{"half_size", vec3(5, 0.05f, 5)}})}, {"offset", vec3(0, 2.4f, 0)}});
            darken(s, s.show(s.node("union", {{"a", s.node("plane")}, {"b", wall}})));
            NodeId id = s.node(light, {{"position", vec3(0.3f, 2, 0)}, {"shadow", std::string("off")}});
            std::vector<float> open = row_of_floor(s.program());
            s.set(id, "shadow", std::string(kind));
            std::vector<float> seen = row_of_floor(s.program());
            for (std::size_t i = 0; i < seen.size(); ++i)
                ASSERT_NEAR(seen[i], open[i], 0.01f * open[i]) << light << " " << kind << " at " << x_of(i);
            EXPECT_GT(open[200], 0.01f);
        }
}

TEST(Lights, fade_as_their_falloff_says)
{
    auto lit = [](const char* falloff, float height) {
        Scene s;
        darken(s, s.show(s.node("plane")));
        s.node("point", {{"position", vec3(0.5f, height, 0)}, {"intensity", 1.0f}, {"falloff", std::string(falloff)}});
        return row_of_floor(s.program())[columns / 2];
    };
    EXPECT_NEAR(lit("inverse_square", 1) / lit("inverse_square", 2), 4, 0.01f);
    EXPECT_NEAR(lit("power", 2) / lit("inverse_square", 2), 1 / (4 * M_PI), 1e-4f);
    EXPECT_NEAR(lit("none", 2) / lit("inverse_square", 1), 1, 1e-3f);
}

TEST(Lights, a_spot_shines_inside_its_cone_only)
{
    Scene s;
    NodeId matt = s.node("phong", {{"specular", 0.0f}});
    darken(s, s.show(s.node("paint", {{"d", s.node("plane")}, {"material", matt}})));
    s.node("spot", {{"position", vec3(0, 1, 0)},
                    {"target", vec3(0, 0, 0)},
                    {"angle", 60.0f},
                    {"softness", 0.3f},
                    {"falloff", std::string("none")}});
    std::vector<float> seen = row_of_floor(s.program());
    float full = seen[100];  // x = 0
    EXPECT_GT(full, 1);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        float degrees = glm::degrees(std::atan(std::abs(x_of(i)))), cosine = std::cos(glm::radians(degrees));
        if (degrees > 20.5f && degrees < 30.5f) continue;
        EXPECT_NEAR(seen[i], degrees < 25 ? full * cosine : 0, 0.01f * full) << degrees;
    }
}

std::string text_of(const Scene& s)
{
    graph::Program program = s.program();
    return codegen::print_fragment_shader(program, field::evaluate_frame(program, 0), codegen::Placement::literals);
}

TEST(Shadows, kinds_are_structure_and_numbers_are_not)
{
    Scene s;
    s.show(s.node("sphere"));
    NodeId sun = s.node("sun");
    std::string hard = text_of(s);
    EXPECT_NE(hard.find("int scene_shadow(int index)\n{\n    return 1;\n}"), std::string::npos);
    EXPECT_NE(hard.find("march.tracks_cone = 0;"), std::string::npos);
    s.document.occlusion.samples = 9;
    s.document.march.normal_step = 0.01f;
    EXPECT_EQ(text_of(s), hard);
    s.set(sun, "shadow", std::string("soft"));
    EXPECT_NE(text_of(s).find("march.tracks_cone = 1;"), std::string::npos);
    s.node("point");
    EXPECT_NE(text_of(s).find("    if (index == 1) return 1;\n    return 2;\n"), std::string::npos);
}

}  // namespace
}  // namespace fieldwright::tests
