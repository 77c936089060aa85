// What both devices need to know of a request, and buffers of a size.
#include "renderer/frame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace fieldwright::renderer {

float eye_side(Eye eye) { return eye == Eye::left ? -1.0f : (eye == Eye::right ? 1.0f : 0.0f); }

Viewpoint viewpoint_of(const ViewCamera& camera)
{
    Viewpoint view{.position = camera.position};
    glm::vec3 way = camera.target - camera.position;
    float far_away = glm::length(way);
    view.forward = far_away > 1e-6f ? way / far_away : glm::vec3(0, 0, -1);
    // Along `up` there is no level direction across the view; x serves.
    glm::vec3 level = glm::cross(view.forward, camera.up);
    float levelness = glm::length(level);
    view.right = levelness > 1e-5f ? level / levelness : glm::vec3(1, 0, 0);
    view.upward = glm::cross(view.right, view.forward);
    bool perspective = camera.orthographic_height <= 0;
    view.slope = perspective ? std::tan(0.5f * camera.field_of_view_rad) : 0;
    view.half_height = perspective ? 0 : 0.5f * camera.orthographic_height;
    return view;
}

Area drawn_area(const FrameRequest& request)
{
    return request.part.value_or(Area{0, 0, request.width, request.height});
}

DrawnPixels drawn_pixels(const FrameRequest& request)
{
    const auto& [step, x, y] = request.lattice;
    const Area area = drawn_area(request);
    auto first = [&](int from, int remainder) { return from + ((remainder - from) % step + step) % step; };
    auto count = [&](int from, int end) { return std::max((end - from + step - 1) / step, 0); };
    int left = first(area.x, x), top = first(area.y, y);
    return {left, top, step, count(left, area.x + area.width), count(top, area.y + area.height)};
}

Layers::Layers(std::size_t pixels)
    : ambient(pixels),
      diffuse(pixels),
      specular(pixels),
      reflection(pixels),
      emission(pixels),
      albedo(pixels),
      position(pixels),
      shadow(pixels),
      occlusion(pixels),
      gradient_length(pixels),
      minimum_cone_ratio(pixels),
      shadow_steps(pixels)
{
}

glm::vec3 Layers::colour(std::size_t pixel) const
{
    return ambient[pixel] + diffuse[pixel] + specular[pixel] + reflection[pixel] + emission[pixel];
}

Frame::Frame(int frame_width, int frame_height, bool with_layers) : width(frame_width), height(frame_height)
{
    auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    colour.resize(pixels);
    depth.resize(pixels, std::numeric_limits<float>::infinity());
    normal.resize(pixels);
    node_id.resize(pixels);
    material_id.resize(pixels);
    steps.resize(pixels);
    exhausted.resize(pixels);
    if (with_layers) layers.emplace(pixels);
}

}  // namespace fieldwright::renderer
