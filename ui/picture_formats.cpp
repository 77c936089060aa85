// Names of picture files and their ends.
#include "ui/picture_formats.h"

#include "ui/choice_field.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace fieldwright::ui {
namespace {

std::string end_of(std::string_view name) { return std::filesystem::path(name).extension().string(); }

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

}  // namespace

std::span<const PictureFormat> picture_formats()
{
    static const std::array formats = {
        PictureFormat{"PNG", "What is shown, without loss; transparent where the scene's backdrop is.", {".png"}},
        PictureFormat{"JPEG", "What is shown, in a small file.", {".jpg", ".jpeg"}},
        PictureFormat{"HDR", "The light itself, before exposure and tone map.", {".hdr"}},
        PictureFormat{"EXR", "The light itself, and every other view as a layer.", {".exr"}},
    };
    return formats;
}

const PictureFormat* picture_format_of(std::string_view name)
{
    std::string end = lower(end_of(name));
    for (const PictureFormat& format : picture_formats())
        if (std::find(format.suffixes.begin(), format.suffixes.end(), end) != format.suffixes.end()) return &format;
    return nullptr;
}

std::string complete_picture_name(std::string name)
{
    return end_of(name).empty() ? name + std::string(picture_formats()[0].suffixes[0]) : name;
}

std::string picture_name_error(std::string_view name)
{
    if (picture_format_of(name)) return {};
    std::span<const PictureFormat> formats = picture_formats();
    std::string ends;
    for (const PictureFormat& format : formats)
        ends += (&format == &formats.front()  ? ""
                 : &format == &formats.back() ? " or "
                                              : ", ") +
                std::string(format.suffixes[0]);
    return "No picture format ends in " + end_of(name) + ": end the name in " + ends;
}

bool picture_format_field(FrameContext& frame, std::string_view path, std::string& name)
{
    std::span<const PictureFormat> formats = picture_formats();
    const PictureFormat* shown = picture_format_of(complete_picture_name(name));
    auto label = [&](std::size_t i) { return std::pair(lower(formats[i].title), std::string(formats[i].title)); };
    auto picked = choice_list(frame, path, ImGui::GetContentRegionAvail().x, shown ? shown->title : "Format",
                              formats.size(), label);
    if (!picked && shown && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", shown->help);
    if (!picked) return false;
    name = std::filesystem::path(name).replace_extension(formats[*picked].suffixes[0]).string();
    return true;
}

}  // namespace fieldwright::ui
