// Exposure and tone mapping: published curves, and what they leave alone.
#include "renderer/look.h"

#include "renderer/picture.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;
using graph::ToneMap;

vec3 shown(const Look& look, vec3 colour)
{
    Rows in(3), out(3);
    for (int k = 0; k < 3; ++k) in.lane(k)[0] = colour[k];
    LookFunction{look}(out, 1, in);
    return out.vec3(0, 0);
}

void expect_near(vec3 seen, vec3 wanted, float tolerance = 6e-4f)
{
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], wanted[k], tolerance) << "channel " << k;
}

TEST(ToneMaps, of_agx_are_the_published_curve)
{
    Look agx{ToneMap::agx};
    expect_near(shown(agx, vec3(0.18f)), vec3(0.2145f));
    expect_near(shown(agx, vec3(1)), vec3(0.590f));
    expect_near(shown(agx, vec3(8)), vec3(0.9366f));
    expect_near(shown(agx, {1, 0, 0}), {0.7194f, 0.0395f, 0.0396f});
}

TEST(ToneMaps, of_aces_are_the_published_fit)
{
    Look aces{ToneMap::aces};
    expect_near(shown(aces, vec3(0.18f)), vec3(0.1056f));
    expect_near(shown(aces, vec3(1)), vec3(0.6191f));
    expect_near(shown(aces, vec3(8)), vec3(0.9630f));
}

TEST(ToneMaps, of_neutral_keep_base_colours_and_compress_highlights)
{
    Look neutral{ToneMap::neutral};
    expect_near(shown(neutral, vec3(0.18f)), vec3(0.14f));
    expect_near(shown(neutral, vec3(1)), vec3(0.8691f));
    expect_near(shown(neutral, vec3(8)), vec3(0.9923f));
    expect_near(shown(neutral, {1, 0, 0}), {0.88f, 0.0156f, 0.0156f});
    expect_near(shown(neutral, {0.5f, 0.3f, 0.1f}), {0.46f, 0.26f, 0.06f});
}

TEST(ToneMaps, rise_without_end_and_never_leave_what_a_screen_shows)
{
    for (ToneMap tone_map : {ToneMap::neutral, ToneMap::agx, ToneMap::aces}) {
        float last = -1;
        for (float stops = -12; stops <= 12; stops += 0.25f) {
            float grey = shown({tone_map}, vec3(std::exp2(stops))).g;
            EXPECT_GE(grey, last - 1e-5f) << static_cast<int>(tone_map) << " at " << stops;
            EXPECT_LE(grey, 1.02f);
            last = grey;
        }
        expect_near(shown({tone_map}, vec3(-1)), vec3(0), 1e-3f);
    }
}

TEST(Exposure, doubles_the_light_by_the_stop)
{
    expect_near(shown({.exposure = 2}, {0.1f, 0.2f, 3}), {0.4f, 0.8f, 12}, 1e-5f);
    expect_near(shown({.exposure = -1}, vec3(1)), vec3(0.5f), 1e-6f);
}

TEST(Looks, are_for_beauty_and_its_glow)
{
    Frame frame(1, 1);
    frame.colour[0] = vec3(0.18f);
    frame.steps[0] = 100;
    frame.normal[0] = vec3(0, 1, 0);
    frame.depth[0] = 3;
    Look look{ToneMap::aces, 1};
    for (const std::string& name : view_names()) {
        View view = *view_from_name(name);
        bool same = picture(frame, view, 256, look).rgb == picture(frame, view, 256).rgb;
        EXPECT_EQ(same, view != View::beauty && view != View::glow) << name;
    }
}

TEST(Looks, show_the_opaque_part_of_a_pixel_in_its_own_colour)
{
    Frame frame(1, 1);
    frame.colour[0] = vec3(0.09f);
    frame.alpha = {0.5f};
    Picture half = picture(frame, View::beauty, 256);
    EXPECT_EQ(half.alpha, std::vector<unsigned char>{128});
    EXPECT_EQ(half.rgb[0], 118) << "0.18, not 0.09";
}

}  // namespace
}  // namespace fieldwright::tests
