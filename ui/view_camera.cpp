// Turning, moving and projecting with the viewport's camera.
#include "ui/view_camera.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float steepest_rad = 1.5690510f;  // 89.9 degrees
constexpr float quarter_rad = 1.5707963f;
constexpr float widest_rad = 2.0943951f, usual_rad = 0.7853982f;     // fields of view: 120 and 45 degrees
constexpr float smallest_distance = 1e-3f, largest_distance = 1e5f;  // m

float yaw_along(int axis, int side)
{
    float one_way = axis == 0 ? quarter_rad : 0;
    return axis == 2 && side < 0 ? 2 * quarter_rad : static_cast<float>(side) * one_way;
}

float pitch_along(int axis, int side) { return axis == 1 ? static_cast<float>(side) * steepest_rad : 0; }

float turn_between(float from_rad, float to_rad) { return std::remainder(to_rad - from_rad, 4 * quarter_rad); }

}  // namespace

ViewCamera ViewCamera::seen_from(glm::vec3 position, glm::vec3 target)
{
    ViewCamera eye;
    glm::vec3 way = position - target;
    float length = glm::length(way), level = glm::length(glm::vec2(way.x, way.z));
    bool somewhere = length > 1e-6f;
    eye.distance = somewhere ? std::clamp(length, smallest_distance, largest_distance) : 1;
    eye.yaw_rad = level > 1e-5f * length && somewhere ? std::atan2(way.x, way.z) : 0;
    eye.pitch_rad = somewhere ? std::clamp(std::atan2(way.y, level), -steepest_rad, steepest_rad) : 0;
    eye.pivot = position - eye.distance * eye.backward();
    return eye;
}

glm::vec3 ViewCamera::backward() const
{
    float across = std::cos(pitch_rad);
    return {across * std::sin(yaw_rad), std::sin(pitch_rad), across * std::cos(yaw_rad)};
}

glm::vec3 ViewCamera::right() const { return {std::cos(yaw_rad), 0, -std::sin(yaw_rad)}; }
glm::vec3 ViewCamera::up() const { return glm::cross(backward(), right()); }
glm::vec3 ViewCamera::drawn_from() const
{
    return orthographic ? pivot + std::max(distance, rays_from) * backward() : position();
}

float ViewCamera::height_at_pivot() const { return 2 * distance * std::tan(0.5f * field_of_view_rad); }

float ViewCamera::height_at(glm::vec3 point) const
{
    if (orthographic) return height_at_pivot();
    float depth = distance - glm::dot(point - pivot, backward());
    return std::max(depth, 0.0f) / distance * height_at_pivot();
}

bool ViewCamera::looks_along(int axis, int side) const
{
    constexpr float close = 1e-3f;
    bool level = axis == 1 || std::abs(turn_between(yaw_rad, yaw_along(axis, side))) < close;
    return level && std::abs(pitch_rad - pitch_along(axis, side)) < close;
}

ViewCamera ViewCamera::towards(const ViewCamera& to, float share) const
{
    if (share >= 1) return to;
    ViewCamera eye = *this;
    eye.pivot = glm::mix(pivot, to.pivot, share);
    eye.yaw_rad = std::remainder(yaw_rad + share * turn_between(yaw_rad, to.yaw_rad), 4 * quarter_rad);
    eye.pitch_rad = glm::mix(pitch_rad, to.pitch_rad, share);
    eye.rays_from = to.rays_from;
    eye.distance = distance * std::pow(to.distance / distance, share);
    eye.field_of_view_rad = glm::mix(field_of_view_rad, to.field_of_view_rad, share);
    return eye;
}

void ViewCamera::orbit(glm::vec2 drag_rad)
{
    yaw_rad = std::remainder(yaw_rad - drag_rad.x, 4 * quarter_rad);
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

void ViewCamera::toggle_orthographic()
{
    orthographic = !orthographic;
    if (orthographic || field_of_view_rad <= widest_rad) return;
    // Parallel rays of a tall picture: as an eye it stands farther away, and does not distort.
    distance = 0.5f * height_at_pivot() / std::tan(0.5f * usual_rad);
    field_of_view_rad = usual_rad;
}

void ViewCamera::look_along(int axis, int side)
{
    orthographic = true;
    pitch_rad = pitch_along(axis, side);
    yaw_rad = yaw_along(axis, side);
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
