// A picture of numbers over numbers: a ground with a grid, and what is drawn on it in the units of its axes.
#pragma once

#include "ui/theme.h"

#include <imgui_internal.h>
#include <glm/glm.hpp>

#include <span>

namespace fieldwright::ui {

struct Plot {
    ImRect box;                       // px
    glm::vec2 low{0, 0}, high{1, 1};  // shown, of both axes

    ImVec2 place(glm::vec2 at) const;
    glm::vec2 at(ImVec2 place_px) const;
};

double grid_step(double span);  // 1, 2 or 5 times a power of ten: four to ten of it make the span

// The ground, lines at round numbers, the axes a little brighter.
void draw_grid(const Theme& theme, const Plot& plot);
void draw_grid_numbers(const Theme& theme, const Plot& plot);  // left of the box and below it
float grid_number_width(const Theme& theme);
void draw_line(const Theme& theme, const Plot& plot, std::span<const glm::vec2> points, ImU32 tint, float width = 1.5f);

}  // namespace fieldwright::ui
