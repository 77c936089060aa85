// Parameter values from words, and their checks.
#include "graph/json.h"
#include "graph/library.h"
#include "graph/limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace fieldwright::graph {
namespace {

// Walks a text of numbers, commas and brackets.
class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    bool skip(char c)
    {
        space();
        if (text_.empty() || text_.front() != c) return false;
        text_.remove_prefix(1);
        return true;
    }

    std::optional<float> number()
    {
        space();
        if (text_.starts_with("+")) text_.remove_prefix(1);
        float value = 0;
        auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
        return value;
    }

    bool at_end()
    {
        space();
        return text_.empty();
    }

private:
    void space()
    {
        while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\t')) text_.remove_prefix(1);
    }

    std::string_view text_;
};

// `1, 2, 3` or `(1, 2, 3)`: 1 to 4 numbers.
std::optional<std::vector<float>> numbers(Reader& reader)
{
    bool bracket = reader.skip('(');
    std::vector<float> result;
    do {
        std::optional<float> number = reader.number();
        if (!number) return std::nullopt;
        result.push_back(*number);
    } while (result.size() < 4 && reader.skip(','));
    if (bracket && !reader.skip(')')) return std::nullopt;
    return result;
}

float linear_from_srgb(int byte)
{
    float v = static_cast<float>(byte) / 255.0f;
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

std::optional<Value> colour(std::string_view text)
{
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    unsigned rgb = 0;
    auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
    if (error != std::errc() || end != text.data() + 7) return std::nullopt;
    return glm::vec3(linear_from_srgb(static_cast<int>(rgb >> 16)), linear_from_srgb(static_cast<int>(rgb >> 8 & 255)),
                     linear_from_srgb(static_cast<int>(rgb & 255)));
}

std::optional<Value> point_list(std::string_view text)
{
    Reader reader(text);
    PointList points;
    if (!reader.skip('[')) return std::nullopt;
    if (reader.skip(']')) return points;
    do {
        auto point = numbers(reader);
        if (!point) return std::nullopt;
        point->resize(4, 0.0f);
        points.emplace_back((*point)[0], (*point)[1], (*point)[2], (*point)[3]);
    } while (reader.skip(','));
    if (!reader.skip(']') || !reader.at_end()) return std::nullopt;
    return points;
}

std::optional<Value> vector_value(std::string_view text, std::size_t size)
{
    Reader reader(text);
    auto parts = numbers(reader);
    if (!parts || !reader.at_end()) return std::nullopt;
    if (parts->size() == 1) parts->resize(size, parts->front());
    if (parts->size() != size) return std::nullopt;
    if (size == 1) return (*parts)[0];
    if (size == 2) return glm::vec2((*parts)[0], (*parts)[1]);
    return glm::vec3((*parts)[0], (*parts)[1], (*parts)[2]);
}

std::optional<Value> integer_value(std::string_view text)
{
    int value = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string short_number(double number)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", number);
    return buffer;
}

std::string range_error(const Parameter& parameter, double number)
{
    if (!std::isfinite(number)) return "must be a finite number";
    if (number >= parameter.minimum && number <= parameter.maximum) return {};
    // Ranges are written in decimal: a float a rounding away from the end is inside.
    if (static_cast<float>(number) >= static_cast<float>(parameter.minimum) &&
        static_cast<float>(number) <= static_cast<float>(parameter.maximum))
        return {};
    return "must lie between " + short_number(parameter.minimum) + " and " + short_number(parameter.maximum) +
           (parameter.unit.empty() ? "" : " " + parameter.unit);
}

template <typename Vector>
std::string components_error(const Parameter& parameter, const Vector& vector, int count)
{
    for (int i = 0; i < count; ++i)
        if (std::string error = range_error(parameter, vector[i]); !error.empty()) return error;
    return {};
}

std::string text_error(const std::string& text)
{
    if (text.size() > text_limit) return "must have at most 4096 bytes";
    if (!is_utf8(text)) return "must be UTF-8 text";
    auto unprintable = [](char c) { return (c >= 0 && c < ' ' && c != '\n' && c != '\t') || c == '\x7f'; };
    if (std::any_of(text.begin(), text.end(), unprintable)) return "must not hold control characters";
    return {};
}

template <typename T>
const T* of_kind(const Value& value)
{
    return std::get_if<T>(&value);
}

}  // namespace

std::optional<Value> parse_value(const Parameter& parameter, std::string_view text)
{
    switch (parameter.kind) {
        case ParameterKind::number:
        case ParameterKind::angle: return vector_value(text, 1);
        case ParameterKind::vec2: return vector_value(text, 2);
        case ParameterKind::vec3:
        case ParameterKind::angles: return vector_value(text, 3);
        case ParameterKind::colour: return text.starts_with("#") ? colour(text) : vector_value(text, 3);
        case ParameterKind::integer: return integer_value(text);
        case ParameterKind::boolean:
            if (text == "true" || text == "false") return text == "true";
            return std::nullopt;
        case ParameterKind::choice:
        case ParameterKind::text:
        case ParameterKind::formula:
        case ParameterKind::image: return std::string(text);
        case ParameterKind::list: return point_list(text);
        case ParameterKind::material: break;
    }
    return std::nullopt;
}

std::string value_error(const Parameter& parameter, const Value& value)
{
    switch (parameter.kind) {
        case ParameterKind::number:
        case ParameterKind::angle:
            if (auto* number = of_kind<float>(value)) return range_error(parameter, *number);
            return "must be a number";
        case ParameterKind::integer:
            if (auto* number = of_kind<int>(value)) return range_error(parameter, *number);
            return "must be a whole number";
        case ParameterKind::boolean: return of_kind<bool>(value) ? "" : "must be true or false";
        case ParameterKind::vec2:
            if (auto* vector = of_kind<glm::vec2>(value)) return components_error(parameter, *vector, 2);
            return "must be two numbers";
        case ParameterKind::vec3:
        case ParameterKind::angles:
        case ParameterKind::colour:
            if (auto* vector = of_kind<glm::vec3>(value)) return components_error(parameter, *vector, 3);
            return "must be three numbers";
        case ParameterKind::choice: {
            auto* word = of_kind<std::string>(value);
            if (word && std::find(parameter.choices.begin(), parameter.choices.end(), *word) != parameter.choices.end())
                return {};
            std::string words;
            for (const std::string& choice : parameter.choices) words += (words.empty() ? "" : ", ") + choice;
            return "must be one of: " + words;
        }
        case ParameterKind::list: {
            auto* points = of_kind<PointList>(value);
            if (!points) return "must be a list of points";
            if (points->size() > 4096) return "must have at most 4096 points";
            for (const glm::vec4& point : *points)
                if (std::string error = components_error(parameter, point, 4); !error.empty()) return error;
            return {};
        }
        case ParameterKind::text:
        case ParameterKind::formula:
            if (auto* text = of_kind<std::string>(value)) return text_error(*text);
            return "must be text in quotes";
        case ParameterKind::image:
            if (auto* path = of_kind<std::string>(value)) return text_error(*path);
            return "must be a file's path in quotes";
        case ParameterKind::material: break;
    }
    return "is a socket and has no value";
}

}  // namespace fieldwright::graph
