// Stereo: red-cyan pictures for two eyes.
#include "ui/number_field.h"
#include "ui/panel_pages.h"
#include "ui/widgets.h"

namespace fieldwright::ui {
namespace {

std::string_view meaning_of(std::string_view mode)
{
    if (mode == "off") return "One eye: an ordinary picture.";
    if (mode == "naive")
        return "Left eye in red, right eye in green and blue. Strong colours flicker between the eyes.";
    if (mode == "dubois")
        return "Colours mixed so that each filter passes as little as possible of the other eye's picture.";
    return "";
}

void glasses(const FrameContext& frame)
{
    const Theme& theme = frame.theme;
    begin_row(frame, "Glasses");
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 lens(theme.px(26), theme.px(16));
    float y = low.y + 0.5f * (theme.row() - lens.y), second = low.x + lens.x + theme.px(6);
    draw.AddRectFilled({low.x, y}, {low.x + lens.x, y + lens.y}, colour::rgb(0xd9483b), theme.px(5));
    draw.AddRectFilled({second, y}, {second + lens.x, y + lens.y}, colour::rgb(0x35b6c4), theme.px(5));
    draw.AddLine({low.x + lens.x, y + 0.4f * lens.y}, {second, y + 0.4f * lens.y}, colour::quiet_text, theme.px(1.5f));
    ImGui::Dummy({2 * lens.x + theme.px(14), theme.row()});
    ImGui::SameLine(0, 0);
    line_text(frame, "red left, cyan right", colour::quiet_text);
}

}  // namespace

void draw_stereo_panel(FrameContext& frame)
{
    ViewState& view = frame.view;
    std::vector<std::pair<std::string, std::string>> modes;
    for (const std::string& name : frame.readings.stereo_names) modes.emplace_back(name, in_words(name));
    begin_row(frame, "Mode", "How the pictures of both eyes become one.");
    segments(frame, "panel/stereo", modes, view.stereo);
    to_field_column(frame);
    paragraph(meaning_of(view.stereo));
    if (view.stereo != "off") glasses(frame);
    ImGui::Dummy({0, frame.theme.gap()});

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
    paragraph("These belong to the view, not to the scene: they are not undone and not saved with it.");
}

}  // namespace fieldwright::ui
