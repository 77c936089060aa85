// The line at the bottom: why something was refused, what was done, or what the mouse may do; and how the scene fares.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

class StatusLine {
public:
    // Shows a refusal for a while.
    void refuse(std::string_view sentence, double now_s);
    // Fills the bottom of the current window.
    void draw(FrameContext& frame, double now_s);
    const std::string& text() const { return text_; }  // in the last frame
    // When it will look different without anybody doing anything; nothing = never.
    std::optional<double> changes_at_s() const { return changes_at_s_; }

private:
    struct Message {
        std::string text;
        ImU32 colour;
    };
    Message message(const FrameContext& frame, double now_s);
    void note_status(const Readings& readings, double now_s);

    std::string refusal_, status_, text_;
    int status_count_ = 0;
    double refused_at_s_ = 0, status_at_s_ = 0;
    std::optional<double> changes_at_s_;
};

}  // namespace fieldwright::ui
