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
    bool operator==(const ViewCamera&) const = default;

    glm::vec3 backward() const;  // unit, from the pivot to the eye
    glm::vec3 right() const;     // unit
    glm::vec3 up() const;        // unit
    glm::vec3 position() const { return pivot + distance * backward(); }
    float height_at_pivot() const;  // m of the picture's height

    void orbit(glm::vec2 drag_rad);
    void pan(glm::vec2 drag_px, float viewport_height_px);  // the pivot's plane follows the hand
    void dolly(float notches);                              // 0.9 of the distance per notch
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
