// What goes to the worker that reads pictures and what comes back, as bytes.
#pragma once

#include "assets/picture_file.h"

#include <optional>
#include <utility>

namespace fieldwright::assets {

std::string text_from(const PictureQuestion& question, const std::string& bytes);
std::pair<PictureQuestion, std::string> question_from(const std::string& text);  // graph::Failure

std::string text_from(const Pixels& pixels);
std::optional<Pixels> pixels_from(const std::string& text);  // nothing unless it is exactly one picture

}  // namespace fieldwright::assets
