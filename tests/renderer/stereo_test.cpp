// Two eyes as one picture: mixes, layouts, what makes eyes fight, and the geometry of the rays.
#include "renderer/picture.h"
#include "renderer/picture_file.h"
#include "tests/graph/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <set>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

constexpr int width = 96, height = 40;

// Colours of all brightnesses, different for each eye.
Frame noise(unsigned seed)
{
    Frame frame(width, height);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> stored(0, 1);
    for (vec3& colour : frame.colour)
        for (int k = 0; k < 3; ++k) colour[k] = std::pow(stored(random), 2.2f);
    return frame;
}

Picture shown(const Display& display) { return picture(noise(1), noise(2), display, 256); }

const unsigned char* pixel(const Picture& picture, int x, int y)
{
    return &picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(x))];
}

bool same_pixel(const Picture& a, int ax, int ay, const Picture& b, int bx, int by)
{
    return std::equal(pixel(a, ax, ay), pixel(a, ax, ay) + 3, pixel(b, bx, by));
}

int largest_difference(const Picture& a, const Picture& b)
{
    int largest = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
    return largest;
}

TEST(StereoModes, are_found_by_their_names_and_say_what_they_are)
{
    std::set<std::string> titles;
    for (std::size_t i = 0; i < stereo_modes().size(); ++i) {
        const StereoMode& mode = stereo_modes()[i];
        EXPECT_EQ(stereo_from_name(mode.name), static_cast<Stereo>(i));
        EXPECT_EQ(stereo_names()[i], mode.name);
        EXPECT_TRUE(titles.insert(mode.title).second);
        EXPECT_TRUE(std::string(mode.help).ends_with('.')) << mode.name;
        EXPECT_EQ(mode.layout == StereoLayout::mixed, mode.left_glass != 0) << mode.name;
    }
    EXPECT_FALSE(stereo_from_name("3d"));
    EXPECT_EQ(stereo_space_from_name("gamma"), StereoSpace::gamma);
}

// ffmpeg makes anaglyphs of our own pair of pictures.
class Ffmpeg : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Ffmpeg, makes_the_same_anaglyph_of_stored_values)
{
    graph::TemporaryFolder folder;
    auto [ours, theirs] = GetParam();
    std::string pair = (folder / "pair.png").string(), made = (folder / "made.png").string();
    write_picture(pair, shown({.stereo = Stereo::side_by_side}), {});
    std::string command = "ffmpeg -v error -y -i " + pair + " -vf stereo3d=sbsl:" + theirs + " -frames:v 1 " + made;
    ASSERT_EQ(std::system(command.c_str()), 0) << "ffmpeg is a package of packages.txt";
    Picture drawn = shown({.stereo = *stereo_from_name(ours), .stereo_space = StereoSpace::gamma});
    EXPECT_LE(largest_difference(drawn, read_png(made)), 1);
}

INSTANTIATE_TEST_SUITE_P(Modes, Ffmpeg,
                         testing::Values(std::pair("naive", "arcc"), std::pair("dubois", "arcd"),
                                         std::pair("dubois-green-magenta", "agmd"),
                                         std::pair("dubois-amber-blue", "aybd"), std::pair("half-colour", "arch"),
                                         std::pair("gray", "arcg"), std::pair("top-bottom", "abl")),
                         [](const auto& mode) { return std::string(mode.param.second); });

TEST(SideBySide, holds_both_eyes_at_full_size_the_left_one_first)
{
    Picture left = picture(noise(1), View::beauty, 256), right = picture(noise(2), View::beauty, 256);
    Picture both = shown({.stereo = Stereo::side_by_side});
    ASSERT_EQ(both.width, 2 * width);
    ASSERT_EQ(both.height, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            ASSERT_TRUE(same_pixel(both, x, y, left, x, y));
            ASSERT_TRUE(same_pixel(both, width + x, y, right, x, y));
        }
}

TEST(Interlace, gives_even_rows_to_the_left_eye)
{
    Picture left = picture(noise(1), View::beauty, 256), right = picture(noise(2), View::beauty, 256);
    Picture rows = shown({.stereo = Stereo::interlace});
    ASSERT_EQ(rows.height, height);
    for (int y = 0; y < height; ++y) ASSERT_TRUE(same_pixel(rows, 5, y, y % 2 == 0 ? left : right, 5, y)) << y;
}

TEST(SwappedEyes, change_places_in_every_mode)
{
    Frame one = noise(1), two = noise(2);
    for (std::size_t i = 1; i < stereo_modes().size(); ++i) {
        Display display{.stereo = static_cast<Stereo>(i)};
        Picture crossed = picture(two, one, display, 256);
        display.swap_eyes = true;
        EXPECT_EQ(picture(one, two, display, 256).rgb, crossed.rgb) << stereo_modes()[i].name;
    }
}

TEST(Optimised, brightens_what_the_left_eye_sees_of_green_and_blue)
{
    Frame grey(1, 1);
    grey.colour[0] = vec3(0.2158605f);  // 0.5020 stored: 128
    Picture linear = picture(grey, grey, {.stereo = Stereo::optimised}, 256);
    EXPECT_EQ(linear.rgb[1], 128);
    // In light 0.2158605^(1/1.5) = 0.35986, which is stored as 162.2; of stored values 0.50196^(1/1.5) = 0.63158: 161.05.
    EXPECT_NEAR(linear.rgb[0], 162, 1);
    Picture gamma = picture(grey, grey, {.stereo = Stereo::optimised, .stereo_space = StereoSpace::gamma}, 256);
    EXPECT_NEAR(gamma.rgb[0], 161, 1);
}

TEST(Split, is_the_naive_anaglyph_left_of_the_divider_and_the_other_right_of_it)
{
    Display display{.stereo = Stereo::dubois, .split = 0.25f};
    Picture split = shown(display), naive = shown({.stereo = Stereo::naive}),
            dubois = shown({.stereo = Stereo::dubois});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_TRUE(same_pixel(split, x, y, x < width / 4 ? naive : dubois, x, y)) << x << " " << y;
}

TEST(Eyes, fight_over_red_in_a_naive_anaglyph_and_not_in_one_of_dubois)
{
    vec3 red(0.8f, 0.1f, 0.05f);
    for (StereoSpace space : {StereoSpace::linear, StereoSpace::gamma}) {
        EXPECT_TRUE(eyes_fight(Stereo::naive, space, red));
        EXPECT_FALSE(eyes_fight(Stereo::dubois, space, red));
        EXPECT_FALSE(eyes_fight(Stereo::gray, space, red));
        EXPECT_FALSE(eyes_fight(Stereo::half_colour, space, red));
    }
    for (const char* name : {"naive", "dubois", "half-colour", "gray"})
        for (float grey : {0.0f, 0.02f, 0.3f, 1.0f})
            EXPECT_FALSE(eyes_fight(*stereo_from_name(name), StereoSpace::linear, vec3(grey))) << name << " " << grey;
    EXPECT_FALSE(eyes_fight(Stereo::side_by_side, StereoSpace::linear, red));
}

TEST(Fights, are_counted_and_marked_with_stripes)
{
    Frame frame(64, 64);
    for (std::size_t i = 0; i < frame.colour.size(); ++i) frame.colour[i] = i % 4 == 0 ? vec3(0.9f, 0, 0) : vec3(0.4f);
    EXPECT_NEAR(fighting_share(frame, Stereo::naive, StereoSpace::linear), 0.25, 1e-9);
    EXPECT_EQ(fighting_share(frame, Stereo::dubois, StereoSpace::linear), 0);
    Display display{.stereo = Stereo::naive};
    Picture plain = picture(frame, frame, display, 256);
    display.rivalry = true;
    Picture marked = picture(frame, frame, display, 256);
    int changed = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (!same_pixel(plain, x, y, marked, x, y)) {
                ++changed;
                EXPECT_EQ(x % 4, 0);
            }
    EXPECT_NEAR(changed, 64 * 64 / 8, 64);  // every other stripe of a quarter of the pixels
}

// Rays of both eyes through one pixel of a camera at the origin that looks along -z.
struct EyePair {
    vec3 origin[2], direction[2];
};
EyePair rays(vec3 direction, bool toe_in)
{
    Rows camera(12), eye(1), interaxial(1), convergence(1), toe(1), seen(12);
    direction = glm::normalize(direction);
    const float lanes[12] = {0, 0, 0, direction.x, direction.y, direction.z, 0, 0, -1, 1, 0, 0};
    for (int k = 0; k < 12; ++k) camera.lane(k)[0] = camera.lane(k)[1] = lanes[k];
    eye.lane(0)[0] = -1, eye.lane(0)[1] = 1;
    interaxial.fill(0, 0.4f), convergence.fill(0, 2), toe.fill(0, toe_in ? 1.0f : 0.0f);
    RowFunction("stereo_ray", field::kernels())(seen, 2, camera, eye, interaxial, convergence, toe);
    EyePair pair;
    for (int i : {0, 1}) pair.origin[i] = seen.vec3(0, i), pair.direction[i] = seen.vec3(3, i);
    return pair;
}

vec3 at_depth(const EyePair& pair, int eye, float depth)
{
    return pair.origin[eye] + pair.direction[eye] * (-depth / pair.direction[eye].z);
}

TEST(Eyes, meet_at_the_convergence_depth_whether_they_turn_or_not)
{
    for (bool toe_in : {false, true}) {
        EyePair middle = rays({0, 0, -1}, toe_in);
        EXPECT_NEAR(middle.origin[1].x - middle.origin[0].x, 0.4f, 1e-6f);
        EXPECT_LT(glm::distance(at_depth(middle, 0, 2), at_depth(middle, 1, 2)), 1e-5f);
        for (int i : {0, 1}) EXPECT_NEAR(glm::length(middle.direction[i]), 1, 1e-6f);
    }
}

TEST(Eyes, see_things_at_one_height_unless_they_turn)
{
    EyePair corner = rays({0.7f, 0.4f, -1}, false);
    EXPECT_LT(glm::distance(at_depth(corner, 0, 2), at_depth(corner, 1, 2)), 1e-5f);
    EXPECT_NEAR(at_depth(corner, 0, 9).y, at_depth(corner, 1, 9).y, 1e-5f);
    EyePair turned = rays({0.7f, 0.4f, -1}, true);
    EXPECT_GT(std::abs(at_depth(turned, 0, 2).y - at_depth(turned, 1, 2).y), 0.02f) << "keystone";
}

}  // namespace
}  // namespace fieldwright::tests
