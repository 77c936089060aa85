// One turn of the editor: wait, take what is new, draw, do what was asked, ask for the next picture.
#include "app/workbench.h"

#include "app/choices.h"
#include "app/library_reload.h"
#include "app/user_nodes.h"
#include "app/view_memory.h"
#include "assets/font_file.h"
#include "codegen/glsl.h"
#include "graph/scene_file.h"
#include "ui/group_actions.h"
#include "ui/transport.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::app {
namespace {

constexpr double frame_s = 1.0 / 60;      // while something moves
constexpr double frame_share = 0.5;       // of the time, at most: the picture is drawn on the same cores
constexpr double script_s = 0.05;         // between the looks of a script at a window at rest
constexpr double lively_s = 0.35;         // frames go on this long after the last input: fades, hovering, framing
constexpr double first_picture_s = 0.03;  // a frame waits this long for the picture of what it shows, at most,
constexpr double edit_frame_s = 0.047;    // and so long that with drawing the window it takes this
constexpr double draw_memory = 0.95;      // of a frame that took long to draw, at the next one
constexpr double idle_s = 1;              // autosave and the like look this often
constexpr double watch_s = FolderWatch::interval_s;
constexpr double blink_s = 0.4;  // of the text cursor
constexpr assets::WorkerLimits trial_limits{
    .memory_bytes = 1 << 30, .cpu_s = 15, .wall_s = 20, .answer_bytes = 1 << 20};

std::optional<std::filesystem::path> user_nodes(const WorkbenchOptions& options)
{
    return options.state.empty() ? user_node_folder() : user_node_folder(options.state);
}

// Before there is a window: a scene that cannot be opened is the command line's error.
EditSession opened_session(const WorkbenchOptions& options)
{
    auto library = options.shaders.empty() ? graph::Library::embedded() : graph::Library::load(options.shaders);
    if (auto folder = user_nodes(options)) library = with_user_nodes(*library, *folder);
    EditSession session(std::move(library));
    if (!options.scene.empty()) session.open(options.scene);
    return session;
}

}  // namespace

Workbench::Workbench(const WorkbenchOptions& options)
    : options_(options),
      folders_(options.state.empty() ? user_folders() : user_folders(options.state)),
      user_nodes_(user_nodes(options)),
      state_(folders_.state / "window.json"),
      recent_(folders_.state / "recent.json"),
      session_(opened_session(options)),
      review_(
          folders_.state / "trusted_code.json",
          [](const std::string& shader, const std::stop_token& stop) {
              return try_shader(assets::Worker(), shader, "its code", stop, trial_limits);
          },
          Window::wake),
      autosave_(folders_.state / "autosave", [this] { return now_s(); }),
      groups_(options.state.empty() ? user_group_folder() : user_group_folder(options.state)),
      window_("Fieldwright", options.size),
      render_thread_({.on_ready = Window::wake}),
      pictures_(Window::wake)
{
    session_.use_judge([this](const graph::OwnType& type) { return review_.verdict(type); });
    if (!options.shaders.empty()) watch_.emplace(options.shaders);
    if (user_nodes_) user_nodes_watch_.emplace(*user_nodes_);
    if (!options.script.empty()) script_.emplace(options.script);
    if (!options.recording.empty()) window_.input.start_recording();
    editor_.rects.listening = script_ || !options.places.empty();
    readings_.export_targets = codegen::export_targets();
    fill_choices(readings_);
    // While the window is drawn, the open group stands in the scene's place.
    readings_.node_at = [this](int x, int y) {
        std::vector<graph::NodeId> path = graph::path_of(scene_.program()->inner_copies, picture_.node_at(x, y));
        return graph::shown_on(path, session_.document().root);
    };
    readings_.depth_at = [this](int x, int y) { return picture_.depth_at(x, y); };
    readings_.depth_range = [this] { return picture_.depth_range(); };
    readings_.bounds_of = [this](graph::NodeId node) { return scene_.bounds_of(node); };
    readings_.font_families = [this]() -> const std::vector<std::string>& {
        if (font_families_.empty()) font_families_ = assets::installed_families();
        return font_families_;
    };
    readings_.blend_of = [this](graph::NodeId node) {
        return scene_.blend_of(node, static_cast<float>(editor_.view.time_s));
    };
    for (const Example& example : examples())
        readings_.examples.push_back(
            {std::string(example.file.name), example.title, example.sentence, example_pictures_.texture(example.file)});
    recall_panes(state_, editor_.view);
    if (!options.scene.empty()) attempt([&] { recent_.add(*session_.path()); });
    scene_replaced();
    if (session_.laid_out()) say_opened();
    list_recoverable();
    list_groups();
}

bool Workbench::attempt(const std::function<void()>& action)
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
    ++readings_.status_count;
    touch();
}

double Workbench::now_s() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

int Workbench::run()
{
    while (!quit_) turn();
    leave_view();
    remember_panes(state_, editor_.view);
    attempt([&] { state_.save(); });
    autosave_.clear();
    if (!options_.recording.empty()) graph::save_atomically(options_.recording, window_.input.recording());
    return 0;
}

void Workbench::turn()
{
    window_.wait(patience_s());
    while (take_result()) {
    }
    forget_refusal();
    if (scene_.poll()) touch();
    watch_shaders();
    review_code();
    answer_dialog();
    if (pictures_.has_news()) lower_scene(), touch();
    attempt([&] { autosave_.update(session_); });
    for (const std::string& path : window_.dropped_files()) take_dropped(path);
    if (window_.close_asked()) editor_.ask_quit();
    if (window_.was_touched()) touch();
    if (something_moves() && now_s() >= next_frame_s()) frame();
    if (!options_.places.empty() && !is_lively()) write_places();
}

// What is shown changed: frames go on for a while, and one is drawn however long the last one took.
void Workbench::touch()
{
    last_touch_s_ = now_s();
    frames_owed_ = std::max(frames_owed_, 1);
}

bool Workbench::is_lively() const
{
    return frames_owed_ > 0 || now_s() - last_touch_s_ < lively_s || !window_.input.empty();
}

// For drivers outside: a line per widget, its name and the pixel of the window in its middle.
void Workbench::write_places()
{
    if (std::exchange(placed_frame_, frames_drawn_) == frames_drawn_) return;
    std::string lines;
    for (const auto& [name, rect] : editor_.rects.all())
        lines += name + " " + std::to_string(std::lround(rect.centre().x)) + " " +
                 std::to_string(std::lround(rect.centre().y)) + "\n";
    graph::save_atomically(options_.places, lines);
}

bool Workbench::something_moves() const
{
    bool blinking = ImGui::GetIO().WantTextInput && now_s() - last_frame_s_ >= blink_s;
    bool due = redraw_at_s_ && now_s() >= *redraw_at_s_;
    bool played = script_ && now_s() - last_frame_s_ >= script_s;
    return window_.visible() && (is_lively() || blinking || due || played || editor_.view.playing);
}

// Moves are many and wait for their turn. A press and an edit's first picture do not.
double Workbench::next_frame_s() const
{
    if (hurried_ || window_.input.has_press()) return last_frame_s_;
    return last_frame_s_ + std::max(frame_s, frame_times_.whole_s / frame_share);
}

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
    Stopwatch watch;
    double now = now_s(), passed = last_frame_s_ > 0 ? now - last_frame_s_ : frame_s;
    last_frame_s_ = now;
    hurried_ = false;
    frames_owed_ = std::max(frames_owed_ - 1, 0);
    ui::ViewState& view = editor_.view;
    if (view.playing) ui::play_on(view, session_.document().animation, passed);
    readings_.frames_per_second = readings_.frames_per_second * 0.9 + 0.1 / std::max(passed, 1e-4);

    window_.begin_frame();
    fill_readings();
    ui::Editor::Output output = editor_.draw(session_.document(), *session_.library(), readings_, window_.theme());
    window_.end_frame();
    if (output.text_expected) window_.input.wait_for_text();
    frame_times_.ui = watch.taken();
    Stopwatch following;
    bool edited = follow(output, now);
    frame_times_.edit = following.taken();
    if (edited) await_first_picture(now + edit_frame_s - draw_s_ - now_s());
    double drawing = now_s();
    render_thread_.set_window_drawing(true);
    window_.draw_frame();
    if (script_) play_script();
    window_.show_frame();
    render_thread_.set_window_drawing(false);
    pictured_generation_ = shown_generation_;
    draw_s_ = std::max(now_s() - drawing, draw_memory * draw_s_);
    frame_times_.whole_s = now_s() - now;
    ++frames_drawn_;
}

// What the hands did, before it is drawn, since its picture takes longer. Whether another scene is shown from now on.
bool Workbench::follow(const ui::Editor::Output& output, double frame_start_s)
{
    if (output.document_changed) {
        session_.follow_types();
        scene_.bake(session_.document(), *session_.library());
        lower_scene();
    }
    if (!output.settled_step.empty()) session_.settle(output.settled_step);
    for (const ui::Request& request : output.requests) perform(request);
    // A hand that holds something at a pane's edge moves the view without moving itself.
    bool holding = output.hands_moving && ImGui::IsAnyMouseDown();
    if (holding || output.document_changed || editor_.viewport().moving()) touch();
    redraw_at_s_ = output.redraw_in_s ? std::optional(frame_start_s + *output.redraw_in_s) : std::nullopt;
    bool edited = request_picture(output.hands_moving);
    write_export();
    if (edited) awaited_generation_ = requested_->generation;
    return edited;
}

// The frame that shows an edit shows its picture too, where that is there soon: the picture's threads have the machine to
// themselves meanwhile, and a second frame is saved.
void Workbench::await_first_picture(double seconds)
{
    render_thread_.wait(awaited_generation_, std::clamp(seconds, 0.0, first_picture_s));
    while (take_result()) {
    }
    hurried_ = false;
}

void Workbench::watch_shaders()
{
    bool shaders_changed = watch_ && watch_->changed(now_s());
    bool nodes_changed = user_nodes_watch_ && user_nodes_watch_->changed(now_s());
    if (!shaders_changed && !nodes_changed) return;
    LibraryReload reload = reload_library(options_.shaders, user_nodes_);
    reload_error_ = reload.error;
    if (reload.library) {
        session_.use_library(reload.library);
        lower_scene();
        say(shaders_changed ? "Read the changed shaders" : "Read the changed nodes of your folder");
    } else {
        say(reload.error, true);
    }
}

void Workbench::review_code()
{
    if (!review_.update(session_.library())) return;
    session_.judge_again();
    lower_scene();
    touch();
}

// Another document is shown: everything derived from the old one goes.
void Workbench::scene_replaced()
{
    lower_scene();
    ray_.forget();
    compile_error_.clear();
    editor_.view.selection.clear();
    editor_.view.way.clear();
    ui::go_to_frame(editor_.view, session_.document().animation, session_.document().animation.first_frame);
    editor_.view.playing = false;
    show_view();
    touch();
}

void Workbench::play_script()
{
    bool finished = readings_.picture.full && shown_generation() == asked_generation() && !pictures_.busy() && !export_;
    Script::Stage stage{
        .input = window_.input,
        .rects = editor_.rects,
        .settled = finished && window_.input.empty() && !ImGui::IsAnyMouseDown(),
        .take_screenshot =
            [&](const std::filesystem::path& path) {
                glm::ivec2 size = window_.size_px();
                renderer::write_png(path, {size.x, size.y, window_.screenshot()});
            },
        .drop = [&](const std::filesystem::path& file) { take_dropped(file); },
        .resize =
            [&](glm::ivec2 size) {
                window_.resize(size);
                hurried_ = true;
            },
        .quit = [&] { quit_ = true; },
    };
    script_->play(stage);
    if (script_->finished()) script_.reset();
}

void Workbench::leave_view()
{
    ui::close_groups(editor_.view);
    if (session_.path()) remember_view(state_, *session_.path(), editor_.view);
}

// The view of a file as it was left; a file never seen is framed.
void Workbench::show_view()
{
    ui::ViewState& view = editor_.view;
    if (session_.path() && recall_view(state_, *session_.path(), view)) return;
    view.camera = {};
    view.through_camera = true;
    if (auto bounds = scene_.bounds_of({}); bounds && bounds->half_size.x < 1e5f)
        view.camera.frame(bounds->centre, bounds->half_size, 1.6f);
    editor_.canvas().frame_opening();
}

}  // namespace fieldwright::app
