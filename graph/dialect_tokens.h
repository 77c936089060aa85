// A text of the dialect, cut into tokens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::graph {

enum class TokenKind { word, number, symbol, comment, end };

struct Token {
    TokenKind kind;
    std::string_view text;  // in the text that was cut
    int line;               // from 1
    std::size_t offset;
};

// Ends with one of kind `end`. Throws DialectError, which names `path`, at the first character or number that the
// dialect does not have.
std::vector<Token> tokens_of(const std::string& path, std::string_view text);

int column_at(std::string_view text, std::size_t offset);  // from 1

}  // namespace fieldwright::graph
