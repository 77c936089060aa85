// The example scenes and their pictures, built into the program.
#pragma once

#include <span>
#include <string_view>

namespace fieldwright::app {

struct ExampleFile {
    std::string_view name;                   // "smooth_blends"
    std::string_view text;                   // its scene file
    std::span<const unsigned char> picture;  // JPEG
};
std::span<const ExampleFile> example_files();  // by name

}  // namespace fieldwright::app
