// What tells one state of a file from another without reading it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace fieldwright::app {

struct FileStamp {
    std::uint64_t device = 0, inode = 0;
    std::int64_t size = 0;         // bytes
    std::int64_t modified_ns = 0;  // since 1970
    bool operator==(const FileStamp&) const = default;
};

// Of the file that links lead to; nothing when there is none.
std::optional<FileStamp> file_stamp(const std::filesystem::path& path);

}  // namespace fieldwright::app
