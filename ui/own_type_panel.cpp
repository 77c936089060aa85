// Writing a node's code.
#include "ui/own_type_panel.h"

#include "ui/node_words.h"
#include "ui/widgets.h"

#include "graph/own_type_edits.h"

#include <imgui_stdlib.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr float least_lines = 12, most_lines = 26;

constexpr const char* grammar_help =
    "The first line reads “// Title: what it is.” A function that ends in _distance makes a shape (it takes p) or "
    "changes one (it takes d, or a and b); _point moves the points at which the input is read; _value gives a number; "
    "_material a material. Shapes have a line “// field: exact”, “bound” or “approximate 0.7”, and a function "
    "_bounds.\n"
    "An argument with a comment is a parameter and a socket: default, [least, most], unit, two spaces, help. The names "
    "p, d, a, b, time and cell are given. Numbers end in f; loops run between whole numbers.";

// What the node is called in the names of steps.
std::string title_of_type(const graph::Library& library, const std::string& name)
{
    const graph::NodeType* type = library.type(name);
    return type ? type->title : graph::in_words(name);
}

const graph::TextError* error_of(const FrameContext& frame, const std::string& type)
{
    const graph::TextError* error = frame.draft.library.left_out(type);
    return error && !error->waiting ? error : nullptr;
}

}  // namespace

void OwnTypePanel::leave_others(FrameContext& frame, std::string_view type)
{
    if (unapplied_ && type_ != type) apply(frame);
}

void OwnTypePanel::take_text(const graph::OwnType& type)
{
    if (type_ == type.name && (unapplied_ || text_ == type.text)) return;
    type_ = name_ = type.name;
    text_ = type.text;
    unapplied_ = false;
}

void OwnTypePanel::apply(FrameContext& frame)
{
    unapplied_ = false;
    Draft& draft = frame.draft;
    const graph::OwnType* type = graph::find_own_type(draft.document, type_);
    if (!type || type->text == text_) return;
    if (!draft.done("Edit the code of " + title_of_type(draft.library, type_),
                    graph::set_own_type_text(draft.document, type_, text_)))
        return;
    draft.step_ends = true;
    frame.requests.push_back(TrustCode{text_, type_});
}

void OwnTypePanel::draw(FrameContext& frame, const graph::Node& node)
{
    const graph::OwnType* type = graph::find_own_type(frame.draft.document, node.type);
    if (!type) return;
    take_text(*type);
    section(frame, "Code");
    code(frame);
    name_row(frame);
    actions(frame, node.id);
    ImGui::PushID("grammar");
    if (folding_section(frame, "How to write it")) paragraph(grammar_help);
    ImGui::PopID();
}

void OwnTypePanel::code(FrameContext& frame)
{
    auto lines = static_cast<float>(std::count(text_.begin(), text_.end(), '\n') + 2);
    float height = (std::clamp(lines, least_lines, most_lines)) * frame.theme.fonts.mono->FontSize + frame.theme.px(16);
    // While the text goes on, the mark of an older one would be at another line.
    const graph::TextError* error = unapplied_ ? nullptr : error_of(frame, type_);
    CodeField::Outcome outcome = field_.draw(frame, "inspector/code", text_, error ? error->line : 0, height);
    if (outcome.edited) {
        unapplied_ = true;
        typed_at_s_ = ImGui::GetTime();
    }
    if (unapplied_ && (outcome.left || ImGui::GetTime() - typed_at_s_ >= rest_s)) apply(frame);
}

void OwnTypePanel::name_row(FrameContext& frame)
{
    Draft& draft = frame.draft;
    ImGui::SetNextItemWidth(
        begin_row(frame, "Type name", "What scene files call it; its functions' names begin with it"));
    {
        RowPadding padding(frame.theme);
        ImGui::InputText("##type_name", &name_, ImGuiInputTextFlags_CharsNoBlank);
    }
    frame.rects.mark("inspector/type_name");
    if (!ImGui::IsItemDeactivatedAfterEdit() || name_ == type_) return;
    if (unapplied_) apply(frame);
    std::string step = "Rename the type " + type_ + " to " + name_;
    if (!draft.done(step, graph::rename_own_type(draft.document, draft.library, type_, name_))) name_ = type_;
}

void OwnTypePanel::actions(FrameContext& frame, graph::NodeId node)
{
    Draft& draft = frame.draft;
    if (!graph::find_own_type(draft.document, type_)) return;  // just renamed
    if (std::size_t uses = graph::uses_of_own_type(draft.document, type_); uses > 1) {
        paragraph(std::to_string(uses) + " nodes share this code.");
        bool pressed = text_button(frame, "single", std::string(icon::copy) + "  Own copy for this node");
        frame.rects.mark("inspector/code/single");
        if (pressed) {
            std::string step = "Own code for " + graph::title_of(*draft.document.root.find(node), draft.library);
            draft.done(step, graph::make_type_single(draft.document, draft.library, node));
        }
        ImGui::SameLine(0, frame.theme.gap());
    }
    ImGui::BeginDisabled(unapplied_ || error_of(frame, type_));
    if (text_button(frame, "keep", std::string(icon::save) + "  Save as my node"))
        frame.requests.push_back(SaveOwnNode{type_});
    ImGui::EndDisabled();
    frame.rects.mark("inspector/code/save");
    tooltip(frame, "Puts the code into your folder of nodes, for every scene of yours");
}

}  // namespace fieldwright::ui
