// Planes, and the ray that is drawn over them.
#include "ui/slice_frame.h"

#include "graph/slice_plane.h"
#include "ui/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fieldwright::ui {
namespace {

constexpr ImU32 ray_tint = colour::rgb(0xfdf6e3), sphere_tint = colour::rgb(0x15171a);

ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }

// The plane through the ray that stands as upright as it can; the ray goes to the right.
SliceFrame frame_of_ray(const RayReading& ray)
{
    glm::vec3 upright = std::abs(ray.direction.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    glm::vec3 up = glm::normalize(upright - glm::dot(upright, ray.direction) * ray.direction);
    return {.centre = ray.origin, .right = ray.direction, .up = up};
}

// A line under a brighter one, so that it is seen on every ground.
void outlined_line(const Theme& theme, ImDrawList& list, glm::vec2 from, glm::vec2 to)
{
    list.AddLine(im(from), im(to), colour::with_alpha(sphere_tint, 0.8f), theme.px(3.5f));
    list.AddLine(im(from), im(to), ray_tint, theme.px(1.5f));
}

}  // namespace

glm::vec3 SliceFrame::point(glm::vec2 at_px, glm::vec2 size_px) const
{
    glm::vec2 way = (at_px - 0.5f * size_px) * (height / size_px.y);
    return centre + way.x * right - way.y * up;
}

glm::vec2 SliceFrame::place(glm::vec3 point, glm::vec2 size_px) const
{
    glm::vec2 way(glm::dot(point - centre, right), -glm::dot(point - centre, up));
    return 0.5f * size_px + way * (size_px.y / height);
}

float SliceFrame::above(glm::vec3 point) const { return glm::dot(point - centre, glm::cross(right, up)); }

SliceFrame slice_frame(const ViewState& view, const Readings& readings)
{
    const SliceView& slice = view.slice;
    SliceFrame frame;
    if (slice.plane == "ray" && readings.ray) {
        frame = frame_of_ray(*readings.ray);
    } else {
        const graph::SlicePlane* plane = graph::find_slice_plane(slice.plane);
        if (!plane) plane = &graph::slice_planes[0];
        frame = {.centre = slice.offset * plane->normal(), .right = plane->right, .up = plane->up};
    }
    frame.centre += slice.centre.x * frame.right + slice.centre.y * frame.up;
    frame.height = slice.height;
    return frame;
}

void draw_slice_overlay(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane)
{
    if (frame.view.view != "slice" || !frame.readings.ray) return;
    const RayReading& ray = *frame.readings.ray;
    SliceFrame plane = slice_frame(frame.view, frame.readings);
    glm::vec2 size = pane.high - pane.low;
    float px_per_metre = size.y / plane.height;
    auto place = [&](float t) { return pane.low + plane.place(ray.at(t), size); };
    list.PushClipRect(im(pane.low), im(pane.high), true);
    for (const RayReading::Step& step : ray.steps) {
        float above = plane.above(ray.at(step.t)), reach = step.distance * step.distance - above * above;
        if (reach <= 0) continue;
        float radius = std::sqrt(reach) * px_per_metre;
        if (radius < 1.5f || radius > 20000) continue;
        list.AddCircle(im(place(step.t)), radius, colour::with_alpha(sphere_tint, 0.75f), 0, frame.theme.px(3));
        list.AddCircle(im(place(step.t)), radius, colour::with_alpha(ray_tint, 0.8f), 0, frame.theme.px(1));
    }
    outlined_line(frame.theme, list, place(0), place(ray.t_end));
    for (const RayReading::Step& step : ray.steps)
        list.AddCircleFilled(im(place(step.t)), frame.theme.px(2.5f), ray_tint);
    if (ray.end == RayReading::End::hit) list.AddCircleFilled(im(place(ray.t_end)), frame.theme.px(4.5f), colour::hot);
    list.PopClipRect();
}

std::string slice_hint(const FrameContext& frame, glm::vec2 at_px, glm::vec2 size_px)
{
    glm::vec3 point = slice_frame(frame.view, frame.readings).point(at_px, size_px);
    const PictureReading& picture = frame.readings.picture;
    glm::vec2 pixel = at_px / size_px * glm::vec2(picture.width, picture.height);
    std::optional<float> distance;
    if (frame.readings.depth_at)
        distance = frame.readings.depth_at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    char place[96];
    std::snprintf(place, sizeof place, "x %.3f, y %.3f, z %.3f m", static_cast<double>(point.x),
                  static_cast<double>(point.y), static_cast<double>(point.z));
    std::string text = place;
    if (distance)
        text += std::string(*distance < 0 ? " · inside by " : " · ") +
                rounded_text(std::abs(static_cast<double>(*distance))) + (*distance < 0 ? " m" : " m from the surface");
    return text + ". Drag to move the plane's picture, scroll to come closer.";
}

}  // namespace fieldwright::ui
