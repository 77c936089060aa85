#include "graph/dialect.h"

#include <algorithm>

namespace fieldwright::graph {

DialectError::DialectError(std::string file_path, int line_number, std::string broken_rule, int column_number)
    : std::runtime_error(file_path + ":" + std::to_string(line_number) + ": " + broken_rule),
      file(std::move(file_path)),
      line(line_number),
      column(column_number),
      rule(std::move(broken_rule))
{
}

const Argument* Function::argument(std::string_view wanted) const
{
    auto found = std::find_if(arguments.begin(), arguments.end(),
                              [&](const Argument& argument) { return argument.name == wanted; });
    return found != arguments.end() ? &*found : nullptr;
}

int lane_count(const Type& type, const std::vector<StructDeclaration>& structs)
{
    switch (type.base) {
        case BaseType::none: return 0;
        case BaseType::real:
        case BaseType::integer:
        case BaseType::boolean: return 1;
        case BaseType::vec2:
        case BaseType::list: return 2;
        case BaseType::vec3: return 3;
        case BaseType::vec4:
        case BaseType::mat2: return 4;
        case BaseType::mat3: return 9;
        case BaseType::structure: break;
    }
    for (const StructDeclaration& declared : structs) {
        if (declared.name != type.name) continue;
        int lanes = 0;
        for (const auto& member : declared.members) lanes += lane_count(member.type, structs);
        return lanes;
    }
    return 0;
}

}  // namespace fieldwright::graph
