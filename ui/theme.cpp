// Building the fonts and the style.
#include "ui/theme.h"

#include "ui/font_files.h"
#include "ui/letter_spacing.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace fieldwright::ui {
namespace {

constexpr ImWchar letters[] = {0x20,   0x17f,  0x2010, 0x2027, 0x2030, 0x203a, 0x20ac, 0x20ac, 0x2190, 0x21ff,
                               0x2200, 0x22ff, 0x25a0, 0x25ff, 0x2713, 0x2717, 0x370,  0x3ff,  0};
constexpr ImWchar icons[] = {0xf000, 0xf2e0, 0};

ImFont* add_font(std::span<const unsigned char> file, float size_px, const ImWchar* ranges, ImFontConfig config = {})
{
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = config.OversampleV = 1;
    config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    // Dear ImGui does not write to fonts it does not own.
    auto* data = const_cast<unsigned char*>(file.data());
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(file.size()), size_px, &config, ranges);
}

void merge_icons(float size_px)
{
    ImFontConfig config;
    config.MergeMode = true;
    config.PixelSnapH = true;
    config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = std::round(size_px * 1.125f);
    add_font(font_awesome(), std::round(size_px * 0.875f), icons, config);
}

ImFont* add_text(std::span<const unsigned char> file, float size_px)
{
    ImFont* font = add_font(file, size_px, letters);
    merge_icons(size_px);
    return font;
}

// A size is from ascender to descender: Inter's letters at 16 are those of 13 px in a browser.
Fonts add_fonts(float scale)
{
    Fonts fonts;
    fonts.text = add_text(inter_regular(), std::round(16 * scale));
    fonts.heading = add_text(inter_semibold(), std::round(16 * scale));
    fonts.small = add_text(inter_regular(), std::round(14 * scale));
    fonts.mono = add_font(jetbrains_mono(), std::round(15 * scale), letters);
    for (std::size_t i = 0; i < canvas_font_sizes.size(); ++i) {
        float size_px = std::round(canvas_font_sizes[i] * scale);
        fonts.canvas[i] = add_text(inter_regular(), size_px);
        fonts.canvas_heading[i] = add_text(inter_semibold(), size_px);
    }
    return fonts;
}

void space(const Fonts& fonts)
{
    for (ImFont* font : {fonts.text, fonts.small}) space_letters(*font, inter_regular());
    for (ImFont* font : fonts.canvas) space_letters(*font, inter_regular());
    for (ImFont* font : fonts.canvas_heading) space_letters(*font, inter_semibold());
    space_letters(*fonts.heading, inter_semibold());
    space_letters(*fonts.mono, jetbrains_mono());
}

ImVec4 vec4(ImU32 value) { return ImGui::ColorConvertU32ToFloat4(value); }

void set_colours(ImVec4* colours)
{
    using namespace colour;
    auto set = [&](std::initializer_list<ImGuiCol> places, ImU32 value) {
        for (ImGuiCol place : places) colours[place] = vec4(value);
    };
    constexpr ImU32 none = IM_COL32(0, 0, 0, 0), hover = rgb(0x2f353e), pressed = rgb(0x39414c);
    set({ImGuiCol_Text}, text);
    set({ImGuiCol_TextDisabled}, quiet_text);
    set({ImGuiCol_WindowBg, ImGuiCol_MenuBarBg}, window);
    set({ImGuiCol_ChildBg, ImGuiCol_BorderShadow, ImGuiCol_ScrollbarBg, ImGuiCol_TableRowBg}, none);
    set({ImGuiCol_PopupBg}, rgb(0x23272e));
    set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderStrong, ImGuiCol_TableBorderLight}, line);
    set({ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_TableHeaderBg}, field);
    set({ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered}, hover);
    set({ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive}, pressed);
    set({ImGuiCol_Header}, rgb(0x2a3038));
    set({ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed}, panel);
    set({ImGuiCol_ScrollbarGrab}, rgb(0x3a424d));
    set({ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive}, rgb(0x4a5461));
    set({ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_NavHighlight,
         ImGuiCol_DragDropTarget, ImGuiCol_SeparatorActive, ImGuiCol_ResizeGripActive, ImGuiCol_PlotHistogram},
        accent);
    set({ImGuiCol_SeparatorHovered, ImGuiCol_ResizeGripHovered}, rgb(0x4a5461));
    set({ImGuiCol_ResizeGrip}, none);
    set({ImGuiCol_Tab, ImGuiCol_TabUnfocused}, panel);
    set({ImGuiCol_TabHovered}, hover);
    set({ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive}, field);
    set({ImGuiCol_PlotLines}, accent);
    set({ImGuiCol_TextSelectedBg}, with_alpha(accent, 0.35f));
    set({ImGuiCol_ModalWindowDimBg, ImGuiCol_NavWindowingDimBg}, rgb(0x000000, 140));
}

// OKLCH to sRGB, for headers of one lightness and chroma (B. Ottosson, "A perceptual color space", 2020).
ImU32 oklch(float lightness, float chroma, float hue_deg)
{
    float hue = hue_deg * 3.14159265f / 180.0f, a = chroma * std::cos(hue), b = chroma * std::sin(hue);
    auto cube = [](float x) { return x * x * x; };
    float l = cube(lightness + 0.3963377774f * a + 0.2158037573f * b);
    float m = cube(lightness - 0.1055613458f * a - 0.0638541728f * b);
    float s = cube(lightness - 0.0894841775f * a - 1.2914855480f * b);
    auto encode = [](float x) {
        float c = std::clamp(x, 0.0f, 1.0f);
        float e = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
        return static_cast<unsigned>(std::lround(255.0f * e));
    };
    return IM_COL32(encode(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s),
                    encode(-1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s),
                    encode(-0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s), 255);
}

}  // namespace

ImU32 category_colour(std::string_view category)
{
    struct Hue {
        std::string_view category;
        float degrees;
    };
    constexpr Hue hues[] = {{"primitive", 195}, {"shape2d", 150}, {"convert", 115},  {"combine", 60}, {"domain", 255},
                            {"modify", 300},    {"material", 5},  {"light", 90},     {"camera", 225}, {"sky", 235},
                            {"output", 30},     {"group", 165},   {"my_groups", 165}};
    for (const Hue& hue : hues)
        if (hue.category == category) return oklch(0.46f, 0.075f, hue.degrees);
    return oklch(0.43f, 0.01f, 250);  // values, and what is unknown
}

ImU32 socket_colour(graph::SocketKind kind)
{
    using graph::SocketKind;
    switch (kind) {
        case SocketKind::field3d:
        case SocketKind::field_any: return oklch(0.76f, 0.11f, 195);
        case SocketKind::field2d: return oklch(0.76f, 0.11f, 150);
        case SocketKind::number: return oklch(0.72f, 0.01f, 250);
        case SocketKind::vec2:
        case SocketKind::vec3: return oklch(0.72f, 0.11f, 285);
        case SocketKind::colour: return oklch(0.82f, 0.12f, 95);
        case SocketKind::material: return oklch(0.70f, 0.13f, 5);
        case SocketKind::camera: return oklch(0.72f, 0.10f, 225);
        case SocketKind::sky: return oklch(0.75f, 0.09f, 240);
        case SocketKind::light: return oklch(0.85f, 0.12f, 90);
        case SocketKind::none: break;
    }
    return colour::quiet_text;
}

void set_style(float scale)
{
    ImGuiStyle style;
    style.WindowPadding = {8, 8};
    style.FramePadding = {8, 4};  // with Inter 16: rows of 24
    style.ItemSpacing = {8, 4};
    style.ItemInnerSpacing = {4, 4};
    style.CellPadding = {4, 2};
    style.IndentSpacing = 12;
    style.ScrollbarSize = 10;
    style.GrabMinSize = 8;
    style.WindowRounding = style.PopupRounding = 6;
    style.ChildRounding = 0;
    style.FrameRounding = style.GrabRounding = style.TabRounding = 4;
    style.ScrollbarRounding = 5;
    style.WindowBorderSize = style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = style.TabBorderSize = 0;
    style.WindowTitleAlign = {0, 0.5f};
    style.WindowMenuButtonPosition = ImGuiDir_None;
    style.DisabledAlpha = 0.45f;
    style.ScaleAllSizes(scale);
    set_colours(style.Colors);
    ImGui::GetStyle() = style;
}

Theme make_theme(float scale)
{
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    Theme theme;
    theme.scale = scale;
    theme.fonts = add_fonts(scale);
    atlas.Build();
    space(theme.fonts);
    ImGui::GetIO().FontDefault = theme.fonts.text;
    set_style(scale);
    return theme;
}

SizedFont canvas_font(const Theme& theme, float size_px, bool heading)
{
    const auto& fonts = heading ? theme.fonts.canvas_heading : theme.fonts.canvas;
    for (ImFont* font : fonts)
        if (font->FontSize >= size_px) return {font, size_px / font->FontSize};
    return {fonts.back(), size_px / fonts.back()->FontSize};
}

}  // namespace fieldwright::ui
