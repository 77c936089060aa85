// One turn of the editor: wait, take what is new, draw, do what was asked, ask for the next picture.
#include "app/workbench.h"

#include "app/library_reload.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "graph/scene_file.h"

#include <algorithm>

namespace fieldwright::app {
namespace {

constexpr double frame_s = 1.0 / 60;  // while something moves
constexpr double frame_share =
    0.5;                           // of the time, at most: the rest is the picture's, which is drawn on the same cores
constexpr double script_s = 0.05;  // between the looks of a script at a window at rest
constexpr double lively_s = 0.35;  // frames go on this long after the last input: fades, hovering, framing
constexpr double settling_s = 0.15;  // a hand this long at rest gets a picture in full
constexpr double idle_s = 1;         // autosave and the like look this often
constexpr double watch_s = FolderWatch::interval_s;
constexpr double blink_s = 0.4;  // of the text cursor

const char* dialog_title(ui::ChooseFile::Then then)
{
    switch (then) {
        case ui::ChooseFile::Then::open: return "Open scene";
        case ui::ChooseFile::Then::save_as: return "Save scene as";
        case ui::ChooseFile::Then::export_shader: return "Export shader";
        case ui::ChooseFile::Then::export_picture: return "Export picture";
    }
    return "";
}

renderer::ViewCamera renderer_camera(const ui::ViewCamera& camera)
{
    return {.position = camera.drawn_from(),
            .target = camera.pivot,
            .up = camera.up(),
            .field_of_view_rad = camera.field_of_view_rad,
            .orthographic_height = camera.orthographic ? camera.height_at_pivot() : 0};
}

bool same_picture(const renderer::PictureRequest& a, const renderer::PictureRequest& b)
{
    return a.program == b.program && a.frame == b.frame && a.view == b.view && a.stereo == b.stereo;
}

// "cpu", or "gpu" with the driver's own name for it.
std::string device_words(const renderer::RenderStatus& status)
{
    std::string device = status.device;
    return device == "gpu" ? device + " " + status.gpu.substr(0, status.gpu.find_first_of("(,/")) : device;
}

std::string when_text(std::int64_t time_s)
{
    std::time_t time = time_s;
    std::tm local{};
    localtime_r(&time, &local);
    char text[64];
    std::strftime(text, sizeof text, "%d %B, %H:%M", &local);
    return text;
}

}  // namespace

Workbench::Workbench(const WorkbenchOptions& options)
    : options_(options),
      folders_(options.state.empty() ? user_folders() : user_folders(options.state)),
      state_(folders_.state / "window.json"),
      recent_(folders_.state / "recent.json"),
      session_(options.shaders.empty() ? graph::Library::embedded() : graph::Library::load(options.shaders)),
      autosave_(folders_.state / "autosave", [this] { return now_s(); }),
      window_("Fieldwright", options.size),
      render_thread_({.on_ready = Window::wake})
{
    if (!options.shaders.empty()) watch_.emplace(options.shaders);
    if (!options.script.empty()) script_.emplace(options.script);
    if (!options.recording.empty()) window_.input.start_recording();
    editor_.rects.listening = script_.has_value();
    readings_.export_targets = codegen::export_targets();
    readings_.view_names = renderer::view_names();
    readings_.stereo_names = renderer::stereo_names();
    readings_.node_at = [this](int x, int y) { return picture_.node_at(x, y); };
    readings_.depth_at = [this](int x, int y) { return picture_.depth_at(x, y); };
    readings_.bounds_of = [this](graph::NodeId node) { return scene_.bounds_of(node); };
    recall_window();
    if (!options.scene.empty()) session_.open(options.scene);
    if (!options.scene.empty()) attempt([&] { recent_.add(*session_.path()); });
    scene_replaced();
    list_recoverable();
}

template <typename Action>
bool Workbench::attempt(const Action& action)
{
    try {
        action();
        return true;
    } catch (const graph::Failure& failure) {
        say(failure.what(), true);
    }
    return false;
}

void Workbench::say(std::string sentence, bool is_error)
{
    readings_.status = std::move(sentence);
    readings_.status_is_error = is_error;
    last_touch_s_ = now_s();
}

double Workbench::now_s() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

int Workbench::run()
{
    while (!quit_) {
        window_.wait(patience_s());
        take_result();
        watch_shaders();
        answer_dialog();
        attempt([&] { autosave_.update(session_); });
        for (const std::string& path : window_.dropped_files()) editor_.ask(ui::OpenFile{path});
        if (window_.close_asked()) editor_.ask_quit();
        if (window_.was_touched()) last_touch_s_ = now_s();
        if (something_moves() && now_s() >= next_frame_s()) frame();
    }
    remember_view();
    attempt([&] { state_.save(); });
    autosave_.clear();
    if (!options_.recording.empty()) graph::save_atomically(options_.recording, window_.input.recording());
    return 0;
}

bool Workbench::something_moves() const
{
    bool lively = now_s() - last_touch_s_ < lively_s || !window_.input.empty();
    bool blinking = ImGui::GetIO().WantTextInput && now_s() - last_frame_s_ >= blink_s;
    bool due = redraw_at_s_ && now_s() >= *redraw_at_s_;
    bool played = script_ && now_s() - last_frame_s_ >= script_s;
    return window_.visible() && (lively || blinking || due || played || editor_.view.playing);
}

double Workbench::next_frame_s() const { return last_frame_s_ + std::max(frame_s, frame_length_s_ / frame_share); }

// How long the window may sleep when nothing comes in.
double Workbench::patience_s() const
{
    if (something_moves()) return std::max(0.0, next_frame_s() - now_s());
    if (dialog_.is_open() || script_) return script_s;
    double patience = ImGui::GetIO().WantTextInput ? blink_s : watch_ ? watch_s : idle_s;
    return redraw_at_s_ ? std::clamp(*redraw_at_s_ - now_s(), 0.0, patience) : patience;
}

void Workbench::frame()
{
    double now = now_s(), passed = last_frame_s_ > 0 ? now - last_frame_s_ : frame_s;
    last_frame_s_ = now;
    ui::ViewState& view = editor_.view;
    if (view.playing) view.time_s = std::fmod(view.time_s + passed, std::max(view.loop_s, 0.1));
    readings_.frames_per_second = readings_.frames_per_second * 0.9 + 0.1 / std::max(passed, 1e-4);

    window_.begin_frame();
    fill_readings();
    ui::Editor::Output output = editor_.draw(session_.document(), *session_.library(), readings_, window_.theme());
    window_.draw_frame();
    if (script_) play_script();
    window_.show_frame();

    if (output.document_changed) scene_.update(session_.document(), session_.library());
    if (!output.settled_step.empty()) session_.settle(output.settled_step);
    for (const ui::Request& request : output.requests) perform(request);
    if (output.hands_moving || output.document_changed || editor_.viewport().moving()) last_touch_s_ = now;
    redraw_at_s_ = output.redraw_in_s ? std::optional(now + *output.redraw_in_s) : std::nullopt;
    request_picture(output.hands_moving);
    frame_length_s_ = now_s() - now;
}

void Workbench::watch_shaders()
{
    if (!watch_ || !watch_->changed(now_s())) return;
    LibraryReload reload = reload_library(watch_->folder());
    reload_error_ = reload.error;
    if (reload.library) {
        session_.use_library(reload.library);
        scene_.update(session_.document(), session_.library());
        say("Read the changed shaders");
    } else {
        say(reload.error, true);
    }
}

void Workbench::fill_readings()
{
    readings_.program = scene_.program();
    readings_.problems = scene_.program()->problems;
    for (const std::string& error : {reload_error_, compile_error_, autosave_.failure()})
        if (!error.empty()) readings_.problems.push_back({{}, error});
    bool reads_shader = editor_.view.panes.shown && editor_.view.panel == ui::Panel::shader;
    readings_.shader_text = reads_shader ? scene_.shader_text(static_cast<float>(editor_.view.time_s)) : nullptr;
    readings_.picture.texture = picture_.texture();
    readings_.picture.width = picture_.size().x;
    readings_.picture.height = picture_.size().y;
    renderer::RenderStatus rendering = render_thread_.status();
    readings_.picture.compiling = rendering.compiling;
    readings_.picture.device = device_words(rendering);
    readings_.step_names = session_.history().names();
    readings_.step = session_.history().step();
    readings_.file_name = session_.name();
    readings_.file_path = session_.path() ? session_.path()->string() : "";
    readings_.dirty = session_.dirty();
    readings_.changed_on_disk = session_.changed_on_disk();
    readings_.recent.clear();
    for (const RecentFile& file : recent_.entries()) readings_.recent.push_back({file.path.string(), file.missing});
    readings_.dialog_open = dialog_.is_open();
    readings_.time_s = editor_.view.time_s;
    readings_.has_camera = scene_.has_camera();
    window_.rename(session_.title() + " - Fieldwright");
}

void Workbench::take_result()
{
    std::optional<renderer::RenderResult> result = render_thread_.poll();
    if (!result) return;
    last_touch_s_ = std::max(last_touch_s_, now_s() - lively_s + 2 * frame_s);  // two frames
    ui::PictureReading& reading = readings_.picture;
    if (auto* drawn = std::get_if<renderer::DrawnPicture>(&*result)) {
        picture_.show(drawn->picture, drawn->frame);
        reading.full = drawn->final;
        reading.draw_ms = static_cast<float>(drawn->ms);
        reading.mean_steps = static_cast<float>(drawn->steps.mean);
        reading.max_steps = drawn->steps.largest;
        reading.exhausted_share = static_cast<float>(drawn->steps.exhausted);
        if (drawn->final && picture_wanted_) export_picture(*std::exchange(picture_wanted_, std::nullopt));
    } else if (auto* failed = std::get_if<renderer::CompileFailed>(&*result)) {
        compile_error_ = failed->log;
    } else if (auto* broken = std::get_if<renderer::Failed>(&*result)) {
        say(broken->sentence, true);
    }
}

void Workbench::request_picture(bool hands_moving)
{
    renderer::PictureRequest request = wanted_picture();
    if (request.frame.width < 8 || request.frame.height < 8) return;
    if (!requested_ || !same_picture(*requested_, request)) last_change_s_ = now_s();
    // A hand that holds still, or types, waits for the whole picture.
    request.interacting = editor_.view.playing || (hands_moving && now_s() - last_change_s_ < settling_s);
    if (requested_ && same_picture(*requested_, request) && requested_->interacting == request.interacting) return;
    request.generation = requested_ ? requested_->generation + 1 : 1;
    requested_ = request;
    render_thread_.request(request);
}

renderer::PictureRequest Workbench::wanted_picture() const
{
    const ui::ViewState& view = editor_.view;
    renderer::PictureRequest request;
    request.program = scene_.program();
    request.frame.width = editor_.viewport_size_px().x;
    request.frame.height = editor_.viewport_size_px().y;
    request.frame.time = static_cast<float>(view.time_s);
    request.frame.interaxial = view.interaxial;
    request.frame.convergence = view.convergence;
    if (!view.through_camera || !scene_.has_camera()) request.frame.camera = renderer_camera(view.camera);
    request.view = renderer::view_from_name(view.view).value_or(renderer::View::beauty);
    request.stereo = renderer::stereo_from_name(view.stereo).value_or(renderer::Stereo::off);
    return request;
}

void Workbench::perform(const ui::Request& request)
{
    auto restored = [&](bool done) {
        if (done) scene_.update(session_.document(), session_.library());
    };
    if (std::holds_alternative<ui::NewScene>(request)) remember_view(), session_.new_scene(), scene_replaced();
    if (auto* file = std::get_if<ui::OpenFile>(&request)) open(file->path);
    if (std::holds_alternative<ui::SaveFile>(request)) save(std::nullopt);
    if (auto* file = std::get_if<ui::SaveFileAs>(&request)) save(file->path);
    if (auto* shader = std::get_if<ui::ExportFile>(&request)) export_shader(*shader);
    if (auto* picture = std::get_if<ui::ExportPicture>(&request)) export_picture(picture->path);
    if (auto* choice = std::get_if<ui::ChooseFile>(&request)) choose(*choice);
    if (std::holds_alternative<ui::ForgetRecent>(request)) attempt([&] { recent_.clear(); });
    if (std::holds_alternative<ui::Undo>(request)) restored(session_.undo());
    if (std::holds_alternative<ui::Redo>(request)) restored(session_.redo());
    if (auto* jump = std::get_if<ui::JumpTo>(&request)) restored(session_.jump(jump->step));
    if (auto* wanted = std::get_if<ui::Recover>(&request)) recover(wanted->id);
    if (auto* unwanted = std::get_if<ui::DiscardRecovered>(&request)) discard_recovered(unwanted->id);
    if (std::holds_alternative<ui::Quit>(request)) quit_ = true;
}

void Workbench::list_recoverable()
{
    readings_.recovered.clear();
    for (const Recovery& recovery : autosave_.recoverable())
        readings_.recovered.push_back({recovery.id, recovery.title, when_text(recovery.time_s)});
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
    dialog.kind = request.then == Then::open ? DialogRequest::Kind::open : DialogRequest::Kind::save;
    dialog.title = dialog_title(request.then);
    dialog.folder = session_.path() ? session_.path()->parent_path() : std::filesystem::current_path();
    std::string stem = session_.path() ? session_.path()->stem().stem().string() : "untitled";
    if (request.then == Then::save_as) dialog.name = stem + ".scene.json";
    if (request.then == Then::export_shader)
        dialog.name = stem + ".glsl", dialog.filter = "Shader", dialog.pattern = "*.glsl";
    if (request.then == Then::export_picture)
        dialog.name = stem + ".png", dialog.filter = "Picture", dialog.pattern = "*.png";
    dialog_.start(dialog);
}

void Workbench::answer_dialog()
{
    if (!dialog_request_) return;
    DialogAnswer answer = dialog_.poll();
    if (answer.state == DialogAnswer::State::pending) return;
    ui::ChooseFile request = *std::exchange(dialog_request_, std::nullopt);
    last_touch_s_ = now_s();
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
    }
}

void Workbench::open(const std::filesystem::path& path)
{
    remember_view();
    if (!attempt([&] { session_.open(path); })) return;
    attempt([&] { recent_.add(*session_.path()); });
    scene_replaced();
    say("Opened " + session_.name());
}

void Workbench::save(const std::optional<std::filesystem::path>& path)
{
    if (!attempt([&] { path ? session_.save_as(*path) : session_.save(); })) return;
    attempt([&] { recent_.add(*session_.path()); });
    say("Saved " + session_.name());
}

void Workbench::export_shader(const ui::ExportFile& request)
{
    attempt([&] {
        std::vector<float> block = field::evaluate_frame(*scene_.program(), static_cast<float>(editor_.view.time_s));
        graph::save_atomically(request.path,
                               codegen::print_export(*scene_.program(), session_.document(), block, request.target));
        say("Exported " + std::filesystem::path(request.path).filename().string());
    });
}

// A picture still being drawn is written once it is finished.
void Workbench::export_picture(const std::filesystem::path& path)
{
    if (!readings_.picture.full) {
        picture_wanted_ = path;
        return say("The picture is written when it is finished");
    }
    attempt([&] {
        renderer::write_png(path, *picture_.picture());
        say("Exported " + path.filename().string());
    });
}

// Another document is shown: everything derived from the old one goes.
void Workbench::scene_replaced()
{
    scene_.update(session_.document(), session_.library());
    compile_error_.clear();
    editor_.view.selection.clear();
    editor_.view.time_s = 0;
    editor_.view.playing = false;
    recall_view();
    last_touch_s_ = now_s();
}

void Workbench::play_script()
{
    const ui::PictureReading& picture = readings_.picture;
    bool newest = !render_thread_.status().busy;
    Script::Stage stage{
        .input = window_.input,
        .rects = editor_.rects,
        .settled = picture.full && newest && window_.input.empty() && !ImGui::IsAnyItemActive(),
        .take_screenshot =
            [&](const std::filesystem::path& path) {
                glm::ivec2 size = window_.size_px();
                renderer::write_png(path, {size.x, size.y, window_.screenshot()});
            },
        .resize = [&](glm::ivec2 size) { window_.resize(size); },
        .quit = [&] { quit_ = true; },
    };
    script_->play(stage);
    if (script_->finished()) script_.reset();
}

void Workbench::remember_view()
{
    const ui::ViewState& view = editor_.view;
    state_.remember("panes/side_width", view.panes.side_width);
    state_.remember("panes/canvas_share", view.panes.canvas_share);
    state_.remember("panes/inspector_share", view.panes.inspector_share);
    if (!session_.path()) return;
    std::string key = "view/" + session_.path()->string() + "/";
    const ui::ViewCamera& camera = view.camera;
    const std::pair<const char*, double> numbers[] = {{"pivot_x", camera.pivot.x},
                                                      {"pivot_y", camera.pivot.y},
                                                      {"pivot_z", camera.pivot.z},
                                                      {"yaw", camera.yaw_rad},
                                                      {"pitch", camera.pitch_rad},
                                                      {"distance", camera.distance},
                                                      {"orthographic", camera.orthographic},
                                                      {"through_camera", view.through_camera},
                                                      {"pan_x", view.canvas.pan_px.x},
                                                      {"pan_y", view.canvas.pan_px.y},
                                                      {"zoom", view.canvas.zoom}};
    for (auto [name, value] : numbers) state_.remember(key + name, value);
}

void Workbench::recall_window()
{
    ui::Panes& panes = editor_.view.panes;
    auto number = [&](const char* key, float value) { return static_cast<float>(state_.number(key, value)); };
    panes.side_width = number("panes/side_width", panes.side_width);
    panes.canvas_share = number("panes/canvas_share", panes.canvas_share);
    panes.inspector_share = number("panes/inspector_share", panes.inspector_share);
}

// The view of a file as it was left; a file never seen is framed.
void Workbench::recall_view()
{
    ui::ViewState& view = editor_.view;
    std::string key = session_.path() ? "view/" + session_.path()->string() + "/" : "";
    auto number = [&](const char* name, float value) {
        return key.empty() ? value : static_cast<float>(state_.number(key + name, value));
    };
    ui::ViewCamera camera;
    if (auto bounds = scene_.bounds_of({}); bounds && bounds->half_size.x < 1e5f)
        camera.frame(bounds->centre, bounds->half_size, 1.6f);
    view.camera.pivot = {number("pivot_x", camera.pivot.x), number("pivot_y", camera.pivot.y),
                         number("pivot_z", camera.pivot.z)};
    view.camera.yaw_rad = number("yaw", camera.yaw_rad);
    view.camera.pitch_rad = number("pitch", camera.pitch_rad);
    view.camera.distance = std::max(number("distance", camera.distance), 1e-3f);
    view.camera.orthographic = number("orthographic", 0) != 0;
    view.through_camera = number("through_camera", 1) != 0;
    float zoom = number("zoom", 0);
    view.canvas.pan_px = {number("pan_x", 0), number("pan_y", 0)};
    view.canvas.zoom = std::clamp(zoom, 0.1f, 4.0f);
    if (zoom == 0) editor_.canvas().frame_all();
}

}  // namespace fieldwright::app
