// What the window asked for: files, exports, history, recovery.
#include "app/workbench.h"

#include "app/user_nodes.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "graph/scene_file.h"
#include "ui/picture_formats.h"

#include <ctime>

namespace fieldwright::app {
namespace {

const char* dialog_title(ui::ChooseFile::Then then)
{
    switch (then) {
        case ui::ChooseFile::Then::open: return "Open scene";
        case ui::ChooseFile::Then::save_as: return "Save scene as";
        case ui::ChooseFile::Then::export_shader: return "Export shader";
        case ui::ChooseFile::Then::export_picture: return "Export picture";
        case ui::ChooseFile::Then::picture: return "Choose a picture";
    }
    return "";
}

std::string picture_patterns()
{
    std::string patterns;
    for (const ui::PictureFormat& format : ui::picture_formats())
        for (std::string_view end : format.suffixes) patterns += (patterns.empty() ? "*" : " *") + std::string(end);
    return patterns;
}

std::string time_text(const char* format, std::time_t time)
{
    std::tm local{};
    localtime_r(&time, &local);
    char text[64];
    std::strftime(text, sizeof text, format, &local);
    return text;
}

}  // namespace

void Workbench::perform(const ui::Request& request)
{
    auto restored = [&](bool done) {
        if (done) lower_scene();
    };
    if (std::holds_alternative<ui::NewScene>(request)) leave_view(), session_.new_scene(), scene_replaced();
    if (auto* file = std::get_if<ui::OpenFile>(&request)) open(file->path);
    if (auto* example = std::get_if<ui::OpenExample>(&request)) open_example(example->name);
    if (std::holds_alternative<ui::SaveFile>(request)) save(std::nullopt);
    if (auto* file = std::get_if<ui::SaveFileAs>(&request)) save(file->path);
    if (auto* shader = std::get_if<ui::ExportFile>(&request)) export_shader(*shader);
    if (auto* picture = std::get_if<ui::ExportPicture>(&request)) export_picture(picture->path);
    if (auto* picture = std::get_if<ui::UsePicture>(&request)) use_picture(*picture);
    if (auto* choice = std::get_if<ui::ChooseFile>(&request)) choose(*choice);
    if (auto* group = std::get_if<ui::SaveGroup>(&request)) save_group(*group);
    if (std::holds_alternative<ui::ForgetRecent>(request)) attempt([&] { recent_.clear(); });
    if (std::holds_alternative<ui::Undo>(request)) restored(session_.undo());
    if (std::holds_alternative<ui::Redo>(request)) restored(session_.redo());
    if (auto* jump = std::get_if<ui::JumpTo>(&request)) restored(session_.jump(jump->step));
    if (auto* wanted = std::get_if<ui::Recover>(&request)) recover(wanted->id);
    if (auto* unwanted = std::get_if<ui::DiscardRecovered>(&request)) discard_recovered(unwanted->id);
    if (auto* written = std::get_if<ui::TrustCode>(&request)) trust({{written->type, written->text}});
    if (std::holds_alternative<ui::AllowSceneCode>(request)) trust(review_.foreign(session_.document()));
    if (auto* node = std::get_if<ui::SaveOwnNode>(&request)) save_own_node(node->type);
    if (std::holds_alternative<ui::MeasureNodes>(request)) measure_nodes();
    if (auto* ray = std::get_if<ui::InspectRay>(&request)) inspect_ray(*ray);
    if (std::holds_alternative<ui::Quit>(request)) quit_ = true;
}

void Workbench::trust(const std::vector<graph::OwnType>& types)
{
    attempt([&] { review_.trust(types); });
    session_.judge_again();
    lower_scene();
    touch();
}

void Workbench::save_own_node(const std::string& name)
{
    attempt([&] {
        const graph::NodeType* type = session_.library()->type(name);
        if (!type || type->origin != graph::Origin::document) return;
        if (!user_nodes_)
            throw graph::Failure(5, "there is no home folder to keep nodes in; set HOME to an absolute path");
        say("Saved " + save_user_node(*user_nodes_, *type).filename().string() + " to your nodes");
    });
}

void Workbench::save_group(const ui::SaveGroup& request)
{
    attempt([&] {
        bool replaced = groups_.save(request.name, request.text);
        say((replaced ? "Saved the group over the one in your library: " : "Saved to your library: ") + request.name);
    });
    list_groups();
}

void Workbench::list_groups()
{
    std::string failure;
    readings_.saved_groups = groups_.read(*session_.library(), failure);
    if (!failure.empty()) say(failure, true);
}

void Workbench::list_recoverable()
{
    readings_.recovered.clear();
    for (const Recovery& recovery : autosave_.recoverable())
        readings_.recovered.push_back({recovery.id, recovery.title, time_text("%d %B, %H:%M", recovery.time_s)});
}

void Workbench::recover(const std::string& id)
{
    for (const Recovery& recovery : autosave_.recoverable())
        if (recovery.id == id && attempt([&] { autosave_.recover(recovery, session_); })) scene_replaced();
    list_recoverable();
}

void Workbench::discard_recovered(const std::string& id)
{
    for (const Recovery& recovery : autosave_.recoverable())
        if (recovery.id == id) attempt([&] { autosave_.discard(recovery); });
    list_recoverable();
}

void Workbench::choose(const ui::ChooseFile& request)
{
    using Then = ui::ChooseFile::Then;
    dialog_request_ = request;
    DialogRequest dialog;
    bool opens = request.then == Then::open || request.then == Then::picture;
    dialog.kind = opens ? DialogRequest::Kind::open : DialogRequest::Kind::save;
    dialog.title = dialog_title(request.then);
    dialog.folder = session_.path() ? session_.path()->parent_path() : std::filesystem::current_path();
    std::string stem = session_.path() ? session_.path()->stem().stem().string() : "untitled";
    if (request.then == Then::save_as) dialog.name = stem + ".scene.json";
    if (request.then == Then::export_shader)
        dialog.name = stem + ".glsl", dialog.filter = "Shader", dialog.pattern = "*.glsl";
    if (request.then == Then::export_picture)
        dialog.name = stem + ".png", dialog.filter = "Pictures", dialog.pattern = picture_patterns();
    if (request.then == Then::picture)
        dialog.filter = "Pictures", dialog.pattern = "*.png *.jpg *.jpeg *.hdr *.exr *.tif *.tiff";
    dialog_.start(dialog);
}

void Workbench::answer_dialog()
{
    if (!dialog_request_) return;
    DialogAnswer answer = dialog_.poll();
    if (answer.state == DialogAnswer::State::pending) return;
    ui::ChooseFile request = *std::exchange(dialog_request_, std::nullopt);
    touch();
    if (answer.state == DialogAnswer::State::path) chosen(request, answer.path);
    if (answer.state == DialogAnswer::State::unavailable) {
        std::filesystem::path folder =
            session_.path() ? session_.path()->parent_path() : std::filesystem::current_path();
        std::string stem = session_.path() ? session_.path()->stem().stem().string() : "untitled";
        editor_.browse(request, folder.string(), stem);
    }
}

void Workbench::chosen(const ui::ChooseFile& request, const std::filesystem::path& path)
{
    switch (request.then) {
        case ui::ChooseFile::Then::open: editor_.ask(ui::OpenFile{path.string()}); break;
        case ui::ChooseFile::Then::save_as: save(path); break;
        case ui::ChooseFile::Then::export_shader: export_shader({path.string(), request.target}); break;
        case ui::ChooseFile::Then::export_picture: export_picture(path); break;
        case ui::ChooseFile::Then::picture: use_picture({path.string(), request.node}); break;
    }
}

void Workbench::open(const std::filesystem::path& path)
{
    leave_view();
    if (!attempt([&] { session_.open(path); })) return;
    attempt([&] { recent_.add(*session_.path()); });
    scene_replaced();
    say_opened();
}

void Workbench::say_opened()
{
    say("Opened " + session_.name() +
        (session_.laid_out() ? "; its nodes lay on one another and were laid out side by side" : ""));
}

void Workbench::open_example(const std::string& name)
{
    for (const Example& example : examples()) {
        if (example.file.name != name) continue;
        leave_view();
        if (!attempt([&] { session_.new_scene(example_scene(example.file, *session_.library())); })) return;
        scene_replaced();
        return say("Opened the example " + example.title);
    }
}

void Workbench::save(const std::optional<std::filesystem::path>& path)
{
    if (!attempt([&] { path ? session_.save_as(*path) : session_.save(); })) return;
    attempt([&] { recent_.add(*session_.path()); });
    say("Saved " + session_.name() + " at " + time_text("%H:%M:%S", std::time(nullptr)));
}

void Workbench::export_shader(const ui::ExportFile& request)
{
    if (std::string refusal = codegen::export_refusal(*scene_.program()); !refusal.empty())
        return say("Not exported: " + refusal, true);
    attempt([&] {
        std::vector<float> block = field::evaluate_frame(*scene_.program(), static_cast<float>(editor_.view.time_s));
        graph::save_atomically(request.path,
                               codegen::print_export(*scene_.program(), session_.document(), block, request.target));
        say("Exported " + std::filesystem::path(request.path).filename().string());
    });
}

// Written once what it needs is drawn.
void Workbench::export_picture(const std::filesystem::path& path)
{
    attempt([&] {
        PictureExport wanted(path);
        if (std::string refusal = wanted.refusal(wanted_picture().display); !refusal.empty())
            return say("Not exported: " + refusal, true);
        export_ = std::move(wanted);
        say("The picture is written when it is finished");
    });
}

void Workbench::write_export()
{
    if (!export_ || !requested_ || !picture_finished() || !export_->suits(*requested_)) return;
    PictureExport finished = *std::exchange(export_, std::nullopt);
    // Another view may be shown by now.
    if (std::string refusal = finished.refusal(requested_->display); !refusal.empty())
        return say("Not exported: " + refusal, true);
    attempt([&] {
        finished.write(*drawn_, *requested_);
        say("Exported " + finished.path().filename().string());
    });
}

}  // namespace fieldwright::app
