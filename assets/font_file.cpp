// Finding fonts by Fontconfig and reading them.
#include "assets/font_file.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

namespace fieldwright::assets {
namespace {

constexpr std::uintmax_t size_limit = 64 << 20;  // bytes

struct FoundFile {
    std::filesystem::path path;
    int face = 0;
};

bool is_path(const std::string& font)
{
    return font.find('/') != std::string::npos || font.ends_with(".ttf") || font.ends_with(".otf") ||
           font.ends_with(".ttc");
}

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

struct Destroy {
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
    void operator()(FcConfig* config) const { FcConfigDestroy(config); }
    void operator()(FcObjectSet* names) const { FcObjectSetDestroy(names); }
    void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};
using Pattern = std::unique_ptr<FcPattern, Destroy>;

// Fontconfig always finds something; it is meant only when one of its names is the one asked for.
bool is_named(FcPattern& pattern, const std::string& name)
{
    for (const char* kind : {FC_FAMILY, FC_FULLNAME}) {
        FcChar8* found = nullptr;
        for (int i = 0; FcPatternGetString(&pattern, kind, i, &found) == FcResultMatch; ++i)
            if (lower(reinterpret_cast<const char*>(found)) == lower(name)) return true;
    }
    return false;
}

// "Inter", or a whole name such as "Inter Semi Bold".
FoundFile installed(const std::string& name)
{
    std::unique_ptr<FcConfig, Destroy> config(FcInitLoadConfigAndFonts());
    for (const char* kind : {FC_FAMILY, FC_FULLNAME}) {
        Pattern wanted(FcPatternCreate());
        FcPatternAddString(wanted.get(), kind, reinterpret_cast<const FcChar8*>(name.c_str()));
        FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
        FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
        FcDefaultSubstitute(wanted.get());
        FcResult result = FcResultNoMatch;
        Pattern found(FcFontMatch(config.get(), wanted.get(), &result));
        FcChar8* file = nullptr;
        if (!found || !is_named(*found, name) || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
            continue;
        FoundFile font{reinterpret_cast<const char*>(file)};
        FcPatternGetInteger(found.get(), FC_INDEX, 0, &font.face);
        return font;
    }
    return {};
}

}  // namespace

std::vector<std::string> installed_families()
{
    std::unique_ptr<FcConfig, Destroy> config(FcInitLoadConfigAndFonts());
    Pattern scalable(FcPatternCreate());
    FcPatternAddBool(scalable.get(), FC_SCALABLE, FcTrue);
    std::unique_ptr<FcObjectSet, Destroy> names(FcObjectSetBuild(FC_FAMILY, nullptr));
    std::unique_ptr<FcFontSet, Destroy> fonts(FcFontList(config.get(), scalable.get(), names.get()));
    std::vector<std::string> families;
    for (int i = 0; fonts && i < fonts->nfont; ++i) {
        FcChar8* family = nullptr;
        if (FcPatternGetString(fonts->fonts[i], FC_FAMILY, 0, &family) == FcResultMatch)
            families.emplace_back(reinterpret_cast<const char*>(family));
    }
    std::sort(families.begin(), families.end());
    families.erase(std::unique(families.begin(), families.end()), families.end());
    return families;
}

FontFile find_font(const std::string& font)
{
    FoundFile found = is_path(font) ? FoundFile{font} : installed(font);
    FontFile result;
    result.face = found.face & 0xffff;  // the upper half names an instance of a variable font
    if (found.path.empty()) {
        result.error = "is not installed";
        return result;
    }
    std::error_code error;
    std::uintmax_t size = std::filesystem::file_size(found.path, error);
    std::ifstream file(found.path, std::ios::binary);
    if (error || size == 0 || size > size_limit || !file) {
        result.error = error ? "is not there" : "cannot be read";
        return result;
    }
    result.bytes.resize(static_cast<std::size_t>(size));
    file.read(reinterpret_cast<char*>(result.bytes.data()), static_cast<std::streamsize>(size));
    if (!file) result.error = "cannot be read";
    return result;
}

}  // namespace fieldwright::assets
