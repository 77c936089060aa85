// Viewport: the picture, the eye that sees it, and what is drawn over it.
#pragma once

#include "ui/axis_gizmo.h"
#include "ui/frame_context.h"
#include "ui/gizmo.h"
#include "ui/sun_handle.h"

namespace fieldwright::ui {

class Viewport {
public:
    // Fills the current ImGui child window.
    void draw(FrameContext& frame);
    // A gesture is under way (a drag, a grab): what it changes is one step, recorded when it ends.
    bool busy() const { return grab_.has_value(); }
    // The eye is on its way to a new place: more frames are wanted.
    bool moving() const { return motion_.has_value(); }
    bool hovered() const { return hovered_; }  // in the last frame; nothing lies over it

    // Each of these leaves the scene's camera first, without a jump.
    void frame_all(FrameContext& frame);
    void frame_selected(FrameContext& frame);                  // everything when nothing is selected
    void look_along(FrameContext& frame, int axis, int side);  // side 1 sees from +axis, -1 from -axis
    void orbit(FrameContext& frame, glm::vec2 turn_rad);
    void toggle_orthographic(FrameContext& frame);

    bool looks_through_camera(const FrameContext& frame) const;
    void look_through_camera(FrameContext& frame);   // and back
    void set_camera_from_view(FrameContext& frame);  // the scene's camera, one step
    void toggle_gizmo(FrameContext& frame);

private:
    enum class Turn { orbit, pan, dolly };
    struct Motion {
        ViewCamera from, to;
        float seconds = 0;
    };
    // A mouse button that went down here and is still held.
    struct Grab {
        enum class On { picture, axes, handle, sun, divider } on;
        Turn turn;
        int button;
        glm::vec2 from, last;  // px of the pane
        bool moved = false;    // far enough to be no click
    };

    std::optional<ViewCamera> shown_eye(const FrameContext& frame) const;
    void leave_camera(FrameContext& frame);
    ViewCamera destination(const FrameContext& frame) const;
    void go_to(FrameContext& frame, const ViewCamera& eye);
    void follow_motion(FrameContext& frame);
    void frame_box(FrameContext& frame, const Measured& box);

    void place_handles(FrameContext& frame);
    void hands(FrameContext& frame);
    void press(int button);
    void drag(FrameContext& frame);
    void turn_eye(FrameContext& frame, Turn turn, glm::vec2 way_px);
    void leave_axis_view(FrameContext& frame);
    void release(FrameContext& frame);
    void click(FrameContext& frame, glm::vec2 at);
    void choose_node(FrameContext& frame, glm::vec2 at);
    glm::ivec2 pixel_under(const FrameContext& frame, glm::vec2 at) const;  // of the picture
    float divider_x(const FrameContext& frame) const;                       // px of the pane
    bool has_divider(const FrameContext& frame) const;
    void move_slice(FrameContext& frame, glm::vec2 way_px);
    void zoom(FrameContext& frame, float notches);
    graph::NodeId node_under(const FrameContext& frame, glm::vec2 at) const;
    std::string hint(const FrameContext& frame) const;

    void draw_picture(const FrameContext& frame) const;
    void draw_handles(FrameContext& frame);
    void draw_divider(FrameContext& frame);
    void draw_projection(FrameContext& frame);

    WidgetRect pane_;
    glm::vec2 mouse_{0};  // px of the pane; where it was last, while another window has it
    bool has_mouse_ = false;
    bool hovered_ = false, on_picture_ = false;
    TranslateGizmo gizmo_;
    SunHandle sun_;
    AxisGizmo axes_;
    bool axes_shown_ = false;
    TranslateGizmo::Handle hot_ = TranslateGizmo::Handle::none;
    bool hot_axes_ = false, hot_sun_ = false, hot_divider_ = false;
    std::optional<Grab> grab_;
    std::optional<Motion> motion_;
    bool perspective_before_axis_view_ = false;
    float scale_ = 1;
};

}  // namespace fieldwright::ui
