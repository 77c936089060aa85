// Letters drawn one after the other by FreeType.
#include "assets/lettering.h"

#include "graph/problem.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <memory>

namespace fieldwright::assets {
namespace {

struct Done {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using LibraryHandle = std::unique_ptr<std::remove_pointer_t<FT_Library>, Done>;
using FaceHandle = std::unique_ptr<std::remove_pointer_t<FT_Face>, Done>;

int whole_px(FT_Pos sixty_fourths) { return static_cast<int>((sixty_fourths + 32) >> 6); }

// The letter's pixels at a pen on the base line; what lies outside is cut off.
void put(Lettering& line, const FT_GlyphSlot glyph, int pen, int base)
{
    const FT_Bitmap& bitmap = glyph->bitmap;
    for (int y = 0; y < static_cast<int>(bitmap.rows); ++y)
        for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
            int to_x = pen + glyph->bitmap_left + x, to_y = base - glyph->bitmap_top + y;
            if (to_x < 0 || to_y < 0 || to_x >= line.width || to_y >= line.height) continue;
            unsigned char& pixel = line.coverage[static_cast<std::size_t>(to_y) * static_cast<std::size_t>(line.width) +
                                                 static_cast<std::size_t>(to_x)];
            pixel = std::max(pixel, bitmap.buffer[y * bitmap.pitch + x]);
        }
}

}  // namespace

Lettering lettering(std::string_view text, int size_px, std::span<const unsigned char> font)
{
    FT_Library opened = nullptr;
    FT_Face found = nullptr;
    if (FT_Init_FreeType(&opened)) throw graph::Failure(1, "letters cannot be drawn: FreeType does not start");
    LibraryHandle library(opened);
    if (FT_New_Memory_Face(opened, font.data(), static_cast<FT_Long>(font.size()), 0, &found))
        throw graph::Failure(1, "letters cannot be drawn: the built-in font does not open");
    FaceHandle face(found);
    FT_Set_Pixel_Sizes(found, 0, static_cast<FT_UInt>(size_px));
    auto load = [&](char letter) {
        return FT_Load_Char(found, static_cast<unsigned char>(letter), FT_LOAD_RENDER | FT_LOAD_NO_HINTING) == 0;
    };
    Lettering line;
    line.height = whole_px(found->size->metrics.ascender - found->size->metrics.descender);
    for (char letter : text)
        if (load(letter)) line.width += whole_px(found->glyph->advance.x);
    line.coverage.resize(static_cast<std::size_t>(line.width) * static_cast<std::size_t>(line.height));
    int pen = 0;
    for (char letter : text) {
        if (!load(letter)) continue;
        put(line, found->glyph, pen, whole_px(found->size->metrics.ascender));
        pen += whole_px(found->glyph->advance.x);
    }
    return line;
}

}  // namespace fieldwright::assets
