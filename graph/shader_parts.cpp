// Line by line, as a preprocessor would, so that printed shaders hold no directives.
#include "graph/shader_parts.h"

#include <algorithm>
#include <vector>

namespace fieldwright::graph {
namespace {

// visit(line with its end, whether it is a directive, whether its parts are wanted).
template <typename Wanted, typename Visit>
void for_each_line(std::string_view text, const Wanted& wanted, const Visit& visit)
{
    std::vector<bool> open;
    while (!text.empty()) {
        std::string_view line = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
        text.remove_prefix(line.size());
        std::string_view words = line.substr(0, line.find_last_not_of(" \r\n") + 1);
        bool directive = words.starts_with("#if ") || words == "#else" || words == "#endif";
        if (words.starts_with("#if ")) open.push_back(wanted(words.substr(4)));
        else if (directive && !open.empty() && words == "#else") open.back() = !open.back();
        else if (directive && !open.empty()) open.pop_back();
        visit(line, directive, std::find(open.begin(), open.end(), false) == open.end());
    }
}

}  // namespace

std::string with_parts(std::string_view text, const ShaderParts& parts)
{
    std::string result;
    result.reserve(text.size());
    auto wanted = [&](std::string_view name) { return parts.contains(name); };
    for_each_line(text, wanted, [&](std::string_view line, bool directive, bool is_wanted) {
        if (!directive && is_wanted) result += line;
    });
    return result;
}

int line_of_whole(std::string_view text, const ShaderParts& parts, int line)
{
    int whole = 0, kept = 0, found = 0;
    auto wanted = [&](std::string_view name) { return parts.contains(name); };
    for_each_line(text, wanted, [&](std::string_view, bool directive, bool is_wanted) {
        ++whole;
        if (!directive && is_wanted && ++kept == line) found = whole;
    });
    return found;
}

std::string with_all_parts(std::string_view text)
{
    std::string result;
    result.reserve(text.size());
    auto wanted = [](std::string_view) { return true; };
    for_each_line(text, wanted, [&](std::string_view line, bool directive, bool is_wanted) {
        if (directive || !is_wanted) result += '\n';
        else result += line;
    });
    return result;
}

}  // namespace fieldwright::graph
