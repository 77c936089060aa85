// What the words of a line of GLSL are, for colouring it.
#pragma once

#include <imgui.h>

#include <string_view>
#include <vector>

namespace fieldwright::ui {

enum class GlslKind { plain, keyword, type, number, comment, preprocessor, function };

struct GlslToken {
    std::size_t first = 0, last = 0;  // bytes of the line, [first, last)
    GlslKind kind = GlslKind::plain;
};

// The tokens of one line (without its newline) in order; blanks and signs between them are left out.
// `in_comment`: whether a block comment is open; updated to how it stands after the line.
std::vector<GlslToken> glsl_tokens(std::string_view line, bool& in_comment);

ImU32 glsl_colour(GlslKind kind);
void glsl_text(std::string_view text);  // as items, a line each, in the current font, which has one width

}  // namespace fieldwright::ui
