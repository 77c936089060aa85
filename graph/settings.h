// The document's settings: name, member and range or words of each, for files, edits, checks and rows alike.
#pragma once

#include "graph/document.h"

#include <array>
#include <optional>
#include <span>

namespace fieldwright::graph {

template <typename Settings>
struct SettingCount {
    const char* name;
    int Settings::*member;
    int minimum, maximum;  // inclusive
};

template <typename Settings>
struct SettingNumber {
    const char* name;
    float Settings::*member;
    float minimum, maximum;  // inclusive
};

// One of several words, in the order of the member's values: an enumeration, or false and true.
template <typename Settings>
struct SettingChoice {
    const char* name;
    std::span<const std::string_view> words;
    std::size_t (*chosen)(const Settings&);
    void (*choose)(Settings&, std::size_t);
};

template <auto member, typename Settings>
constexpr SettingChoice<Settings> setting_choice(const char* name, std::span<const std::string_view> words)
{
    return {name, words, [](const Settings& settings) { return static_cast<std::size_t>(settings.*member); },
            [](Settings& settings, std::size_t choice) {
                settings.*member = static_cast<std::remove_reference_t<decltype(settings.*member)>>(choice);
            }};
}

template <typename Settings>
struct SettingColour {
    const char* name;
    glm::vec3 Settings::*member;  // linear Rec.709
};
inline constexpr float setting_colour_maximum = 1000;

// All settings of one structure, in the order of files.
template <typename Settings>
struct SettingTable {
    std::span<const SettingCount<Settings>> counts;
    std::span<const SettingNumber<Settings>> numbers;
    std::span<const SettingChoice<Settings>> choices;
    std::span<const SettingColour<Settings>> colours;
};

// The words of files, in the order of the values.
inline constexpr std::array<std::string_view, 2> out_of_steps_names = {"miss", "hit"};
inline constexpr std::array<std::string_view, 2> march_method_names = {"sphere_tracing", "constant_steps"};
inline constexpr std::array<std::string_view, 2> step_scale_names = {"derived", "own"};
inline constexpr std::array<std::string_view, 2> normals_names = {"tetrahedron", "central"};
inline constexpr std::array<std::string_view, 2> anti_aliasing_names = {"none", "coverage"};
inline constexpr std::array<std::string_view, 2> occlusion_names = {"mean", "smallest_ratio"};
inline constexpr std::array<std::string_view, 4> tone_map_names = {"none", "neutral", "agx", "aces"};
inline constexpr std::array<std::string_view, 3> backdrop_names = {"sky", "colour", "transparent"};

inline constexpr std::array march_counts = {
    SettingCount<MarchSettings>{"step_limit", &MarchSettings::step_limit, 1, 60000},
};
inline constexpr std::array march_numbers = {
    SettingNumber<MarchSettings>{"minimum_step", &MarchSettings::minimum_step, 1e-6f, 1.0f},
    SettingNumber<MarchSettings>{"tolerance", &MarchSettings::tolerance, 1e-6f, 1.0f},
    SettingNumber<MarchSettings>{"near", &MarchSettings::near, 0.0f, 1e6f},
    SettingNumber<MarchSettings>{"far", &MarchSettings::far, 1e-3f, 1e6f},
    SettingNumber<MarchSettings>{"step_scale", &MarchSettings::step_scale, 0.01f, 4.0f},
    SettingNumber<MarchSettings>{"constant_step", &MarchSettings::constant_step, 1e-4f, 1e3f},
    SettingNumber<MarchSettings>{"normal_step", &MarchSettings::normal_step, 0.0f, 1.0f},
};
inline constexpr std::array march_choices = {
    setting_choice<&MarchSettings::out_of_steps_hits, MarchSettings>("out_of_steps", out_of_steps_names),
    setting_choice<&MarchSettings::constant_steps, MarchSettings>("method", march_method_names),
    setting_choice<&MarchSettings::own_step_scale, MarchSettings>("step_scale_from", step_scale_names),
    setting_choice<&MarchSettings::central_normals, MarchSettings>("normals", normals_names),
    setting_choice<&MarchSettings::coverage, MarchSettings>("anti_aliasing", anti_aliasing_names),
};
inline constexpr SettingTable<MarchSettings> march_table{march_counts, march_numbers, march_choices, {}};

inline constexpr std::array occlusion_counts = {
    SettingCount<OcclusionSettings>{"samples", &OcclusionSettings::samples, 1, 32},
};
inline constexpr std::array occlusion_numbers = {
    SettingNumber<OcclusionSettings>{"strength", &OcclusionSettings::strength, 0.0f, 1.0f},
    SettingNumber<OcclusionSettings>{"radius", &OcclusionSettings::radius, 1e-3f, 1e3f},
};
inline constexpr std::array occlusion_choices = {
    setting_choice<&OcclusionSettings::smallest_ratio, OcclusionSettings>("kind", occlusion_names),
};
inline constexpr SettingTable<OcclusionSettings> occlusion_table{
    occlusion_counts, occlusion_numbers, occlusion_choices, {}};

inline constexpr std::array fog_numbers = {
    SettingNumber<FogSettings>{"density", &FogSettings::density, 0.0f, 1e3f},
    SettingNumber<FogSettings>{"start", &FogSettings::start, 0.0f, 1e6f},
    SettingNumber<FogSettings>{"height_falloff", &FogSettings::height_falloff, 0.0f, 1e3f},
};
inline constexpr std::array fog_colours = {
    SettingColour<FogSettings>{"colour", &FogSettings::colour},
};
inline constexpr SettingTable<FogSettings> fog_table{{}, fog_numbers, {}, fog_colours};

inline constexpr int bounces_maximum = 8;
// Of new scenes: into a solid of glass, out of it, and on to a mirror. Costs nothing where nothing mirrors.
inline constexpr int bounces_of_new_scenes = 3;

inline constexpr int samples_maximum = 4096;
inline constexpr std::array picture_counts = {
    SettingCount<PictureSettings>{"samples", &PictureSettings::samples, 1, samples_maximum},
};
inline constexpr std::array picture_numbers = {
    SettingNumber<PictureSettings>{"shutter", &PictureSettings::shutter, 0.0f, 100.0f},
    SettingNumber<PictureSettings>{"exposure", &PictureSettings::exposure, -20.0f, 20.0f},
};
inline constexpr std::array picture_choices = {
    setting_choice<&PictureSettings::tone_map, PictureSettings>("tone_map", tone_map_names),
    setting_choice<&PictureSettings::backdrop, PictureSettings>("backdrop", backdrop_names),
};
inline constexpr std::array picture_colours = {
    SettingColour<PictureSettings>{"backdrop_colour", &PictureSettings::backdrop_colour},
};
inline constexpr SettingTable<PictureSettings> picture_table{picture_counts, picture_numbers, picture_choices,
                                                             picture_colours};

inline constexpr std::array animation_counts = {
    SettingCount<AnimationSettings>{"first_frame", &AnimationSettings::first_frame, -1'000'000, 1'000'000},
    SettingCount<AnimationSettings>{"last_frame", &AnimationSettings::last_frame, -1'000'000, 1'000'000},
};
inline constexpr std::array animation_numbers = {
    SettingNumber<AnimationSettings>{"frames_per_second", &AnimationSettings::frames_per_second, 0.1f, 1000.0f},
};
inline constexpr SettingTable<AnimationSettings> animation_table{animation_counts, animation_numbers, {}, {}};

// A setting that breaks its rule: `what` ends the sentence that `name` begins.
struct SettingError {
    std::string name;
    std::string what;
};
std::optional<SettingError> setting_error(const MarchSettings& settings);
std::optional<SettingError> setting_error(const OcclusionSettings& settings);
std::optional<SettingError> setting_error(const FogSettings& settings);
std::optional<SettingError> bounces_error(int bounces);
std::optional<SettingError> setting_error(const PictureSettings& settings);
std::optional<SettingError> setting_error(const AnimationSettings& settings);
// The same as a sentence without its full stop, or nothing.
std::optional<std::string> setting_refusal(const std::optional<SettingError>& error);

// The moment that a frame shows, in seconds.
inline float time_of_frame(const AnimationSettings& animation, int frame)
{
    return static_cast<float>((frame - 1) / static_cast<double>(animation.frames_per_second));
}

}  // namespace fieldwright::graph
