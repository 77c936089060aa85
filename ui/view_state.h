// How the window looks at the document: saved with the session, neither undone nor part of the scene.
#pragma once

#include "ui/drawing_view.h"
#include "ui/selection.h"
#include "ui/view_camera.h"

#include <glm/glm.hpp>

#include <string>

namespace fieldwright::ui {

enum class Panel { materials, lights, camera, cost, stereo, shader, problems, history };

struct CanvasView {
    glm::vec2 pan_px{40, 40};  // of the window: screen = canvas corner + pan + zoom * canvas
    float zoom = 1;            // 0.1 .. 4
};

// A group that is open on the canvas.
struct OpenGroup {
    graph::NodeId node;  // of the group, in the graph around it
    CanvasView around;   // how that graph was seen
};

struct Panes {
    bool shown = true;             // all but the viewport (space bar)
    float side_width = 380;        // design px
    float canvas_share = 0.42f;    // of the left column's height
    float inspector_share = 0.5f;  // of the right column's height
};

struct ViewState {
    Panes panes;
    Panel panel = Panel::materials;
    CanvasView canvas;
    bool minimap = true;

    ViewCamera camera;
    bool through_camera = true;  // shows what the scene's camera sees, while the scene has one
    std::string view = "beauty";
    std::string stereo = "off";
    float interaxial = 0.065f;  // m
    float convergence = 5;      // m along the view axis
    bool statistics = true;
    bool gizmo = true;

    bool playing = false;
    double time_s = 0;   // of the scene
    double loop_s = 10;  // playing starts again here

    Selection selection;
    DrawingView drawing;
    std::vector<OpenGroup> way;   // the groups that lead to the graph on the canvas, outermost first
    graph::NodeId frame_request;  // the canvas is to bring this node into view; cleared when done
    bool add_request = false;     // the add menu is to open; cleared when done
    std::string hint;             // about what is under the mouse, for the status line; its part writes it every frame
    bool reduced_motion = false;
};

}  // namespace fieldwright::ui
