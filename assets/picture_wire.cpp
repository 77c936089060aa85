// Two integers and the rest, both ways.
#include "assets/picture_wire.h"

#include "graph/problem.h"

#include <cstring>

namespace fieldwright::assets {
namespace {

struct Head {
    std::int32_t first = 0, second = 0;
};

std::string headed(const Head& head, const void* rest, std::size_t size)
{
    std::string text(sizeof head + size, '\0');
    std::memcpy(text.data(), &head, sizeof head);
    if (size > 0) std::memcpy(text.data() + sizeof head, rest, size);
    return text;
}

std::optional<Head> head_of(const std::string& text)
{
    Head head;
    if (text.size() < sizeof head) return std::nullopt;
    std::memcpy(&head, text.data(), sizeof head);
    return head;
}

}  // namespace

std::string text_from(const PictureQuestion& question, const std::string& bytes)
{
    return headed({question.scale == PixelScale::light ? 1 : 0, question.long_side}, bytes.data(), bytes.size());
}

std::pair<PictureQuestion, std::string> question_from(const std::string& text)
{
    std::optional<Head> head = head_of(text);
    if (!head) throw graph::Failure(1, "cannot be read (the worker was asked nothing)");
    return {{head->first == 1 ? PixelScale::light : PixelScale::shown, head->second}, text.substr(sizeof(Head))};
}

std::string text_from(const Pixels& pixels)
{
    return headed({pixels.width, pixels.height}, pixels.rgba.data(), pixels.rgba.size() * sizeof(float));
}

std::optional<Pixels> pixels_from(const std::string& text)
{
    std::optional<Head> head = head_of(text);
    if (!head || head->first < 1 || head->second < 1 || head->first > picture_side_limit ||
        head->second > picture_side_limit)
        return std::nullopt;
    Pixels pixels{head->first, head->second, {}};
    std::size_t count = 4 * static_cast<std::size_t>(head->first) * static_cast<std::size_t>(head->second);
    if (text.size() != sizeof(Head) + count * sizeof(float)) return std::nullopt;
    pixels.rgba.resize(count);
    std::memcpy(pixels.rgba.data(), text.data() + sizeof(Head), count * sizeof(float));
    return pixels;
}

}  // namespace fieldwright::assets
