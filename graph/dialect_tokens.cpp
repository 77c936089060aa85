#include "graph/dialect_tokens.h"

#include "graph/dialect.h"

#include <cctype>

namespace fieldwright::graph {
namespace {

bool is_word_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_word_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Lexer {
public:
    Lexer(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    std::vector<Token> tokens()
    {
        std::vector<Token> result;
        while (skip_space()) result.push_back(next());
        result.push_back({TokenKind::end, {}, line_, text_.size()});
        return result;
    }

private:
    bool skip_space()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) {
            check_line_end();
            if (text_[at_] == '\n') ++line_;
            ++at_;
        }
        return at_ < text_.size();
    }

    // A return alone ends a line for GLSL, and hides from us what follows.
    void check_line_end() const
    {
        if (text_[at_] == '\r' && text_.substr(at_, 2) != "\r\n") fail("lines end with a line feed");
        if (text_[at_] == '\0') fail("the text holds a zero byte");
    }

    [[noreturn]] void fail(const std::string& rule) const
    {
        throw DialectError(path_, line_, rule, column_at(text_, at_));
    }

    Token next()
    {
        std::size_t start = at_;
        char c = text_[at_];
        if (text_.substr(at_, 2) == "//") return comment(start);
        if (text_.substr(at_, 2) == "/*") fail("comments are written with //");
        if (c == '#') fail("preprocessor lines are not part of the dialect; remove the #");
        if (c == '\\' || c == '"' || c == '`' || c == '@' || c == '$')
            fail(std::string("the character ") + c + " is not part of the dialect");
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~')
            fail("only the characters of ASCII are part of the dialect, outside comments");
        if (is_word_start(c)) return take(TokenKind::word, start, is_word_part);
        if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) return number(start);
        ++at_;
        return {TokenKind::symbol, text_.substr(start, 1), line_, start};
    }

    Token comment(std::size_t start)
    {
        for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) check_line_end();
        std::string_view text = text_.substr(start, at_ - start);
        // For GLSL the comment would go on in the next line.
        if (text.find_last_not_of("\r \t") != text.npos && text[text.find_last_not_of("\r \t")] == '\\')
            fail("a comment does not end with \\");
        return {TokenKind::comment, text, line_, start};
    }

    Token take(TokenKind kind, std::size_t start, bool (*belongs)(char))
    {
        while (at_ < text_.size() && belongs(text_[at_])) ++at_;
        return {kind, text_.substr(start, at_ - start), line_, start};
    }

    Token number(std::size_t start)
    {
        while (at_ < text_.size()) {
            char c = text_[at_];
            bool exponent_sign = (c == '+' || c == '-') && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
            if (!is_word_part(c) && c != '.' && !exponent_sign) break;
            ++at_;
        }
        Token token{TokenKind::number, text_.substr(start, at_ - start), line_, start};
        check_number(token);
        return token;
    }

    void check_number(const Token& token) const
    {
        bool real = token.text.find_first_of(".eE") != std::string_view::npos;
        bool suffixed = token.text.back() == 'f';
        std::string number(token.text);
        int column = column_at(text_, token.offset);
        if (real && !suffixed)
            throw DialectError(path_, token.line, "the number " + number + " needs the suffix f, as in " + number + "f",
                               column);
        if (!real && suffixed)
            throw DialectError(path_, token.line, "the number " + number + " needs a decimal point", column);
    }

    const std::string& path_;
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

std::vector<Token> tokens_of(const std::string& path, std::string_view text) { return Lexer(path, text).tokens(); }

int column_at(std::string_view text, std::size_t offset)
{
    std::size_t line_end = offset == 0 ? text.npos : text.rfind('\n', offset - 1);
    return static_cast<int>(line_end == text.npos ? offset : offset - line_end - 1) + 1;
}

}  // namespace fieldwright::graph
