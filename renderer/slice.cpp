// Planes and colours of distance slices.
#include "renderer/slice.h"

#include "renderer/srgb_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fieldwright::renderer {
namespace {

constexpr SliceStyleKind styles[] = {
    {"sign", "Inside and outside", "Blue inside, amber outside, with lines of equal distance and a white surface."},
    {"grey", "Distance as grey", "The distance to the surface, either side: black on it, white from one metre."},
    {"contour", "Outline only", "The surface's outline and nothing else."},
    {"gradient", "Gradient error",
     "How far the gradient's length is from 1: dark where the field is a true distance, bright where it is not."},
};
constexpr float surface_px = 2, line_px = 1;  // wide

// sRGB, stored.
constexpr glm::vec3 inside(0.29f, 0.50f, 0.78f), outside(0.86f, 0.62f, 0.32f), ground(0.082f, 0.09f, 0.102f),
    surface(0.96f);

glm::vec3 decoded(glm::vec3 stored)
{
    for (int k = 0; k < 3; ++k)
        stored[k] =
            SrgbTable::shared().linear(static_cast<unsigned char>(255 * std::clamp(stored[k], 0.0f, 1.0f) + 0.5f));
    return stored;
}

// How much of a pixel a line covers that lies `away` metres of distance from it.
float coverage(float away, float change, float width_px)
{
    return std::clamp(0.5f * width_px + 0.5f - std::abs(away) / std::max(change, 1e-9f), 0.0f, 1.0f);
}

float surface_coverage(const SliceSample& sample) { return coverage(sample.distance, sample.change, surface_px); }

// Lines that would lie closer than three pixels fade: they would be no lines.
float line_coverage(const Slice& slice, const SliceSample& sample)
{
    float away = sample.distance - slice.spacing * std::round(sample.distance / slice.spacing);
    float apart_px = slice.spacing / std::max(sample.change, 1e-9f);
    return coverage(away, sample.change, line_px) * std::clamp((apart_px - 3) / 6, 0.0f, 1.0f);
}

glm::vec3 sign_colour(const Slice& slice, const SliceSample& sample)
{
    float near = std::exp(-3 * std::abs(sample.distance) / slice.height * 4);
    glm::vec3 side = (sample.distance < 0 ? inside : outside) * (1 - 0.45f * near);
    return glm::mix(side, 0.62f * side, line_coverage(slice, sample));
}

glm::vec3 grey(const Slice& slice, const SliceSample& sample)
{
    return glm::vec3(std::pow(std::clamp(std::abs(sample.distance), 0.0f, 1.0f), 1 / slice.gamma));
}

}  // namespace

std::span<const SliceStyleKind> slice_styles() { return styles; }

const std::vector<std::string>& slice_style_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const SliceStyleKind& style : styles) list.emplace_back(style.name);
        return list;
    }();
    return names;
}

std::optional<SliceStyle> slice_style_from_name(std::string_view name)
{
    auto found =
        std::find_if(std::begin(styles), std::end(styles), [&](const auto& style) { return style.name == name; });
    if (found == std::end(styles)) return std::nullopt;
    return static_cast<SliceStyle>(found - std::begin(styles));
}

Slice slice_of(const graph::SlicePlane& plane, float offset)
{
    return {.centre = offset * plane.normal(), .right = plane.right, .up = plane.up};
}

glm::vec3 slice_colour(const Slice& slice, const SliceSample& sample)
{
    float on_surface = surface_coverage(sample);
    switch (slice.style) {
        case SliceStyle::sign: return decoded(glm::mix(sign_colour(slice, sample), surface, on_surface));
        case SliceStyle::grey: return decoded(grey(slice, sample));
        case SliceStyle::contour: return decoded(glm::mix(ground, surface, on_surface));
        case SliceStyle::gradient: break;
    }
    glm::vec3 error = map_colour(slice.colour_map, std::abs(sample.slope - 1));
    return glm::mix(error, decoded(surface), on_surface);
}

}  // namespace fieldwright::renderer
