// Small JSON files in the state folder: whatever is in them is read without complaint, and they change in one step.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace fieldwright::app {

using StateJson = nlohmann::ordered_json;

// Null when the file is absent, too large, no regular file or no JSON.
StateJson read_state(const std::filesystem::path& path);
void write_state(const std::filesystem::path& path, const StateJson& json);  // graph::Failure

// A string member of an object, or the alternative.
std::string string_member(const StateJson& object, const char* key, std::string alternative = {});
// A whole number of an object, or the alternative.
std::int64_t integer_member(const StateJson& object, const char* key, std::int64_t alternative = 0);

}  // namespace fieldwright::app
