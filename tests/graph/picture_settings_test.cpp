// Settings of pictures and animations: in files, in edits, and within their ranges.
#include "graph/edits.h"
#include "graph/picture_scene.h"
#include "graph/scene_file.h"
#include "graph/settings.h"
#include "tests/graph/small_library.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

std::string scene_with(const std::string& member)
{
    return R"({"format": "fieldwright", "version": 1, )" + member + R"("graphs": {"root": {"nodes": {}}}})";
}

std::string refusal(const std::string& member)
{
    try {
        read_scene(scene_with(member), *small_library());
    } catch (const Failure& failure) {
        return failure.what();
    }
    return {};
}

TEST(PictureSettings, are_the_defaults_in_files_that_do_not_have_them)
{
    Document document = read_scene(scene_with(""), *small_library());
    EXPECT_EQ(document.picture, PictureSettings());
    EXPECT_EQ(document.animation, AnimationSettings());
}

TEST(PictureSettings, come_back_from_a_file)
{
    Document document;
    document.picture = {64, 0.25f, ToneMap::agx, -1.5f, Backdrop::colour, {0.25f, 0.5f, 2}};
    document.animation = {-3, 48, 29.97f};
    Document read = read_scene(write_scene(document, *small_library()), *small_library());
    EXPECT_EQ(read.picture, document.picture);
    EXPECT_EQ(read.animation, document.animation);
    EXPECT_EQ(validate(read, *small_library()), std::nullopt);
}

TEST(PictureSettings, beyond_their_ranges_are_refused_where_they_stand)
{
    for (auto [member, part] :
         {std::pair(R"("picture": {"samples": 0}, )", "$.picture.samples: must lie between 1 and 4096"),
          std::pair(R"("picture": {"tone_map": "filmic"}, )",
                    "$.picture.tone_map: must be `none`, `neutral`, `agx` or `aces`"),
          std::pair(R"("picture": {"exposure": 21}, )", "$.picture.exposure: must lie between"),
          std::pair(R"("picture": {"backdrop_colour": [0, 0]}, )", "$.picture.backdrop_colour: must be three"),
          std::pair(R"("picture": {"backdrop_colour": [0, 0, -1]}, )", "$.picture.backdrop_colour: must lie"),
          std::pair(R"("picture": {"sample": 1}, )", "the members are `samples`"),
          std::pair(R"("animation": {"first_frame": 9, "last_frame": 8}, )", "$.animation.first_frame: must not"),
          std::pair(R"("animation": {"frames_per_second": 0}, )", "$.animation.frames_per_second: must lie")})
        EXPECT_NE(refusal(member).find(part), std::string::npos) << member << "\n" << refusal(member);
}

TEST(PictureSettings, change_by_edits_that_refuse_the_same)
{
    Document document;
    EXPECT_EQ(set_picture(document, {.samples = 32}), std::nullopt);
    EXPECT_EQ(document.picture.samples, 32);
    EXPECT_EQ(set_picture(document, {.shutter = -1}), "“Shutter” must lie between 0 and 100");
    EXPECT_EQ(set_animation(document, {.first_frame = 5, .last_frame = 4}),
              "“First frame” must not come after the last frame");
    EXPECT_EQ(document.picture.samples, 32);
    EXPECT_EQ(document.animation, AnimationSettings());
}

TEST(PictureScene, is_found_among_the_chunks_of_a_png)
{
    auto chunk = [](std::string type, const std::string& data) {
        std::string length = {0, 0, 0, static_cast<char>(data.size())};
        return length + type + data + "crc.";
    };
    std::string text = std::string("fieldwright:graph") + '\0' + "{}";
    std::string png = std::string(png_signature) + chunk("IHDR", "abc") + chunk("tEXt", text) + chunk("IEND", "");
    EXPECT_EQ(scene_in_png(png), "{}");
    EXPECT_FALSE(scene_in_png(std::string(png_signature) + chunk("tEXt", "other")));
    EXPECT_FALSE(scene_in_png("{}"));
    for (std::size_t size = 0; size < png.size(); ++size) scene_in_png(std::string_view(png).substr(0, size));
}

}  // namespace
}  // namespace fieldwright::graph
