// How large a document may be; beyond it edits and files are refused.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fieldwright::graph {

inline constexpr std::size_t node_limit = 20'000;
inline constexpr std::size_t wire_limit = 65'536;
inline constexpr std::size_t name_limit = 256;   // bytes
inline constexpr std::size_t text_limit = 4096;  // bytes of a text or formula parameter
inline constexpr std::size_t own_type_limit = 256;
inline constexpr std::size_t own_text_limit = 64u << 10;         // bytes
inline constexpr std::int64_t id_limit = std::int64_t(1) << 53;  // ids lie below

}  // namespace fieldwright::graph
