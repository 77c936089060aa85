// Pictures of the five formats come as pixels; everything else as one sentence.
#include "assets/picture_file.h"

#include "graph/problem.h"
#include "tests/assets/picture_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace fieldwright::assets {
namespace {

using tests::encoded_picture;

const char* const formats[] = {"png", "jpeg", "hdr", "openexr", "tiff"};

void slope(int x, int y, float* rgba)
{
    rgba[0] = static_cast<float>(x) / 15;
    rgba[1] = static_cast<float>(y) / 7;
    rgba[2] = 0.25f;
}

PictureAnswer read(const std::string& bytes, const PictureQuestion& question = {})
{
    return read_picture(Worker(), bytes, "The picture x", question);
}

float shown(float light) { return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f; }

TEST(PictureFile, reads_the_pixels_of_each_format)
{
    for (std::string format : formats) {
        SCOPED_TRACE(format);
        bool light = format == "hdr" || format == "openexr";
        PictureAnswer answer =
            read(encoded_picture(format, 16, 8, 3, slope), {light ? PixelScale::light : PixelScale::shown, 0});
        ASSERT_TRUE(answer) << answer.sentence;
        ASSERT_EQ(answer.pixels.width, 16);
        ASSERT_EQ(answer.pixels.height, 8);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 16; ++x) {
                const float* pixel = &answer.pixels.rgba[static_cast<std::size_t>(4 * (16 * y + x))];
                float tolerance = format == "jpeg" ? 0.1f : 0.01f;
                EXPECT_NEAR(pixel[0], static_cast<float>(x) / 15, tolerance) << x << ", " << y;
                EXPECT_NEAR(pixel[1], static_cast<float>(y) / 7, tolerance) << x << ", " << y;
                EXPECT_EQ(pixel[3], 1);
            }
    }
}

TEST(PictureFile, gives_numbers_as_shown_or_as_light)
{
    auto grey = [](int, int, float* rgba) { rgba[0] = rgba[1] = rgba[2] = 0.5f; };
    std::string png = encoded_picture("png", 2, 2, 3, grey), exr = encoded_picture("openexr", 2, 2, 3, grey);
    EXPECT_NEAR(read(png).pixels.rgba[0], 0.5f, 0.005f);
    EXPECT_NEAR(read(png, {PixelScale::light, 0}).pixels.rgba[0], 0.214f, 0.005f);
    EXPECT_NEAR(read(exr).pixels.rgba[0], shown(0.5f), 0.005f);
    EXPECT_NEAR(read(exr, {PixelScale::light, 0}).pixels.rgba[0], 0.5f, 0.005f);
}

TEST(PictureFile, keeps_colour_apart_from_alpha_and_repeats_grey)
{
    auto half = [](int, int, float* rgba) { rgba[0] = rgba[1] = rgba[2] = 0.8f, rgba[3] = 0.5f; };
    for (const char* format : {"png", "tiff"}) {
        Pixels pixels = read(encoded_picture(format, 2, 2, 4, half)).pixels;
        ASSERT_EQ(pixels.rgba.size(), 16u) << format;
        EXPECT_NEAR(pixels.rgba[1], 0.8f, 0.01f) << format;
        EXPECT_NEAR(pixels.rgba[3], 0.5f, 0.01f) << format;
    }
    Pixels grey = read(encoded_picture("png", 2, 2, 1, half)).pixels;
    ASSERT_EQ(grey.rgba.size(), 16u);
    EXPECT_NEAR(grey.rgba[2], 0.8f, 0.01f);
    EXPECT_EQ(grey.rgba[3], 1);
}

TEST(PictureFile, averages_large_pictures_down)
{
    auto left_half = [](int x, int, float* rgba) { rgba[0] = x < 150 ? 1.0f : 0.0f; };
    Pixels pixels = read(encoded_picture("png", 300, 200, 3, left_half), {PixelScale::shown, 30}).pixels;
    ASSERT_EQ(pixels.width, 30);
    ASSERT_EQ(pixels.height, 20);
    EXPECT_NEAR(pixels.rgba[4 * 14], 1, 1e-4);
    EXPECT_NEAR(pixels.rgba[4 * 15], 0, 1e-4);
    Pixels odd = read(encoded_picture("png", 300, 200, 3, left_half), {PixelScale::shown, 31}).pixels;
    EXPECT_NEAR(odd.rgba[4 * 15], 0.5, 0.01);  // the border crosses its middle
}

TEST(PictureFile, opens_only_five_formats_and_tells_them_by_content)
{
    EXPECT_EQ(picture_format(encoded_picture("jpeg", 4, 4, 3, slope)), "jpeg");
    for (const char* other : {"bmp", "sgi"}) {
        PictureAnswer answer = read(encoded_picture(other, 8, 8, 3, slope));
        EXPECT_EQ(answer.ending, Ending::refused) << other;
        EXPECT_EQ(answer.sentence, "The picture x is not a PNG, JPEG, HDR, EXR or TIFF file") << other;
    }
    EXPECT_FALSE(read("just a few words, no picture"));
    EXPECT_FALSE(read(""));
}

TEST(PictureFile, refuses_an_image_bomb_before_it_is_unpacked)
{
    PictureAnswer wide = read(tests::png_bomb(1'000'000, 1'000'000)), large = read(tests::png_bomb(16'000, 16'000));
    EXPECT_EQ(wide.ending, Ending::refused);
    EXPECT_TRUE(wide.sentence.starts_with("The picture x is ")) << wide.sentence;
    EXPECT_EQ(large.sentence, "The picture x is too large (16000 x 16000 pixels; at most 64 million)");
}

TEST(PictureFile, says_in_one_sentence_that_a_file_is_damaged)
{
    for (std::string format : formats) {
        SCOPED_TRACE(format);
        std::string good = encoded_picture(format, 64, 64, 3, slope);
        for (std::size_t kept : {good.size() / 2, std::size_t(20)}) {
            PictureAnswer cut = read(good.substr(0, kept));
            EXPECT_TRUE(kept > 20 || !cut);
            EXPECT_TRUE(cut || cut.sentence.starts_with("The picture x ")) << cut.sentence;
            EXPECT_EQ(cut.sentence.find('\n'), std::string::npos);
        }
        std::string dirty = good;
        for (std::size_t i = 24; i < dirty.size(); i += 7) dirty[i] = static_cast<char>(dirty[i] * 31 + 17);
        PictureAnswer answer = read(dirty);
        EXPECT_TRUE(answer || answer.sentence.starts_with("The picture x ")) << answer.sentence;
    }
}

class PictureBytes : public testing::Test {
protected:
    PictureBytes() { std::filesystem::create_directories(folder_); }
    ~PictureBytes() override { std::filesystem::remove_all(folder_); }
    static std::string reason(const std::filesystem::path& path)
    {
        try {
            picture_bytes(path);
        } catch (const graph::Failure& failure) {
            return failure.what();
        }
        return "read";
    }
    std::filesystem::path folder_ = testing::TempDir() + "fieldwright-bytes-" + std::to_string(::getpid());
};

TEST_F(PictureBytes, come_from_ordinary_files_only)
{
    EXPECT_EQ(reason(folder_ / "none.png"), "is not there");
    EXPECT_EQ(reason(folder_), "is not a file");
    ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
    EXPECT_EQ(reason(folder_ / "pipe.png"), "is not a file");
    EXPECT_EQ(reason("/dev/zero"), "is not a file");
    std::filesystem::resize_file((std::ofstream(folder_ / "large.png"), folder_ / "large.png"),
                                 static_cast<std::uintmax_t>(picture_bytes_limit) + 1);
    EXPECT_EQ(reason(folder_ / "large.png"), "is larger than 256 MB");
}

}  // namespace
}  // namespace fieldwright::assets
