// Browsing folders and choosing a file.
#include "ui/file_browser.h"

#include "ui/dialog_frame.h"
#include "ui/keys.h"
#include "ui/picture_formats.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

namespace fs = std::filesystem;
using Then = ChooseFile::Then;

constexpr float format_width = 84;  // design px

struct Purpose {
    const char *title, *verb, *suffix;
};

Purpose purpose(Then then)
{
    switch (then) {
        case Then::open: return {"Open a scene", "Open", ".scene.json"};
        case Then::save_as: return {"Save the scene as", "Save", ".scene.json"};
        case Then::export_shader: return {"Export the shader to", "Export", ".glsl"};
        case Then::export_picture: return {"Export the picture to", "Export", "picture"};
        case Then::picture: return {"Choose a picture", "Choose", "picture"};
    }
    return {"", "", ""};
}

std::vector<std::string> suffixes(Then then)
{
    if (then == Then::picture) return {".png", ".jpg", ".jpeg", ".hdr", ".exr", ".tif", ".tiff"};
    if (then != Then::export_picture) return {purpose(then).suffix};
    std::vector<std::string> ends;
    for (const PictureFormat& format : picture_formats())
        ends.insert(ends.end(), format.suffixes.begin(), format.suffixes.end());
    return ends;
}

Request request_for(const ChooseFile& what, std::string path)
{
    switch (what.then) {
        case Then::open: return OpenFile{std::move(path)};
        case Then::save_as: return SaveFileAs{std::move(path)};
        case Then::export_shader: return ExportFile{std::move(path), what.target};
        case Then::picture: return UsePicture{std::move(path), what.node};
        case Then::export_picture: break;
    }
    return ExportPicture{std::move(path)};
}

bool icon_button(FrameContext& frame, const char* sign, const char* mark, const char* tip)
{
    ImGui::PushID(mark);
    bool clicked = ImGui::Button(sign, {frame.theme.px(28), 0});
    ImGui::PopID();
    frame.rects.mark(mark);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
    return clicked;
}

}  // namespace

void FileBrowser::open(ChooseFile what, const std::string& folder, std::string name)
{
    what_ = std::move(what);
    open_ = appearing_ = true;
    all_files_ = naming_folder_ = false;
    name_ = std::move(name);
    replace_.clear();
    go_to(existing_folder(folder.empty() ? home_folder() : fs::path(folder)));
}

void FileBrowser::go_to(const fs::path& folder)
{
    folder_ = folder;
    path_text_ = folder.string();
    naming_folder_ = false;
    highlighted_ = -1;
    scroll_ = true;
    if (!saving()) name_.clear();
    refresh();
}

void FileBrowser::refresh()
{
    listing_ = list_folder(folder_, all_files_ ? std::vector<std::string>() : suffixes(what_.then));
    error_ = listing_.error;
}

void FileBrowser::go_up()
{
    std::string from = folder_.filename().string();
    go_to(folder_.parent_path());
    for (std::size_t i = 0; i < listing_.entries.size(); ++i)
        if (listing_.entries[i] == FolderEntry{from, true}) highlighted_ = static_cast<int>(i);
}

void FileBrowser::draw(FrameContext& frame, bool shown)
{
    if (!begin_dialog("files", open_ && shown, frame.theme, 640, 520)) return;
    bool was_typing = ImGui::GetIO().WantTextInput;
    heading(frame.theme, purpose(what_.then).title);
    draw_path_row(frame);
    if (naming_folder_) draw_new_folder(frame);
    draw_entries(frame);
    draw_name(frame);
    draw_buttons(frame);
    if (!was_typing && !appearing_) use_keys();
    bool entered = !was_typing && confirmed_by_key() && !appearing_;
    if (entered && highlighted_ >= 0) enter(static_cast<std::size_t>(highlighted_), frame);
    else if (entered) accept(frame);
    if (cancelled_by_key() && !std::exchange(naming_folder_, false)) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    appearing_ = false;
    end_dialog();
}

void FileBrowser::draw_path_row(FrameContext& frame)
{
    float buttons = 3 * (frame.theme.px(28) + ImGui::GetStyle().ItemSpacing.x);
    if (icon_button(frame, icon::arrow_up, "browser/up", "Go to the folder above (Backspace)")) go_up();
    ImGui::SameLine();
    if (icon_button(frame, icon::home, "browser/home", "Go to your home folder")) go_to(home_folder());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttons / 3);
    if (ImGui::InputText("##path", &path_text_, ImGuiInputTextFlags_EnterReturnsTrue)) type_path();
    frame.rects.mark("browser/path");
    ImGui::SameLine();
    if (icon_button(frame, icon::add, "browser/new_folder", "Make a folder here")) {
        naming_folder_ = naming_begins_ = true;
        new_folder_.clear();
    }
}

void FileBrowser::type_path()
{
    fs::path typed = folder_ / path_text_;
    std::error_code error;
    if (fs::is_directory(typed, error)) {
        go_to(existing_folder(typed));
        return;
    }
    if (!fs::is_directory(typed.parent_path(), error)) {
        error_ = "There is no folder " + typed.parent_path().string() + ".";
        return;
    }
    std::string name = typed.filename().string();
    go_to(existing_folder(typed.parent_path()));
    name_ = name;
}

void FileBrowser::draw_new_folder(FrameContext& frame)
{
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Folder name");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - frame.theme.px(96));
    if (std::exchange(naming_begins_, false)) frame.focus_next_text();
    bool made = ImGui::InputText("##new folder", &new_folder_, ImGuiInputTextFlags_EnterReturnsTrue);
    frame.rects.mark("browser/folder_name");
    ImGui::SameLine();
    made = ImGui::Button("Make", {-1, 0}) || made;
    frame.rects.mark("browser/make_folder");
    if (!made || new_folder_.empty()) return;
    fs::path folder = folder_ / new_folder_;
    error_ = make_folder(folder);
    if (error_.empty()) go_to(folder);
}

void FileBrowser::draw_entries(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    // The name, the line for errors, the buttons, and the space above each.
    float below =
        ImGui::GetFrameHeight() + ImGui::GetTextLineHeight() + theme.px(28) + 3 * ImGui::GetStyle().ItemSpacing.y;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::panel);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(4));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(4), theme.px(4)});
    ImGui::BeginChild("entries", {0, -below}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(listing_.entries.size()), theme.row());
    std::size_t entered = listing_.entries.size();
    if (scroll_ && highlighted_ >= 0)
        ImGui::SetScrollY(
            std::max(0.0f, static_cast<float>(highlighted_) * theme.row() - ImGui::GetWindowHeight() / 2));
    scroll_ = false;
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            draw_entry(frame, static_cast<std::size_t>(i));
            if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) entered = static_cast<std::size_t>(i);
        }
    if (listing_.entries.empty() && listing_.error.empty())
        ImGui::TextDisabled("  No folders and no %s files here.", all_files_ ? "other" : purpose(what_.then).suffix);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    if (entered < listing_.entries.size()) enter(entered, frame);
}

void FileBrowser::draw_entry(FrameContext& frame, std::size_t index)
{
    const Theme& theme = frame.theme;
    const FolderEntry& entry = listing_.entries[index];
    ImVec2 at = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, theme.row());
    ImGui::PushID(static_cast<int>(index));
    if (ImGui::InvisibleButton("entry", size)) pick(index);
    ImGui::PopID();
    frame.rects.mark("browser/file/" + entry.name);
    bool highlighted = static_cast<int>(index) == highlighted_;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (highlighted || ImGui::IsItemHovered())
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y},
                           ImGui::GetColorU32(highlighted ? ImGuiCol_HeaderActive : ImGuiCol_Header), theme.px(4));
    float y = at.y + std::floor((theme.row() - ImGui::GetTextLineHeight()) / 2), right = at.x + size.x - theme.px(8);
    list.AddText({at.x + theme.px(8), y}, colour::quiet_text, entry.is_folder ? icon::folder : icon::file);
    ImGui::RenderTextEllipsis(&list, {at.x + theme.px(32), y}, {right, y + theme.row()}, right, right,
                              entry.name.c_str(), nullptr, nullptr);
}

void FileBrowser::draw_name(FrameContext& frame)
{
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("File name");
    ImGui::SameLine();
    bool has_formats = what_.then == Then::export_picture;
    float formats = has_formats ? frame.theme.px(format_width) + ImGui::GetStyle().ItemSpacing.x : 1;
    ImGui::SetNextItemWidth(-formats);
    if (appearing_ && saving()) frame.focus_next_text();
    bool entered = ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
    frame.rects.mark("browser/name");
    bool renamed = ImGui::IsItemEdited();
    if (has_formats) {
        ImGui::SameLine();
        renamed = picture_format_field(frame, "browser/format", name_) || renamed;
    }
    if (renamed) {
        replace_.clear();
        highlighted_ = -1;
        error_ = listing_.error;
    }
    if (entered) accept(frame);
}

void FileBrowser::draw_buttons(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    bool asks = !replace_.empty();
    std::string line = asks ? replace_ + " is there already." : error_;
    ImGui::PushStyleColor(ImGuiCol_Text, asks ? colour::warning : colour::error);
    ImVec2 at = ImGui::GetCursorScreenPos();
    float right = at.x + ImGui::GetContentRegionAvail().x;
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, {right, at.y + theme.row()}, right, right, line.c_str(),
                              nullptr, nullptr);
    ImGui::PopStyleColor();
    if (!line.empty()) frame.rects.mark("browser/error", {{at.x, at.y}, {right, at.y + theme.row()}});
    ImGui::Dummy({0, ImGui::GetTextLineHeight()});
    float y = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(y + (theme.px(28) - ImGui::GetFrameHeight()) / 2);
    if (ImGui::Checkbox("All files", &all_files_)) refresh();
    frame.rects.mark("browser/all_files");
    ImGui::SameLine();
    ImGui::SetCursorPosY(y);
    int choice = button_row(
        frame, {{"Cancel", "browser/cancel"}, {asks ? "Replace" : purpose(what_.then).verb, "browser/accept", true}});
    if (choice == 0) open_ = false;
    if (choice == 1) accept(frame);
}

void FileBrowser::use_keys()
{
    int last = static_cast<int>(listing_.entries.size()) - 1, before = highlighted_;
    if (ImGui::IsKeyPressed(key::down)) highlighted_ = std::min(highlighted_ + 1, last);
    if (ImGui::IsKeyPressed(key::up)) highlighted_ = std::max(highlighted_ - 1, std::min(0, last));
    if (highlighted_ != before && highlighted_ >= 0) {
        pick(static_cast<std::size_t>(highlighted_));
        scroll_ = true;
    }
    if (ImGui::IsKeyPressed(key::backspace, false)) go_up();
}

void FileBrowser::pick(std::size_t index)
{
    highlighted_ = static_cast<int>(index);
    replace_.clear();
    if (!listing_.entries[index].is_folder) name_ = listing_.entries[index].name;
}

void FileBrowser::enter(std::size_t index, FrameContext& frame)
{
    FolderEntry entry = listing_.entries[index];
    if (entry.is_folder) {
        go_to(folder_ / entry.name);
        return;
    }
    name_ = entry.name;
    accept(frame);
}

fs::path FileBrowser::chosen_path() const
{
    std::string name = name_;
    if (what_.then == Then::export_picture) return folder_ / complete_picture_name(name);
    std::string suffix = purpose(what_.then).suffix;
    bool complete = name.ends_with(suffix) || (suffix == ".scene.json" && name.ends_with(".json"));
    if (saving() && !complete) name += suffix;
    return folder_ / name;
}

std::string FileBrowser::refusal_of(const fs::path& path) const
{
    std::error_code error;
    std::string name = path.filename().string();
    if (!saving()) return fs::exists(path, error) ? "" : "There is no file " + name + " here.";
    if (what_.then == Then::export_picture && !picture_format_of(name)) return picture_name_error(name) + ".";
    if (!fs::is_directory(path.parent_path(), error)) return "There is no folder " + path.parent_path().string() + ".";
    return {};
}

void FileBrowser::accept(FrameContext& frame)
{
    std::error_code error;
    if (name_.empty()) {
        error_ = saving() ? "Type a name for the file." : "Choose a file, or type its name.";
        return;
    }
    if (fs::path typed = folder_ / name_; fs::is_directory(typed, error)) {
        go_to(existing_folder(typed));
        return;
    }
    fs::path path = chosen_path();
    if (error_ = refusal_of(path); !error_.empty()) return;
    if (saving() && fs::exists(path, error) && replace_ != path.filename().string()) {
        replace_ = path.filename().string();
        return;
    }
    open_ = false;
    frame.requests.push_back(request_for(what_, path.lexically_normal().string()));
}

}  // namespace fieldwright::ui
