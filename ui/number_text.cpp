// Formatting and reading numbers.
#include "ui/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fieldwright::ui {
namespace {

struct UnitWord {
    std::string_view word, base;
    double size;  // in its base unit
};

constexpr UnitWord unit_words[] = {{"m", "m", 1},       {"mm", "m", 1e-3}, {"cm", "m", 1e-2},    {"km", "m", 1e3},
                                   {"s", "s", 1},       {"ms", "s", 1e-3}, {"deg", "deg", 1},    {"°", "deg", 1},
                                   {"°/m", "deg/m", 1}, {"%", "", 1e-2},   {"deg/m", "deg/m", 1}};

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

const UnitWord* find_unit(std::string_view word)
{
    for (const UnitWord& unit : unit_words)
        if (unit.word == word) return &unit;
    return nullptr;
}

// How many of `unit` one `word` is; nothing when the two measure different things.
std::optional<double> unit_factor(std::string_view word, std::string_view unit)
{
    if (word.empty() || word == unit) return 1;
    const UnitWord* typed = find_unit(word);
    const UnitWord* wanted = find_unit(unit);
    if (!typed || typed->base != (wanted ? wanted->base : unit)) return std::nullopt;
    return typed->size / (wanted ? wanted->size : 1);
}

// Reads a number off the front of `text`.
std::optional<double> take_number(std::string_view& text)
{
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    return number;
}

}  // namespace

std::string unit_suffix(std::string_view unit)
{
    if (unit.empty()) return {};
    if (unit == "deg") return "°";
    if (unit == "deg/m") return " °/m";
    return " " + std::string(unit);
}

std::string number_text(double value, int decimals)
{
    char text[48];
    for (int places = decimals;; ++places) {
        int length = std::snprintf(text, sizeof text, "%.*f", places, value);
        double error = std::abs(std::strtod(text, nullptr) - value);
        if (places >= 6 || error <= 2e-7 * std::abs(value)) {
            std::string_view shown(text, static_cast<std::size_t>(length));
            // "-0.00" is zero.
            if (shown.find_first_not_of("-0.") == std::string_view::npos && shown.starts_with('-'))
                shown.remove_prefix(1);
            return std::string(shown);
        }
    }
}

std::string grouped_text(std::int64_t number)
{
    std::string digits = std::to_string(number);
    auto first = number < 0 ? std::ptrdiff_t{1} : 0;
    for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > first; place -= 3)
        digits.insert(static_cast<std::size_t>(place), ",");
    return digits;
}

std::string rounded_text(double value)
{
    constexpr int digits = 3, most_places = 6;
    if (std::abs(value) >= 999.5) return grouped_text(std::llround(value));
    char text[48];
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);  // rounds: 9.996 has one place less than 9.99
    int exponent = std::atoi(std::strchr(text, 'e') + 1);
    if (value == 0 || exponent < -most_places) return "0";
    std::snprintf(text, sizeof text, "%.*f", std::clamp(digits - 1 - exponent, 0, most_places), value);
    return text;
}

std::string duration_text(double ms) { return ms < 999.5 ? rounded_text(ms) + " ms" : rounded_text(ms / 1000) + " s"; }

std::string percent_text(double share)
{
    constexpr double least = 0.01;  // percent
    double percent = 100 * share;
    return (percent > 0 && percent < least ? "< " + number_text(least, 2) : rounded_text(percent)) + " %";
}

std::string exact_text(double value)
{
    char text[32];
    auto [end, error] = std::to_chars(text, text + sizeof text, static_cast<float>(value));
    return error == std::errc() ? std::string(text, end) : std::string();
}

std::optional<double> parse_number(std::string_view text, std::string_view unit)
{
    std::string plain(text);
    if (auto comma = plain.find(','); comma != std::string::npos && plain.find('.') == std::string::npos)
        plain[comma] = '.';
    std::string_view rest = plain;
    std::optional<double> number = take_number(rest);
    if (!number) return std::nullopt;
    if (rest.starts_with('/')) {
        rest.remove_prefix(1);
        std::optional<double> divisor = take_number(rest);
        if (!divisor || *divisor == 0) return std::nullopt;
        *number /= *divisor;
    }
    std::optional<double> factor = unit_factor(rest, unit);
    if (!factor) return std::nullopt;
    return *number * *factor;
}

}  // namespace fieldwright::ui
