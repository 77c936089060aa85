// A program's instructions in runs that are short enough to be one function each.
#pragma once

#include "graph/program.h"

#include <span>
#include <vector>

namespace fieldwright::codegen {

// Instructions of one level: a body or an entry, blocks counted as one item.
struct Item {
    std::int32_t instruction;
    std::int32_t end;  // index after it (after the body of a block)
};

inline constexpr std::size_t largest_part = 128;  // items

struct Part {
    std::size_t first, last;  // items
    std::vector<graph::ValueId> inputs, outputs;
};

std::vector<Item> items_of(const graph::Program& program, std::int32_t first, std::int32_t last);
// results: values of the level that are read after it.
std::vector<Part> parts_of(const graph::Program& program, const std::vector<Item>& items,
                           std::span<const graph::ValueId> results);

}  // namespace fieldwright::codegen
