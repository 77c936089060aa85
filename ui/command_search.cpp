// Ranking commands.
#include "ui/command_search.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace fieldwright::ui {
namespace {

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

std::vector<std::string> words_of(const std::string& text)
{
    std::vector<std::string> words;
    std::size_t at = 0;
    while ((at = text.find_first_not_of(' ', at)) != std::string::npos) {
        std::size_t end = std::min(text.find(' ', at), text.size());
        words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

bool begins_a_word(const std::string& text, const std::string& word)
{
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if (at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1]))) return true;
    return false;
}

bool has_letters_in_order(const std::string& text, const std::string& word)
{
    std::size_t at = 0;
    for (char c : word) {
        at = text.find(c, at);
        if (at == std::string::npos) return false;
        ++at;
    }
    return true;
}

struct Lowered {
    std::string title, menu, help;
};

// Lower is better; nothing = no match.
std::optional<int> rank_of_word(const Lowered& command, const std::string& word)
{
    if (command.title.starts_with(word)) return 0;
    if (begins_a_word(command.title, word)) return 1;
    if (command.title.find(word) != std::string::npos) return 2;
    if (begins_a_word(command.menu, word)) return 3;
    if (begins_a_word(command.help, word)) return 4;
    return std::nullopt;
}

std::optional<int> rank_by_letters(const Lowered& command, const std::string& word)
{
    if (word.size() < 2 || !has_letters_in_order(command.title, word)) return std::nullopt;
    return static_cast<int>(command.title.size());  // the less else the better
}

template <typename RankWord>
std::vector<const Command*> ranked(std::span<const Command* const> commands, const std::vector<std::string>& words,
                                   const RankWord& rank_word)
{
    std::vector<std::pair<int, const Command*>> found;
    for (const Command* command : commands) {
        Lowered lowered{lower_case(command->title), lower_case(command->menu), lower_case(command->help)};
        std::optional<int> sum = 0;
        for (const std::string& word : words) {
            auto rank = rank_word(lowered, word);
            sum = sum && rank ? std::optional(*sum + *rank) : std::nullopt;
        }
        if (sum) found.emplace_back(*sum, command);
    }
    // Of equals, the shorter title says less that was not asked for.
    auto key = [&](const auto& entry) {
        return std::pair(entry.first, words.empty() ? 0 : entry.second->title.size());
    };
    std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    std::vector<const Command*> in_order;
    for (const auto& [_, command] : found) in_order.push_back(command);
    return in_order;
}

}  // namespace

std::vector<const Command*> search_commands(std::span<const Command* const> commands, std::string_view query)
{
    std::vector<std::string> words = words_of(lower_case(query));
    std::vector<const Command*> found = ranked(commands, words, rank_of_word);
    return found.empty() ? ranked(commands, words, rank_by_letters) : found;
}

}  // namespace fieldwright::ui
