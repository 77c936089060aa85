// A font, wherever it comes from: an installed family, a file, or the one built into the program.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace fieldwright::assets {

struct FontFile {
    std::vector<unsigned char> bytes;
    int face = 0;  // of several in one file

    // Nothing, or why there are no bytes: the end of a sentence that begins with "the font `Foo`".
    std::string error;
};

// `font` is a family as Fontconfig knows it, or the path of a file: what holds a / or ends in .ttf, .otf or .ttc.
FontFile find_font(const std::string& font);

// The families of scalable fonts that Fontconfig knows, by name, each once. May take a tenth of a second.
std::vector<std::string> installed_families();

}  // namespace fieldwright::assets
