// Lanes of structures by name, and rows.
#include "renderer/rows.h"

#include "graph/problem.h"

#include <algorithm>
#include <stdexcept>

namespace fieldwright::renderer {

Rows::Rows(int lanes, int capacity)
    : lanes_(lanes), capacity_(capacity), data_(static_cast<std::size_t>(lanes) * static_cast<std::size_t>(capacity))
{
}

void Rows::fill(int k, float value) { std::fill_n(lane(k), capacity_, value); }

void Rows::copy(int i, const Rows& from, int j)
{
    for (int k = 0; k < std::min(lanes_, from.lanes_); ++k) lane(k)[i] = from.lane(k)[j];
}

RowFunction::RowFunction(std::string_view name, const field::KernelTable& table)
{
    const field::KernelEntry* entry = field::find_kernel(table, name);
    if (!entry)
        throw graph::Failure(
            1, "the shading function " + std::string(name) + " is not compiled into this program; build it again");
    kernel_ = entry->varying;
}

int member_lane(const graph::Library& library, std::string_view structure, std::string_view member)
{
    for (const graph::StructDeclaration& declared : library.structs()) {
        if (declared.name != structure) continue;
        int lane = 0;
        for (const auto& candidate : declared.members) {
            if (candidate.name == member) return lane;
            lane += library.lanes(candidate.type);
        }
    }
    throw std::out_of_range("no member " + std::string(structure) + "." + std::string(member));
}

int structure_lanes(const graph::Library& library, std::string_view structure)
{
    return library.lanes({graph::BaseType::structure, std::string(structure)});
}

}  // namespace fieldwright::renderer
