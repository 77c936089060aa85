// Asking FreeType for the advances before hinting and rounding.
#include "ui/letter_spacing.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace fieldwright::ui {
namespace {

constexpr float smallest_crisp_px = 12;  // of smaller letters a pixel is too much to be out of place
constexpr ImWchar first_icon = 0xe000;   // Unicode's private use

bool is_digit(ImWchar letter) { return letter >= '0' && letter <= '9'; }

class FontFile {
public:
    explicit FontFile(std::span<const unsigned char> file)
    {
        FT_Library library = nullptr;
        FT_Init_FreeType(&library);
        library_.reset(library);
        FT_Face face = nullptr;
        FT_New_Memory_Face(library, file.data(), static_cast<FT_Long>(file.size()), 0, &face);
        face_.reset(face);
        assert(face);  // built into the program
    }

    // Of the height from ascender to descender, which is what Dear ImGui calls a font's size.
    float advance(ImWchar letter) const
    {
        if (FT_Load_Char(face_.get(), letter, FT_LOAD_NO_SCALE)) return 0;
        return static_cast<float>(face_->glyph->metrics.horiAdvance) /
               static_cast<float>(face_->ascender - face_->descender);
    }

    float widest_digit() const
    {
        float widest = 0;
        for (ImWchar digit = '0'; digit <= '9'; ++digit) widest = std::max(widest, advance(digit));
        return widest;
    }

private:
    struct Free {
        void operator()(FT_Library library) const { FT_Done_FreeType(library); }
        void operator()(FT_Face face) const { FT_Done_Face(face); }
    };
    std::unique_ptr<FT_LibraryRec_, Free> library_;
    std::unique_ptr<FT_FaceRec_, Free> face_;
};

}  // namespace

void space_letters(ImFont& font, std::span<const unsigned char> file)
{
    FontFile letters(file);
    bool whole = font.FontSize >= smallest_crisp_px;
    float digit_px = letters.widest_digit() * font.FontSize;
    if (whole) digit_px = std::round(digit_px);
    for (ImFontGlyph& glyph : font.Glyphs) {
        auto letter = static_cast<ImWchar>(glyph.Codepoint);
        float true_px = letters.advance(letter) * font.FontSize;
        if (letter >= first_icon || true_px <= 0) continue;
        glyph.AdvanceX = is_digit(letter) ? digit_px : whole ? std::round(true_px) : true_px;
        if (!is_digit(letter)) continue;
        // Numbers that change must not make their neighbours jump.
        float shift = std::round(0.5f * (digit_px - true_px));
        glyph.X0 += shift;
        glyph.X1 += shift;
    }
    font.BuildLookupTable();
}

}  // namespace fieldwright::ui
