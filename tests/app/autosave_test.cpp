// Copies of unsaved work, and recovering from them.
#include "app/autosave.h"

#include "graph/edits.h"
#include "graph/scene_file.h"
#include "tests/app/program.h"

#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <thread>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

class AutosaveTest : public tests::InFolder {
protected:
    std::function<double()> clock()
    {
        return [this] { return now_s; };
    }
    std::vector<fs::path> copies() const
    {
        std::vector<fs::path> found;
        std::error_code error;
        for (fs::directory_iterator it(folder(), error), end; !error && it != end; it.increment(error))
            if (it->path().string().ends_with(".scene.json")) found.push_back(it->path());
        return found;
    }
    fs::path folder() const { return folder_ / "state/autosave"; }
    void move(float x) { graph::move_node(session.document(), {1}, {x, 0}); }
    // Frames of half a second, each long enough for the disk.
    void pass(Autosave& autosave, double seconds)
    {
        for (double end_s = now_s + seconds; now_s < end_s; now_s += 0.5) {
            autosave.update(session);
            autosave.wait();
        }
    }
    // Whether there is one copy, and it holds the session's document.
    bool copied() const
    {
        return copies().size() == 1 && graph::open_scene(copies()[0], *session.library()) == session.document();
    }
    // Another process that autosaves `session` and is then killed.
    void crash()
    {
        pid_t child = ::fork();
        if (child == 0) {
            Autosave autosave(folder(), clock());
            pass(autosave, 32);
            ::raise(SIGKILL);
        }
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
    }

    double now_s = 100;
    EditSession session{graph::Library::embedded()};
};

TEST_F(AutosaveTest, a_clean_scene_leaves_nothing_behind)
{
    Autosave autosave(folder(), clock());
    pass(autosave, 100);
    EXPECT_FALSE(fs::exists(folder()));
}

TEST_F(AutosaveTest, half_a_minute_of_change_is_copied_and_not_earlier)
{
    Autosave autosave(folder(), clock());
    pass(autosave, 60);
    move(5);
    pass(autosave, 29);
    EXPECT_TRUE(copies().empty());
    pass(autosave, 3);
    EXPECT_TRUE(copied());
    EXPECT_EQ(autosave.failure(), "");
    move(6);
    pass(autosave, 32);
    EXPECT_TRUE(copied()) << "later changes are copied too";
}

TEST_F(AutosaveTest, an_unchanged_copy_is_not_written_again)
{
    Autosave autosave(folder(), clock());
    move(5);
    pass(autosave, 32);
    ASSERT_TRUE(copied());
    auto stamp = file_stamp(copies()[0]);
    pass(autosave, 100);
    EXPECT_EQ(file_stamp(copies()[0]), stamp);
}

TEST_F(AutosaveTest, saving_removes_the_copy)
{
    Autosave autosave(folder(), clock());
    move(5);
    pass(autosave, 32);
    ASSERT_TRUE(copied());
    session.save_as(path("scene"));
    pass(autosave, 2);
    EXPECT_TRUE(fs::is_empty(folder()));
    move(6);
    pass(autosave, 32);
    EXPECT_TRUE(copied()) << "and the next change is copied again";
    autosave.clear();
    EXPECT_TRUE(fs::is_empty(folder()));
}

TEST_F(AutosaveTest, the_folder_and_the_copies_are_private)
{
    Autosave autosave(folder(), clock());
    move(5);
    pass(autosave, 32);
    ASSERT_TRUE(copied());
    EXPECT_EQ(fs::status(folder()).permissions(), fs::perms::owner_all);
}

TEST_F(AutosaveTest, a_living_window_is_no_crash)
{
    Autosave autosave(folder(), clock());
    move(5);
    pass(autosave, 32);
    ASSERT_TRUE(copied());
    EXPECT_TRUE(autosave.recoverable().empty()) << "its own";
    Autosave other(folder(), clock());
    EXPECT_TRUE(other.recoverable().empty()) << "another's";
}

TEST_F(AutosaveTest, a_crash_is_recovered_as_unsaved_work_of_its_file)
{
    session.save_as(path("scene"));
    move(5);
    graph::Document work = session.document();
    crash();
    session.new_scene();
    Autosave autosave(folder(), clock());
    std::vector<Recovery> recoveries = autosave.recoverable();
    ASSERT_EQ(recoveries.size(), 1u);
    EXPECT_EQ(recoveries[0].origin, folder_ / "scene.scene.json");
    EXPECT_EQ(recoveries[0].title, "scene.scene.json");
    EXPECT_GT(recoveries[0].time_s, 1'600'000'000);
    autosave.recover(recoveries[0], session);
    EXPECT_EQ(session.document(), work);
    EXPECT_EQ(session.title(), "scene.scene.json \u2022");
    EXPECT_TRUE(fs::exists(recoveries[0].copy)) << "kept until it is saved";
    EXPECT_FALSE(session.changed_on_disk());
    EXPECT_TRUE(autosave.recoverable().empty());
    EXPECT_TRUE(Autosave(folder(), clock()).recoverable().empty()) << "it is this window's now";
    session.save();
    pass(autosave, 2);
    EXPECT_TRUE(fs::is_empty(folder()));
}

TEST_F(AutosaveTest, a_file_saved_since_the_crash_is_not_overwritten_unasked)
{
    session.save_as(path("scene"));
    move(5);
    crash();
    session.save();
    Autosave autosave(folder(), clock());
    autosave.recover(autosave.recoverable().at(0), session);
    EXPECT_TRUE(session.changed_on_disk());
}

TEST_F(AutosaveTest, a_second_crash_keeps_what_was_recovered)
{
    move(5);
    graph::Document work = session.document();
    crash();
    {
        Autosave autosave(folder(), clock());
        autosave.recover(autosave.recoverable().at(0), session);
    }
    Autosave autosave(folder(), clock());
    ASSERT_EQ(autosave.recoverable().size(), 1u);
    session.new_scene();
    autosave.recover(autosave.recoverable()[0], session);
    EXPECT_EQ(session.document(), work);
    EXPECT_EQ(session.path(), std::nullopt);
}

TEST_F(AutosaveTest, two_windows_do_not_recover_the_same_copy)
{
    move(5);
    crash();
    Autosave first(folder(), clock()), second(folder(), clock());
    Recovery recovery = second.recoverable().at(0);
    first.recover(first.recoverable().at(0), session);
    EditSession other(graph::Library::embedded());
    EXPECT_THROW(second.recover(recovery, other), graph::Failure);
    EXPECT_FALSE(other.dirty());
    second.discard(recovery);
    EXPECT_TRUE(fs::exists(recovery.copy)) << "it belongs to the first window";
}

TEST_F(AutosaveTest, crashes_are_listed_until_the_user_answers_newest_first)
{
    move(5);
    crash();
    move(6);
    // The sidecars tell whole seconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    crash();
    Autosave autosave(folder(), clock());
    pass(autosave, 100);
    std::vector<Recovery> recoveries = autosave.recoverable();
    ASSERT_EQ(recoveries.size(), 2u);
    EXPECT_GT(recoveries[0].time_s, recoveries[1].time_s);
    EXPECT_EQ(graph::open_scene(recoveries[0].copy, *session.library()), session.document());
    autosave.discard(recoveries[0]);
    ASSERT_EQ(autosave.recoverable().size(), 1u);
    EXPECT_EQ(autosave.recoverable()[0].id, recoveries[1].id);
}

TEST_F(AutosaveTest, a_copy_without_its_sidecar_is_still_offered)
{
    fs::create_directories(folder());
    graph::save_scene(folder() / "7-7.scene.json", session.document(), *session.library());
    tests::write_text(folder() / "7-7.json", "{broken");
    Autosave autosave(folder(), clock());
    ASSERT_EQ(autosave.recoverable().size(), 1u);
    EXPECT_EQ(autosave.recoverable()[0].title, "Untitled");
    EXPECT_EQ(autosave.recoverable()[0].origin, std::nullopt);
}

TEST_F(AutosaveTest, a_broken_copy_changes_nothing_and_stays)
{
    fs::create_directories(folder());
    tests::write_text(folder() / "7-7.scene.json", "{broken");
    move(5);
    graph::Document work = session.document();
    Autosave autosave(folder(), clock());
    Recovery recovery = autosave.recoverable().at(0);
    EXPECT_THROW(autosave.recover(recovery, session), graph::Failure);
    EXPECT_EQ(session.document(), work);
    EXPECT_EQ(autosave.recoverable().size(), 1u);
}

TEST_F(AutosaveTest, a_folder_that_cannot_be_written_is_said_and_tried_again)
{
    tests::write_text(folder_ / "state", "in the way");
    Autosave autosave(folder(), clock());
    move(5);
    pass(autosave, 32);
    EXPECT_NE(autosave.failure(), "");
    fs::remove(folder_ / "state");
    pass(autosave, 32);
    EXPECT_TRUE(copied());
    pass(autosave, 2);
    EXPECT_EQ(autosave.failure(), "");
}

TEST_F(AutosaveTest, a_frame_never_waits_for_the_disk)
{
    for (int i = 0; i < 600; ++i) graph::add_node(session.document(), *session.library(), "rounded_box");
    Autosave autosave(folder(), clock());
    std::chrono::duration<double, std::milli> longest{0};
    for (double end_s = now_s + 95; now_s < end_s; now_s += 0.5) {
        move(static_cast<float>(now_s));
        auto start = std::chrono::steady_clock::now();
        autosave.update(session);
        longest =
            std::max<std::chrono::duration<double, std::milli>>(longest, std::chrono::steady_clock::now() - start);
    }
    RecordProperty("longest_ms", std::to_string(longest.count()));
    std::cout << "longest update with 600 nodes: " << longest.count() << " ms\n";
    EXPECT_LT(longest.count(), 50) << "far above what it takes, far below a slow disk";
}

}  // namespace
}  // namespace fieldwright::app
