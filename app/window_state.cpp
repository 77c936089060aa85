// Entries of the window in one JSON object.
#include "app/window_state.h"

#include "app/state_file.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::app {
namespace {
constexpr std::size_t entry_limit = 2000;
}  // namespace

WindowState::WindowState(std::filesystem::path file) : file_(std::move(file))
{
    StateJson json = read_state(file_);
    if (!json.is_object()) return;
    for (const auto& [key, value] : json.items()) {
        if (value.is_number()) remember(key, value.get<double>());
        else if (value.is_string()) remember(key, value.get<std::string>());
    }
    changed_ = false;
}

WindowState::Entries::const_iterator WindowState::find(std::string_view key) const
{
    return std::find_if(entries_.begin(), entries_.end(), [key](const auto& entry) { return entry.first == key; });
}

double WindowState::number(std::string_view key, double alternative) const
{
    auto found = find(key);
    const double* number = found == entries_.end() ? nullptr : std::get_if<double>(&found->second);
    return number ? *number : alternative;
}

std::string WindowState::text(std::string_view key, std::string_view alternative) const
{
    auto found = find(key);
    const std::string* text = found == entries_.end() ? nullptr : std::get_if<std::string>(&found->second);
    return text ? *text : std::string(alternative);
}

void WindowState::remember(std::string_view key, Entry entry)
{
    if (const double* number = std::get_if<double>(&entry); number && !std::isfinite(*number)) return;
    auto found = find(key);
    if (found != entries_.end() && found->second == entry) return;
    if (found != entries_.end()) entries_.erase(found);
    entries_.emplace_back(key, std::move(entry));
    changed_ = true;
}

void WindowState::forget(std::string_view key)
{
    auto found = find(key);
    if (found == entries_.end()) return;
    entries_.erase(found);
    changed_ = true;
}

void WindowState::save()
{
    if (!changed_) return;
    if (entries_.size() > entry_limit)
        entries_.erase(entries_.begin(), entries_.end() - static_cast<std::ptrdiff_t>(entry_limit));
    StateJson json = StateJson::object();
    for (const auto& [key, entry] : entries_)
        std::visit([&, &name = key](const auto& plain) { json[name] = plain; }, entry);
    write_state(file_, json);
    changed_ = false;
}

}  // namespace fieldwright::app
