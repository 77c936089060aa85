// A file chooser of the desktop, run as a program beside ours: zenity or kdialog.
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fieldwright::app {

struct DialogRequest {
    enum class Kind { open, save };
    Kind kind = Kind::open;
    std::string title;             // "Open scene"
    std::filesystem::path folder;  // where it starts
    std::string name;              // of the file, when one is suggested
    std::string filter = "Scene";  // "Scene", pattern "*.scene.json"
    std::string pattern = "*.scene.json";
};

struct DialogAnswer {
    enum class State { pending, path, cancelled, unavailable };
    State state = State::pending;
    std::filesystem::path path;
};

class NativeDialog {
public:
    NativeDialog() = default;
    ~NativeDialog() { close(); }
    NativeDialog(const NativeDialog&) = delete;
    NativeDialog& operator=(const NativeDialog&) = delete;

    // Opens the chooser, closing one that is still open.
    void start(const DialogRequest& request);
    // Never blocks. After an answer other than pending the dialog is closed. Unavailable: use the built-in browser.
    DialogAnswer poll();
    bool is_open() const { return child_ > 0; }
    void close();

private:
    void spawn(const std::vector<std::string>& command);
    void read_some();

    pid_t child_ = 0;
    int pipe_ = -1;
    std::string output_;
};

// The chooser's command, program first; nothing when the desktop has none or FIELDWRIGHT_DIALOGS=builtin.
std::optional<std::vector<std::string>> dialog_command(const DialogRequest& request);

}  // namespace fieldwright::app
