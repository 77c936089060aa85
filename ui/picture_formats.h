// The formats that pictures are saved in, by the ends of file names.
#pragma once

#include "ui/frame_context.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::ui {

struct PictureFormat {
    const char *title, *help;
    std::vector<std::string_view> suffixes;  // the usual one first
};

std::span<const PictureFormat> picture_formats();
// By the end of a file's name, in capitals or not; null for others.
const PictureFormat* picture_format_of(std::string_view name);
// With the first format's end where the name has none.
std::string complete_picture_name(std::string name);
// Why no picture can be saved under that name, as a sentence; empty when it can.
std::string picture_name_error(std::string_view name);

// A list that gives `name` another format's end; its width is that of the room left. True when one was chosen.
bool picture_format_field(FrameContext& frame, std::string_view path, std::string& name);

}  // namespace fieldwright::ui
