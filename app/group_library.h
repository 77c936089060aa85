// The user's library of groups: one file each, <group>.json, in a folder.
#pragma once

#include "graph/library.h"
#include "ui/readings.h"

#include <filesystem>
#include <optional>

namespace fieldwright::app {

class GroupLibrary {
public:
    static constexpr std::size_t file_limit = 500;

    explicit GroupLibrary(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

    // By name. What cannot be read is left out; `failure` gets the first reason.
    std::vector<ui::SavedGroup> read(const graph::Library& library, std::string& failure) const;
    // Replaces a group of that name, and says whether there was one. Makes the folder. graph::Failure
    bool save(const std::string& name, std::string_view text) const;

private:
    std::optional<std::filesystem::path> folder_;
};

}  // namespace fieldwright::app
