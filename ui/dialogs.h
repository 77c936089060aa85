// Questions the window asks: unsaved changes, a file that somebody else wrote, work that a crash left behind.
#pragma once

#include "ui/frame_context.h"

#include <optional>

namespace fieldwright::ui {

class Dialogs {
public:
    void show_about() { about_ = true; }
    void ask_about_code() { code_put_off_ = false; }  // that the scene brought with it
    // Takes requests that would lose something out of the list and asks about them first. Call each frame;
    // `choosing_file`: the file browser is up.
    void hold_back(std::vector<Request>& requests, const Readings& readings, bool choosing_file);
    void draw(FrameContext& frame);
    // A question waits for its answer; nothing else may be in the way.
    bool asking() const { return question_ || overwriting_; }

private:
    void hold_back(Request request, std::vector<Request>& passed, const Readings& readings);
    void go_on_when_saved(std::vector<Request>& passed, const Readings& readings, bool choosing_file);
    void draw_unsaved(FrameContext& frame);
    void draw_overwrite(FrameContext& frame);
    void draw_recovery(FrameContext& frame);
    void draw_recovered(FrameContext& frame, const Recovered& recovered);
    void draw_foreign_code(FrameContext& frame);
    void draw_about(FrameContext& frame);
    void save(FrameContext& frame);

    std::optional<Request> question_;      // asked about now
    std::optional<Request> after_saving_;  // goes on once the scene is saved
    int frames_since_saving_ = 0;          // with no file dialog up
    bool overwriting_ = false;
    bool recovery_put_off_ = false;
    bool code_put_off_ = false, code_shown_ = false;
    std::vector<ForeignCode> code_asked_;  // about this
    bool about_ = false;
};

// What loses unsaved changes.
bool loses_changes(const Request& request);

}  // namespace fieldwright::ui
