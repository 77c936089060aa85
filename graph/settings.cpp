// Range checks of settings.
#include "graph/settings.h"

#include "graph/json.h"
#include "graph/words.h"

namespace fieldwright::graph {
namespace {

template <typename Number>
bool within(Number value, Number minimum, Number maximum)
{
    return value >= minimum && value <= maximum;  // no number is not within
}

std::string range(float minimum, float maximum)
{
    std::string what = "must lie between ";
    append_json_number(what, minimum, false);
    what += " and ";
    append_json_number(what, maximum, false);
    return what;
}

template <typename Settings>
std::optional<SettingError> range_error(const Settings& settings, const SettingTable<Settings>& table)
{
    for (const auto& count : table.counts)
        if (!within(settings.*count.member, count.minimum, count.maximum))
            return SettingError{count.name, "must lie between " + std::to_string(count.minimum) + " and " +
                                                std::to_string(count.maximum)};
    for (const auto& number : table.numbers)
        if (!within(settings.*number.member, number.minimum, number.maximum))
            return SettingError{number.name, range(number.minimum, number.maximum)};
    for (const auto& colour : table.colours)
        for (int k = 0; k < 3; ++k)
            if (!within((settings.*colour.member)[k], 0.0f, setting_colour_maximum))
                return SettingError{colour.name, range(0, setting_colour_maximum)};
    return std::nullopt;
}

}  // namespace

std::optional<SettingError> setting_error(const MarchSettings& settings)
{
    if (auto error = range_error(settings, march_table)) return error;
    if (settings.near >= settings.far) return SettingError{"near", "must be smaller than far"};
    return std::nullopt;
}

std::optional<SettingError> setting_error(const OcclusionSettings& settings)
{
    return range_error(settings, occlusion_table);
}

std::optional<SettingError> setting_error(const FogSettings& settings) { return range_error(settings, fog_table); }

std::optional<SettingError> bounces_error(int bounces)
{
    if (within(bounces, 0, bounces_maximum)) return std::nullopt;
    return SettingError{"bounces", "must lie between 0 and " + std::to_string(bounces_maximum)};
}

std::optional<SettingError> setting_error(const PictureSettings& settings)
{
    return range_error(settings, picture_table);
}

std::optional<SettingError> setting_error(const AnimationSettings& settings)
{
    if (auto error = range_error(settings, animation_table)) return error;
    if (settings.first_frame > settings.last_frame)
        return SettingError{"first_frame", "must not come after the last frame"};
    return std::nullopt;
}

std::optional<std::string> setting_refusal(const std::optional<SettingError>& error)
{
    if (!error) return std::nullopt;
    return titled(in_words(error->name)) + " " + error->what;
}

}  // namespace fieldwright::graph
