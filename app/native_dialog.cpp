// Starts the desktop's file chooser and listens to it without waiting.
#include "app/native_dialog.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <utility>

extern char** environ;

namespace fieldwright::app {

namespace fs = std::filesystem;

namespace {

std::string_view variable(const char* name)
{
    const char* text = std::getenv(name);
    return text ? text : "";
}

// The program's file in one of the folders of PATH; empty when there is none.
std::string found_program(const char* name)
{
    std::string_view path = variable("PATH");
    while (!path.empty()) {
        std::string_view folder = path.substr(0, path.find(':'));
        path.remove_prefix(std::min(path.size(), folder.size() + 1));
        if (!folder.starts_with('/')) continue;
        std::string file = std::string(folder) + "/" + name;
        std::error_code error;
        if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

std::vector<std::string> zenity(const std::string& program, const DialogRequest& request)
{
    std::vector<std::string> command = {program, "--file-selection", "--title=" + request.title,
                                        "--filename=" + (request.folder / request.name).string()};
    if (request.kind == DialogRequest::Kind::save) command.insert(command.end(), {"--save", "--confirm-overwrite"});
    command.push_back("--file-filter=" + request.filter + " | " + request.pattern);
    command.push_back("--file-filter=All files | *");
    return command;
}

std::vector<std::string> kdialog(const std::string& program, const DialogRequest& request)
{
    return {program,
            "--title",
            request.title,
            request.kind == DialogRequest::Kind::save ? "--getsavefilename" : "--getopenfilename",
            (request.folder / request.name).string(),
            request.filter + " (" + request.pattern + ")"};
}

// Our ends of a child's streams: nothing to read, its output in our pipe, its complaints dropped.
class ChildStreams {
public:
    explicit ChildStreams(int output)
    {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        ::posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    ~ChildStreams() { ::posix_spawn_file_actions_destroy(&actions_); }
    ChildStreams(const ChildStreams&) = delete;
    ChildStreams& operator=(const ChildStreams&) = delete;
    const posix_spawn_file_actions_t* actions() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

// What the chooser's exit says; choosers end their answer with a line end.
DialogAnswer answer(int status, std::string output)
{
    if (!WIFEXITED(status) || WEXITSTATUS(status) > 1) return {DialogAnswer::State::unavailable, {}};
    if (output.ends_with('\n')) output.pop_back();
    if (WEXITSTATUS(status) == 1 || output.empty()) return {DialogAnswer::State::cancelled, {}};
    return {DialogAnswer::State::path, output};
}

}  // namespace

std::optional<std::vector<std::string>> dialog_command(const DialogRequest& request)
{
    if (variable("FIELDWRIGHT_DIALOGS") == "builtin") return std::nullopt;
    // Without a display they fail as if cancelled.
    if (variable("DISPLAY").empty() && variable("WAYLAND_DISPLAY").empty()) return std::nullopt;
    std::string gnome = found_program("zenity"), kde = found_program("kdialog");
    bool on_kde = variable("XDG_CURRENT_DESKTOP").find("KDE") != std::string_view::npos;
    if (!kde.empty() && (on_kde || gnome.empty())) return kdialog(kde, request);
    if (!gnome.empty()) return zenity(gnome, request);
    return std::nullopt;
}

void NativeDialog::start(const DialogRequest& request)
{
    close();
    if (auto command = dialog_command(request)) spawn(*command);
}

void NativeDialog::spawn(const std::vector<std::string>& command)
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return;
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ChildStreams streams(ends[1]);
    int error = ::posix_spawnp(&child_, arguments[0], streams.actions(), nullptr, arguments.data(), environ);
    ::close(ends[1]);
    pipe_ = ends[0];
    if (error == 0) return;
    child_ = 0;
    close();
}

void NativeDialog::read_some()
{
    char buffer[4096];
    ssize_t count = 0;
    do {
        count = ::read(pipe_, buffer, sizeof buffer);
        if (count > 0) output_.append(buffer, static_cast<std::size_t>(count));
    } while (count > 0 || (count < 0 && errno == EINTR));
}

DialogAnswer NativeDialog::poll()
{
    if (child_ == 0) return {DialogAnswer::State::unavailable, {}};
    // A chooser's helpers may keep the pipe open, so it is its end that counts.
    read_some();
    int status = 0;
    pid_t ended = ::waitpid(child_, &status, WNOHANG);
    if (ended == 0) return {};
    child_ = 0;
    read_some();
    DialogAnswer result = ended < 0 ? DialogAnswer{DialogAnswer::State::unavailable, {}} : answer(status, output_);
    close();
    return result;
}

void NativeDialog::close()
{
    if (child_ > 0) {
        ::kill(child_, SIGKILL);
        while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    child_ = 0;
    if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
    output_.clear();
}

}  // namespace fieldwright::app
