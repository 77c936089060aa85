// Drawing the active node: its parameters, help and problems.
#include "ui/inspector.h"

#include "ui/blend_plot.h"
#include "ui/node_words.h"
#include "ui/number_text.h"
#include "ui/parameter_rows.h"
#include "ui/scene_settings.h"
#include "ui/widgets.h"

#include "graph/own_type_edits.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

struct Badge {
    std::string word, meaning;
};

Badge badge_of(graph::Quality quality, float approximate_step)
{
    switch (quality) {
        case graph::Quality::exact: return {"exact", "The distance is right everywhere: rays take the longest steps."};
        case graph::Quality::bound:
            return {"bound", "The distance is never too long but may be too short: right picture, more steps."};
        case graph::Quality::approximate: break;
    }
    return {"approximate", "The distance may be too long; steps are shortened to " + number_text(approximate_step, 2) +
                               " of it to be safe."};
}

// A word on a tinted ground, ending `from_right` before the right of the row. Its width.
float badge(const FrameContext& frame, const char* name, const std::string& word, const std::string& tip,
            float from_right)
{
    const Theme& theme = frame.theme;
    ImGui::PushFont(theme.fonts.small);
    ImVec2 text = ImGui::CalcTextSize(word.c_str());
    ImVec2 size(text.x + theme.px(14), theme.px(18));
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - size.x - from_right);
    ImVec2 low = ImGui::GetCursorScreenPos();
    low.y += 0.5f * (theme.row() - size.y);
    ImGui::InvisibleButton(name, {size.x, theme.row()});
    frame.rects.mark(std::string("inspector/") + name);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, colour::field, 0.5f * size.y);
    draw.AddText({low.x + theme.px(7), low.y + std::floor(0.5f * (size.y - text.y))}, colour::text, word.c_str());
    ImGui::PopFont();
    tooltip(frame, tip);
    return size.x;
}

float quality_badge(const FrameContext& frame, const graph::NodeType& type)
{
    Badge outside = badge_of(type.quality_outside, type.approximate_step);
    std::string tip = "Outside: " + outside.meaning;
    if (type.quality_inside != type.quality_outside)
        tip += "\nInside, it is " + badge_of(type.quality_inside, type.approximate_step).word + ".";
    return badge(frame, "quality", outside.word, tip, 0);
}

void device_badge(const FrameContext& frame, float from_right)
{
    badge(frame, "gpu_only", "GPU only",
          "Its code is not compiled into the program: only the graphics card can run it, and the way rays take may "
          "be longer than it must be.",
          from_right);
}

void category_chip(const FrameContext& frame, std::string_view category)
{
    float side = frame.theme.row();
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("category", {side, side});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + side, low.y + side}, category_colour(category), frame.theme.px(5));
    const char* icon = category_icon(category);
    ImVec2 size = ImGui::CalcTextSize(icon);
    draw.AddText({std::floor(low.x + 0.5f * (side - size.x)), std::floor(low.y + 0.5f * (side - size.y))}, colour::text,
                 icon);
    tooltip(frame, category_title(category));
}

float room_for_badges(const FrameContext& frame, const graph::NodeType* type)
{
    if (!type) return 0;
    return frame.theme.px((type->is_field() ? 96.0f : 0.0f) + (type->compiled ? 0.0f : 80.0f));
}

void header(FrameContext& frame, const graph::Node& node, const graph::NodeType* type)
{
    const Theme& theme = frame.theme;
    category_chip(frame, type ? type->category : "unknown");
    ImGui::SameLine(0, theme.padding());
    ImGui::PushFont(theme.fonts.heading);
    ImGui::BeginDisabled(!type);
    node_name_field(frame, "inspector/name", node, row_field_width(frame) - theme.gap());
    ImGui::EndDisabled();
    ImGui::PopFont();
    to_row_end(frame);
    ImGui::BeginDisabled(!type);
    mute_button(frame, "inspector/mute", *frame.draft.document.root.find(node.id));
    ImGui::EndDisabled();
    bool own = graph::find_own_type(frame.draft.document, node.type);
    std::string words = type ? type->title : (own ? "Own type “" : "Unknown type “") + node.type + "”";
    if (std::string category = type ? category_title(type->category) : words; category != words)
        words += " · " + category;
    line_text(frame, words, colour::quiet_text,
              std::max(ImGui::GetContentRegionAvail().x - room_for_badges(frame, type), theme.px(40)));
    float used = type && type->is_field() ? quality_badge(frame, *type) + theme.gap() : 0;
    if (type && !type->compiled) device_badge(frame, used);
}

void problems(FrameContext& frame, graph::NodeId id)
{
    for (const graph::Problem& problem : frame.readings.problems) {
        if (problem.node != id) continue;
        bool error = problem.severity == graph::Problem::Severity::error;
        notice(frame, error ? icon::error : icon::info, error ? colour::error : colour::warning,
               as_sentence(problem.sentence));
    }
}

void help(FrameContext& frame, const graph::NodeType& type)
{
    ImGui::PushID("help");
    bool open = folding_section(frame, "Help");
    frame.rects.mark("inspector/help");
    ImGui::PopID();
    if (!open) return;
    paragraph(type.help);
    if (type.synonyms.empty()) return;
    std::string words = "Also found as ";
    for (const std::string& word : type.synonyms) words += (&word == &type.synonyms.front() ? "" : ", ") + word;
    paragraph(words + ".");
}

void unknown_type(FrameContext& frame)
{
    notice(frame, icon::question, colour::warning,
           "This version does not know the type. The node is kept unchanged and saved as it was read.");
    frame.rects.mark("inspector/unknown");
}

}  // namespace

void Inspector::active_node(FrameContext& frame, graph::NodeId id)
{
    graph::Document& document = frame.draft.document;
    const graph::Node& node = *document.root.find(id);
    const graph::NodeType* type = frame.draft.library.type(node.type);
    bool own = graph::find_own_type(document, node.type);
    if (std::size_t count = frame.view.selection.nodes().size(); count > 1) {
        line_text(frame, std::to_string(count) + " nodes selected; this is the active one", colour::quiet_text);
        frame.rects.mark("inspector/several");
    }
    header(frame, node, type);
    problems(frame, id);
    if (!type && !own) return unknown_type(frame);
    ImGui::Dummy({0, 0});
    if (type) parameter_rows(frame, "inspector", id);
    if (auto curve = frame.readings.blend_of ? frame.readings.blend_of(id) : std::nullopt)
        blend_plot(frame, "inspector/blend", *curve);
    if (type && has_inputs(*type)) {
        section(frame, "Inputs");
        input_rows(frame, "inspector", id);
    }
    if (own) own_type_.draw(frame, *document.root.find(id));
    if (type) help(frame, *type);
}

void Inspector::draw(FrameContext& frame)
{
    graph::NodeId id = frame.view.selection.active();
    const graph::Node* node = frame.draft.document.root.find(id);
    own_type_.leave_others(frame, node ? node->type : "");
    if (node) {
        active_node(frame, id);
        interface_.draw(frame);
        return;
    }
    if (!frame.draft.document.entered.empty()) return interface_.draw(frame);
    ImGui::PushFont(frame.theme.fonts.heading);
    line_text(frame, "Scene");
    ImGui::PopFont();
    paragraph("Click a node on the canvas, or a surface in the picture, to edit it here.");
    scene_settings(frame, "inspector/scene");
}

}  // namespace fieldwright::ui
