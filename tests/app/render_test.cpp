// `render` as batch systems use it: sequences, tiles, formats, and the same bytes every time.
#include "app/frame_numbers.h"
#include "renderer/picture.h"
#include "tests/app/program.h"

#include <OpenImageIO/imagebufalgo.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace fieldwright::tests {
namespace {

using app::frames_from_text;
using app::numbered;
using app::tile_from_text;
using renderer::Area;

using Numbers = std::vector<int>;

TEST(FrameNumbers, are_ranges_lists_and_steps)
{
    EXPECT_EQ(frames_from_text("7"), Numbers{7});
    EXPECT_EQ(frames_from_text("1-3,20,30..34x2"), (Numbers{1, 2, 3, 20, 30, 32, 34}));
    EXPECT_EQ(frames_from_text("-2--1"), (Numbers{-2, -1}));
    for (const char* text : {"", "a", "3-1", "1-", "1,", "1-3x0", "1-9x", "1 2", "1-99999999"})
        EXPECT_FALSE(frames_from_text(text)) << text;
}

TEST(FrameNumbers, take_the_place_of_the_last_run_of_number_signs)
{
    EXPECT_EQ(numbered("out.####.png", 7), "out.0007.png");
    EXPECT_EQ(numbered("#_##.png", 123), "#_123.png");
    EXPECT_EQ(numbered("out.png", 7), "out.png");
    EXPECT_EQ(numbered("###", 12), "012");
}

TEST(Tiles, are_bands_or_rectangles_within_the_picture)
{
    EXPECT_EQ(tile_from_text("1/3", 10, 10), (Area{0, 0, 10, 3}));
    EXPECT_EQ(tile_from_text("3/3", 10, 10), (Area{0, 6, 10, 4}));
    EXPECT_EQ(tile_from_text("2,3,4,5", 10, 10), (Area{2, 3, 4, 5}));
    for (const char* text :
         {"0/3", "4/3", "1/11", "8,0,3,1", "0,0,0,1", "-1,0,2,2", "1,2,3", "1/2x", "2147483647,0,1,1"})
        EXPECT_FALSE(tile_from_text(text, 10, 10)) << text;
}

class Render : public InFolder {
protected:
    std::string pulse() const { return (source_folder() / "examples/pulse.scene.json").string(); }

    void render(const std::string& words, int code = 0) const
    {
        Outcome outcome = run_program("render " + pulse() + " --device cpu -q --size 64x36 " + words);
        EXPECT_EQ(outcome.code, code) << words << "\n" << outcome.errors;
        EXPECT_EQ(outcome.output, "");
    }

    std::string bytes(const std::string& name) const { return read_text(path(name)); }
};

TEST_F(Render, writes_a_picture_for_every_frame)
{
    render("--samples 2 --frames 1,4-5 --fps 10 -o " + path("f.###.png"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
    render("--samples 2 --time 0.3 -o " + path("moment.png"));
    EXPECT_TRUE(bytes("f.004.png") == bytes("moment.png")) << "frame 4 is the time 3 / 10";
    EXPECT_TRUE(bytes("f.001.png") != bytes("f.004.png"));
    EXPECT_TRUE(std::filesystem::exists(path("f.005.png")));
}

TEST_F(Render, leaves_existing_frames_alone_when_asked)
{
    write_text(path("f.1.png"), "mine");
    render("--samples 1 --skip-existing --frames 1-2 -o " + path("f.#.png"));
    EXPECT_EQ(bytes("f.1.png"), "mine");
    EXPECT_TRUE(std::filesystem::exists(path("f.2.png")));
}

TEST_F(Render, names_the_frame_that_failed)
{
    std::filesystem::create_directory(path("f.2.png"));
    std::string command =
        "render " + pulse() + " --device cpu -q --size 8x8 --samples 1 --frames 1-3 -o " + path("f.#.png");
    Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.code, 5) << outcome.errors;
    EXPECT_NE(outcome.errors.find("frame 2: "), std::string::npos) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(path("f.3.png")));
    outcome = run_program(command + " --keep-going");
    EXPECT_EQ(outcome.code, 7);
    EXPECT_TRUE(std::filesystem::exists(path("f.3.png")));
}

TEST_F(Render, says_what_it_wrote_as_lines_of_json)
{
    Outcome outcome = run_program("render " + pulse() +
                                  " --device cpu -q --size 8x8 --samples 3 --json --frames 1-2 -o " + path("f.#.png"));
    std::istringstream lines(outcome.output);
    std::string line;
    for (int frame = 1; frame <= 2; ++frame) {
        ASSERT_TRUE(std::getline(lines, line)) << outcome.errors;
        nlohmann::json told = nlohmann::json::parse(line);
        EXPECT_EQ(told["frame"], frame);
        EXPECT_EQ(told["path"], path("f." + std::to_string(frame) + ".png"));
        EXPECT_EQ(told["samples"], 3);
    }
    EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST_F(Render, of_tiles_joins_to_the_whole_picture)
{
    render("--samples 3 -o " + path("whole.png"));
    renderer::Picture whole = renderer::read_png(path("whole.png"));
    std::vector<unsigned char> joined;
    for (int i = 1; i <= 3; ++i) {
        render("--samples 3 --tile " + std::to_string(i) + "/3 -o " + path("tile.png"));
        renderer::Picture tile = renderer::read_png(path("tile.png"));
        joined.insert(joined.end(), tile.rgb.begin(), tile.rgb.end());
    }
    EXPECT_TRUE(joined == whole.rgb);
}

// The second of four bands begins at a row of odd number.
TEST_F(Render, of_a_tile_has_the_rows_and_stripes_of_the_whole_stereo_picture)
{
    for (const char* stereo : {"interlace", "naive --rivalry"}) {
        std::string options = std::string("--samples 1 --interaxial 0.3 --stereo ") + stereo;
        render(options + " -o " + path("whole.png"));
        render(options + " --tile 2/4 -o " + path("tile.png"));
        renderer::Picture whole = renderer::read_png(path("whole.png")), tile = renderer::read_png(path("tile.png"));
        auto rows = whole.rgb.begin() + 3 * 64 * 9;
        EXPECT_TRUE(std::equal(tile.rgb.begin(), tile.rgb.end(), rows)) << stereo;
    }
}

TEST_F(Render, of_both_eyes_swaps_the_parts_of_openexr_too)
{
    for (const char* name : {"plain", "swapped"})
        render(std::string("--samples 1 --interaxial 0.4 --stereo side-by-side -o ") + path(name) + ".exr" +
               (name == std::string("swapped") ? " --swap-eyes" : ""));
    auto same = [&](int plain, int swapped) {
        OIIO::ImageBuf a(path("plain.exr"), plain, 0), b(path("swapped.exr"), swapped, 0);
        return OIIO::ImageBufAlgo::compare(a, b, 0, 0).nfail == 0;
    };
    EXPECT_TRUE(same(0, 1) && same(1, 0));
    EXPECT_FALSE(same(0, 0));
}

TEST_F(Render, takes_the_mean_of_samples_for_views_of_light_and_the_middle_one_for_data)
{
    for (const char* name : {"glow", "diffuse", "steps"}) {
        std::string view = std::string("--view ") + name;
        render(view + " --samples 1 -o " + path("one.png"));
        render(view + " --samples 8 -o " + path("eight.png"));
        bool mean = renderer::kind_of(*renderer::view_from_name(name)).mean;
        EXPECT_EQ(bytes("one.png") != bytes("eight.png"), mean) << name;
    }
}

TEST_F(Render, twice_gives_the_same_bytes_in_every_format)
{
    for (const char* end : {".png", ".jpg", ".hdr", ".exr"}) {
        std::string a = std::string("a") + end, b = std::string("b") + end;
        render("--samples 4 --time 0.4 -o " + path(a));
        render("--samples 4 --time 0.4 -o " + path(b));
        EXPECT_FALSE(bytes(a).empty()) << end;
        EXPECT_TRUE(bytes(a) == bytes(b)) << end;
    }
}

TEST_F(Render, of_one_sample_is_the_middle_of_every_pixel_and_more_are_smoother)
{
    render("--samples 1 -o " + path("one.png"));
    render("-o " + path("own.png"));
    render("--samples 16 -o " + path("sixteen.png"));
    render("--grid 4 -o " + path("grid.png"));
    EXPECT_TRUE(bytes("one.png") != bytes("own.png"));
    EXPECT_TRUE(bytes("own.png") == bytes("sixteen.png")) << "the scene's own setting";
    EXPECT_TRUE(bytes("grid.png") != bytes("sixteen.png"));
}

TEST_F(Render, keeps_the_scene_in_the_picture_when_asked)
{
    render("--samples 1 -o " + path("plain.png"));
    render("--samples 1 --keep-scene -o " + path("kept.png"));
    EXPECT_EQ(bytes("plain.png").find("fieldwright"), std::string::npos);
    Outcome drawn =
        run_program("render " + path("kept.png") + " --device cpu -q --size 64x36 --samples 1 -o " + path("again.png"));
    EXPECT_EQ(drawn.code, 0) << drawn.errors;
    EXPECT_TRUE(bytes("again.png") == bytes("plain.png")) << "the picture is a scene file, too";
    Outcome refused = run_program("check " + path("plain.png"));
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.errors.find("--keep-scene"), std::string::npos) << refused.errors;
}

TEST_F(Render, splits_an_anaglyph_between_the_plain_one_and_its_own)
{
    auto half = [&](const std::string& name, int from, int to) {
        renderer::Picture picture = renderer::read_png(path(name));
        std::vector<unsigned char> bytes;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 3 * from; x < 3 * to; ++x)
                bytes.push_back(picture.rgb[static_cast<std::size_t>(3 * y * picture.width + x)]);
        return bytes;
    };
    render("--samples 1 --stereo naive -o " + path("naive.png"));
    render("--samples 1 --stereo dubois -o " + path("dubois.png"));
    render("--samples 1 --stereo dubois --split 0.5 -o " + path("split.png"));
    EXPECT_TRUE(half("split.png", 0, 32) == half("naive.png", 0, 32));
    EXPECT_TRUE(half("split.png", 32, 64) == half("dubois.png", 32, 64));
    EXPECT_TRUE(half("naive.png", 0, 32) != half("dubois.png", 0, 32));
    render("--split 0.5 -o " + path("off.png"), 2);
    render("--split 0.5 --stereo side-by-side -o " + path("two.png"), 2);
    render("--split 0.5 --stereo dubois --tile 1/2 -o " + path("tile.png"), 2);
}

TEST_F(Render, puts_every_view_on_a_sheet)
{
    render("--samples 1 --sheet -o " + path("sheet.png"));
    renderer::Picture sheet = renderer::read_png(path("sheet.png"));
    auto views = static_cast<int>(renderer::view_names().size());
    EXPECT_GT(sheet.width * sheet.height, views * 64 * 36);
}

}  // namespace
}  // namespace fieldwright::tests
