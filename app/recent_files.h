// The files opened and saved last, newest first, kept in the state folder.
#pragma once

#include <filesystem>
#include <vector>

namespace fieldwright::app {

struct RecentFile {
    std::filesystem::path path;  // absolute
    bool missing = false;        // now; it may come back, as from a drive that is not mounted
    bool operator==(const RecentFile&) const = default;
};

class RecentFiles {
public:
    static constexpr std::size_t limit = 15;

    // Reads the file; a broken one counts as empty.
    explicit RecentFiles(std::filesystem::path file);

    std::vector<RecentFile> entries() const;  // asks the disk which are missing
    // Each writes the file, keeping what other windows added; graph::Failure, and then only this window knows.
    void add(const std::filesystem::path& path);
    void remove(const std::filesystem::path& path);
    void clear();

private:
    void read();
    void write() const;

    std::filesystem::path file_;
    std::vector<std::filesystem::path> paths_;
};

}  // namespace fieldwright::app
