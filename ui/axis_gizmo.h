// The axis gizmo: six balls that show where x, y and z point, and turn the view along one.
#pragma once

#include "ui/frame_context.h"

#include <optional>

namespace fieldwright::ui {

struct Side {
    int axis = 0;  // 0 x, 1 y, 2 z
    int sign = 1;
    bool operator==(const Side&) const = default;
};

class AxisGizmo {
public:
    // Where it stands: its ball's centre. Called before the others, every frame.
    void place(glm::vec2 centre, const ViewCamera& eye, const Theme& theme);
    bool contains(glm::vec2 at) const;                // the disc that can be dragged
    std::optional<Side> side_at(glm::vec2 at) const;  // the ball nearest to the eye there
    void draw(ImDrawList& list, glm::vec2 mouse, bool hot, FrameContext& frame) const;

private:
    struct Ball {
        Side side;
        glm::vec2 at;
        float nearness;  // -1 away from the eye .. 1 towards it
    };
    void draw_ball(ImDrawList& list, const Ball& ball, bool hot, const Theme& theme) const;

    glm::vec2 centre_{0};
    float radius_ = 0, ball_radius_ = 0;
    std::vector<Ball> balls_;  // farthest first
};

}  // namespace fieldwright::ui
