// Turning, moving and projecting with the viewport's camera.
#include "ui/view_camera.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float steepest_rad = 1.5690510f;                           // 89.9 degrees
constexpr float smallest_distance = 1e-3f, largest_distance = 1e5f;  // m

}  // namespace

glm::vec3 ViewCamera::backward() const
{
    float across = std::cos(pitch_rad);
    return {across * std::sin(yaw_rad), std::sin(pitch_rad), across * std::cos(yaw_rad)};
}

glm::vec3 ViewCamera::right() const { return {std::cos(yaw_rad), 0, -std::sin(yaw_rad)}; }
glm::vec3 ViewCamera::up() const { return glm::cross(backward(), right()); }
float ViewCamera::height_at_pivot() const { return 2 * distance * std::tan(0.5f * field_of_view_rad); }

void ViewCamera::orbit(glm::vec2 drag_rad)
{
    yaw_rad = std::remainder(yaw_rad - drag_rad.x, 6.2831853f);
    pitch_rad = std::clamp(pitch_rad + drag_rad.y, -steepest_rad, steepest_rad);
}

void ViewCamera::pan(glm::vec2 drag_px, float viewport_height_px)
{
    float metres_per_px = height_at_pivot() / std::max(viewport_height_px, 1.0f);
    pivot += metres_per_px * (drag_px.y * up() - drag_px.x * right());
}

void ViewCamera::dolly(float notches)
{
    distance = std::clamp(distance * std::pow(0.9f, notches), smallest_distance, largest_distance);
}

void ViewCamera::look_along(int axis, int side)
{
    constexpr float quarter = 1.5707963f;
    orthographic = true;
    pitch_rad = axis == 1 ? static_cast<float>(side) * steepest_rad : 0;
    yaw_rad = axis == 0 ? static_cast<float>(side) * quarter : axis == 2 && side < 0 ? 2 * quarter : 0;
}

void ViewCamera::frame(glm::vec3 centre, glm::vec3 half_size, float aspect)
{
    pivot = centre;
    float across_rad = 2 * std::atan(std::tan(0.5f * field_of_view_rad) * std::min(aspect, 1.0f));
    float radius = std::max(glm::length(half_size), 1e-3f);
    distance = std::clamp(1.1f * radius / std::sin(0.5f * across_rad), smallest_distance, largest_distance);
}

std::optional<glm::vec2> ViewCamera::project(glm::vec3 point, glm::vec2 size_px) const
{
    glm::vec3 offset = point - pivot;
    float depth = distance - glm::dot(offset, backward());
    if (!orthographic && depth < 1e-4f) return std::nullopt;
    float half_height = 0.5f * height_at_pivot() * (orthographic ? 1.0f : depth / distance);
    glm::vec2 uv = glm::vec2(glm::dot(offset, right()), glm::dot(offset, up())) / half_height;
    return 0.5f * size_px + 0.5f * size_px.y * glm::vec2(uv.x, -uv.y);
}

ViewCamera::Ray ViewCamera::ray(glm::vec2 at_px, glm::vec2 size_px) const
{
    glm::vec2 uv = (at_px - 0.5f * size_px) / (0.5f * size_px.y);
    glm::vec3 across = 0.5f * height_at_pivot() * (uv.x * right() - uv.y * up());
    if (orthographic) return {position() + across, -backward()};
    return {position(), glm::normalize(across - distance * backward())};
}

}  // namespace fieldwright::ui
