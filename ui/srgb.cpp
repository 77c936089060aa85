// The transfer function of sRGB (IEC 61966-2-1) and hex words.
#include "ui/srgb.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace fieldwright::ui {
namespace {

float encoded(float c) { return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f; }
float decoded(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

unsigned byte_of(float c) { return static_cast<unsigned>(std::lround(255.0f * std::clamp(c, 0.0f, 1.0f))); }

}  // namespace

glm::vec3 srgb_from_linear(glm::vec3 linear) { return {encoded(linear.x), encoded(linear.y), encoded(linear.z)}; }
glm::vec3 linear_from_srgb(glm::vec3 srgb) { return {decoded(srgb.x), decoded(srgb.y), decoded(srgb.z)}; }

std::string hex_text(glm::vec3 srgb)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte_of(srgb.x), byte_of(srgb.y), byte_of(srgb.z));
    return text;
}

std::optional<glm::vec3> parse_hex(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    if (text.starts_with('#')) text.remove_prefix(1);
    unsigned number = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (text.size() == 3) return glm::vec3(number >> 8 & 15u, number >> 4 & 15u, number & 15u) / 15.0f;
    if (text.size() != 6) return std::nullopt;
    return glm::vec3(number >> 16 & 255u, number >> 8 & 255u, number & 255u) / 255.0f;
}

}  // namespace fieldwright::ui
