// Ranks node types by how well a query fits their words.
#include "graph/search.h"

#include <algorithm>
#include <tuple>

namespace fieldwright::graph {
namespace {

// Lower case, `_` and `-` as spaces, one space between words, none at the ends.
std::string plain(std::string_view text)
{
    std::string result;
    for (char c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (c == '_' || c == '-' || c == '\t' || c == '\n') c = ' ';
        if (c != ' ' || (!result.empty() && result.back() != ' ')) result += c;
    }
    if (result.ends_with(' ')) result.pop_back();
    return result;
}

// How a query fits a text, best first.
enum class Match { whole, prefix, word_prefix, subsequence, none };

bool starts_a_word(std::string_view text, std::string_view query)
{
    return text.find(" " + std::string(query)) != std::string_view::npos;
}

// The first letter must begin a word: letters scattered anywhere are found in everything.
bool is_subsequence(std::string_view text, std::string_view query)
{
    for (std::size_t start = 0; start < text.size(); ++start) {
        if (text[start] != query.front() || (start > 0 && text[start - 1] != ' ')) continue;
        std::size_t found = 0;
        for (char c : text.substr(start)) found += found < query.size() && c == query[found];
        if (found == query.size()) return true;
    }
    return false;
}

Match match(std::string_view text, std::string_view query)
{
    if (text == query) return Match::whole;
    if (text.starts_with(query)) return Match::prefix;
    if (starts_a_word(text, query)) return Match::word_prefix;
    return is_subsequence(text, query) ? Match::subsequence : Match::none;
}

std::vector<std::string> words_of(std::string_view text)
{
    std::vector<std::string> words(1);
    for (char c : text)
        if (c == ' ') words.emplace_back();
        else words.back() += c;
    return words;
}

// Match first, then where: name, title, synonyms (the closest are written first), category.
using Score = std::pair<Match, int>;
constexpr int last_place = 1'000, of_category = last_place + 1;

Score score(const NodeType& type, const std::string& query)
{
    Score best = {Match::none, 0};
    std::string all;
    auto consider = [&](std::string_view text, int where) {
        std::string words = plain(text);
        best = std::min(best, Score{match(words, query), where});
        all += " " + words;
    };
    consider(type.name, 0);
    consider(type.title, 1);
    int where = 2;
    for (const std::string& synonym : type.synonyms) consider(synonym, where++);
    consider(type.category, of_category);
    // Words in any order: "union smooth".
    std::vector<std::string> words = words_of(query);
    auto begins = [&](const std::string& word) { return starts_a_word(all, word); };
    if (words.size() > 1 && std::all_of(words.begin(), words.end(), begins))
        best = std::min(best, Score{Match::word_prefix, last_place});
    return best;
}

}  // namespace

std::vector<const NodeType*> search_types(std::span<const NodeType* const> types, std::string_view query_text,
                                          const std::vector<std::string>& recent)
{
    std::string query = plain(query_text);
    if (query.empty()) return {types.begin(), types.end()};
    std::vector<std::tuple<Score, std::ptrdiff_t, std::size_t, const NodeType*>> found;
    for (const NodeType* type : types) {
        Score fit = score(*type, query);
        auto age = std::find(recent.begin(), recent.end(), type->name) - recent.begin();
        // Of equals, the shorter title says less that was not asked for; a category stays in its order.
        std::size_t length = fit.second == of_category ? 0 : type->title.size();
        if (fit.first != Match::none) found.emplace_back(fit, age, length, type);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return std::tie(std::get<0>(a), std::get<1>(a), std::get<2>(a)) <
               std::tie(std::get<0>(b), std::get<1>(b), std::get<2>(b));
    });
    std::vector<const NodeType*> result;
    for (const auto& entry : found) result.push_back(std::get<3>(entry));
    return result;
}

}  // namespace fieldwright::graph
