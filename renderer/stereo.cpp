// The one list of stereo modes, and what they do to colours.
#include "renderer/stereo.h"

#include "renderer/srgb_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fieldwright::renderer {
namespace {

using field::row_width;
using Weights = std::array<float, 3>;

// What counts as brightness: of light (Rec.709), and of encoded values (Rec.601), for which these modes were published.
constexpr Weights light_weights = {0.2126f, 0.7152f, 0.0722f}, code_weights = {0.299f, 0.587f, 0.114f};
constexpr float fighting = 25;  // CIE lightness

constexpr EyeMix naive_mix = {{1, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1}};

// Least squares between what each eye should see and what the filters let through: E. Dubois, "A projection method to
// generate anaglyph stereo images", 2001, and his later matrices for other glasses.
constexpr EyeMix dubois_mix = {
    {0.456100f, 0.500484f, 0.176381f, -0.0400822f, -0.0378246f, -0.0157589f, -0.0152161f, -0.0205971f, -0.00546856f},
    {-0.0434706f, -0.0879388f, -0.00155529f, 0.378476f, 0.733640f, -0.0184503f, -0.0721527f, -0.112961f, 1.226400f}};
constexpr EyeMix green_magenta_mix = {{-0.062f, -0.158f, -0.039f, 0.284f, 0.668f, 0.143f, -0.015f, -0.027f, 0.021f},
                                      {0.529f, 0.705f, 0.024f, -0.016f, -0.015f, -0.065f, 0.009f, 0.075f, 0.937f}};
constexpr EyeMix amber_blue_mix = {{1.062f, -0.205f, 0.299f, -0.026f, 0.908f, 0.068f, -0.038f, -0.173f, 0.022f},
                                   {-0.016f, -0.123f, -0.017f, 0.006f, 0.062f, -0.017f, 0.094f, 0.185f, 0.911f}};

constexpr EyeMix half_colour_mix(const Weights& w)
{
    return {{w[0], w[1], w[2], 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1}};
}

constexpr EyeMix gray_mix(const Weights& w)
{
    return {{w[0], w[1], w[2], 0, 0, 0, 0, 0, 0}, {0, 0, 0, w[0], w[1], w[2], w[0], w[1], w[2]}};
}

// P. Wimmer: red is made of the left eye's green and blue, and brightened by a gamma of 1.5.
constexpr EyeMix optimised_mix = {{0, 0.7f, 0.3f, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1}, 1 / 1.5f};

constexpr unsigned red = 0xff0000, cyan = 0x00ffff, green = 0x00ff00, magenta = 0xff00ff, amber = 0xffff00,
                   blue = 0x0000ff;

constexpr StereoMode modes[] = {
    {"off", "No stereo", "One eye: an ordinary picture.", StereoLayout::one_eye},
    {"naive", "Plain red-cyan anaglyph",
     "Left eye in red, right eye in green and blue. Strong colours flicker between the eyes.", StereoLayout::mixed,
     naive_mix, naive_mix, red, cyan},
    {"dubois", "Dubois red-cyan anaglyph",
     "Colours mixed so that each filter passes as little as possible of the other eye's picture.", StereoLayout::mixed,
     dubois_mix, dubois_mix, red, cyan},
    {"dubois-green-magenta", "Dubois green-magenta anaglyph",
     "As Dubois' red-cyan, for glasses with a green and a magenta filter.", StereoLayout::mixed, green_magenta_mix,
     green_magenta_mix, green, magenta},
    {"dubois-amber-blue", "Dubois amber-blue anaglyph",
     "As Dubois' red-cyan, for glasses with an amber and a blue filter: truest in colour, dark on the right.",
     StereoLayout::mixed, amber_blue_mix, amber_blue_mix, amber, blue},
    {"half-colour", "Half-colour red-cyan anaglyph",
     "The left eye sees brightness only, so that reds do not flicker; colours are paler.", StereoLayout::mixed,
     half_colour_mix(light_weights), half_colour_mix(code_weights), red, cyan},
    {"gray", "Gray red-cyan anaglyph", "Both eyes see brightness only: no colours, and nothing that flickers.",
     StereoLayout::mixed, gray_mix(light_weights), gray_mix(code_weights), red, cyan},
    {"optimised", "Optimised red-cyan anaglyph",
     "Red comes from the left eye's green and blue, brightened: no flicker, and no reds.", StereoLayout::mixed,
     optimised_mix, optimised_mix, red, cyan},
    {"side-by-side", "Side by side", "Both pictures at full size, the left eye's on the left.", StereoLayout::beside},
    {"top-bottom", "One above the other", "Both pictures at full size, the left eye's on top.", StereoLayout::below},
    {"interlace", "Row by row", "Even rows for the left eye, odd ones for the right: for polarised screens.",
     StereoLayout::rows},
};

constexpr const char* space_names[] = {"linear", "gamma"};

void mix_channel(float* mixed, const float* left_row, const float* right_row, const Rows& left, const Rows& right,
                 float unit)
{
    const float *lr = left.lane(0), *lg = left.lane(1), *lb = left.lane(2);
    const float *rr = right.lane(0), *rg = right.lane(1), *rb = right.lane(2);
    for (int i = 0; i < row_width; ++i) {
        float sum = left_row[0] * lr[i] + left_row[1] * lg[i] + left_row[2] * lb[i] + right_row[0] * rr[i] +
                    right_row[1] * rg[i] + right_row[2] * rb[i];
        mixed[i] = std::min(std::max(sum, 0.0f), unit);
    }
}

// CIE L* of a luminance from 0 to 1.
float lightness(float y) { return y > 0.008856f ? 116 * std::cbrt(y) - 16 : 903.3f * y; }

float brightness_behind(unsigned glass, glm::vec3 light)
{
    float sum = 0, white = 0;
    for (int k = 0; k < 3; ++k) {
        float passed =
            static_cast<float>(glass >> (16 - 8 * k) & 255u) / 255 * light_weights[static_cast<std::size_t>(k)];
        sum += passed * light[k];
        white += passed;
    }
    return sum / white;
}

// Of a surface that both eyes see in the same colour, in light.
glm::vec3 mixed_colour(const EyeMix& mix, StereoSpace space, glm::vec3 colour)
{
    const SrgbTable& table = SrgbTable::shared();
    bool gamma = space == StereoSpace::gamma;
    for (int k = 0; gamma && k < 3; ++k) colour[k] = static_cast<float>(table.byte(colour[k])) / 255;
    glm::vec3 mixed(0);
    for (std::size_t i = 0; i < 9; ++i)
        mixed[static_cast<int>(i / 3)] += (mix.left[i] + mix.right[i]) * colour[static_cast<int>(i % 3)];
    mixed = glm::clamp(mixed, glm::vec3(0), glm::vec3(1));
    if (mix.red_power != 1) mixed.r = std::pow(mixed.r, mix.red_power);
    for (int k = 0; gamma && k < 3; ++k) mixed[k] = table.linear(static_cast<unsigned char>(255 * mixed[k] + 0.5f));
    return mixed;
}

}  // namespace

std::span<const StereoMode> stereo_modes() { return modes; }

const StereoMode& mode_of(Stereo stereo) { return modes[static_cast<std::size_t>(stereo)]; }

const EyeMix& mix_of(Stereo stereo, StereoSpace space)
{
    const StereoMode& mode = mode_of(stereo);
    return space == StereoSpace::linear ? mode.linear : mode.gamma;
}

std::optional<Stereo> stereo_from_name(std::string_view name)
{
    auto found = std::find_if(std::begin(modes), std::end(modes), [&](const StereoMode& m) { return m.name == name; });
    if (found == std::end(modes)) return std::nullopt;
    return static_cast<Stereo>(found - std::begin(modes));
}

const std::vector<std::string>& stereo_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const StereoMode& mode : modes) list.emplace_back(mode.name);
        return list;
    }();
    return names;
}

std::optional<StereoSpace> stereo_space_from_name(std::string_view name)
{
    auto found = std::find(std::begin(space_names), std::end(space_names), name);
    if (found == std::end(space_names)) return std::nullopt;
    return static_cast<StereoSpace>(found - std::begin(space_names));
}

const std::vector<std::string>& stereo_space_names()
{
    static const std::vector<std::string> names(std::begin(space_names), std::end(space_names));
    return names;
}

void mix_eyes(Rows& mixed, int count, const EyeMix& mix, const Rows& left, const Rows& right, float unit)
{
    for (std::size_t k = 0; k < 3; ++k)
        mix_channel(mixed.lane(static_cast<int>(k)), &mix.left[3 * k], &mix.right[3 * k], left, right, unit);
    if (mix.red_power == 1) return;
    for (int i = 0; i < count; ++i) mixed.lane(0)[i] = unit * std::pow(mixed.lane(0)[i] / unit, mix.red_power);
}

bool eyes_fight(Stereo stereo, StereoSpace space, glm::vec3 colour)
{
    const StereoMode& mode = mode_of(stereo);
    if (mode.layout != StereoLayout::mixed) return false;
    glm::vec3 seen = mixed_colour(mix_of(stereo, space), space, glm::clamp(colour, glm::vec3(0), glm::vec3(1)));
    float left = lightness(brightness_behind(mode.left_glass, seen)),
          right = lightness(brightness_behind(mode.right_glass, seen));
    return std::abs(left - right) > fighting;
}

}  // namespace fieldwright::renderer
