// What is in a folder, as a file browser shows it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fieldwright::ui {

struct FolderEntry {
    std::string name;
    bool is_folder = false;
    bool operator==(const FolderEntry&) const = default;
};

struct FolderListing {
    std::vector<FolderEntry> entries;  // folders first, each by name without regard to case; hidden ones left out
    std::string error;                 // why it could not be read, as a sentence; empty when it was
};

// Folders, and the files whose name ends in one of the suffixes, in capitals or not; all files without any.
FolderListing list_folder(const std::filesystem::path& folder, const std::vector<std::string>& suffixes);
// Empty when it was made; else why not, as a sentence.
std::string make_folder(const std::filesystem::path& path);
// The nearest folder at or above `path` that is there; the root at the end.
std::filesystem::path existing_folder(std::filesystem::path path);
std::filesystem::path home_folder();

}  // namespace fieldwright::ui
