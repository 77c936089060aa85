// From how the window looks at the scene to what the render thread is asked for.
#pragma once

#include "renderer/render_thread.h"
#include "ui/readings.h"
#include "ui/view_state.h"

namespace fieldwright::app {

// View, colours and eyes, for a pane of `size_px`: of eyes beside or below each other, each gets its part of it.
void set_display(renderer::PictureRequest& request, const ui::ViewState& view, const ui::Readings& readings,
                 glm::ivec2 size_px);

}  // namespace fieldwright::app
