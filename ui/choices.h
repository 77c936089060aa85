// What can be chosen of a kind: names as the program knows them, and words for people. Filled by app.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::ui {

struct Choice {
    std::string name, title, help;
};

struct ViewChoice : Choice {
    bool light = false;       // what eyes see; the colours of the others are data, which glasses would falsify
    std::string scale_title;  // of numbers shown by a colour map; empty of others
    float scale_end = 0;      // the number at the map's end; 0 = of steps
};

struct StereoChoice : Choice {
    bool mixes = false;        // the colours of both eyes, for glasses of two colours
    int across = 1, down = 1;  // pictures of one eye beside and below each other
    ImU32 left_glass = 0, right_glass = 0;
};

struct ColourMapChoice : Choice {
    std::vector<ImU32> colours;  // at even places, from 0 to 1
};

template <typename Kind>
const Kind* find_choice(const std::vector<Kind>& list, std::string_view name)
{
    for (const Kind& choice : list)
        if (choice.name == name) return &choice;
    return nullptr;
}

}  // namespace fieldwright::ui
