// The numbers of the march and occlusion settings: name, member and range, for files, edits and checks alike.
#pragma once

#include "graph/document.h"

#include <array>
#include <optional>

namespace fieldwright::graph {

template <typename Settings>
struct SettingNumber {
    const char* name;
    float Settings::*member;
    float minimum, maximum;  // inclusive
};

inline constexpr std::array march_numbers = {
    SettingNumber<MarchSettings>{"minimum_step", &MarchSettings::minimum_step, 1e-6f, 1.0f},
    SettingNumber<MarchSettings>{"tolerance", &MarchSettings::tolerance, 1e-6f, 1.0f},
    SettingNumber<MarchSettings>{"near", &MarchSettings::near, 0.0f, 1e6f},
    SettingNumber<MarchSettings>{"far", &MarchSettings::far, 1e-3f, 1e6f},
};
inline constexpr std::array occlusion_numbers = {
    SettingNumber<OcclusionSettings>{"strength", &OcclusionSettings::strength, 0.0f, 1.0f},
    SettingNumber<OcclusionSettings>{"radius", &OcclusionSettings::radius, 1e-3f, 1e3f},
};
inline constexpr int step_limit_maximum = 60000;

// A setting that breaks its rule: `what` ends the sentence that `name` begins.
struct SettingError {
    std::string name;
    std::string what;
};
std::optional<SettingError> setting_error(const MarchSettings& settings);
std::optional<SettingError> setting_error(const OcclusionSettings& settings);

}  // namespace fieldwright::graph
