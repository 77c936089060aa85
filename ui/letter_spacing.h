// How far apart letters stand: as their font says, in whole pixels where they are large enough; digits share one width.
#pragma once

#include <imgui.h>

#include <span>

namespace fieldwright::ui {

// Dear ImGui's FreeType builder rounds every advance up, which sets small text wide and uneven. Sets those of the
// letters that `font`, already built, took from `file`; icons merged into it keep theirs.
void space_letters(ImFont& font, std::span<const unsigned char> file);

}  // namespace fieldwright::ui
