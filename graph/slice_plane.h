// The planes on which a field is looked at, from +z, from +x and from +y as the axis views are, and their lines.
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <string_view>

namespace fieldwright::graph {

struct SlicePlane {
    const char* name;
    glm::vec3 right, up;  // unit

    glm::vec3 normal() const { return glm::cross(right, up); }  // towards who looks at it
};

inline constexpr SlicePlane slice_planes[] = {
    {"xy", {1, 0, 0}, {0, 1, 0}}, {"yz", {0, 0, -1}, {0, 1, 0}}, {"zx", {1, 0, 0}, {0, 0, -1}}};

inline const SlicePlane* find_slice_plane(std::string_view name)  // null when there is none
{
    for (const SlicePlane& plane : slice_planes)
        if (plane.name == name) return &plane;
    return nullptr;
}

// Metres between lines of equal distance in a picture of that height: 1, 2 or 5 times a power of ten, 15 to 40 of them.
inline float line_spacing(float height)
{
    float wanted = height / 15, power = std::pow(10.0f, std::floor(std::log10(wanted)));
    for (float step : {5.0f, 2.0f})
        if (wanted >= step * power) return step * power;
    return power;
}

}  // namespace fieldwright::graph
