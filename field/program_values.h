// Places in a program's lists, as what lists are asked by.
#pragma once

#include "graph/program.h"

namespace fieldwright::field {

inline std::size_t index(std::int32_t number) { return static_cast<std::size_t>(number); }

inline const graph::ProgramValue& value_of(const graph::Program& program, graph::ValueId id)
{
    return program.values[index(id)];
}

}  // namespace fieldwright::field
