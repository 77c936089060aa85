// Stereo: pictures for two eyes, and how comfortable they are.
#include "ui/choice_field.h"
#include "ui/number_field.h"
#include "ui/number_text.h"
#include "ui/panel_pages.h"
#include "ui/stereo_comfort.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float meter_end = 0.05f;  // of the picture's width, either side of the screen

void glasses(const FrameContext& frame, const StereoChoice& mode)
{
    const Theme& theme = frame.theme;
    begin_row(frame, "Glasses");
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 lens(theme.px(26), theme.px(16));
    float y = low.y + 0.5f * (theme.row() - lens.y), second = low.x + lens.x + theme.px(6);
    ImU32 left = colour::with_alpha(mode.left_glass, 0.8f), right = colour::with_alpha(mode.right_glass, 0.8f);
    draw.AddRectFilled({low.x, y}, {low.x + lens.x, y + lens.y}, left, theme.px(5));
    draw.AddRectFilled({second, y}, {second + lens.x, y + lens.y}, right, theme.px(5));
    draw.AddLine({low.x + lens.x, y + 0.4f * lens.y}, {second, y + 0.4f * lens.y}, colour::quiet_text, theme.px(1.5f));
    ImGui::Dummy({2 * lens.x + theme.px(14), theme.row()});
    ImGui::SameLine(0, 0);
    line_text(frame, "left and right eye", colour::quiet_text);
}

void mode_rows(FrameContext& frame)
{
    ViewState& view = frame.view;
    float width = begin_row(frame, "Mode", "How the pictures of both eyes become one.");
    choice_field(frame, "panel/stereo/mode", width, frame.readings.stereo_modes, view.stereo);
    const StereoChoice* mode = find_choice(frame.readings.stereo_modes, view.stereo);
    if (!mode) return;
    to_field_column(frame);
    paragraph(mode->help);
    if (!mode->mixes) return;
    glasses(frame, *mode);
    begin_row(frame, "Mixed in",
              "Light is what the glasses filter. Most players mix the stored values of the picture files instead.");
    std::string space = view.eyes.linear ? "linear" : "gamma";
    if (segments(frame, "panel/stereo/space", {{"linear", "Light"}, {"gamma", "Stored values"}}, space))
        view.eyes.linear = space == "linear";
}

void switch_row(FrameContext& frame, const char* label, const char* name, const char* tip, bool& on)
{
    begin_row(frame, label, tip);
    toggle(frame, name, on);
    frame.rects.mark(std::string("panel/stereo/") + name);
}

void eye_rows(FrameContext& frame)
{
    ViewState& view = frame.view;
    NumberStyle apart{.minimum = 0,
                      .maximum = 10000,
                      .soft_minimum = 0,
                      .soft_maximum = 200,
                      .unit = "mm",
                      .tip = "Distance between the two eyes. People have about 65 mm; small scenes want less."};
    double interaxial_mm = 1000.0 * static_cast<double>(view.interaxial);
    apart.width_px = begin_row(frame, "Interaxial", apart.tip);
    if (number_field(frame, "##interaxial", "Interaxial", interaxial_mm, apart))
        view.interaxial = static_cast<float>(interaxial_mm / 1000);
    frame.rects.mark("panel/stereo/interaxial");

    NumberStyle away{
        .minimum = 0.01,
        .maximum = 10000,
        .soft_minimum = 0.1,
        .soft_maximum = 30,
        .unit = "m",
        .tip = "Distance that appears to lie in the screen: nearer things stand out, farther ones lie behind."};
    double convergence = view.convergence;
    away.width_px = begin_row(frame, "Convergence", away.tip);
    if (number_field(frame, "##convergence", "Convergence", convergence, away))
        view.convergence = static_cast<float>(convergence);
    frame.rects.mark("panel/stereo/convergence");
    to_row_end(frame);
    bool picking = view.click == Click::converge;
    if (icon_button(frame, "converge", icon::crosshair, "Converge on what is clicked in the picture",
                    colour::quiet_text, picking))
        view.click = picking ? Click::select : Click::converge;
    frame.rects.mark("panel/stereo/converge");

    switch_row(frame, "Swap eyes", "swap", "Gives each eye the other one's picture.", view.eyes.swap);
    begin_row(frame, "Cameras",
              "Off-axis cameras look in one direction and shift the picture. Toed-in ones turn towards each other, as "
              "on a tripod, which moves corners up and down between the eyes: tiring, and only for comparison.");
    std::string cameras = view.eyes.toe_in ? "toe_in" : "off_axis";
    if (segments(frame, "panel/stereo/cameras", {{"off_axis", "Off-axis"}, {"toe_in", "Toe-in"}}, cameras))
        view.eyes.toe_in = cameras == "toe_in";
}

void comparison_rows(FrameContext& frame)
{
    const StereoChoice* mode = find_choice(frame.readings.stereo_modes, frame.view.stereo);
    if (!mode || !mode->mixes) return;
    StereoView& eyes = frame.view.eyes;
    switch_row(frame, "Compare", "split", "Shows the plain anaglyph left of a divider that can be dragged.",
               eyes.split);
    switch_row(frame, "Mark fights", "rivalry",
               "Draws stripes over colours that are bright for one eye and dark for the other: those flicker.",
               eyes.rivalry);
    if (std::optional<double> share = frame.readings.picture.fighting_share)
        fact_row(frame, "Eyes fight", "over " + percent_text(*share) + " of the picture");
}

void screen_rows(FrameContext& frame)
{
    StereoView& eyes = frame.view.eyes;
    auto row = [&](const char* label, const char* name, const char* tip, float& metres, double soft_maximum) {
        NumberStyle style{.minimum = 0.05,
                          .maximum = 100,
                          .soft_minimum = 0.1,
                          .soft_maximum = soft_maximum,
                          .unit = "m",
                          .tip = tip};
        double value = metres;
        style.width_px = begin_row(frame, label, tip);
        if (number_field(frame, (std::string("##") + name).c_str(), label, value, style))
            metres = static_cast<float>(value);
        frame.rects.mark(std::string("panel/stereo/") + name);
    };
    row("Screen width", "screen_width", "Of the screen, or the part of it, that shows the picture.", eyes.screen_width,
        2);
    row("Seen from", "viewing_distance", "The way from the eyes to the screen.", eyes.viewing_distance, 5);
}

ImU32 tint_of(Comfort comfort)
{
    return comfort == Comfort::good     ? colour::rgb(0x6fae7d)
           : comfort == Comfort::strong ? colour::warning
                                        : colour::error;
}

// "8.2 mm behind the screen, 0.67°, 1.4 %"
std::string parallax_text(const Parallax& parallax)
{
    std::string where = parallax.share < 0 ? " in front" : " behind";
    return rounded_text(std::abs(parallax.mm)) + " mm" + where + " · " + rounded_text(std::abs(parallax.degrees)) +
           "° · " + percent_text(std::abs(static_cast<double>(parallax.share)));
}

// The screen in the middle, what is in front of it left, what is behind it right.
void draw_meter(const FrameContext& frame, const Parallax& nearest, const Parallax& farthest)
{
    const Theme& theme = frame.theme;
    to_field_column(frame);
    ImVec2 low = ImGui::GetCursorScreenPos(), size(row_field_width(frame), theme.px(16));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    auto x = [&](float share) { return low.x + size.x * (0.5f + 0.5f * std::clamp(share / meter_end, -1.0f, 1.0f)); };
    auto zone = [&](float from, float to, ImU32 tint) {
        draw.AddRectFilled({x(from), low.y}, {x(to), low.y + size.y}, colour::with_alpha(tint, 0.28f));
    };
    zone(-meter_end, -0.04f, colour::error), zone(0.04f, meter_end, colour::error);
    zone(-0.04f, -0.02f, colour::warning), zone(0.02f, 0.04f, colour::warning);
    zone(-0.02f, 0.02f, tint_of(Comfort::good));
    draw.AddLine({x(0), low.y}, {x(0), low.y + size.y}, colour::quiet_text, theme.px(1));
    float bar = theme.px(5), middle = low.y + 0.5f * size.y;
    draw.AddRectFilled({x(nearest.share), middle - 0.5f * bar}, {x(farthest.share), middle + 0.5f * bar}, colour::text,
                       theme.px(2));
    for (const Parallax* end : {&nearest, &farthest})
        draw.AddCircleFilled({x(end->share), middle}, theme.px(4.5f), tint_of(comfort_of(*end)));
    ImGui::Dummy(size);
    frame.rects.mark("panel/stereo/meter");
}

std::string_view advice(Comfort nearest, Comfort farthest)
{
    if (nearest == Comfort::painful || farthest == Comfort::painful)
        return "Too strong for most eyes: move the eyes closer together.";
    if (nearest == Comfort::strong || farthest == Comfort::strong)
        return "Strong: good for a moment, tiring for longer.";
    return "Comfortable to look at.";
}

void comfort_meter(FrameContext& frame)
{
    std::optional<DepthRange> range = frame.readings.depth_range ? frame.readings.depth_range() : std::nullopt;
    std::optional<SeenWidth> width = seen_width(frame);
    if (!range || !width) {
        paragraph(!width ? "The camera is moved by wires, so that nothing can be said about it here."
                         : "Nothing is in the picture whose distance could be judged.");
        return;
    }
    Eyes eyes{frame.view.interaxial, frame.view.convergence};
    auto seen = [&](float depth) { return parallax_on(frame.view.eyes, parallax_share(eyes, *width, depth)); };
    Parallax nearest = seen(range->near), farthest = seen(range->far);
    draw_meter(frame, nearest, farthest);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.theme.padding(), 0));
    fact_row(frame, "Nearest", parallax_text(nearest),
             "At " + rounded_text(range->near) + " m: how far apart the eyes' pictures of it are on the screen.");
    fact_row(frame, "Farthest", parallax_text(farthest),
             "At " + rounded_text(range->far) + " m: how far apart the eyes' pictures of it are on the screen.");
    ImGui::PopStyleVar();
    to_field_column(frame);
    Comfort worst = std::max(comfort_of(nearest), comfort_of(farthest));
    paragraph(advice(comfort_of(nearest), comfort_of(farthest)),
              worst == Comfort::good ? colour::quiet_text : tint_of(worst));
}

}  // namespace

void draw_stereo_panel(FrameContext& frame)
{
    mode_rows(frame);
    ImGui::Dummy({0, frame.theme.gap()});
    eye_rows(frame);
    comparison_rows(frame);
    section(frame, "Comfort");
    screen_rows(frame);
    comfort_meter(frame);
    to_field_column(frame);
    if (text_button(frame, "automatic", "Set eyes for comfort")) set_comfortable_eyes(frame);
    frame.rects.mark("panel/stereo/automatic");
    ImGui::Dummy({0, frame.theme.gap()});
    paragraph("These belong to the view, not to the scene: they are not undone and not saved with it.");
}

}  // namespace fieldwright::ui
