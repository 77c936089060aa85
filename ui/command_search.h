// Finding commands by what one remembers of them.
#pragma once

#include "ui/commands.h"

namespace fieldwright::ui {

// Those that match every word of the query, best first: at the title's beginning, at the beginning of one of its words,
// inside it, in the menu's name, in the help; when there are none, by the letters of the title in order. An empty query
// matches all and keeps the order.
std::vector<const Command*> search_commands(std::span<const Command* const> commands, std::string_view query);

}  // namespace fieldwright::ui
