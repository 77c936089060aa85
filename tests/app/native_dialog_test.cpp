// File choosers of the desktop, played by small scripts.
#include "app/native_dialog.h"

#include "tests/app/program.h"

#include <sys/stat.h>
#include <unistd.h>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace fieldwright::app {
namespace {

using State = DialogAnswer::State;

class NativeDialogTest : public tests::InFolder {
protected:
    NativeDialogTest()
    {
        for (const char* name : {"PATH", "DISPLAY", "WAYLAND_DISPLAY", "XDG_CURRENT_DESKTOP", "FIELDWRIGHT_DIALOGS"}) {
            const char* old = std::getenv(name);
            old_.emplace_back(name, old ? std::optional<std::string>(old) : std::nullopt);
        }
        ::setenv("PATH", ("relative:" + folder_.string() + ":/nowhere").c_str(), 1);
        ::setenv("DISPLAY", ":77", 1);
        for (const char* name : {"WAYLAND_DISPLAY", "XDG_CURRENT_DESKTOP", "FIELDWRIGHT_DIALOGS"}) ::unsetenv(name);
    }
    ~NativeDialogTest() override
    {
        for (const auto& [name, value] : old_)
            value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }

    void script(const std::string& name, const std::string& body)
    {
        tests::write_text(folder_ / name, "#!/bin/sh\n" + body + "\n");
        ::chmod(path(name).c_str(), 0755);
    }

    DialogAnswer answer(NativeDialog& dialog)
    {
        for (int i = 0; i < 1000; ++i) {
            DialogAnswer answer = dialog.poll();
            if (answer.state != State::pending) return answer;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return {};
    }

    DialogAnswer ask(const DialogRequest& request = open())
    {
        NativeDialog dialog;
        dialog.start(request);
        return answer(dialog);
    }

    static DialogRequest open()
    {
        return {
            .kind = DialogRequest::Kind::open, .title = "Open $(scene)", .folder = "/a b", .name = "it's.scene.json"};
    }

    std::vector<std::pair<std::string, std::optional<std::string>>> old_;
};

TEST_F(NativeDialogTest, gives_the_chosen_path_whatever_is_in_it)
{
    script("zenity", "printf '/a b/\"c\"\\nd.scene.json\\n'");
    DialogAnswer answer = ask();
    EXPECT_EQ(answer.state, State::path);
    EXPECT_EQ(answer.path, "/a b/\"c\"\nd.scene.json");
}

TEST_F(NativeDialogTest, passes_its_words_without_a_shell)
{
    script("zenity", "printf '%s\\n' \"$@\" > " + path("words") + "; exit 1");
    EXPECT_EQ(ask().state, State::cancelled);
    EXPECT_EQ(tests::read_text(path("words")),
              "--file-selection\n--title=Open $(scene)\n--filename=/a b/it's.scene.json\n"
              "--file-filter=Scene | *.scene.json\n--file-filter=All files | *\n");
    DialogRequest save = open();
    save.kind = DialogRequest::Kind::save;
    ask(save);
    EXPECT_NE(tests::read_text(path("words")).find("--save\n--confirm-overwrite\n"), std::string::npos);
}

TEST_F(NativeDialogTest, is_the_desktops_own)
{
    script("zenity", "echo /zenity");
    script("kdialog", "echo /kdialog");
    EXPECT_EQ(ask().path, "/zenity");
    ::setenv("XDG_CURRENT_DESKTOP", "ubuntu:GNOME", 1);
    EXPECT_EQ(ask().path, "/zenity");
    ::setenv("XDG_CURRENT_DESKTOP", "KDE", 1);
    EXPECT_EQ(ask().path, "/kdialog");
    std::filesystem::remove(folder_ / "kdialog");
    EXPECT_EQ(ask().path, "/zenity") << "better than none";
    std::filesystem::rename(folder_ / "zenity", folder_ / "kdialog");
    ::unsetenv("XDG_CURRENT_DESKTOP");
    EXPECT_EQ(ask().path, "/zenity") << "kdialog, as renamed";
}

TEST_F(NativeDialogTest, is_unavailable_without_a_program_a_display_or_the_users_wish)
{
    EXPECT_EQ(ask().state, State::unavailable);
    tests::write_text(folder_ / "zenity", "not executable");
    EXPECT_EQ(ask().state, State::unavailable);
    script("zenity", "echo /a");
    EXPECT_EQ(ask().state, State::path);
    ::unsetenv("DISPLAY");
    EXPECT_EQ(ask().state, State::unavailable);
    ::setenv("WAYLAND_DISPLAY", "wayland-0", 1);
    EXPECT_EQ(ask().state, State::path);
    ::setenv("FIELDWRIGHT_DIALOGS", "builtin", 1);
    EXPECT_EQ(ask().state, State::unavailable);
}

TEST_F(NativeDialogTest, a_chooser_that_breaks_is_unavailable_and_an_empty_answer_cancels)
{
    script("zenity", "echo /a; exit 5");
    EXPECT_EQ(ask().state, State::unavailable);
    script("zenity", "kill -9 $$");
    EXPECT_EQ(ask().state, State::unavailable);
    script("zenity", "exit 0");
    EXPECT_EQ(ask().state, State::cancelled);
}

TEST_F(NativeDialogTest, polling_never_waits_and_a_long_answer_does_not_block_the_chooser)
{
    script("zenity",
           "read line < " + path("go") + "; i=0; while [ $i -lt 20000 ]; do printf 0123456789; i=$((i+1)); done");
    ASSERT_EQ(::mkfifo(path("go").c_str(), 0600), 0);
    NativeDialog dialog;
    dialog.start(open());
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(dialog.poll().state, State::pending);
        EXPECT_TRUE(dialog.is_open());
    }
    tests::write_text(path("go"), "\n");
    DialogAnswer result = answer(dialog);
    EXPECT_EQ(result.state, State::path);
    EXPECT_EQ(result.path.string().size(), 200'000u);
    EXPECT_FALSE(dialog.is_open());
}

TEST_F(NativeDialogTest, closing_ends_the_chooser)
{
    script("zenity", "echo $$ > " + path("pid") + "; while :; do :; done");
    NativeDialog dialog;
    dialog.start(open());
    while (tests::read_text(path("pid")).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    pid_t child = std::stoi(tests::read_text(path("pid")));
    EXPECT_EQ(::kill(child, 0), 0);
    dialog.close();
    EXPECT_NE(::kill(child, 0), 0);
    EXPECT_EQ(dialog.poll().state, State::unavailable);
}

}  // namespace
}  // namespace fieldwright::app
