// Rows of march and occlusion settings, from the table of their ranges.
#include "ui/scene_settings.h"

#include "graph/settings.h"
#include "ui/number_field.h"
#include "ui/widgets.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

struct Words {
    std::string_view name, unit, help;
    double soft_minimum, soft_maximum;
};

constexpr Words words[] = {
    {"step_limit", "", "Most steps that a ray takes. More reaches farther into grazing angles and costs time.", 16,
     512},
    {"minimum_step", "m", "Shortest step; longer is faster and may pass through thin things.", 0, 0.01},
    {"tolerance", "m", "How near to a surface a ray counts as arrived; smaller shows finer detail.", 0, 0.01},
    {"near", "m", "Where along the ray the scene begins.", 0, 1},
    {"far", "m", "Where along the ray the scene ends.", 1, 500},
    {"strength", "", "How dark corners get where little of the sky is seen; 0 is off.", 0, 1},
    {"radius", "m", "How far above a surface other things darken it.", 0.01, 5}};

const Words& words_of(std::string_view name)
{
    return *std::find_if(std::begin(words), std::end(words) - 1, [&](const Words& w) { return w.name == name; });
}

NumberStyle style_of(std::string_view name, double minimum, double maximum)
{
    const Words& entry = words_of(name);
    return {.minimum = minimum,
            .maximum = maximum,
            .soft_minimum = std::max(entry.soft_minimum, minimum),
            .soft_maximum = entry.soft_maximum,
            .unit = std::string(entry.unit),
            .tip = std::string(entry.help)};
}

// Draws one row; true when the value changed, and `verb` says how.
bool setting_row(FrameContext& frame, std::string_view path, std::string_view name, double& value, double initial,
                 NumberStyle style, std::string& step)
{
    std::string title = in_words(name), mark = std::string(path) + "/" + std::string(name);
    ImGui::PushID(mark.c_str());
    style.width_px = begin_row(frame, title, style.tip);
    bool changed = number_field(frame, "##number", title, value, style);
    frame.rects.mark(mark);
    std::string words_of_step = graph::inside_a_sentence(title);
    if (changed) step = "Change " + words_of_step;
    if (value != initial) {
        to_row_end(frame);
        if (icon_button(frame, "reset", icon::undo, "Reset to the default")) {
            value = initial;
            step = "Reset " + words_of_step;
            changed = true;
        }
        frame.rects.mark(mark + "/reset");
    }
    ImGui::PopID();
    return changed;
}

template <typename Settings, typename Numbers>
bool number_rows(FrameContext& frame, std::string_view path, const Numbers& numbers, Settings& settings,
                 std::string& step)
{
    const Settings initial;
    bool changed = false;
    for (const auto& number : numbers) {
        double value = settings.*number.member;
        if (!setting_row(frame, path, number.name, value, initial.*number.member,
                         style_of(number.name, number.minimum, number.maximum), step))
            continue;
        settings.*number.member = std::clamp(static_cast<float>(value), number.minimum, number.maximum);
        changed = true;
    }
    return changed;
}

bool march_rows(FrameContext& frame, std::string_view path, graph::MarchSettings& march, std::string& step)
{
    NumberStyle style = style_of("step_limit", 1, graph::step_limit_maximum);
    style.whole = true;
    double limit = march.step_limit;
    bool changed = setting_row(frame, path, "step_limit", limit, graph::MarchSettings{}.step_limit, style, step);
    march.step_limit = static_cast<int>(limit);
    changed |= number_rows(frame, path, graph::march_numbers, march, step);
    begin_row(frame, "Out of steps", "What a ray that ran out of steps shows: the sky, or the place where it stopped.");
    std::string outcome = march.out_of_steps_hits ? "hit" : "miss";
    std::string mark = std::string(path) + "/out_of_steps";
    if (segments(frame, mark, {{"miss", "Sky"}, {"hit", "Surface"}}, outcome)) {
        march.out_of_steps_hits = outcome == "hit";
        step = "Change out of steps";
        changed = true;
    }
    return changed;
}

}  // namespace

void scene_settings(FrameContext& frame, std::string_view path)
{
    std::string step;
    section(frame, "Ray marching");
    graph::MarchSettings march = frame.draft.document.march;
    if (march_rows(frame, path, march, step)) frame.draft.done(step, graph::set_march(frame.draft.document, march));
    section(frame, "Occlusion");
    graph::OcclusionSettings occlusion = frame.draft.document.occlusion;
    if (number_rows(frame, path, graph::occlusion_numbers, occlusion, step))
        frame.draft.done(step, graph::set_occlusion(frame.draft.document, occlusion));
}

}  // namespace fieldwright::ui
