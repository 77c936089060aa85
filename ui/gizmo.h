// The translate gizmo: arrows along the world's axes that move the active node's surface by a translate node, or a
// lamp, or what a camera looks at.
#pragma once

#include "ui/frame_context.h"
#include "ui/placement.h"

#include <optional>

namespace fieldwright::ui {

// How far along an axis (a unit vector) through `origin` it comes nearest to a ray; nothing when they are parallel.
std::optional<float> along_axis(glm::vec3 origin, glm::vec3 axis, const ViewCamera::Ray& ray);
// Where a ray meets the plane through `origin`; nothing when it does not.
std::optional<glm::vec3> on_plane(glm::vec3 origin, glm::vec3 normal, const ViewCamera::Ray& ray);

class TranslateGizmo {
public:
    enum class Handle { none, x, y, z, centre };

    // The hand on a handle, in this frame.
    struct Hand {
        glm::vec2 at_px;  // of the pane
        bool snap = false, fine = false;
    };

    // Finds where the active node stands. What is turned, bent or driven beyond reckoning is moved as a whole, after
    // that; hidden when there is no such place before it joins with something else.
    void place(FrameContext& frame, const ViewCamera& eye, glm::vec2 pane_size_px);
    void hide();
    bool shown() const { return stand_.has_value(); }
    Handle handle_at(glm::vec2 at_px, const Theme& theme) const;

    void grab(Handle handle, glm::vec2 at_px);
    void drag(FrameContext& frame, const Hand& hand);  // one undo step until let go
    void cancel(FrameContext& frame);                  // everything as before the grab
    void let_go();
    Handle grabbed() const { return grip_ ? grip_->handle : Handle::none; }

    void draw(ImDrawList& list, glm::vec2 pane_low, Handle hot, FrameContext& frame) const;

private:
    struct Stand {
        graph::NodeId active;
        graph::NodeId node, mover;                // no mover: the first move inserts a translate after the node
        std::string_view parameter;               // of the mover, m
        Placement place;                          // of the mover's output, or of the node's while there is none
        glm::vec3 origin;                         // world, m
        std::optional<glm::vec3> seen_from = {};  // of a camera
    };
    struct Grip {
        Handle handle;
        glm::vec3 origin;
        glm::vec3 start;             // where the hand held on to, world
        glm::vec2 last_px, held_px;  // the mouse, and where it is taken to be: slower while fine
        std::optional<graph::Document> before;
        glm::vec3 offset_before{0};
    };

    bool is_found(const FrameContext& frame, graph::NodeId active) const;
    std::optional<Stand> find(const FrameContext& frame, graph::NodeId active) const;
    std::optional<Stand> stand_at(const FrameContext& frame, graph::NodeId node) const;
    std::optional<Stand> stand_on_point(const FrameContext& frame, const graph::Node& node,
                                        const graph::NodeType& type) const;
    std::optional<glm::vec3> held(Handle handle, glm::vec3 origin, glm::vec2 at_px) const;
    void move(FrameContext& frame, glm::vec3 way);
    bool give_translate(FrameContext& frame);
    float metres() const;  // of the arrows' length
    std::optional<glm::vec2> tip(Handle handle) const;

    ViewCamera eye_;
    glm::vec2 pane_size_px_{0};
    float length_px_ = 0;
    std::optional<Stand> stand_;
    std::optional<Grip> grip_;

    // What `stand_` was found for: that is a walk over the scene, and asks for bounds.
    std::shared_ptr<const graph::Program> found_in_;
    graph::NodeId found_for_;
    double found_at_s_ = 0;
    bool found_through_camera_ = false;
};

}  // namespace fieldwright::ui
