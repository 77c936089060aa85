// Rows of one structure of the document's settings, from its table of ranges and words.
#pragma once

#include "graph/settings.h"
#include "ui/frame_context.h"
#include "ui/number_field.h"

#include <algorithm>

namespace fieldwright::ui {

// What the window says of a setting. Numbers: their unit, and the range of a drag.
struct SettingWords {
    std::string_view group, name, title, unit, help;
    double soft_minimum = 0, soft_maximum = 0;
    std::string_view at_zero = {};  // what 0 means, where that is not an amount
};
const SettingWords& setting_words(std::string_view group, std::string_view name);

// A row each; true when the value changed, and `step` says how.
bool number_setting(FrameContext& frame, const std::string& mark, const SettingWords& words, double& value,
                    double initial, NumberStyle style, std::string& step);
bool choice_setting(FrameContext& frame, const std::string& mark, const SettingWords& words,
                    std::span<const std::string_view> choices, std::size_t& chosen, std::string& step);
bool colour_setting(FrameContext& frame, const std::string& mark, const SettingWords& words, glm::vec3& colour,
                    std::string& step);

template <typename Settings>
class SettingRows {
public:
    // `group`: of the words. Widgets are marked `path`/`name`.
    SettingRows(FrameContext& frame, std::string path, std::string_view group,
                const graph::SettingTable<Settings>& table, const Settings& settings)
        : settings_(settings), table_(table), group_(group), frame_(frame), path_(std::move(path))
    {
    }

    // Draws the row of one setting.
    void row(std::string_view name)
    {
        const SettingWords& words = setting_words(group_, name);
        for (const auto& count : table_.counts)
            if (name == count.name) count_row(words, count);
        for (const auto& number : table_.numbers)
            if (name == number.name) number_row(words, number);
        for (const auto& choice : table_.choices)
            if (name == choice.name) choice_row(words, choice);
        for (const auto& colour : table_.colours)
            if (name == colour.name) colour_row(words, colour);
    }

    // Of a number that settings come to; `take` changes them to come to another one.
    template <typename Take>
    void derived_row(std::string_view name, double value, double initial, const NumberStyle& style, const Take& take)
    {
        const SettingWords& words = setting_words(group_, name);
        if (number_setting(frame_, mark(words), words, value, initial, style, step_)) take(settings_, value);
    }

    const Settings& settings() const { return settings_; }
    const std::string& step() const { return step_; }  // empty: nothing changed

private:
    void count_row(const SettingWords& words, const graph::SettingCount<Settings>& count)
    {
        double value = settings_.*count.member;
        if (number_setting(frame_, mark(words), words, value, Settings{}.*count.member,
                           {.minimum = double(count.minimum), .maximum = double(count.maximum), .whole = true}, step_))
            settings_.*count.member = static_cast<int>(value);
    }
    void number_row(const SettingWords& words, const graph::SettingNumber<Settings>& number)
    {
        double value = settings_.*number.member;
        if (number_setting(frame_, mark(words), words, value, Settings{}.*number.member,
                           {.minimum = number.minimum, .maximum = number.maximum}, step_))
            settings_.*number.member = std::clamp(static_cast<float>(value), number.minimum, number.maximum);
    }
    void choice_row(const SettingWords& words, const graph::SettingChoice<Settings>& choice)
    {
        std::size_t chosen = choice.chosen(settings_);
        if (choice_setting(frame_, mark(words), words, choice.words, chosen, step_)) choice.choose(settings_, chosen);
    }
    void colour_row(const SettingWords& words, const graph::SettingColour<Settings>& colour)
    {
        colour_setting(frame_, mark(words), words, settings_.*colour.member, step_);
    }

    std::string mark(const SettingWords& words) const { return path_ + "/" + std::string(words.name); }

    Settings settings_;
    const graph::SettingTable<Settings>& table_;
    std::string_view group_;
    FrameContext& frame_;
    std::string path_, step_;
};

}  // namespace fieldwright::ui
