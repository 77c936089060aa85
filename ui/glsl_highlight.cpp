// A tokenizer for colours: it need not understand GLSL, only tell its words apart.
#include "ui/glsl_highlight.h"

#include "ui/theme.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace fieldwright::ui {
namespace {

constexpr std::array keywords = {
    std::string_view("break"),     std::string_view("case"),    std::string_view("const"),
    std::string_view("continue"),  std::string_view("default"), std::string_view("discard"),
    std::string_view("do"),        std::string_view("else"),    std::string_view("false"),
    std::string_view("flat"),      std::string_view("for"),     std::string_view("highp"),
    std::string_view("if"),        std::string_view("in"),      std::string_view("inout"),
    std::string_view("invariant"), std::string_view("layout"),  std::string_view("lowp"),
    std::string_view("mediump"),   std::string_view("out"),     std::string_view("precision"),
    std::string_view("return"),    std::string_view("struct"),  std::string_view("switch"),
    std::string_view("true"),      std::string_view("uniform"), std::string_view("varying"),
    std::string_view("while")};
constexpr std::array types = {
    std::string_view("bool"),          std::string_view("bvec2"),      std::string_view("bvec3"),
    std::string_view("bvec4"),         std::string_view("double"),     std::string_view("float"),
    std::string_view("int"),           std::string_view("isampler2D"), std::string_view("ivec2"),
    std::string_view("ivec3"),         std::string_view("ivec4"),      std::string_view("mat2"),
    std::string_view("mat3"),          std::string_view("mat4"),       std::string_view("sampler2D"),
    std::string_view("samplerBuffer"), std::string_view("uint"),       std::string_view("uvec2"),
    std::string_view("uvec3"),         std::string_view("uvec4"),      std::string_view("vec2"),
    std::string_view("vec3"),          std::string_view("vec4"),       std::string_view("void")};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

template <typename Words>
bool among(const Words& words, std::string_view word)
{
    return std::binary_search(words.begin(), words.end(), word);
}

std::size_t end_of_number(std::string_view line, std::size_t at)
{
    while (at < line.size()) {
        bool exponent_sign = (line[at] == '+' || line[at] == '-') && (line[at - 1] == 'e' || line[at - 1] == 'E');
        if (!is_letter(line[at]) && line[at] != '.' && !exponent_sign) break;
        ++at;
    }
    return at;
}

std::size_t end_of_word(std::string_view line, std::size_t at)
{
    while (at < line.size() && is_letter(line[at])) ++at;
    return at;
}

GlslKind kind_of_word(std::string_view line, std::size_t first, std::size_t last)
{
    std::string_view word = line.substr(first, last - first);
    if (among(keywords, word)) return GlslKind::keyword;
    if (among(types, word)) return GlslKind::type;
    std::size_t next = line.find_first_not_of(' ', last);
    if (next != std::string_view::npos && line[next] == '(') return GlslKind::function;
    // Structures are capitalised and not all capitals, which are constants.
    bool structure = std::isupper(static_cast<unsigned char>(word[0])) &&
                     std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::islower(c); });
    return structure ? GlslKind::type : GlslKind::plain;
}

// The end of a block comment that is open at `at`, and whether it closes on this line.
std::size_t end_of_comment(std::string_view line, std::size_t at, bool& open)
{
    std::size_t close = line.find("*/", at);
    open = close == std::string_view::npos;
    return open ? line.size() : close + 2;
}

GlslToken token_at(std::string_view line, std::size_t at, bool& in_comment)
{
    std::string_view rest = line.substr(at);
    if (rest.starts_with("//")) return {at, line.size(), GlslKind::comment};
    if (rest.starts_with("/*")) return {at, end_of_comment(line, at + 2, in_comment), GlslKind::comment};
    if (rest[0] == '#') return {at, std::min(line.find("//", at), line.size()), GlslKind::preprocessor};
    if (is_digit(rest[0]) || (rest.size() > 1 && rest[0] == '.' && is_digit(rest[1])))
        return {at, end_of_number(line, at + 1), GlslKind::number};
    if (!is_letter(rest[0])) return {at, at + 1, GlslKind::plain};
    std::size_t last = end_of_word(line, at);
    return {at, last, kind_of_word(line, at, last)};
}

}  // namespace

std::vector<GlslToken> glsl_tokens(std::string_view line, bool& in_comment)
{
    static_assert(std::is_sorted(keywords.begin(), keywords.end()) && std::is_sorted(types.begin(), types.end()));
    std::vector<GlslToken> tokens;
    std::size_t at = 0;
    if (in_comment && !line.empty()) {
        at = end_of_comment(line, 0, in_comment);
        tokens.push_back({0, at, GlslKind::comment});
    }
    while (at < line.size()) {
        if (std::isspace(static_cast<unsigned char>(line[at]))) {
            ++at;
            continue;
        }
        GlslToken token = token_at(line, at, in_comment);
        at = token.last;
        // Signs in a row are drawn as one.
        bool joins = token.kind == GlslKind::plain && !tokens.empty() && tokens.back().last == token.first &&
                     tokens.back().kind == GlslKind::plain;
        if (joins) tokens.back().last = token.last;
        else tokens.push_back(token);
    }
    return tokens;
}

ImU32 glsl_colour(GlslKind kind)
{
    switch (kind) {
        case GlslKind::keyword: return colour::rgb(0xd08fb4);
        case GlslKind::type: return colour::rgb(0x7fc1c7);
        case GlslKind::number: return colour::rgb(0xd9b27c);
        case GlslKind::comment: return colour::rgb(0x7d8896);
        case GlslKind::preprocessor: return colour::rgb(0xb79fe0);
        case GlslKind::function: return colour::rgb(0xa9c587);
        case GlslKind::plain: break;
    }
    return colour::rgb(0xc5ccd6);
}

void glsl_text(std::string_view text)
{
    bool in_comment = false;
    float letter_px = ImGui::GetFont()->GetCharAdvance('0');
    for (std::size_t first = 0; first < text.size();) {
        std::size_t last = std::min(text.find('\n', first), text.size());
        std::string_view line = text.substr(first, last - first);
        ImVec2 low = ImGui::GetCursorScreenPos();
        for (const GlslToken& token : glsl_tokens(line, in_comment))
            ImGui::GetWindowDrawList()->AddText({low.x + letter_px * static_cast<float>(token.first), low.y},
                                                glsl_colour(token.kind), line.data() + token.first,
                                                line.data() + token.last);
        ImGui::Dummy({letter_px * static_cast<float>(line.size() + 1), ImGui::GetFontSize()});
        first = last + 1;
    }
}

}  // namespace fieldwright::ui
