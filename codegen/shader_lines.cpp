// Printed shaders hold functions, and files but for the parts they do not need, verbatim: a line is found where the text
// around it is.
#include "codegen/shader_lines.h"

#include "codegen/features.h"

#include <algorithm>
#include <regex>

namespace fieldwright::codegen {
namespace {

int lines_before(std::string_view text, std::size_t position)
{
    return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

// Which line of `part`, from 0, is line `line` of `shader`, from 1; nothing when `part` does not reach there.
std::optional<int> line_within(std::string_view part, std::string_view shader, int line)
{
    std::size_t at = part.empty() ? shader.npos : shader.find(part);
    if (at == shader.npos) return std::nullopt;
    int within = line - 1 - lines_before(shader, at);
    bool reaches = within >= 0 && within <= lines_before(part, part.size());
    return reaches ? std::optional(within) : std::nullopt;
}

}  // namespace

std::optional<std::string> place_of_line(const graph::Library& library, std::string_view shader, int line)
{
    for (const graph::NodeType* type : library.types())
        for (const graph::Function& function : type->source.functions)
            if (auto within = line_within(function.text, shader, line))
                return type->source.path + ":" + std::to_string(function.line + *within);
    const graph::ShaderParts parts = parts_of_shader(shader);
    for (const graph::SourceFile& file : library.render_files())
        if (auto within = line_within(graph::with_parts(library.text(file.path), parts), shader, line))
            return file.path + ":" + std::to_string(graph::line_of_whole(library.text(file.path), parts, 1 + *within));
    return std::nullopt;
}

std::string with_place(std::string complaint, const graph::Library& library, std::string_view shader)
{
    static const std::regex line_number(R"(\b0:(\d{1,9})(\(\d+\))?|\b0\((\d{1,9})\))");
    std::smatch match;
    if (!std::regex_search(complaint, match, line_number)) return complaint;
    int line = std::stoi(match[1].matched ? match[1] : match[3]);
    std::optional<std::string> place = place_of_line(library, shader, line);
    return place ? match.prefix().str() + *place + match.suffix().str() : complaint;
}

}  // namespace fieldwright::codegen
