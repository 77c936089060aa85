// A row by the kind of its parameter; every change goes through graph::set_parameter.
#include "ui/parameter_rows.h"

#include "graph/contours.h"
#include "graph/groups.h"
#include "graph/known_types.h"
#include "graph/leader.h"
#include "ui/choice_field.h"
#include "ui/colour_field.h"
#include "ui/commands.h"
#include "ui/curve_field.h"
#include "ui/drawing_field.h"
#include "ui/font_menu.h"
#include "ui/group_interface.h"
#include "ui/node_geometry.h"
#include "ui/node_words.h"
#include "ui/number_field.h"
#include "ui/number_text.h"
#include "ui/points_field.h"
#include "ui/widgets.h"
#include "ui/words_field.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

using graph::Parameter;
using graph::ParameterKind;

constexpr std::string_view font_parameter = "font";

// One row being drawn.
struct Row {
    FrameContext& frame;
    std::string path;  // "inspector/radius"
    const graph::Node& node;
    const Parameter& parameter;
    std::string title;  // "Radius"
    float width_px = 0;

    const graph::Library& library() const { return frame.draft.library; }
    std::string words() const { return graph::inside_a_sentence(in_words(parameter.name)); }
    std::string step(std::string_view verb) const
    {
        return std::string(verb) + " " + graph::title_inside(node, library()) + " " + words();
    }
    void write(graph::Value value, std::string_view verb = "Change") const
    {
        std::string name = step(verb);  // before the document moves under `node`
        frame.draft.done(
            name, graph::set_parameter(frame.draft.document, library(), node.id, parameter.name, std::move(value)));
    }
    void mark(std::string_view part = {}) const
    {
        frame.rects.mark(part.empty() ? path : path + "/" + std::string(part));
    }
};

template <typename T>
T value_of(const Row& row)
{
    const graph::Value* value = row.node.parameter(row.parameter.name);
    const T* held = value ? std::get_if<T>(value) : nullptr;
    return held ? *held : T{};
}

std::string lower_title(const Row& row) { return title_of(row.node, row.library()) + "'s " + row.words(); }

void number_row(const Row& row)
{
    bool whole = row.parameter.kind == ParameterKind::integer;
    double value = whole ? value_of<int>(row) : static_cast<double>(value_of<float>(row));
    NumberStyle style = number_style(row.parameter);
    style.width_px = row.width_px;
    bool changed = number_field(row.frame, "##number", lower_title(row), value, style);
    row.mark();
    if (!changed) return;
    if (whole) row.write(static_cast<int>(value));
    else row.write(static_cast<float>(value));
}

void vector_row(const Row& row)
{
    bool flat = row.parameter.kind == ParameterKind::vec2;
    glm::vec3 value = flat ? glm::vec3(value_of<glm::vec2>(row), 0) : value_of<glm::vec3>(row);
    NumberStyle style = number_style(row.parameter);
    style.width_px = row.width_px;
    bool changed = vector_field(row.frame, row.path, lower_title(row), &value.x, flat ? 2 : 3, style);
    row.mark();
    if (!changed) return;
    if (flat) row.write(glm::vec2(value));
    else row.write(value);
}

void boolean_row(const Row& row)
{
    bool on = value_of<bool>(row);
    bool changed = toggle(row.frame, "toggle", on);
    row.mark();
    if (changed) row.write(on);
}

// The inputs are called as they are on the node.
std::string choice_words(const std::string& word)
{
    return word == "a" || word == "b" ? socket_label(nullptr, word) : in_words(word);
}

void choice_row(const Row& row)
{
    std::string current = value_of<std::string>(row);
    const auto& words = row.parameter.choices;
    auto label = [&](std::size_t i) { return std::pair(words[i], choice_words(words[i])); };
    if (auto chosen = choice_list(row.frame, row.path, row.width_px, choice_words(current), words.size(), label))
        row.write(words[*chosen]);
}

void colour_row(const Row& row)
{
    auto value = value_of<glm::vec3>(row);
    if (colour_field(row.frame, row.path, lower_title(row), value, row.width_px)) row.write(value);
}

// An unwired material: one of the document's can be taken.
void material_row(const Row& row)
{
    std::vector<const graph::Node*> materials;
    for (const graph::Node& node : row.frame.draft.document.root.nodes)
        if (const graph::NodeType* type = row.library().type(node.type);
            type && type->output == graph::SocketKind::material)
            materials.push_back(&node);
    auto label = [&](std::size_t i) {
        return std::pair(std::to_string(materials[i]->id.number), title_of(*materials[i], row.library()));
    };
    auto chosen = choice_list(row.frame, row.path, row.width_px,
                              materials.empty() ? "No materials yet" : "Choose a material", materials.size(), label);
    if (!chosen) return;
    std::string name = "Give " + graph::title_inside(row.node, row.library()) + " the material " +
                       graph::title_inside(*materials[*chosen], row.library());
    row.frame.draft.done(name, graph::connect(row.frame.draft.document, row.library(), materials[*chosen]->id,
                                              row.node.id, row.parameter.name));
}

void text_row(const Row& row)
{
    auto text = value_of<std::string>(row);
    bool has_menu = row.parameter.name == font_parameter && row.frame.readings.font_families;
    float button = has_menu ? row.frame.theme.row() : 0;
    bool changed = text_field(row.frame, "##text", text, row.width_px - button);
    row.mark();
    if (has_menu) {
        ImGui::SameLine(0, 0);
        if (auto chosen = font_menu(row.frame, row.path, text)) text = *chosen, changed = true;
    }
    if (changed) row.write(std::move(text));
}

// The file's name; a click chooses another.
void image_row(const Row& row)
{
    const Theme& theme = row.frame.theme;
    auto path = value_of<std::string>(row);
    std::string name = path.substr(path.find_last_of('/') + 1);
    ImVec2 low = ImGui::GetCursorScreenPos();
    bool pressed = ImGui::InvisibleButton("choose", {row.width_px, theme.row()});
    row.mark();
    bool hovered = ImGui::IsItemHovered();
    tooltip(row.frame, path.empty() ? "Choose a picture file" : path + "\nChoose another picture file");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + row.width_px, low.y + theme.row()},
                       ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), theme.px(4));
    float y = low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()));
    draw.AddText({low.x + theme.px(8), y}, colour::quiet_text, icon::folder);
    std::string words = fitted(path.empty() ? "Choose\u2026" : name, row.width_px - theme.px(36));
    draw.AddText({low.x + theme.px(28), y}, colour::text, words.c_str());
    if (pressed) row.frame.requests.push_back(ChooseFile{ChooseFile::Then::picture, {}, row.node.id});
}

bool is_drawing(const Parameter& parameter)
{
    return parameter.kind == ParameterKind::list && parameter.unit == graph::drawing_unit;
}

// Drawings are painted, and outlines made from a text.
bool has_table(const Parameter& parameter)
{
    bool outlines = parameter.unit == graph::contour_unit;
    return parameter.kind == ParameterKind::list && !outlines && !is_drawing(parameter);
}

void list_row(const Row& row)
{
    auto points = value_of<graph::PointList>(row);
    std::string count = std::to_string(points.size()) + (points.size() == 1 ? " point" : " points");
    line_text(row.frame, is_drawing(row.parameter) ? drawing_words(row.node, points) : count, colour::quiet_text,
              row.width_px);
    row.mark();
}

// Where a value comes from: a click selects that node.
void source_link(FrameContext& frame, const std::string& path, graph::NodeId source_id, float width_px)
{
    const graph::Library& library = frame.draft.library;
    const graph::Node* source = frame.draft.document.root.find(source_id);
    const graph::NodeType* type = source ? library.type(source->type) : nullptr;
    std::string title = source ? title_of(*source, library) : "a missing node";
    ImU32 tint = type ? socket_colour(type->output) : colour::quiet_text;
    ImVec2 low = ImGui::GetCursorScreenPos();
    bool pressed = ImGui::InvisibleButton("source", {width_px, frame.theme.row()});
    frame.rects.mark(path);
    bool hovered = ImGui::IsItemHovered();
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip(frame, "Select " + title);
    const Theme& theme = frame.theme;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + width_px, low.y + theme.row()},
                       ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg, 0.6f), theme.px(4));
    draw.AddCircleFilled({low.x + theme.px(12), low.y + 0.5f * theme.row()}, theme.px(4), tint);
    std::string words = fitted("from " + title, width_px - theme.px(28));
    draw.AddText({low.x + theme.px(22), low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()))}, colour::text,
                 words.c_str());
    if (pressed && source) frame.view.selection.only(source_id);
}

// What is wired to a socket. The icon after it takes the wire off.
void source_field(FrameContext& frame, const std::string& path, const graph::Node& node, std::string_view socket,
                  graph::NodeId source_id, float width_px)
{
    graph::Document& document = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    source_link(frame, path, source_id, width_px);
    to_row_end(frame);
    bool unwire = icon_button(frame, "unwire", icon::close, "Take this wire off");
    frame.rects.mark(path + "/unwire");
    if (!unwire) return;
    std::string step = "Unwire " + graph::title_inside(node, library) + " " +
                       graph::inside_a_sentence(socket_label(library.type(node.type), socket));
    frame.draft.done(step, graph::disconnect(document, node.id, socket));
}

void value_field(const Row& row)
{
    switch (row.parameter.kind) {
        case ParameterKind::number:
        case ParameterKind::angle:
        case ParameterKind::integer: return number_row(row);
        case ParameterKind::vec2:
        case ParameterKind::vec3:
        case ParameterKind::angles: return vector_row(row);
        case ParameterKind::boolean: return boolean_row(row);
        case ParameterKind::choice: return choice_row(row);
        case ParameterKind::colour: return colour_row(row);
        case ParameterKind::material: return material_row(row);
        case ParameterKind::list: return list_row(row);
        case ParameterKind::text: return text_row(row);
        case ParameterKind::image: return image_row(row);
        case ParameterKind::formula: break;  // needs more than its place in the row
    }
}

bool differs(const Row& row)
{
    const graph::Value* value = row.node.parameter(row.parameter.name);
    return value && *value != row.parameter.initial;
}

int component_count(ParameterKind kind)
{
    if (kind == ParameterKind::vec2 || kind == ParameterKind::list) return 2;
    return kind == ParameterKind::vec3 || kind == ParameterKind::angles ? 3 : 1;
}

// The unit too, where the fields do not show it.
std::string label_of(const FrameContext& frame, const Parameter& parameter)
{
    int count = component_count(parameter.kind);
    bool without_unit = count > 1 && !vector_is_stacked(frame.theme, count, usual_field_width(frame));
    if (parameter.kind == ParameterKind::list && !has_table(parameter)) without_unit = false;
    std::string unit = parameter.unit == "deg" ? "°" : parameter.unit;
    return in_words(parameter.name) + (without_unit && !unit.empty() ? " (" + unit + ")" : "");
}

void reset_button(const Row& row)
{
    if (!differs(row)) return;
    to_row_end(row.frame);
    if (icon_button(row.frame, "reset", icon::undo, "Reset to the default")) row.write(row.parameter.initial, "Reset");
    row.mark("reset");
}

// The formula has a line of its own: they are long.
void formula_row(const Row& row)
{
    const graph::NodeType& type = *row.library().type(row.node.type);
    line_text(row.frame, "of " + formula_name_list(type), colour::quiet_text, row.width_px);
    FormulaField field =
        formula_field(row.frame, row.path, type, value_of<std::string>(row), row_field_width(row.frame));
    tooltip(row.frame, formula_words(type));
    if (field.keep) row.write(field.shown);
    else reset_button(row);
    formula_complaint(row.frame, row.path, type, field.shown);
}

// What stands below the row of a list: its points, to be dragged, or its drawing.
void points_below(const Row& row)
{
    if (is_drawing(row.parameter)) return drawing_field(row.frame, row.path, row.node.id, row.parameter);
    if (!has_table(row.parameter)) return;
    auto points = value_of<graph::PointList>(row);
    bool is_curve = row.node.type == graph::known_types::curve;
    bool changed = is_curve ? curve_field(row.frame, row.path, row.node, row.parameter, points)
                            : points_field(row.frame, row.path, row.parameter, points);
    if (changed) row.write(std::move(points));
}

// The node that gives a parameter because this one follows it; null where the parameter is its own.
const graph::Node* leader_of(const FrameContext& frame, const graph::Node& node, const Parameter& parameter)
{
    const graph::Library& library = frame.draft.library;
    const graph::Node* leader = graph::leader_of(frame.draft.document.root, node, *library.type(node.type));
    const graph::NodeType* type = leader ? library.type(leader->type) : nullptr;
    return type && graph::is_led(node, parameter, *type) ? leader : nullptr;
}

void parameter_row(FrameContext& frame, std::string_view path, graph::NodeId id, const Parameter& parameter)
{
    const graph::Node* node = frame.draft.document.root.find(id);
    if (!node) return;
    Row row{frame, std::string(path) + "/" + parameter.name, *node, parameter, label_of(frame, parameter)};
    ImGui::PushID(parameter.name.c_str());
    ImVec2 low = ImGui::GetCursorScreenPos();
    const graph::Exposed* exposed = exposed_as(frame.draft, id, parameter.name);
    std::string tip = parameter_tip(parameter);
    if (exposed) {
        row.title = std::string(icon::link) + " " + row.title;
        tip += "\nExposed as “" + exposed->name + "”: this value is that of new nodes of the group.";
    }
    row.width_px = begin_row(frame, row.title, tip);
    if (graph::NodeId source = node->input(parameter.name)) {
        source_field(frame, row.path, *node, parameter.name, source, row.width_px);
    } else if (const graph::Node* leader = leader_of(frame, *node, parameter)) {
        source_link(frame, row.path, leader->id, row.width_px);
    } else if (parameter.kind == ParameterKind::formula) {
        formula_row(row);
    } else {
        value_field(row);
        reset_button(row);
        if (parameter.kind == ParameterKind::list) points_below(row);
    }
    expose_menu(frame, row.path, id, parameter.name, low);
    ImGui::PopID();
}

}  // namespace

void parameter_rows(FrameContext& frame, std::string_view path, graph::NodeId id)
{
    const graph::Node* node = frame.draft.document.root.find(id);
    const graph::NodeType* type = node ? frame.draft.library.type(node->type) : nullptr;
    if (!type) return;
    ImGui::PushID(static_cast<int>(id.number));
    for (const Parameter& parameter : type->parameters)
        if (!graph::ready_made(parameter.name).first) parameter_row(frame, path, id, parameter);
    ImGui::PopID();
}

bool has_inputs(const graph::NodeType& type)
{
    return std::any_of(type.inputs.begin(), type.inputs.end(),
                       [&](const graph::Socket& socket) { return !type.parameter(socket.name); });
}

void input_rows(FrameContext& frame, std::string_view path, graph::NodeId id)
{
    const graph::Node* node = frame.draft.document.root.find(id);
    const graph::NodeType* type = node ? frame.draft.library.type(node->type) : nullptr;
    if (!type) return;
    ImGui::PushID(static_cast<int>(id.number));
    InputRows rows(*node, type);
    for (std::size_t row = 0; row < rows.count(); ++row) {
        const graph::Socket& socket = type->inputs[rows.input(row)];
        if (type->parameter(socket.name)) continue;
        ImGui::PushID(socket.name.c_str());
        ImVec2 low = ImGui::GetCursorScreenPos();
        float width = begin_row(frame, socket_label(type, socket.name), socket_hint(type, socket.name));
        std::string name = std::string(path) + "/input/" + socket.name;
        if (graph::NodeId source = node->input(socket.name)) {
            source_field(frame, name, *node, socket.name, source, width);
        } else {
            line_text(frame, "nothing wired", colour::quiet_text, width);
            frame.rects.mark(name);
        }
        expose_menu(frame, name, id, socket.name, low);
        ImGui::PopID();
        node = frame.draft.document.root.find(id);
    }
    ImGui::PopID();
}

void node_name_field(FrameContext& frame, std::string_view path, const graph::Node& node, float width_px)
{
    const graph::NodeType* type = frame.draft.library.type(node.type);
    std::string name = node.name, before = graph::title_inside(node, frame.draft.library);
    ImGui::PushID(static_cast<int>(node.id.number));
    bool changed = name_field(frame, "##name", name, type ? type->title : node.type, width_px);
    ImGui::PopID();
    frame.rects.mark(path);
    if (changed) frame.draft.done("Rename " + before, graph::rename_node(frame.draft.document, node.id, name));
}

void mute_button(FrameContext& frame, std::string_view path, const graph::Node& node)
{
    const char* shown = node.muted ? icon::eye_off : icon::eye;
    std::string tip = node.muted ? "Muted: click to unmute"
                                 : with_shortcut("Mute: the scene is drawn without this node", "edit.mute");
    bool pressed = icon_button(frame, "mute", shown, tip, node.muted ? colour::warning : colour::quiet_text);
    frame.rects.mark(path);
    if (!pressed) return;
    std::string step = (node.muted ? "Unmute " : "Mute ") + graph::title_inside(node, frame.draft.library);
    frame.draft.done(step, graph::set_muted(frame.draft.document, node.id, !node.muted));
}

}  // namespace fieldwright::ui
