// Small parsers of ranges, names and tiles.
#include "app/frame_numbers.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>

namespace fieldwright::app {
namespace {

constexpr std::size_t frames_limit = 1'000'000;

// Takes a whole number, or a word, off the front; whether it was there.
bool take(std::string_view& text, int& number)
{
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

bool take(std::string_view& text, std::string_view word)
{
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

struct Range {
    int first = 0, last = 0, step = 1;
};

std::optional<Range> take_range(std::string_view& text)
{
    Range range;
    if (!take(text, range.first)) return std::nullopt;
    range.last = range.first;
    if (!take(text, "..") && !take(text, "-")) return range;
    if (!take(text, range.last) || range.last < range.first) return std::nullopt;
    if (take(text, "x") && (!take(text, range.step) || range.step < 1)) return std::nullopt;
    return range;
}

}  // namespace

std::optional<std::vector<int>> frames_from_text(std::string_view text)
{
    std::vector<int> frames;
    do {
        std::optional<Range> range = take_range(text);
        if (!range) return std::nullopt;
        for (std::int64_t frame = range->first; frame <= range->last; frame += range->step) {
            if (frames.size() == frames_limit) return std::nullopt;
            frames.push_back(static_cast<int>(frame));
        }
    } while (take(text, ","));
    return text.empty() ? std::optional(frames) : std::nullopt;
}

bool has_number_place(const std::string& name) { return name.find('#') != std::string::npos; }

std::string numbered(const std::string& name, int frame)
{
    std::size_t last = name.rfind('#');
    if (last == std::string::npos) return name;
    std::size_t before = name.find_last_not_of('#', last), first = before == std::string::npos ? 0 : before + 1;
    char number[32];
    std::snprintf(number, sizeof number, "%0*d", static_cast<int>(std::min<std::size_t>(last - first + 1, 16)), frame);
    return name.substr(0, first) + number + name.substr(last + 1);
}

std::optional<renderer::Area> tile_from_text(std::string_view text, int width, int height)
{
    int a = 0, b = 0, c = 0, d = 0;
    std::string_view rest = text;
    if (take(rest, a) && take(rest, "/") && take(rest, b) && rest.empty()) {
        if (a < 1 || a > b || b > height) return std::nullopt;
        auto edge = [&](int n) { return static_cast<int>(std::int64_t{height} * n / b); };
        return renderer::Area{0, edge(a - 1), width, edge(a) - edge(a - 1)};
    }
    rest = text;
    bool reads = take(rest, a) && take(rest, ",") && take(rest, b) && take(rest, ",") && take(rest, c) &&
                 take(rest, ",") && take(rest, d) && rest.empty();
    bool inside =
        a >= 0 && b >= 0 && c >= 1 && d >= 1 && c <= width && d <= height && a <= width - c && b <= height - d;
    return reads && inside ? std::optional(renderer::Area{a, b, c, d}) : std::nullopt;
}

}  // namespace fieldwright::app
