// Reads state files tolerantly, writes them atomically.
#include "app/state_file.h"

#include "graph/scene_file.h"

#include <fstream>

namespace fieldwright::app {

namespace fs = std::filesystem;

namespace {
constexpr std::uintmax_t size_limit = 4u << 20;  // bytes
}  // namespace

StateJson read_state(const fs::path& path)
{
    std::error_code error;
    if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > size_limit || error) return nullptr;
    std::ifstream stream(path, std::ios::binary);
    StateJson json = StateJson::parse(stream, nullptr, false);
    return json.is_discarded() ? StateJson(nullptr) : json;
}

void write_state(const fs::path& path, const StateJson& json)
{
    // File names need not be UTF-8; what is not is replaced rather than refused.
    graph::save_atomically(path, json.dump(1, ' ', false, StateJson::error_handler_t::replace) + "\n");
}

std::string string_member(const StateJson& object, const char* key, std::string alternative)
{
    auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() && found->is_string() ? found->get<std::string>() : alternative;
}

std::int64_t integer_member(const StateJson& object, const char* key, std::int64_t alternative)
{
    auto found = object.is_object() ? object.find(key) : object.end();
    bool fits = object.is_object() && found != object.end() && found->is_number_integer();
    return fits ? found->get<std::int64_t>() : alternative;
}

}  // namespace fieldwright::app
