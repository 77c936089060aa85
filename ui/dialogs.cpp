// Asking the questions.
#include "ui/dialogs.h"

#include "ui/dialog_frame.h"
#include "ui/glsl_highlight.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace fieldwright::ui {
namespace {

// A save that has not made the scene clean by then has failed or was cancelled.
constexpr int frames_for_saving = 10;
constexpr float recovery_buttons = 208;  // design px, with the space before them

const char* verb_for(const Request& request)
{
    if (std::holds_alternative<Quit>(request)) return "before closing";
    if (std::holds_alternative<NewScene>(request)) return "before starting a new scene";
    return "before opening another scene";
}

void wrapped_quiet(const std::string& text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, colour::quiet_text);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

// The texts, in colours.
void code_listing(FrameContext& frame)
{
    ImGui::PushFont(frame.theme.fonts.mono);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::window);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {frame.theme.padding(), frame.theme.padding()});
    ImGui::BeginChild("listing", {0, frame.theme.px(320)}, true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PopStyleVar();
    frame.rects.mark("dialog/code");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    for (const ForeignCode& code : frame.readings.foreign_code) glsl_text(code.text);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

bool asks_before_saving(const Readings& readings)
{
    return readings.changed_on_disk || !readings.overwrite_warning.empty();
}

}  // namespace

bool loses_changes(const Request& request)
{
    if (const auto* choose = std::get_if<ChooseFile>(&request)) return choose->then == ChooseFile::Then::open;
    return std::holds_alternative<NewScene>(request) || std::holds_alternative<OpenFile>(request) ||
           std::holds_alternative<OpenExample>(request) || std::holds_alternative<Recover>(request) ||
           std::holds_alternative<Quit>(request);
}

void Dialogs::hold_back(std::vector<Request>& requests, const Readings& readings, bool choosing_file)
{
    std::vector<Request> passed;
    for (Request& request : requests) hold_back(std::move(request), passed, readings);
    go_on_when_saved(passed, readings, choosing_file);
    requests = std::move(passed);
}

void Dialogs::hold_back(Request request, std::vector<Request>& passed, const Readings& readings)
{
    if (loses_changes(request)) {
        after_saving_.reset();  // the newer wish counts
        if (readings.dirty) {
            question_ = std::move(request);
            return;
        }
    }
    if (std::holds_alternative<SaveFile>(request) && asks_before_saving(readings)) {
        overwriting_ = true;
        return;
    }
    passed.push_back(std::move(request));
}

void Dialogs::go_on_when_saved(std::vector<Request>& passed, const Readings& readings, bool choosing_file)
{
    if (!after_saving_) return;
    if (!readings.dirty) {
        passed.push_back(*std::exchange(after_saving_, std::nullopt));
        return;
    }
    bool under_way = choosing_file || overwriting_ || readings.dialog_open;
    frames_since_saving_ = under_way ? 0 : frames_since_saving_ + 1;
    if (frames_since_saving_ > frames_for_saving) after_saving_.reset();
}

void Dialogs::draw(FrameContext& frame)
{
    draw_overwrite(frame);
    draw_unsaved(frame);
    draw_recovery(frame);
    draw_foreign_code(frame);
    draw_about(frame);
}

void Dialogs::save(FrameContext& frame)
{
    if (frame.readings.file_path.empty()) frame.requests.push_back(ChooseFile{ChooseFile::Then::save_as, {}});
    else if (asks_before_saving(frame.readings)) overwriting_ = true;
    else frame.requests.push_back(SaveFile{});
}

void Dialogs::draw_unsaved(FrameContext& frame)
{
    if (!begin_dialog("unsaved", question_ && !overwriting_, frame.theme, 440)) return;
    heading(frame.theme, "Save " + frame.readings.file_name + " " + verb_for(*question_) + "?");
    wrapped_quiet("What changed since it was saved last is lost otherwise.");
    ImGui::Dummy({0, frame.theme.gap()});
    int choice =
        button_row(frame, {{"Cancel", "dialog/cancel"}, {"Discard", "dialog/discard"}, {"Save", "dialog/save", true}});
    if (choice == 2 || confirmed_by_key()) {
        after_saving_ = std::exchange(question_, std::nullopt);
        frames_since_saving_ = 0;
        save(frame);
    } else if (choice == 1) frame.requests.push_back(*std::exchange(question_, std::nullopt));
    else if (choice == 0 || cancelled_by_key()) question_.reset();
    if (!question_) ImGui::CloseCurrentPopup();
    end_dialog();
}

void Dialogs::draw_overwrite(FrameContext& frame)
{
    if (!begin_dialog("overwrite", overwriting_, frame.theme, 440)) return;
    const Readings& readings = frame.readings;
    std::string what = readings.changed_on_disk ? "the other changes to " : "";
    heading(frame.theme, "Replace " + what + readings.file_name + "?");
    if (readings.changed_on_disk)
        wrapped_quiet("Another program wrote the file since it was opened here. Saving replaces what it wrote.");
    if (!readings.overwrite_warning.empty()) wrapped_quiet(readings.overwrite_warning);
    ImGui::Dummy({0, frame.theme.gap()});
    int choice = button_row(
        frame, {{"Cancel", "dialog/cancel"}, {"Save as…", "dialog/save_as"}, {"Replace", "dialog/replace", true}});
    bool cancelled = choice == 0 || cancelled_by_key();
    if (choice == 2 || confirmed_by_key()) frame.requests.push_back(SaveFile{});
    else if (choice == 1) frame.requests.push_back(ChooseFile{ChooseFile::Then::save_as, {}});
    else if (cancelled) after_saving_.reset();
    else {
        end_dialog();
        return;
    }
    overwriting_ = false;
    frames_since_saving_ = 0;
    ImGui::CloseCurrentPopup();
    end_dialog();
}

void Dialogs::draw_recovery(FrameContext& frame)
{
    bool wanted = !frame.readings.recovered.empty() && !recovery_put_off_ && !asking();
    if (!begin_dialog("recovery", wanted, frame.theme, 580)) return;
    heading(frame.theme, "Recover unsaved work?");
    wrapped_quiet("The program ended without saving. These copies were kept.");
    for (const Recovered& recovered : frame.readings.recovered) draw_recovered(frame, recovered);
    ImGui::Dummy({0, frame.theme.gap()});
    if (button_row(frame, {{"Decide later", "dialog/later"}}) == 0 || cancelled_by_key()) recovery_put_off_ = true;
    if (recovery_put_off_) ImGui::CloseCurrentPopup();
    end_dialog();
}

void Dialogs::draw_recovered(FrameContext& frame, const Recovered& recovered)
{
    ImGui::PushID(recovered.id.c_str());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {frame.theme.padding(), frame.theme.px(7)});  // as the buttons
    ImGui::AlignTextToFramePadding();
    ImGui::PopStyleVar();
    float room = ImGui::GetContentRegionAvail().x - frame.theme.px(recovery_buttons);
    float when = ImGui::CalcTextSize(recovered.when.c_str()).x + ImGui::GetStyle().ItemSpacing.x;
    ImGui::TextUnformatted(fitted(recovered.title, room - when).c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", recovered.when.c_str());
    ImGui::SameLine();
    std::string discard = "dialog/discard/" + recovered.id, recover = "dialog/recover/" + recovered.id;
    int choice = button_row(frame, {{"Discard", discard.c_str()}, {"Recover", recover.c_str()}});
    if (choice == 0) frame.requests.push_back(DiscardRecovered{recovered.id});
    if (choice == 1) {
        recovery_put_off_ = true;
        if (frame.readings.dirty) question_ = Recover{recovered.id};
        else frame.requests.push_back(Recover{recovered.id});
    }
    ImGui::PopID();
}

// Other code is another question.
void Dialogs::draw_foreign_code(FrameContext& frame)
{
    const Readings& readings = frame.readings;
    if (!readings.foreign_code.empty() && code_asked_ != readings.foreign_code) {
        code_asked_ = readings.foreign_code;
        code_put_off_ = code_shown_ = false;
    }
    bool recovering = !readings.recovered.empty() && !recovery_put_off_;
    bool wanted = !readings.foreign_code.empty() && !code_put_off_ && !asking() && !recovering;
    if (!begin_dialog("foreign_code", wanted, frame.theme, code_shown_ ? 720.0f : 480.0f)) return;
    std::size_t count = readings.foreign_code.size();
    heading(frame.theme, "Run the code of this scene?");
    wrapped_quiet("This scene brings its own shader code (" + std::to_string(count) +
                  (count == 1 ? " node type" : " node types") +
                  "). It runs on your graphics card, which bad code can slow down or stop. Until you run it, its nodes "
                  "count as unconnected.");
    if (code_shown_) code_listing(frame);
    ImGui::Dummy({0, frame.theme.gap()});
    int choice = button_row(frame, {{code_shown_ ? "Hide code" : "Show code", "dialog/show_code"},
                                    {"Not now", "dialog/not_now"},
                                    {"Run it", "dialog/run_code", true}});
    if (choice == 0) code_shown_ = !code_shown_;
    if (choice == 1 || cancelled_by_key()) code_put_off_ = true;
    if (choice == 2) {
        frame.requests.push_back(AllowSceneCode{});
        code_put_off_ = true;  // until there is other code
    }
    if (code_put_off_) ImGui::CloseCurrentPopup();
    end_dialog();
}

void Dialogs::draw_about(FrameContext& frame)
{
    if (!begin_dialog("about", about_ && !asking(), frame.theme, 400)) return;
    heading(frame.theme, "Fieldwright");
    wrapped_quiet(
        "A node-graph editor for signed distance fields: wire nodes, see the picture, take the shader with you.");
    if (!frame.readings.picture.device.empty())
        wrapped_quiet("Pictures are drawn by: " + frame.readings.picture.device);
    ImGui::Dummy({0, frame.theme.gap()});
    if (button_row(frame, {{"Close", "dialog/close", true}}) == 0 || confirmed_by_key() || cancelled_by_key()) {
        about_ = false;
        ImGui::CloseCurrentPopup();
    }
    end_dialog();
}

}  // namespace fieldwright::ui
