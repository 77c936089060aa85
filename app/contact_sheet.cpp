// Pictures in a grid, and under each its name and, where its colours mean numbers, a legend.
#include "app/contact_sheet.h"

#include "assets/lettering.h"
#include "ui/font_files.h"
#include "ui/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace fieldwright::app {
namespace {

using assets::Lettering;
using renderer::Display;
using renderer::Frame;
using renderer::Picture;
using renderer::View;

constexpr unsigned char paper = 24, ink = 225, quiet_ink = 150;
constexpr float half_bright_m = 5;  // the depth that view_depth of the shading library shows half as bright as nearness

// What stands under the bar: at its ends, and between them.
struct Legend {
    std::string low, middle, high;
    bool marks_exhausted = false;  // magenta: out of steps
};

std::optional<Legend> legend_of(const Display& display, int step_limit)
{
    const renderer::ViewKind& kind = renderer::kind_of(display.view);
    if (kind.scale_title)
        return Legend{"0", kind.scale_title, ui::scale_text(renderer::scale_end(display, step_limit)),
                      display.view == View::steps};
    if (display.view == View::depth) return Legend{"0 m", ui::scale_text(half_bright_m) + " m", "far"};
    if (display.view == View::shadow) return Legend{"0", "Share of the lights", "1"};
    if (display.view == View::occlusion) return Legend{"0", "Open to the sky", "1"};
    return std::nullopt;
}

// The numbers from one end of the view's scale to the other, in one row of pixels: its picture is the legend's bar.
Frame ramp(int width, float end)
{
    Frame frame(width, 1, true);
    for (int x = 0; x < width; ++x) {
        auto at = static_cast<std::size_t>(x);
        float share = static_cast<float>(x) / static_cast<float>(std::max(width - 1, 1)), number = share * end;
        frame.steps[at] = frame.layers->shadow_steps[at] = static_cast<int>(std::lround(number));
        frame.layers->minimum_cone_ratio[at] = frame.layers->gradient_length[at] = number;
        frame.layers->shadow[at] = frame.layers->occlusion[at] = share;
        frame.depth[at] = half_bright_m * share / (1 - share);  // inf at the end
    }
    return frame;
}

Lettering letters(std::string_view text, int size_px) { return assets::lettering(text, size_px, ui::inter_regular()); }

struct Tile {
    Picture picture, bar;  // the bar has no pixels where there is no legend
    std::optional<Legend> legend;
    Lettering title;
};

// Lengths in pixels; all follow from the size of the pictures.
struct Measures {
    int letter, small_letter, gap, line, small_line, bar, cell;

    explicit Measures(const Frame& frame)
        : letter(std::clamp(frame.height / 15, 11, 48)),
          small_letter(std::max(letter * 4 / 5, 10)),
          gap(letter),
          line(letters("", letter).height),
          small_line(letters("", small_letter).height),
          bar(std::max(letter / 2, 6)),
          cell(frame.width)
    {
    }
    int label() const { return gap / 4 + line; }
    int legend() const { return gap / 2 + bar + gap / 4 + small_line; }
    // No word is cut: narrow pictures stand apart.
    void make_room(const Tile& tile)
    {
        int width = tile.title.width;
        if (tile.legend && tile.legend->marks_exhausted) width += gap + exhausted_mark().width + small_line;
        if (tile.legend) {
            auto small = [&](const std::string& text) { return letters(text, small_letter).width; };
            int side = std::max(small(tile.legend->low), small(tile.legend->high));
            width = std::max(width, small(tile.legend->middle) + 2 * (side + gap / 2));
        }
        cell = std::max(cell, width);
    }
    Lettering exhausted_mark() const { return letters("Out of steps", small_letter); }
};

class Sheet {
public:
    Sheet(int width, int height) : picture_{width, height}
    {
        picture_.rgb.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), paper);
    }
    Picture& picture() { return picture_; }

    void put(const Picture& part, int left, int top)
    {
        for (int y = 0; y < part.height; ++y)
            std::copy_n(&part.rgb[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(part.width)],
                        3 * part.width, pixel(left, top + y));
    }
    void write(const Lettering& text, int left, int top, unsigned char colour)
    {
        for (int y = 0; y < text.height; ++y)
            for (int x = 0; x < text.width; ++x) {
                int covered = text.coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(text.width) +
                                            static_cast<std::size_t>(x)];
                std::fill_n(pixel(left + x, top + y), 3,
                            static_cast<unsigned char>(paper + (colour - paper) * covered / 255));
            }
    }
    void fill(int left, int top, int size, std::array<unsigned char, 3> colour)
    {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) std::copy(colour.begin(), colour.end(), pixel(left + x, top + y));
    }

private:
    unsigned char* pixel(int x, int y)
    {
        return &picture_.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                                  static_cast<std::size_t>(x))];
    }

    Picture picture_;
};

void draw_exhausted_mark(Sheet& sheet, const Measures& measures, int left, int top)
{
    Lettering words = measures.exhausted_mark();
    int square = measures.small_letter * 3 / 4, at = left + measures.cell - words.width;
    int lowered = (measures.line - measures.small_line) / 2;
    sheet.write(words, at, top + lowered, quiet_ink);
    sheet.fill(at - square - measures.small_letter / 3, top + (measures.line - square) / 2, square, {255, 0, 255});
}

void draw_legend(Sheet& sheet, const Tile& tile, const Measures& measures, int left, int top)
{
    for (int y = 0; y < measures.bar; ++y) sheet.put(tile.bar, left, top + y);
    top += measures.bar + measures.gap / 4;
    auto write = [&](const std::string& text, int share) {
        Lettering words = letters(text, measures.small_letter);
        sheet.write(words, left + share * (measures.cell - words.width) / 2, top, quiet_ink);
    };
    write(tile.legend->low, 0), write(tile.legend->middle, 1), write(tile.legend->high, 2);
}

void draw_tile(Sheet& sheet, const Tile& tile, const Measures& measures, int left, int top)
{
    sheet.put(tile.picture, left, top);
    top += tile.picture.height + measures.gap / 4;
    sheet.write(tile.title, left, top, ink);
    if (!tile.legend) return;
    if (tile.legend->marks_exhausted) draw_exhausted_mark(sheet, measures, left, top);
    draw_legend(sheet, tile, measures, left, top + measures.line + measures.gap / 4);
}

std::vector<Tile> tiles_of(const Frame& frame, int step_limit, Display display, Measures& measures)
{
    std::vector<Tile> tiles;
    for (const std::string& name : renderer::view_names()) {
        display.view = *renderer::view_from_name(name);
        Tile& tile = tiles.emplace_back();
        tile.picture = renderer::picture(frame, frame, display, step_limit);
        tile.title = letters(renderer::kind_of(display.view).title, measures.letter);
        tile.legend = legend_of(display, step_limit);
        measures.make_room(tile);
    }
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (!tiles[i].legend) continue;
        display.view = *renderer::view_from_name(renderer::view_names()[i]);
        Frame numbers = ramp(measures.cell, renderer::scale_end(display, step_limit));
        tiles[i].bar = renderer::picture(numbers, numbers, display, step_limit);
    }
    return tiles;
}

// Of rows of so many tiles, from the top: a row is higher where one of its tiles has a legend.
std::vector<int> row_heights(const std::vector<Tile>& tiles, int columns, const Measures& measures)
{
    std::vector<int> heights;
    for (std::size_t first = 0; first < tiles.size(); first += static_cast<std::size_t>(columns)) {
        std::span<const Tile> row(&tiles[first], std::min(tiles.size() - first, static_cast<std::size_t>(columns)));
        bool has_legend = std::any_of(row.begin(), row.end(), [](const Tile& tile) { return tile.legend.has_value(); });
        heights.push_back(row[0].picture.height + measures.label() + (has_legend ? measures.legend() : 0));
    }
    return heights;
}

// Nearly square, wider than high.
int columns_for(std::size_t count) { return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))); }

}  // namespace

Picture contact_sheet(const Frame& frame, int step_limit, const Display& display)
{
    Measures measures(frame);
    std::vector<Tile> tiles = tiles_of(frame, step_limit, display, measures);
    int columns = columns_for(tiles.size()), gap = measures.gap, top = gap;
    std::vector<int> heights = row_heights(tiles, columns, measures);
    int height = gap;
    for (int row : heights) height += row + gap;
    Sheet sheet(columns * (measures.cell + gap) + gap, height);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        int column = static_cast<int>(i) % columns;
        if (i > 0 && column == 0) top += heights[i / static_cast<std::size_t>(columns) - 1] + gap;
        draw_tile(sheet, tiles[i], measures, gap + column * (measures.cell + gap), top);
    }
    return std::move(sheet.picture());
}

}  // namespace fieldwright::app
