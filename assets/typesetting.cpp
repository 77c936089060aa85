// HarfBuzz says which glyph stands where, FreeType how it looks.
#include "assets/typesetting.h"

#include "graph/problem.h"

#include <hb-ot.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

#include <cmath>
#include <memory>

namespace fieldwright::assets {
namespace {

using glm::dvec2;

struct Destroy {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
template <typename T>
using Owned = std::unique_ptr<T, Destroy>;

// Follows the outline FreeType tells of.
struct Pen {
    double units, tolerance;  // font units per em; em
    dvec2 origin;             // em
    std::vector<Contour>& contours;

    dvec2 place(const FT_Vector* v) const
    {
        return origin + dvec2(static_cast<double>(v->x), static_cast<double>(v->y)) / units;
    }
    dvec2 last() const { return contours.back().back(); }

    // `bend` bounds the second derivative: a chord over 1/n of the curve leaves it by at most bend / (8 n^2).
    template <typename Curve>
    void follow(double bend, const Curve& curve)
    {
        int steps = std::max(1, static_cast<int>(std::ceil(std::sqrt(bend / (8 * tolerance)))));
        for (int i = 1; i <= steps; ++i) contours.back().push_back(curve(static_cast<double>(i) / steps));
    }
};

int move_to(const FT_Vector* to, void* user)
{
    Pen& pen = *static_cast<Pen*>(user);
    pen.contours.push_back({pen.place(to)});
    return 0;
}

int line_to(const FT_Vector* to, void* user)
{
    Pen& pen = *static_cast<Pen*>(user);
    pen.contours.back().push_back(pen.place(to));
    return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user)
{
    Pen& pen = *static_cast<Pen*>(user);
    dvec2 a = pen.last(), b = pen.place(control), c = pen.place(to);
    pen.follow(2 * glm::length(a - 2.0 * b + c),
               [&](double t) { return glm::mix(glm::mix(a, b, t), glm::mix(b, c, t), t); });
    return 0;
}

int cubic_to(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user)
{
    Pen& pen = *static_cast<Pen*>(user);
    dvec2 a = pen.last(), b = pen.place(first), c = pen.place(second), d = pen.place(to);
    double bend = 6 * std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d));
    pen.follow(bend, [&](double t) {
        dvec2 ab = glm::mix(a, b, t), bc = glm::mix(b, c, t), cd = glm::mix(c, d, t);
        return glm::mix(glm::mix(ab, bc, t), glm::mix(bc, cd, t), t);
    });
    return 0;
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines(1);
    for (char c : text) {
        if (c == '\n') lines.emplace_back();
        else if (c == '\t') lines.back() += "    ";
        else lines.back() += c;
    }
    return lines;
}

}  // namespace

struct Typesetter::Handles {
    Owned<std::remove_pointer_t<FT_Library>> library;
    Owned<std::remove_pointer_t<FT_Face>> face;
    Owned<hb_font_t> font;
};

// Glyphs and where they begin, in em from the line's origin.
struct Typesetter::Line {
    struct Glyph {
        FT_UInt index;
        dvec2 at;
    };
    std::vector<Glyph> glyphs;
    double width = 0;
};

Typesetter::Typesetter(std::span<const unsigned char> bytes, int face) : handles_(std::make_unique<Handles>())
{
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library)) throw graph::Failure(1, "FreeType does not start");
    handles_->library.reset(library);
    FT_Face opened = nullptr;
    if (FT_New_Memory_Face(library, bytes.data(), static_cast<FT_Long>(bytes.size()), face, &opened))
        throw graph::Failure(1, "is no font that can be read");
    handles_->face.reset(opened);
    if (!FT_IS_SCALABLE(opened) || opened->units_per_EM == 0) throw graph::Failure(1, "holds pixels, not outlines");
    units_ = opened->units_per_EM;
    Owned<hb_blob_t> blob(hb_blob_create(reinterpret_cast<const char*>(bytes.data()),
                                         static_cast<unsigned>(bytes.size()), HB_MEMORY_MODE_READONLY, nullptr,
                                         nullptr));
    Owned<hb_face_t> shaping(hb_face_create(blob.get(), static_cast<unsigned>(face)));
    handles_->font.reset(hb_font_create(shaping.get()));
    hb_font_set_scale(handles_->font.get(), opened->units_per_EM, opened->units_per_EM);
}

Typesetter::~Typesetter() = default;

Typesetter::Line Typesetter::shaped(const std::string& text, double letter_spacing) const
{
    Owned<hb_buffer_t> buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
    hb_buffer_guess_segment_properties(buffer.get());
    hb_shape(handles_->font.get(), buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
    Line line;
    dvec2 at(0);
    for (unsigned i = 0; i < count; ++i) {
        line.glyphs.push_back({infos[i].codepoint, at + dvec2(positions[i].x_offset, positions[i].y_offset) / units_});
        at += dvec2(positions[i].x_advance, positions[i].y_advance) / units_;
        line.width = at.x;
        bool letter_ends = i + 1 == count || infos[i + 1].cluster != infos[i].cluster;
        if (letter_ends) at.x += letter_spacing;
    }
    return line;
}

void Typesetter::add_line(const Line& line, dvec2 origin, double tolerance, std::vector<Contour>& into) const
{
    FT_Face face = handles_->face.get();
    FT_Outline_Funcs pen_moves{move_to, line_to, conic_to, cubic_to, 0, 0};
    for (const Line::Glyph& glyph : line.glyphs) {
        if (FT_Load_Glyph(face, glyph.index, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP)) continue;
        if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) continue;
        Pen pen{units_, tolerance, origin + glyph.at, into};
        FT_Outline_Decompose(&face->glyph->outline, &pen_moves, &pen);
    }
}

std::vector<Contour> Typesetter::set(const Writing& writing, double tolerance)
{
    std::vector<Line> lines;
    double width = 0;
    for (const std::string& text : lines_of(writing.text)) {
        lines.push_back(shaped(text, writing.letter_spacing));
        width = std::max(width, lines.back().width);
    }
    FT_Face face = handles_->face.get();
    const auto* os2 = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(face, FT_SFNT_OS2));
    bool knows_capitals = os2 && os2->version >= 2 && os2->sCapHeight > 0;
    double capitals = knows_capitals ? os2->sCapHeight / units_ : 0.7;
    double step = writing.line_spacing * (face->height > 0 ? face->height / units_ : 1.2);
    double y = 0.5 * (step * static_cast<double>(lines.size() - 1) - capitals);
    std::vector<Contour> contours;
    for (const Line& line : lines) {
        add_line(line, {writing.alignment * (width - line.width) - 0.5 * width, y}, tolerance, contours);
        y -= step;
    }
    return contours;
}

}  // namespace fieldwright::assets
