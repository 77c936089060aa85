// How the window looks at the document: saved with the session, neither undone nor part of the scene.
#pragma once

#include "ui/drawing_view.h"
#include "ui/selection.h"
#include "ui/view_camera.h"

#include <glm/glm.hpp>

#include <string>

namespace fieldwright::ui {

enum class Panel { materials, lights, camera, cost, field, stereo, shader, problems, history };

// What the next click on the picture does.
enum class Click { select, converge, inspect };

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

// How two eyes see, besides their distance and convergence.
struct StereoView {
    bool linear = true;  // anaglyphs mix light, else encoded values
    bool swap = false, toe_in = false;
    bool rivalry = false;                                // stripes where the eyes fight
    bool split = false;                                  // the naive anaglyph left of the divider
    float divider = 0.5f;                                // share of the picture's width
    float screen_width = 0.6f, viewing_distance = 0.7f;  // m, of the screen and of who sits before it
};

// The plane of the view `slice`.
struct SliceView {
    std::string plane = "xy";  // or "ray": the one through the inspected ray
    std::string style = "sign";
    float offset = 0;           // m along the plane's normal
    glm::vec2 centre{0, 0.5f};  // m, of the picture, along the plane's axes
    float height = 4;           // m, of the picture
    float gamma = 2.2f;         // of the style `grey`
};

struct ViewState {
    Panes panes;
    Panel panel = Panel::materials;
    CanvasView canvas;
    bool minimap = true;

    ViewCamera camera;
    bool through_camera = true;  // shows what the scene's camera sees, while the scene has one
    std::string view = "beauty";
    std::string colour_map = "viridis";
    int full_scale = 0;  // steps at the map's end; 0 = the step limit
    StereoView eyes;
    std::string stereo = "off";
    float interaxial = 0.065f;  // m
    float convergence = 5;      // m along the view axis
    SliceView slice;
    Click click = Click::select;
    bool node_costs = true;  // shown on the nodes, once measured
    bool statistics = true;
    bool gizmo = true;

    bool playing = false;
    bool looping = true;      // playing begins again after the last frame
    double time_s = 0;        // of the scene
    double frame_rest_s = 0;  // while playing: how long the frame has been shown

    Selection selection;
    DrawingView drawing;
    std::string font_query;       // what is searched for in the open list of fonts
    std::vector<OpenGroup> way;   // the groups that lead to the graph on the canvas, outermost first
    graph::NodeId frame_request;  // the canvas is to bring this node into view; cleared when done
    bool add_request = false;     // the add menu is to open; cleared when done
    std::string hint;             // about what is under the mouse, for the status line; its part writes it every frame
    bool reduced_motion = false;
};

}  // namespace fieldwright::ui
