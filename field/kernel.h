// One compiled function of the dialect over rows of points. Generated from the shader texts at build time, once per
// instruction set; the evaluator picks the widest the machine runs.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>

namespace fieldwright::field {

inline constexpr int row_width = 256;             // points per row
inline constexpr std::size_t max_arguments = 32;  // of a function

// Rows are structure of arrays: lane k of a value lies at data + k * row_width. Structures are their members' lanes in
// declaration order; ints and bools are stored as floats; a List is (first, count) and always uniform.
// result: rows. arguments: one pointer per argument. count: points, at most row_width.
using Kernel = void (*)(float* result, const float* const* arguments, const glm::vec4* list_data, int count);

struct KernelEntry {
    std::string_view function;
    Kernel uniform;  // commented parameters (and List, int copy) are single values, reserved arguments are rows
    Kernel varying;  // every argument but List is rows
};

struct KernelTable {
    std::string_view instruction_set;  // "avx512", "avx2", "base"
    const KernelEntry* begin;
    const KernelEntry* end;
};

// The widest table this processor runs, or the one named by the environment variable FIELDWRIGHT_ISA.
const KernelTable& kernels();
// All tables this processor can run, widest first (tests compare them).
const KernelTable* const* runnable_kernels(int& count);
const KernelEntry* find_kernel(const KernelTable& table, std::string_view function);  // null when not compiled in

}  // namespace fieldwright::field
