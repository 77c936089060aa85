// What skies show in one direction, and what they give to a matt surface.
#include "field/evaluator.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using glm::vec3;

class Sky {
public:
    Sky(std::string_view type, std::initializer_list<Scene::Setting> settings, const graph::BakedImages& images = {})
    {
        Scene s;
        s.wire(s.node(type, settings), s.show(s.node("sphere")), "sky");
        program_ = s.program({.images = &images});
        block_ = field::evaluate_frame(program_, 0);
        EXPECT_TRUE(program_.problems.empty());
    }

    vec3 operator()(const vec3& direction, float spread = 0) const
    {
        field::Evaluator evaluator(program_, program_.sky);
        field::Evaluator::Workspace workspace(evaluator);
        vec3 unit = glm::normalize(direction);
        for (int k = 0; k < 3; ++k) workspace.input(k)[0] = unit[k];
        workspace.input(3)[0] = spread;
        evaluator.evaluate(workspace, block_, 1);
        return {workspace.result(0)[0], workspace.result(1)[0], workspace.result(2)[0]};
    }

private:
    graph::Program program_;
    std::vector<float> block_;
};

TEST(SunAndSky, shows_the_disc_where_the_sun_light_comes_from)
{
    Sky sky("sun_and_sky", {{"follow_sun", false}, {"elevation", 30.0f}, {"azimuth", 70.0f}, {"disc", 2.0f}});
    float up = std::sin(glm::radians(30.0f)), level = std::cos(glm::radians(30.0f));
    vec3 sun(level * std::sin(glm::radians(70.0f)), up, level * std::cos(glm::radians(70.0f)));
    EXPECT_GT(sky(sun).r, 5);
    vec3 beside = sun + vec3(0, std::tan(glm::radians(3.0f)), 0);
    EXPECT_LT(sky(beside).r, 2);
    EXPECT_LT(sky(sun, 1).r, 2) << "the light of the disc is the sun node's";
    Sky without("sun_and_sky", {{"follow_sun", false}, {"elevation", 30.0f}, {"azimuth", 70.0f}, {"disc", 0.0f}});
    EXPECT_LT(without(sun).r, 2);
}

TEST(SunAndSky, is_blue_above_pale_at_the_horizon_and_red_at_dusk)
{
    Sky noon("sun_and_sky", {{"follow_sun", false}, {"elevation", 60.0f}, {"azimuth", 0.0f}});
    vec3 zenith = noon({0, 1, 0}), horizon = noon({0, 0.02f, -1});
    EXPECT_GT(zenith.b, 1.8f * zenith.r);
    EXPECT_LT(horizon.b, 1.5f * horizon.r);
    EXPECT_GT(horizon.g, zenith.g);
    Sky dusk("sun_and_sky", {{"follow_sun", false}, {"elevation", 2.0f}, {"azimuth", 0.0f}});
    vec3 glow = dusk({0, 0.1f, 1});
    EXPECT_GT(glow.r, 1.5f * glow.b);
    Sky night("sun_and_sky", {{"follow_sun", false}, {"elevation", -30.0f}});
    EXPECT_LT(night({0, 1, 0}).b, 0.01f);
}

// 8 x 4 colours: red counts columns, green rows from the top; what is gathered is blue.
graph::BakedImages numbered_picture()
{
    auto image = std::make_shared<graph::BakedImage>();
    image->list.emplace_back(8, 4, 2, 2);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) image->list.emplace_back(x, y, 0, 0);
    for (int i = 0; i < 4; ++i) image->list.emplace_back(0, 0, 9, 0);
    return {{{.path = "sky.hdr", .part = std::string(graph::panorama), .detail = 360}, image}};
}

vec3 around(float column, float row)
{
    float turn = glm::radians(45.0f) * (column + 0.5f - 4), down = glm::radians(45.0f) * (row + 0.5f);
    return {std::sin(down) * std::sin(turn), std::cos(down), -std::sin(down) * std::cos(turn)};
}

void expect_near(const vec3& a, const vec3& b)
{
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 0.01f);
}

TEST(Environment, wraps_the_picture_with_its_middle_ahead)
{
    graph::BakedImages images = numbered_picture();
    graph::Value file = std::string("sky.hdr");
    Sky sky("environment", {{"picture", file}}, images);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 8; ++column)
            expect_near(sky(around(float(column), float(row))), {column, row, 0});
    expect_near(sky({0, 0, -1}), {3.5f, 1.5f, 0});
    expect_near(sky(around(2.5f, 1)), {2.5f, 1, 0});
    EXPECT_NEAR(sky({0, 1, 0}).g, 0, 0.01f);
    EXPECT_NEAR(sky({0, -1, 0}).g, 3, 0.01f);
    expect_near(sky(around(5, 2), 1), {0, 0, 9});
    Sky turned("environment", {{"picture", file}, {"turn", 90.0f}, {"strength", 0.5f}}, images);
    expect_near(turned(around(5, 1)), {1.5f, 0.5f, 0});
}

}  // namespace
}  // namespace fieldwright::tests
