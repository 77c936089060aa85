// The viewport's own eye: a pivot, a direction and a distance. Session state; the scene's cameras are nodes.
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace fieldwright::ui {

struct ViewCamera {
    glm::vec3 pivot{0, 0.5f, 0};        // m
    float yaw_rad = 0.6f;               // about +y; 0 looks from +z
    float pitch_rad = 0.45f;            // above the horizon; within +-89.9 degrees
    float distance = 6;                 // m, from the pivot
    float field_of_view_rad = 0.7854f;  // vertical
    bool orthographic = false;          // shows the same height at the pivot
    float rays_from = 0;                // m from the pivot: where parallel rays begin, when that is behind the eye
    bool operator==(const ViewCamera&) const = default;

    // Looks from a place at another; straight up and down, x is to the right.
    static ViewCamera seen_from(glm::vec3 position, glm::vec3 target);

    glm::vec3 backward() const;  // unit, from the pivot to the eye
    glm::vec3 right() const;     // unit
    glm::vec3 up() const;        // unit
    glm::vec3 position() const { return pivot + distance * backward(); }
    // Where a picture's rays begin. Coming closer with parallel rays only enlarges: it must not cut into what is near.
    glm::vec3 drawn_from() const;
    float height_at_pivot() const;                                // m of the picture's height
    float height_at(glm::vec3 point) const;                       // the same in the plane of a point; 0 behind the eye
    bool looks_along(int axis, int side) const;                   // as after look_along
    ViewCamera towards(const ViewCamera& to, float share) const;  // on the way: 0 is this one, 1 the other

    void orbit(glm::vec2 drag_rad);
    void pan(glm::vec2 drag_px, float viewport_height_px);  // the pivot's plane follows the hand
    void dolly(float notches);                              // 0.9 of the distance per notch
    void toggle_orthographic();                             // what lies at the pivot keeps its size
    // Looks along an axis, orthographic: side 1 sees from +axis, -1 from -axis.
    void look_along(int axis, int side);
    void frame(glm::vec3 centre, glm::vec3 half_size, float aspect);

    // Pixels of a viewport `size_px` (top-left origin) for a world point; nothing when it is behind the eye.
    std::optional<glm::vec2> project(glm::vec3 point, glm::vec2 size_px) const;
    struct Ray {
        glm::vec3 origin, direction;
    };
    Ray ray(glm::vec2 at_px, glm::vec2 size_px) const;
};

}  // namespace fieldwright::ui
