// Range checks of march and occlusion settings.
#include "graph/settings.h"

#include "graph/json.h"

namespace fieldwright::graph {
namespace {

template <typename Settings, typename Numbers>
std::optional<SettingError> number_error(const Settings& settings, const Numbers& numbers)
{
    for (const SettingNumber<Settings>& number : numbers) {
        float value = settings.*number.member;
        if (value >= number.minimum && value <= number.maximum) continue;
        std::string what = "must lie between ";
        append_json_number(what, number.minimum, false);
        what += " and ";
        append_json_number(what, number.maximum, false);
        return SettingError{number.name, what};
    }
    return std::nullopt;
}

}  // namespace

std::optional<SettingError> setting_error(const MarchSettings& settings)
{
    if (settings.step_limit < 1 || settings.step_limit > step_limit_maximum)
        return SettingError{"step_limit", "must lie between 1 and " + std::to_string(step_limit_maximum)};
    if (auto error = number_error(settings, march_numbers)) return error;
    if (settings.near >= settings.far) return SettingError{"near", "must be smaller than far"};
    return std::nullopt;
}

std::optional<SettingError> setting_error(const OcclusionSettings& settings)
{
    return number_error(settings, occlusion_numbers);
}

}  // namespace fieldwright::graph
