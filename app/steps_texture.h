// The steps of a frame as a small picture for the cost panel.
#pragma once

#include "app/shown_picture.h"

namespace fieldwright::app {

class StepsTexture {
public:
    // Draws it anew when the frame or the display is another one.
    void show(const std::shared_ptr<const renderer::Frame>& frame, renderer::Display display, int step_limit);
    ui::StepsPicture reading() const { return {picture_.texture(), picture_.size().x, picture_.size().y}; }

private:
    std::shared_ptr<const renderer::Frame> frame_;
    renderer::Display display_;
    ShownPicture picture_;
};

}  // namespace fieldwright::app
