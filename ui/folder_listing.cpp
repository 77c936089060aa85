// Reading folders without throwing.
#include "ui/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace fieldwright::ui {
namespace {

namespace fs = std::filesystem;

bool before(const FolderEntry& a, const FolderEntry& b)
{
    if (a.is_folder != b.is_folder) return a.is_folder;
    auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    bool less = std::lexicographical_compare(a.name.begin(), a.name.end(), b.name.begin(), b.name.end(),
                                             [&](char x, char y) { return lower(x) < lower(y); });
    bool more = std::lexicographical_compare(b.name.begin(), b.name.end(), a.name.begin(), a.name.end(),
                                             [&](char x, char y) { return lower(x) < lower(y); });
    return less || (!more && a.name < b.name);
}

bool ends_in_one(const std::string& name, const std::vector<std::string>& suffixes)
{
    auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return suffixes.empty() || std::any_of(suffixes.begin(), suffixes.end(), [&](const std::string& suffix) {
               return suffix.size() <= name.size() && std::equal(suffix.rbegin(), suffix.rend(), name.rbegin(), same);
           });
}

}  // namespace

FolderListing list_folder(const fs::path& folder, const std::vector<std::string>& suffixes)
{
    FolderListing listing;
    std::error_code error;
    fs::directory_iterator at(folder, error), end;
    for (; !error && at != end; at.increment(error)) {
        std::string name = at->path().filename().string();
        std::error_code unknown;  // a link to nowhere is neither
        bool is_folder = at->is_directory(unknown), is_file = at->is_regular_file(unknown);
        if (name.starts_with('.') || (!is_folder && !(is_file && ends_in_one(name, suffixes)))) continue;
        listing.entries.push_back({std::move(name), is_folder});
    }
    if (error) listing.error = "Cannot read " + folder.string() + ": " + error.message() + ".";
    std::sort(listing.entries.begin(), listing.entries.end(), before);
    return listing;
}

std::string make_folder(const fs::path& path)
{
    std::error_code error;
    if (fs::exists(path, error)) return path.filename().string() + " is there already.";
    if (fs::create_directory(path, error)) return {};
    return "Cannot make the folder " + path.filename().string() + ": " + error.message() + ".";
}

fs::path existing_folder(fs::path path)
{
    std::error_code error;
    if (path.is_relative()) path = fs::current_path(error) / path;
    path = path.lexically_normal();
    while (!fs::is_directory(path, error) && path != path.parent_path()) path = path.parent_path();
    if (!path.has_filename() && path != path.root_path()) path = path.parent_path();  // "a/b/" is "a/b"
    return path;
}

fs::path home_folder()
{
    const char* home = std::getenv("HOME");
    return existing_folder(home && *home ? home : "/");
}

}  // namespace fieldwright::ui
