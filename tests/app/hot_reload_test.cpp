// Shaders that change while the program runs.
#include "app/folder_watch.h"
#include "app/library_reload.h"

#include "tests/app/program.h"

#include <chrono>
#include <iostream>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

class HotReloadTest : public tests::InFolder {
protected:
    HotReloadTest() { fs::copy(tests::source_folder() / "shaders", shaders(), fs::copy_options::recursive); }
    fs::path shaders() const { return folder_ / "shaders"; }
    fs::path torus() const { return shaders() / "nodes/primitive/torus.glsl"; }
    // Frames of 1/60 s; when a change was reported, or nothing.
    std::optional<double> reported_after(FolderWatch& watch, double seconds)
    {
        double start_s = now_s;
        for (; now_s < start_s + seconds; now_s += 1.0 / 60)
            if (watch.changed(now_s)) return now_s - start_s;
        return std::nullopt;
    }

    double now_s = 0;
};

TEST_F(HotReloadTest, a_folder_at_rest_is_never_reported)
{
    FolderWatch watch(shaders());
    EXPECT_FALSE(reported_after(watch, 5));
}

TEST_F(HotReloadTest, edits_new_files_and_deletions_are_reported_once_and_soon)
{
    FolderWatch watch(shaders());
    auto expect_one_report = [&](const char* what) {
        std::optional<double> delay_s = reported_after(watch, 1);
        ASSERT_TRUE(delay_s) << what;
        EXPECT_LT(*delay_s, 0.6) << what;
        EXPECT_FALSE(reported_after(watch, 2)) << what;
    };
    tests::write_text(torus(), tests::read_text(torus()) + "\n");
    expect_one_report("edit");
    tests::write_text(shaders() / "render/extra.glsl", "// Extra: nothing.\n");
    expect_one_report("new file in render");
    fs::create_directories(shaders() / "nodes/mine");
    tests::write_text(shaders() / "nodes/mine/blob.glsl", "// Blob\n");
    expect_one_report("new file in a new folder");
    fs::remove(torus());
    expect_one_report("deletion");
    tests::write_text(shaders() / "nodes/mine/.blob.glsl.swp", "swap");
    EXPECT_FALSE(reported_after(watch, 2)) << "an editor's own file";
}

TEST_F(HotReloadTest, a_file_still_being_written_is_left_alone)
{
    FolderWatch watch(shaders());
    std::string text = tests::read_text(torus());
    for (int i = 0; i < 5; ++i) {
        tests::write_text(torus(), text.substr(0, 10 + static_cast<std::size_t>(i)));
        EXPECT_FALSE(reported_after(watch, 0.25));
    }
    EXPECT_TRUE(reported_after(watch, 1));
}

TEST_F(HotReloadTest, a_folder_that_goes_and_comes_back_is_watched_on)
{
    FolderWatch watch(shaders());
    fs::rename(shaders(), folder_ / "away");
    EXPECT_TRUE(reported_after(watch, 1));
    EXPECT_NE(reload_library(shaders()).error, "");
    fs::rename(folder_ / "away", shaders());
    EXPECT_TRUE(reported_after(watch, 1));
    EXPECT_EQ(reload_library(shaders()).error, "");
}

TEST_F(HotReloadTest, a_good_change_gives_a_new_library)
{
    std::string text = tests::read_text(torus());
    std::size_t place = text.find("// 0.25");
    ASSERT_NE(place, std::string::npos);
    tests::write_text(torus(), text.replace(place, 7, "// 0.5"));
    LibraryReload reload = reload_library(shaders());
    ASSERT_TRUE(reload.library) << reload.error;
    EXPECT_EQ(reload.library->type("torus")->parameter("minor")->initial, graph::Value(0.5f));
}

TEST_F(HotReloadTest, a_bad_change_names_file_and_line)
{
    std::string text = tests::read_text(torus());
    std::size_t place = text.find("    float across");
    ASSERT_NE(place, std::string::npos);
    long line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n') + 1;
    tests::write_text(torus(), text.insert(place, "    while (true) {}\n"));
    LibraryReload reload = reload_library(shaders());
    EXPECT_FALSE(reload.library);
    EXPECT_NE(reload.error.find("nodes/primitive/torus.glsl:" + std::to_string(line)), std::string::npos)
        << reload.error;
}

TEST_F(HotReloadTest, looking_and_loading_are_quick_enough_for_a_frame_and_a_second)
{
    using Milliseconds = std::chrono::duration<double, std::milli>;
    FolderWatch watch(shaders());
    auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 20; ++i) watch.changed(i);
    Milliseconds look = (std::chrono::steady_clock::now() - start) / 20;
    start = std::chrono::steady_clock::now();
    ASSERT_TRUE(reload_library(shaders()).library);
    Milliseconds load = std::chrono::steady_clock::now() - start;
    std::cout << "look " << look.count() << " ms, load " << load.count() << " ms\n";
    EXPECT_LT(look.count(), 20);
    EXPECT_LT(load.count(), 500);
}

}  // namespace
}  // namespace fieldwright::app
