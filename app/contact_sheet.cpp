// Pictures in a grid, and labels under them.
#include "app/contact_sheet.h"

#include "assets/lettering.h"
#include "ui/font_files.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::app {
namespace {

using renderer::Picture;

constexpr unsigned char paper = 24, ink = 225;

// Nearly square, wider than high.
int columns_for(std::size_t count) { return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))); }

unsigned char* pixel(Picture& picture, int x, int y)
{
    return &picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(x))];
}

void put(Picture& sheet, const Picture& view, int left, int top)
{
    for (int y = 0; y < view.height; ++y) {
        const unsigned char* row = &view.rgb[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width)];
        std::copy_n(row, 3 * view.width, pixel(sheet, left, top + y));
    }
}

// What does not fit into `width` is left out.
void write(Picture& sheet, const assets::Lettering& letters, int left, int top, int width)
{
    for (int y = 0; y < letters.height; ++y)
        for (int x = 0; x < std::min(letters.width, width); ++x) {
            int covered = letters.coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(letters.width) +
                                           static_cast<std::size_t>(x)];
            std::fill_n(pixel(sheet, left + x, top + y), 3,
                        static_cast<unsigned char>(paper + (ink - paper) * covered / 255));
        }
}

}  // namespace

Picture contact_sheet(const renderer::Frame& frame, int step_limit, renderer::Display display)
{
    const std::vector<std::string>& names = renderer::view_names();
    int letter_px = std::clamp(frame.height / 15, 11, 48), gap = letter_px;
    int columns = columns_for(names.size()), rows = (static_cast<int>(names.size()) + columns - 1) / columns;
    int label_height = assets::lettering("", letter_px, ui::inter_regular()).height + gap / 2;
    int across = frame.width + gap, down = frame.height + label_height + gap;
    Picture sheet{columns * across + gap, rows * down + gap};
    sheet.rgb.assign(3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), paper);
    for (std::size_t i = 0; i < names.size(); ++i) {
        int left = gap + static_cast<int>(i) % columns * across, top = gap + static_cast<int>(i) / columns * down;
        display.view = *renderer::view_from_name(names[i]);
        put(sheet, renderer::picture(frame, frame, display, step_limit), left, top);
        write(sheet, assets::lettering(renderer::kind_of(display.view).title, letter_px, ui::inter_regular()), left,
              top + frame.height + gap / 4, frame.width);
    }
    return sheet;
}

}  // namespace fieldwright::app
