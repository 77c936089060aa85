// What the window remembers between runs and no document holds: sizes of panes, the view camera of each file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fieldwright::app {

class WindowState {
public:
    using Entry = std::variant<double, std::string>;

    // Reads the file; what is broken or missing counts as never remembered.
    explicit WindowState(std::filesystem::path file);

    double number(std::string_view key, double alternative) const;
    std::string text(std::string_view key, std::string_view alternative) const;
    void remember(std::string_view key, Entry entry);  // numbers that are not finite are not remembered
    void forget(std::string_view key);

    // Writes the file when something changed; graph::Failure. Of more than 2,000 entries the longest unchanged are
    // forgotten, so keys may name files.
    void save();

private:
    using Entries = std::vector<std::pair<std::string, Entry>>;
    Entries::const_iterator find(std::string_view key) const;

    std::filesystem::path file_;
    Entries entries_;  // last remembered at the end
    bool changed_ = false;
};

}  // namespace fieldwright::app
