// The scene's own camera, as an eye that the viewport can take over.
#pragma once

#include "graph/document.h"
#include "ui/view_camera.h"

#include <optional>

namespace fieldwright::ui {

struct SceneCamera {
    ViewCamera eye;
    bool driven = false;  // wires decide about its place, so that `eye` is only where it was left
    bool bent = false;    // its rays lie otherwise than those of `eye`, which only looks the same way
};

// The camera that the output uses; nothing when it has none, or one of a type of its own.
std::optional<SceneCamera> scene_camera(const graph::Document& document);

}  // namespace fieldwright::ui
