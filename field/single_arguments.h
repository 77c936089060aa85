// Which arguments the uniform form of a kernel reads as single values: a rule of those who write kernels and who call them.
#pragma once

#include "graph/dialect.h"

namespace fieldwright::field {

// Parameters, copies and time, in functions of node files. Lists are no rows in any form.
inline bool is_single(const graph::Function& function, const graph::Argument& argument)
{
    bool varies_seldom =
        argument.parameter >= 0 || argument.role == graph::Role::copy || argument.role == graph::Role::time;
    return varies_seldom && argument.type.base != graph::BaseType::list && function.file.starts_with("nodes/");
}

}  // namespace fieldwright::field
