// Points of an area, their distances, and what follows from them.
#include "renderer/slice_tile.h"

namespace fieldwright::renderer {
namespace {

constexpr float tap_m = 5e-4f;  // of the gradient, from the point
constexpr glm::vec3 corners[] = {{1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {1, 1, 1}};

// One column and row more than the area has: the change from pixel to pixel needs them.
std::vector<glm::vec3> points_of(const FrameRequest& request, const Area& area)
{
    std::vector<glm::vec3> points;
    glm::vec2 size(request.width, request.height);
    for (int y = area.y; y <= area.y + area.height; ++y)
        for (int x = area.x; x <= area.x + area.width; ++x)
            points.push_back(slice_point(*request.slice, glm::vec2(x, y) + 0.5f, size));
    return points;
}

// Lengths of the gradient, by the four corners of a tetrahedron.
std::vector<float> slopes_at(std::span<const glm::vec3> points, const DistancesAt& distances_at)
{
    std::vector<glm::vec3> gradients(points.size(), glm::vec3(0)), taps(points.size());
    for (glm::vec3 corner : corners) {
        for (std::size_t i = 0; i < points.size(); ++i) taps[i] = points[i] + tap_m * corner;
        std::vector<float> distances = distances_at(taps);
        for (std::size_t i = 0; i < points.size(); ++i) gradients[i] += distances[i] / (4 * tap_m) * corner;
    }
    std::vector<float> slopes;
    for (const glm::vec3& gradient : gradients) slopes.push_back(glm::length(gradient));
    return slopes;
}

}  // namespace

glm::vec3 slice_point(const Slice& slice, glm::vec2 at_px, glm::vec2 size_px)
{
    glm::vec2 way = (at_px - 0.5f * size_px) * (slice.height / size_px.y);
    return slice.centre + way.x * slice.right - way.y * slice.up;
}

void draw_slice_area(Frame& frame, const FrameRequest& request, const Area& area, const DistancesAt& distances_at)
{
    std::vector<glm::vec3> points = points_of(request, area);
    std::vector<float> distances = distances_at(points), slopes;
    if (request.slice->style == SliceStyle::gradient) slopes = slopes_at(points, distances_at);
    auto pitch = static_cast<std::size_t>(area.width + 1);
    for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x) {
            std::size_t from = static_cast<std::size_t>(y) * pitch + static_cast<std::size_t>(x);
            float d = distances[from];
            float change = glm::length(glm::vec2(distances[from + 1] - d, distances[from + pitch] - d));
            std::size_t to = static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(frame.width) +
                             static_cast<std::size_t>(area.x + x);
            frame.colour[to] = slice_colour(*request.slice, {d, change, slopes.empty() ? 1 : slopes[from]});
            frame.depth[to] = d;
            frame.normal[to] = glm::vec3(0);
            frame.node_id[to] = frame.material_id[to] = frame.exhausted[to] = 0;
            frame.steps[to] = 1;
        }
}

}  // namespace fieldwright::renderer
