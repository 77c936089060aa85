// File stamps from stat.
#include "app/file_stamp.h"

#include <sys/stat.h>

namespace fieldwright::app {

std::optional<FileStamp> file_stamp(const std::filesystem::path& path)
{
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return FileStamp{status.st_dev, status.st_ino, status.st_size,
                     std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

}  // namespace fieldwright::app
