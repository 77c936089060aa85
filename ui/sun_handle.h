// The sun handle: an arrow from the middle of the view towards the selected sun; its ball turns the light.
#pragma once

#include "ui/frame_context.h"
#include "ui/gizmo.h"

#include <optional>

namespace fieldwright::ui {

// A sun's direction, unit, towards it. Degrees, as the node has them.
glm::vec3 sun_direction(float elevation_deg, float azimuth_deg);

class SunHandle {
public:
    // Hidden unless the active node is a sun that no wire drives.
    void place(const FrameContext& frame, const ViewCamera& eye, glm::vec2 pane_size_px);
    void hide();
    bool is_under(glm::vec2 at_px, const Theme& theme) const;

    void grab(glm::vec2 at_px);
    void drag(FrameContext& frame, const TranslateGizmo::Hand& hand);  // one undo step until let go
    void cancel(FrameContext& frame);                                  // everything as before the grab
    void let_go() { grip_.reset(); }

    void draw(ImDrawList& list, glm::vec2 pane_low, bool hot, FrameContext& frame) const;

private:
    struct Angles {
        float elevation_deg = 0, azimuth_deg = 0;
        bool operator==(const Angles&) const = default;
    };
    struct Grip {
        glm::vec2 last_px, held_px;  // the mouse, and where the ball is taken to be: slower while fine
        bool far_side;               // of the sphere that the ball goes on
        std::optional<graph::Document> before;
    };

    static std::optional<Angles> angles_of(const graph::Node& node);
    float metres() const;  // of the arrow's length
    glm::vec3 ball() const;
    Angles angles_at(glm::vec2 at_px) const;

    ViewCamera eye_;
    glm::vec2 pane_size_px_{0};
    float length_px_ = 0;
    graph::NodeId sun_;  // none: hidden
    Angles angles_;
    std::optional<Grip> grip_;
};

}  // namespace fieldwright::ui
