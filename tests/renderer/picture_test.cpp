// Views, anaglyphs, the sRGB encoding and picture files.
#include "renderer/picture.h"

#include "graph/problem.h"
#include "renderer/rows.h"
#include "renderer/srgb_table.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;
using Bytes = std::array<int, 3>;

Frame one_colour(vec3 colour)
{
    Frame frame(1, 1);
    frame.colour[0] = colour;
    return frame;
}

Bytes first_pixel(const Picture& picture) { return {picture.rgb[0], picture.rgb[1], picture.rgb[2]}; }

Bytes shown(const Frame& frame, View view, int step_limit = 256)
{
    return first_pixel(picture(frame, view, step_limit));
}

void expect_near(const Bytes& seen, const Bytes& wanted, int tolerance)
{
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], wanted[k], tolerance) << "channel " << k;
}

std::string file_bytes(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class PictureFile : public testing::Test {
protected:
    PictureFile() : folder_(std::filesystem::temp_directory_path() / ("picture_test_" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(folder_);
    }
    ~PictureFile() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
};

Picture gradient()
{
    Picture picture{37, 19, std::vector<unsigned char>(37 * 19 * 3)};
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = static_cast<unsigned char>(i * 7 % 256);
    return picture;
}

TEST(Views, are_found_by_their_names)
{
    for (std::size_t i = 0; i < view_names().size(); ++i)
        EXPECT_EQ(view_from_name(view_names()[i]), static_cast<View>(i));
    EXPECT_FALSE(view_from_name("heat"));
    std::set<std::string> titles;
    for (const ViewKind& kind : views()) {
        EXPECT_TRUE(titles.insert(kind.title).second) << kind.name;
        EXPECT_TRUE(std::string(kind.help).ends_with('.')) << kind.name;
    }
}

TEST(Beauty, is_clamped_and_encoded_as_srgb)
{
    EXPECT_EQ(shown(one_colour(vec3(0.18f, 0.5f, 1.0f)), View::beauty), (Bytes{118, 188, 255}));
    EXPECT_EQ(shown(one_colour(vec3(-1.0f, 9.0f, 0.002f)), View::beauty), (Bytes{0, 255, 7}));
}

TEST(Beauty, has_the_byte_of_the_shading_librarys_encoding_at_every_value)
{
    const RowFunction encode("srgb_encode_channel", field::kernels());
    Rows x(1), encoded(1);
    for (int batch = -2; batch < 400; ++batch) {
        for (int i = 0; i < field::row_width; ++i)
            x.lane(0)[i] = static_cast<float>(batch * field::row_width + i) * (1.0f / 99991.0f);
        encode(encoded, field::row_width, x);
        for (int i = 0; i < field::row_width; ++i) {
            int byte = static_cast<int>(std::floor(255.0f * encoded.lane(0)[i] + 0.5f));
            ASSERT_EQ(SrgbTable::shared().byte(x.lane(0)[i]), byte) << x.lane(0)[i];
        }
    }
    EXPECT_EQ(SrgbTable::shared().byte(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(SrgbTable::shared().byte(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(SrgbTable::shared().byte(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Steps, are_viridis_from_none_to_the_limit_and_magenta_when_exhausted)
{
    Frame frame(1, 1);
    expect_near(shown(frame, View::steps), {0x44, 0x01, 0x54}, 4);
    frame.steps[0] = 128;
    expect_near(shown(frame, View::steps), {0x21, 0x90, 0x8c}, 4);
    frame.steps[0] = 256;
    expect_near(shown(frame, View::steps), {0xfd, 0xe7, 0x25}, 4);
    frame.exhausted[0] = 1;
    EXPECT_EQ(shown(frame, View::steps), (Bytes{255, 0, 255}));
}

TEST(Steps, end_at_the_full_scale_in_the_map_that_is_asked_for)
{
    Frame frame(1, 1);
    frame.steps[0] = 40;
    Display display{.view = View::steps, .colour_map = ColourMap::inferno, .full_scale = 40};
    EXPECT_EQ(first_pixel(picture(frame, frame, display, 256)), (Bytes{0xfc, 0xff, 0xa4}));
    frame.steps[0] = 0;
    EXPECT_EQ(first_pixel(picture(frame, frame, display, 256)), (Bytes{0, 0, 4}));
}

TEST(Glow, is_magenta_light_over_the_picture_and_grows_with_the_steps)
{
    Frame frame = one_colour(vec3(0.2f));
    EXPECT_EQ(shown(frame, View::glow, 100), shown(frame, View::beauty, 100));
    frame.steps[0] = 30;
    // 0.2 + 0.3 of red and blue, 0.2 of green, stored.
    EXPECT_EQ(shown(frame, View::glow, 100), (Bytes{188, 124, 188}));
    frame.exhausted[0] = 1;
    EXPECT_EQ(shown(frame, View::glow, 100), (Bytes{255, 124, 255}));
}

TEST(Layers, are_shown_as_what_they_are)
{
    Frame frame(1, 1, true);
    frame.layers->albedo[0] = vec3(0.18f, 0.5f, 1.0f);
    EXPECT_EQ(shown(frame, View::albedo), (Bytes{118, 188, 255}));
    frame.layers->position[0] = vec3(3.25f, -0.5f, 2);
    expect_near(shown(frame, View::position), {64, 128, 0}, 1);
    frame.layers->shadow[0] = 0.5f;
    expect_near(shown(frame, View::shadow), {128, 128, 128}, 1);
    frame.layers->gradient_length[0] = 2;
    expect_near(shown(frame, View::gradient), {0xfd, 0xe7, 0x25}, 1);
    frame.layers->shadow_steps[0] = 256;
    expect_near(shown(frame, View::shadow_steps), {0xfd, 0xe7, 0x25}, 1);
}

TEST(Layers, that_are_not_there_are_black)
{
    for (std::size_t i = 0; i < views().size(); ++i) {
        if (!views()[i].layers) continue;
        EXPECT_EQ(shown(Frame(1, 1), static_cast<View>(i)), (Bytes{0, 0, 0})) << views()[i].name;
    }
}

TEST(Views, show_a_miss_as_black)
{
    for (View view : {View::normal, View::depth, View::id}) EXPECT_EQ(shown(Frame(1, 1), view), (Bytes{0, 0, 0}));
}

TEST(Normals, are_stored_as_half_plus_half)
{
    Frame frame(1, 1);
    frame.normal[0] = vec3(0, 0, 1);
    EXPECT_EQ(shown(frame, View::normal), (Bytes{128, 128, 255}));
    frame.normal[0] = vec3(-1, 0, 0);
    EXPECT_EQ(shown(frame, View::normal), (Bytes{0, 128, 128}));
}

TEST(Depth, darkens_with_distance_and_is_half_at_five_metres)
{
    Frame frame(1, 1);
    frame.depth[0] = 0;
    EXPECT_EQ(shown(frame, View::depth), (Bytes{255, 255, 255}));
    frame.depth[0] = 5;
    EXPECT_EQ(shown(frame, View::depth), (Bytes{188, 188, 188}));
}

TEST(Ids, have_colours_of_their_own)
{
    Frame frame(1, 1);
    std::set<Bytes> colours;
    for (frame.node_id[0] = 1; frame.node_id[0] <= 256; ++frame.node_id[0]) colours.insert(shown(frame, View::id));
    EXPECT_GE(colours.size(), 250u);
}

TEST(Anaglyph, naive_takes_red_from_the_left_eye_and_the_rest_from_the_right)
{
    Frame left = one_colour(vec3(1, 0, 0)), right = one_colour(vec3(0, 0.5f, 1));
    EXPECT_EQ(first_pixel(picture(left, right, {.stereo = Stereo::naive}, 256)), (Bytes{255, 188, 255}));
    EXPECT_EQ(first_pixel(picture(right, left, {.stereo = Stereo::naive}, 256)), (Bytes{0, 0, 0}));
}

TEST(Anaglyph, dubois_keeps_white_and_mixes_colours_in_linear_light)
{
    Frame white = one_colour(vec3(1)), black = one_colour(vec3(0));
    expect_near(first_pixel(picture(white, white, {.stereo = Stereo::dubois}, 256)), {255, 255, 255}, 1);
    // Rows of the matrices summed: 1.132965 and less than 0 on the left; less than 0, 1.0936662 and 1.0412863 on the right.
    EXPECT_EQ(first_pixel(picture(white, black, {.stereo = Stereo::dubois}, 256)), (Bytes{255, 0, 0}));
    EXPECT_EQ(first_pixel(picture(black, white, {.stereo = Stereo::dubois}, 256)), (Bytes{0, 255, 255}));
    // 0.456100 of red is 0.7064 encoded.
    EXPECT_EQ(first_pixel(picture(one_colour(vec3(1, 0, 0)), black, {.stereo = Stereo::dubois}, 256)),
              (Bytes{180, 0, 0}));
}

TEST_F(PictureFile, reads_back_what_was_written)
{
    write_png(folder_ / "a.png", gradient());
    Picture read = read_png(folder_ / "a.png");
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 19);
    EXPECT_EQ(read.rgb, gradient().rgb);
}

TEST_F(PictureFile, has_the_same_bytes_for_the_same_pixels_and_leaves_nothing_else_behind)
{
    write_png(folder_ / "a.png", gradient());
    std::string first = file_bytes(folder_ / "a.png");
    write_png(folder_ / "a.png", gradient());
    write_png(folder_ / "b.png", gradient());
    EXPECT_EQ(file_bytes(folder_ / "a.png"), first);
    EXPECT_EQ(file_bytes(folder_ / "b.png"), first);
    EXPECT_EQ(first.find("tIME"), std::string::npos);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 2);
}

int code_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const graph::Failure& failure) {
        return failure.exit_code;
    }
    return 0;
}

TEST_F(PictureFile, says_when_it_cannot_be_written_or_read)
{
    EXPECT_EQ(code_of([&] { write_png(folder_ / "missing" / "a.png", gradient()); }), 5);
    EXPECT_EQ(code_of([&] { read_png(folder_ / "missing.png"); }), 3);
    std::ofstream(folder_ / "text.png") << "no picture";
    EXPECT_EQ(code_of([&] { read_png(folder_ / "text.png"); }), 3);
}

}  // namespace
}  // namespace fieldwright::tests
