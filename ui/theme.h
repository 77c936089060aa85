// Colours, sizes and fonts of the window: a calm dark instrument in which the picture is the brightest thing.
#pragma once

#include "graph/library.h"

#include <imgui.h>

#include <array>
#include <string_view>

namespace fieldwright::ui {

// sRGB, as drawn.
namespace colour {
constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255)
{
    return IM_COL32(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u, alpha);
}
inline constexpr ImU32 window = rgb(0x15171a), panel = rgb(0x1c1f24), field = rgb(0x262b32), line = rgb(0x333a44);
inline constexpr ImU32 text = rgb(0xd9dee6), quiet_text = rgb(0x8d97a6);
inline constexpr ImU32 accent = rgb(0x5aa9ff);  // selection, focus, primary action; nothing else
inline constexpr ImU32 chosen = rgb(0x3d4c5f);  // of several, where the accent would be too loud
inline constexpr ImU32 warning = rgb(0xe0a93e), error = rgb(0xef6b6b);
inline constexpr ImU32 node_body = rgb(0x20242a), canvas = rgb(0x17191d), grid = rgb(0x1f2329);

inline constexpr ImU32 axes[3] = {rgb(0xd9606a), rgb(0x7cab5e), rgb(0x5f8edb)};  // x, y, z
inline constexpr ImU32 hot = rgb(0xf2cf5b);                                      // the handle under the mouse
inline constexpr ImU32 veil = rgb(0x15171a, 200);                                // behind text over a picture

constexpr ImU32 with_alpha(ImU32 value, float alpha)
{
    return (value & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha * 255.0f + 0.5f) << IM_COL32_A_SHIFT;
}
}  // namespace colour

ImU32 category_colour(std::string_view category);  // of a node's header: one lightness and chroma, hue only
ImU32 socket_colour(graph::SocketKind kind);       // of sockets and the links between them

// Font sizes the canvas is drawn with, at scale 1, px; the smallest that is large enough is scaled down.
inline constexpr std::array<float, 8> canvas_font_sizes = {9, 12, 14, 16, 21, 28, 40, 60};

struct Fonts {
    ImFont* text = nullptr;     // Inter 16, with icons and digits of one width
    ImFont* heading = nullptr;  // Inter semi-bold 16, with icons
    ImFont* small = nullptr;    // Inter 14
    ImFont* mono = nullptr;     // JetBrains Mono 15
    std::array<ImFont*, canvas_font_sizes.size()> canvas{}, canvas_heading{};
};

// Space of one design, in px at the scale it was made for.
struct Theme {
    float scale = 1;  // of the display: 2 on HiDPI
    Fonts fonts;

    float px(float size) const { return size * scale; }  // design px to px
    float row() const { return px(24); }
    float gap() const { return px(4); }
    float padding() const { return px(8); }
    float menu_bar() const { return px(28); }
    float status_line() const { return px(22); }
};

// Fills the atlas of the current ImGui context and sets its style. Call between frames, when the scale changes.
Theme make_theme(float scale);
void set_style(float scale);  // of the current ImGui context; make_theme does it too

// The font for text `size_px` high on the canvas, and the scale to push with it.
struct SizedFont {
    ImFont* font;
    float scale;
};
SizedFont canvas_font(const Theme& theme, float size_px, bool heading = false);

}  // namespace fieldwright::ui
