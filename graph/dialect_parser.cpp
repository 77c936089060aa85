// The parser of declarations, and the lint of what stands between them.
#include "graph/dialect.h"
#include "graph/dialect_tokens.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace fieldwright::graph {
namespace {

constexpr std::array forbidden_words = {"out",       "inout",   "in",         "while",     "do",       "switch",
                                        "goto",      "uniform", "varying",    "attribute", "layout",   "texture",
                                        "discard",   "inverse", "double",     "union",     "template", "class",
                                        "namespace", "using",   "inversesqrt"};

constexpr std::array reserved_names = {
    "active",     "asm",      "atomic_uint", "auto",     "buffer", "case",      "catch",     "char",     "common",
    "default",    "delete",   "enum",        "explicit", "export", "extern",    "external",  "filter",   "fixed",
    "friend",     "half",     "highp",       "image2D",  "inline", "input",     "interface", "long",     "lowp",
    "mediump",    "new",      "noinline",    "operator", "output", "partition", "precision", "private",  "protected",
    "public",     "register", "resource",    "sample",   "short",  "signed",    "sizeof",    "smooth",   "static",
    "subroutine", "superp",   "this",        "throw",    "try",    "typedef",   "typename",  "unsigned", "virtual",
    "volatile",   "flat",     "centroid",    "patch",    "xor",    "and",       "or",        "not",      "restrict",
    "shared",     "coherent", "readonly",    "writeonly"};

template <typename List>
bool contains(const List& list, std::string_view word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
}

BaseType base_type(std::string_view word)
{
    static const std::map<std::string_view, BaseType> types = {
        {"float", BaseType::real}, {"int", BaseType::integer}, {"bool", BaseType::boolean},
        {"vec2", BaseType::vec2},  {"vec3", BaseType::vec3},   {"vec4", BaseType::vec4},
        {"mat2", BaseType::mat2},  {"mat3", BaseType::mat3},   {"List", BaseType::list}};
    auto found = types.find(word);
    return found == types.end() ? BaseType::none : found->second;
}

std::string_view comment_text(std::string_view comment)
{
    comment.remove_prefix(2);
    if (!comment.empty() && comment.front() == ' ') comment.remove_prefix(1);
    while (!comment.empty() && std::isspace(static_cast<unsigned char>(comment.back()))) comment.remove_suffix(1);
    return comment;
}

class Parser {
public:
    Parser(SourceFile& file, const std::vector<std::string>& struct_names) : file_(file), struct_names_(struct_names)
    {
        tokens_ = tokens_of(file.path, file.text);
    }

    void parse()
    {
        header();
        while (peek().kind != TokenKind::end) declaration();
    }

private:
    [[noreturn]] void fail(const Token& token, const std::string& rule) const
    {
        throw DialectError(file_.path, token.line, rule, column_at(file_.text, token.offset));
    }

    void header()
    {
        int expected_line = 1;
        while (at_ < tokens_.size() && tokens_[at_].kind == TokenKind::comment && tokens_[at_].line == expected_line) {
            file_.header.emplace_back(comment_text(tokens_[at_].text));
            ++at_;
            ++expected_line;
        }
        if (file_.header.empty()) fail(tokens_[0], "the file must begin with a line `// Title: what it is.`");
    }

    const Token& peek()
    {
        while (tokens_[at_].kind == TokenKind::comment) ++at_;
        return tokens_[at_];
    }

    Token take()
    {
        Token token = peek();
        if (token.kind != TokenKind::end) ++at_;
        return token;
    }

    Token expect(std::string_view text)
    {
        Token token = take();
        if (token.text != text)
            fail(token, "expected `" + std::string(text) + "`, found `" + std::string(token.text) + "`");
        return token;
    }

    Token expect_name()
    {
        Token token = take();
        if (token.kind != TokenKind::word) fail(token, "expected a name, found `" + std::string(token.text) + "`");
        check_name(token);
        return token;
    }

    void check_name(const Token& token) const
    {
        if (contains(reserved_names, token.text) || contains(forbidden_words, token.text))
            fail(token, "`" + std::string(token.text) + "` is a reserved word of GLSL or C++; use another name");
        if (token.text.starts_with("gl_") || token.text.find("__") != std::string_view::npos)
            fail(token, "`" + std::string(token.text) + "` is reserved for the GLSL compiler; use another name");
    }

    bool is_type(std::string_view word) const
    {
        return base_type(word) != BaseType::none || contains(struct_names_, word) ||
               std::any_of(file_.structs.begin(), file_.structs.end(), [&](const auto& s) { return s.name == word; });
    }

    Type type()
    {
        Token token = take();
        if (!is_type(token.text)) fail(token, "`" + std::string(token.text) + "` is not a type of the dialect");
        BaseType base = base_type(token.text);
        return {base == BaseType::none ? BaseType::structure : base, std::string(token.text)};
    }

    void declaration()
    {
        if (peek().text == "struct") structure();
        else if (peek().text == "const") constant();
        else function();
    }

    std::string text_from(std::size_t first_offset, const Token& last) const
    {
        return file_.text.substr(first_offset, last.offset + last.text.size() - first_offset);
    }

    void structure()
    {
        Token keyword = take();
        StructDeclaration declared;
        declared.line = keyword.line;
        declared.name = expect_name().text;
        expect("{");
        while (peek().text != "}") {
            Type member_type = type();
            declared.members.push_back({member_type, std::string(expect_name().text)});
            expect(";");
        }
        take();
        declared.text = text_from(keyword.offset, expect(";"));
        file_.structs.push_back(std::move(declared));
    }

    void constant()
    {
        Token keyword = take();
        type();
        expect_name();
        expect("=");
        while (peek().text != ";" && peek().kind != TokenKind::end) check_body_token(take());
        file_.constants.push_back(text_from(keyword.offset, expect(";")));
    }

    void function()
    {
        Token start = peek();
        Function function;
        function.file = file_.path;
        function.line = start.line;
        function.result = type();
        function.name = expect_name().text;
        for (const Function& other : file_.functions)
            if (other.name == function.name) fail(start, "`" + function.name + "` is defined twice; use another name");
        expect("(");
        while (peek().text != ")") argument(function);
        Token closing = expect(")");
        if (!function.arguments.empty()) take_argument_comment(function.arguments.back(), closing);
        expect("{");
        Token last = body(function);
        function.text = text_from(start.offset, last);
        file_.functions.push_back(std::move(function));
    }

    void argument(Function& function)
    {
        Argument argument;
        argument.type = type();
        Token name = expect_name();
        argument.name = name.text;
        argument.line = name.line;
        for (const Argument& other : function.arguments)
            if (other.name == argument.name) fail(name, "the argument `" + argument.name + "` is declared twice");
        function.arguments.push_back(argument);
        if (peek().text == ",") {
            take_argument_comment(function.arguments.back(), take());
        } else if (peek().text != ")") {
            fail(peek(), "expected `,` or `)` after the argument `" + argument.name + "`");
        }
    }

    void take_argument_comment(Argument& argument, const Token& separator)
    {
        const Token& next = tokens_[at_];
        if (next.kind == TokenKind::comment && next.line == separator.line && next.line == argument.line)
            argument.comment = comment_text(next.text);
    }

    // Walks the body to its closing brace, checks every token and counts loop iterations.
    Token body(Function& function)
    {
        struct Scope {
            int brace_depth;
            double multiplicity;
            std::string_view counter;
        };
        std::vector<Scope> loops;  // enclosing for loops
        double multiplicity = 1, iterations = 0, list_iterations = 0, list_loops = 0, tokens = 0;
        int depth = 1;
        double pending_loop = 0;  // iterations of a `for (...)` header just read
        std::string_view counter;
        while (true) {
            Token token = take();
            ++tokens;
            if (token.kind == TokenKind::end) fail(token, "the body of `" + function.name + "` is not closed");
            check_body_token(token);
            for (const Scope& loop : loops)
                if (token.text == loop.counter) check_counter_is_read(token);
            if (token.text == "for") {
                pending_loop = loop_header(counter);
                iterations += multiplicity * pending_loop;
                if (peek().text != "{") fail(peek(), "the body of a loop is written in braces");
                if (ends_with_a_list(function)) {
                    list_iterations += multiplicity * pending_loop;
                    list_loops += multiplicity;
                }
            } else if (token.text == "{") {
                ++depth;
                if (pending_loop > 0) {
                    loops.push_back({depth, multiplicity, counter});
                    multiplicity *= pending_loop;
                    pending_loop = 0;
                }
            } else if (token.text == "}") {
                if (!loops.empty() && loops.back().brace_depth == depth) {
                    multiplicity = loops.back().multiplicity;
                    loops.pop_back();
                }
                if (--depth == 0) {
                    function.loop_iterations = static_cast<int>(std::min(iterations, 1e6));
                    function.list_iterations = static_cast<int>(std::min(list_iterations, 1e6));
                    function.list_loops = static_cast<int>(std::min(list_loops, 1e6));
                    function.inlined_tokens = static_cast<int>(std::min(tokens, 1e9));
                    return token;
                }
            } else if (token.kind == TokenKind::word && peek().text == "(") {
                const Function* callee = callee_of(function, token);
                if (!callee) continue;
                iterations += multiplicity * callee->loop_iterations;
                list_iterations += multiplicity * callee->list_iterations;
                list_loops += multiplicity * callee->list_loops;
                tokens += callee->inlined_tokens;
            }
        }
    }

    // `{ if (i >= points.count) { break; }`: the loop leaves off at the end of a list.
    bool ends_with_a_list(const Function& function) const
    {
        constexpr std::array idiom = {"{", "if", "(", "", ">", "=", "", ".", "count", ")", "{", "break", ";", "}"};
        std::size_t at = at_;
        std::string_view list;
        for (std::size_t i = 0; i < idiom.size(); ++i, ++at) {
            while (at < tokens_.size() && tokens_[at].kind == TokenKind::comment) ++at;
            if (at >= tokens_.size()) return false;
            if (i == 6) list = tokens_[at].text;
            if (*idiom[i] && tokens_[at].text != idiom[i]) return false;
        }
        return std::any_of(function.arguments.begin(), function.arguments.end(), [&](const Argument& argument) {
            return argument.name == list && argument.type.base == BaseType::list;
        });
    }

    // The function of this file that is called there; null for those of other files.
    const Function* callee_of(const Function& caller, const Token& name) const
    {
        if (name.text == caller.name)
            fail(name, "`" + caller.name + "` calls itself; recursion is not part of the dialect");
        for (const Function& other : file_.functions)
            if (other.name == name.text) return &other;
        return nullptr;
    }

    // Tokens before (negative) and after the one just taken, comments apart.
    const Token& neighbour(int distance) const
    {
        int step = distance < 0 ? -1 : 1;
        auto at = static_cast<int>(at_) - 1;
        for (int left = std::abs(distance); left > 0; --left) {
            int next = at;
            do next += step;
            while (next > 0 && next < static_cast<int>(tokens_.size()) - 1 &&
                   tokens_[static_cast<std::size_t>(next)].kind == TokenKind::comment);
            if (next < 0 || next >= static_cast<int>(tokens_.size())) return tokens_.back();
            at = next;
        }
        return tokens_[static_cast<std::size_t>(at)];
    }

    // The operator that begins or ends there, as written without spaces.
    bool is_written(const Token& token, std::string_view text) const
    {
        return token.kind == TokenKind::symbol &&
               std::string_view(file_.text).substr(token.offset, text.size()) == text;
    }

    // Only a loop whose counter nobody else changes is known to end.
    void check_counter_is_read(const Token& counter) const
    {
        const Token &before = neighbour(-1), &after = neighbour(1);
        if (before.text == ".") return;
        bool changed = is_type(before.text) || (is_written(after, "=") && !is_written(after, "=="));
        for (const char* change : {"++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="})
            changed = changed || is_written(after, change);
        for (const char* step : {"++", "--"}) changed = changed || is_written(neighbour(-2), step);
        // (i) may be assigned to; only calls hold the counter alone.
        const Token& caller = neighbour(-2);
        bool called = caller.kind == TokenKind::word && caller.text != "else";
        changed = changed || (before.text == "(" && after.text == ")" && !called);
        if (changed)
            fail(counter, "the loop's counter `" + std::string(counter.text) +
                              "` is changed in its body, or stands alone in brackets; use another variable");
    }

    int integer_literal()
    {
        Token token = take();
        int value = 0;
        auto [end, error] = std::from_chars(token.text.data(), token.text.data() + token.text.size(), value);
        if (token.kind != TokenKind::number || error != std::errc() || end != token.text.data() + token.text.size())
            fail(token, "a loop's bounds are whole numbers, as in `for (int i = 0; i < 8; i++)`");
        return value;
    }

    double loop_header(std::string_view& counter)
    {
        expect("(");
        expect("int");
        Token name = expect_name();
        counter = name.text;
        expect("=");
        int first = integer_literal();
        expect(";");
        expect(name.text);
        expect("<");
        double last = peek().text == "=" ? (take(), integer_literal() + 1.0) : integer_literal();
        expect(";");
        expect(name.text);
        expect("+");
        expect("+");
        expect(")");
        return std::max(1.0, last - first);
    }

    void check_body_token(const Token& token)
    {
        if (token.kind == TokenKind::word && contains(forbidden_words, token.text))
            fail(token, "`" + std::string(token.text) + "` is not part of the dialect");
        if (token.text == "round" && peek().text == "(")
            fail(token, "GLSL and C++ round halves differently; write floor(x + 0.5f)");
        if (token.kind == TokenKind::word && token.text != "float" && contains(reserved_names, token.text))
            fail(token, "`" + std::string(token.text) + "` is a reserved word of GLSL or C++; use another name");
        if (token.text == "." && tokens_[at_].kind == TokenKind::word) check_member(tokens_[at_]);
        if (is_type(token.text) && peek().text == "[")
            fail(token, "array constructors are not part of the dialect; use a List or separate variables");
    }

    void check_member(const Token& member) const
    {
        bool swizzle = member.text.size() > 1 && member.text.size() <= 4 &&
                       (member.text.find_first_not_of("xyzw") == std::string_view::npos ||
                        member.text.find_first_not_of("rgba") == std::string_view::npos);
        if (swizzle)
            fail(member, "the swizzle ." + std::string(member.text) +
                             " is not part of the dialect; write out the components, as in vec2(p.x, p.z)");
    }

    SourceFile& file_;
    const std::vector<std::string>& struct_names_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

}  // namespace

SourceFile parse_source(std::string path, std::string text, const std::vector<std::string>& struct_names)
{
    SourceFile file;
    file.path = std::move(path);
    file.text = std::move(text);
    Parser(file, struct_names).parse();
    return file;
}

}  // namespace fieldwright::graph
