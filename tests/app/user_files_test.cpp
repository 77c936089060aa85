// What is kept between runs: folders, window, recent files.
#include "app/recent_files.h"
#include "app/user_folders.h"
#include "app/window_state.h"
#include "graph/problem.h"
#include "tests/app/program.h"

#include <sys/stat.h>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

// A variable of the environment for the length of a test.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name)
    {
        if (const char* old = std::getenv(name)) old_ = old;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }

private:
    const char* name_;
    std::optional<std::string> old_;
};

unsigned mode(const fs::path& path)
{
    struct stat status = {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 0777;
}

using UserFoldersTest = tests::InFolder;

TEST_F(UserFoldersTest, follow_the_variables_and_are_private)
{
    Variable config("XDG_CONFIG_HOME", path("a/config")), state("XDG_STATE_HOME", path("b/state"));
    UserFolders folders = user_folders();
    EXPECT_EQ(folders.config, folder_ / "a/config/fieldwright");
    EXPECT_EQ(folders.state, folder_ / "b/state/fieldwright");
    for (const fs::path& made : {folders.config, folder_ / "a", folders.state}) EXPECT_EQ(mode(made), 0700u) << made;
}

TEST_F(UserFoldersTest, empty_and_relative_variables_count_as_unset)
{
    Variable home("HOME", path("home")), config("XDG_CONFIG_HOME", ""), state("XDG_STATE_HOME", "here/state");
    UserFolders folders = user_folders();
    EXPECT_EQ(folders.config, folder_ / "home/.config/fieldwright");
    EXPECT_EQ(folders.state, folder_ / "home/.local/state/fieldwright");
    EXPECT_FALSE(fs::exists("here"));
}

TEST_F(UserFoldersTest, lie_in_a_given_root_whatever_the_environment_says)
{
    Variable config("XDG_CONFIG_HOME", path("elsewhere"));
    UserFolders folders = user_folders(folder_ / "root");
    EXPECT_EQ(folders.config, folder_ / "root/config");
    EXPECT_TRUE(fs::is_directory(folders.state));
    EXPECT_FALSE(fs::exists(path("elsewhere")));
}

TEST_F(UserFoldersTest, a_file_in_the_way_is_a_failure)
{
    tests::write_text(folder_ / "root", "");
    EXPECT_THROW(user_folders(folder_ / "root"), graph::Failure);
}

using WindowStateTest = tests::InFolder;

TEST_F(WindowStateTest, remembers_numbers_and_texts_across_runs)
{
    WindowState state(folder_ / "window.json");
    EXPECT_EQ(state.number("pane", 320), 320);
    state.remember("pane", 0.1);
    state.remember("theme", "dark");
    state.remember("camera " + path("a \"b\".scene.json"), "1 2 3");
    state.remember("bad", std::nan(""));
    state.remember("gone", 1.0);
    state.forget("gone");
    state.save();
    WindowState again(folder_ / "window.json");
    EXPECT_EQ(again.number("pane", 320), 0.1);
    EXPECT_EQ(again.text("theme", "light"), "dark");
    EXPECT_EQ(again.text("camera " + path("a \"b\".scene.json"), ""), "1 2 3");
    EXPECT_EQ(again.number("theme", 5), 5) << "a text is no number";
    EXPECT_EQ(again.number("bad", 7), 7);
    EXPECT_EQ(again.number("gone", 8), 8);
}

TEST_F(WindowStateTest, reads_what_makes_sense_of_a_broken_file)
{
    for (const char* text : {"", "{", "[1, 2]", "null", "\xff\xfe", "{\"a\": 1e999}"}) {
        tests::write_text(folder_ / "window.json", text);
        WindowState state(folder_ / "window.json");
        EXPECT_EQ(state.number("a", 4), 4) << text;
        state.remember("a", 1.0);
        state.save();
        EXPECT_EQ(WindowState(folder_ / "window.json").number("a", 4), 1) << text;
    }
    tests::write_text(folder_ / "window.json", R"({"a": [1], "b": true, "c": 3, "d": null})");
    EXPECT_EQ(WindowState(folder_ / "window.json").number("c", 4), 3);
    EXPECT_EQ(WindowState(folder_ / "window.json").number("a", 4), 4);
}

TEST_F(WindowStateTest, forgets_the_longest_unchanged_of_too_many)
{
    WindowState state(folder_ / "window.json");
    state.remember("pane", 1.0);
    for (int i = 0; i < 2500; ++i) state.remember("camera " + std::to_string(i), 1.0);
    state.remember("pane", 2.0);
    state.save();
    WindowState again(folder_ / "window.json");
    EXPECT_EQ(again.number("pane", 0), 2);
    EXPECT_EQ(again.number("camera 2499", 0), 1);
    EXPECT_EQ(again.number("camera 0", 0), 0);
}

TEST_F(WindowStateTest, an_unchanged_state_is_not_written)
{
    WindowState state(folder_ / "window.json");
    state.save();
    EXPECT_FALSE(fs::exists(folder_ / "window.json"));
}

class RecentFilesTest : public tests::InFolder {
protected:
    fs::path scene(int number) const { return folder_ / (std::to_string(number) + ".scene.json"); }
    std::vector<fs::path> paths(const RecentFiles& recent) const
    {
        std::vector<fs::path> paths;
        for (const RecentFile& file : recent.entries()) paths.push_back(file.path);
        return paths;
    }
    fs::path file() const { return folder_ / "recent.json"; }
};

TEST_F(RecentFilesTest, are_the_last_fifteen_newest_first_each_once)
{
    RecentFiles recent(file());
    for (int i = 0; i < 20; ++i) recent.add(scene(i));
    recent.add(scene(10));
    std::vector<fs::path> expected = {scene(10)};
    for (int i = 19; i >= 5; --i)
        if (i != 10) expected.push_back(scene(i));
    EXPECT_EQ(paths(recent), expected);
    EXPECT_EQ(paths(RecentFiles(file())), expected);
    EXPECT_EQ(expected.size(), 15u);
}

TEST_F(RecentFilesTest, missing_ones_are_marked_and_stay)
{
    tests::write_text(scene(1), "");
    RecentFiles recent(file());
    recent.add(scene(1));
    recent.add(scene(2));
    EXPECT_EQ(recent.entries(), (std::vector<RecentFile>{{scene(2), true}, {scene(1), false}}));
    recent.remove(scene(2));
    EXPECT_EQ(recent.entries(), (std::vector<RecentFile>{{scene(1), false}}));
}

TEST_F(RecentFilesTest, clear_clears_for_good)
{
    RecentFiles recent(file());
    recent.add(scene(1));
    recent.clear();
    EXPECT_TRUE(recent.entries().empty());
    EXPECT_TRUE(RecentFiles(file()).entries().empty());
}

TEST_F(RecentFilesTest, two_windows_keep_each_others_entries)
{
    RecentFiles first(file()), second(file());
    first.add(scene(1));
    second.add(scene(2));
    first.add(scene(3));
    EXPECT_EQ(paths(first), (std::vector<fs::path>{scene(3), scene(2), scene(1)}));
}

TEST_F(RecentFilesTest, a_broken_file_counts_as_empty_and_is_replaced)
{
    for (const char* text : {"", "{\"a\": 1}", "[1, null, \"relative.json\", [\"x\"]]", "[\"/a", "\xff"}) {
        tests::write_text(file(), text);
        RecentFiles recent(file());
        EXPECT_TRUE(recent.entries().empty()) << text;
        recent.add(scene(1));
        EXPECT_EQ(paths(RecentFiles(file())), (std::vector<fs::path>{scene(1)})) << text;
    }
}

}  // namespace
}  // namespace fieldwright::app
