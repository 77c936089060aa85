#include "graph/settings_reader.h"

#include "graph/settings.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

// Reads the members of one structure by its table.
template <typename Settings>
class SettingsReader {
public:
    SettingsReader(const SceneJson& json, const SettingTable<Settings>& table) : json_(json), table_(table) {}

    void read(const JsonValue& object, Settings& settings) const
    {
        for (const JsonValue* member = json_.first_child(object); member; member = json_.next_sibling(*member))
            if (!read_member(*member, settings)) json_.unknown_member(*member, names());
        std::optional<SettingError> error = setting_error(settings);
        if (!error) return;
        const JsonValue* member = json_.member(object, error->name);
        if (member) json_.fail(*member, error->what);
        json_.fail(object, "`" + error->name + "` " + error->what);
    }

private:
    bool read_member(const JsonValue& member, Settings& settings) const
    {
        auto is_it = [&](const auto& setting) { return member.key == setting.name; };
        auto find = [&](const auto& list) { return std::find_if(list.begin(), list.end(), is_it); };
        auto count = find(table_.counts);
        auto number = find(table_.numbers);
        auto choice = find(table_.choices);
        auto colour = find(table_.colours);
        if (count != table_.counts.end()) settings.*count->member = json_.small_integer(member);
        else if (number != table_.numbers.end()) settings.*number->member = json_.number(member);
        else if (choice != table_.choices.end()) choice->choose(settings, word(member, choice->words));
        else if (colour != table_.colours.end()) settings.*colour->member = json_.triple(member);
        else return false;
        return true;
    }

    // Which of the words a value is.
    std::size_t word(const JsonValue& value, std::span<const std::string_view> words) const
    {
        auto found = std::find(words.begin(), words.end(), json_.string(value));
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
        std::string list;
        for (std::size_t i = 0; i < words.size(); ++i)
            list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + in_quotes(words[i]);
        json_.fail(value, "must be " + list);
    }

    std::string names() const
    {
        std::string list;
        auto add = [&](const auto& settings) {
            for (const auto& setting : settings) list += (list.empty() ? "`" : ", `") + std::string(setting.name) + "`";
        };
        add(table_.counts);
        add(table_.numbers);
        add(table_.choices);
        add(table_.colours);
        return list;
    }

    const SceneJson& json_;
    const SettingTable<Settings>& table_;
};

int bounces(const SceneJson& json, const JsonValue& value)
{
    int number = json.small_integer(value);
    if (auto error = bounces_error(number)) json.fail(value, error->what);
    return number;
}

}  // namespace

bool read_setting(const SceneJson& json, const JsonValue& member, Document& document)
{
    auto read = [&](const auto& table, auto& settings) {
        SettingsReader(json, table).read(json.object(member), settings);
    };
    if (member.key == "march") read(march_table, document.march);
    else if (member.key == "occlusion") read(occlusion_table, document.occlusion);
    else if (member.key == "fog") read(fog_table, document.fog);
    else if (member.key == "bounces") document.bounces = bounces(json, member);
    else if (member.key == "picture") read(picture_table, document.picture);
    else if (member.key == "animation") read(animation_table, document.animation);
    else return false;
    return true;
}

}  // namespace fieldwright::graph
