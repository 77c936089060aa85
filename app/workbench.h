// The editor as a program: window, session, render thread and the parts of ui, brought together frame by frame.
#pragma once

#include "app/autosave.h"
#include "app/code_review.h"
#include "app/examples.h"
#include "app/folder_watch.h"
#include "app/group_library.h"
#include "app/inspected_ray.h"
#include "app/native_dialog.h"
#include "app/node_costs.h"
#include "app/picture_export.h"
#include "app/picture_shelf.h"
#include "app/recent_files.h"
#include "app/script.h"
#include "app/session.h"
#include "app/shown_picture.h"
#include "app/shown_scene.h"
#include "app/steps_texture.h"
#include "app/stopwatch.h"
#include "app/user_folders.h"
#include "app/window.h"
#include "app/window_state.h"
#include "renderer/render_thread.h"
#include "ui/editor.h"

#include <chrono>
#include <functional>
#include <optional>

namespace fieldwright::app {

struct WorkbenchOptions {
    std::filesystem::path scene;    // empty = a new scene
    std::filesystem::path shaders;  // read and watched; empty = built in
    std::filesystem::path script;   // played, when given
    std::filesystem::path state;    // instead of the user's folders, when given
    std::filesystem::path places;  // where the places of widgets are written whenever the window is at rest, when given
    std::filesystem::path recording;  // where the input is recorded, when given
    glm::ivec2 size{1440, 900};       // px
};

class Workbench {
public:
    explicit Workbench(const WorkbenchOptions& options);  // graph::Failure
    int run();                                            // until the window closes; the exit code
    void turn();                                          // waits, and draws a frame if one is due

    // For those who drive and measure it.
    struct FrameTimes {
        Taken ui;            // from taking the input to the end of what ImGui was told
        Taken edit;          // then: lowering what was edited, the history, asking for a picture
        double whole_s = 0;  // to the end of the frame
    };
    const FrameTimes& frame_times() const { return frame_times_; }  // of the last frame
    int frames_drawn() const { return frames_drawn_; }
    ui::Editor& editor() { return editor_; }
    EditSession& session() { return session_; }
    ui::InputQueue& input() { return window_.input; }
    const ui::Readings& readings() const { return readings_; }
    renderer::RenderStatus rendering() const { return render_thread_.status(); }
    std::uint64_t shown_generation() const { return shown_generation_; }        // of the picture in the viewport
    std::uint64_t pictured_generation() const { return pictured_generation_; }  // of the picture in the last frame
    std::uint64_t asked_generation() const { return requested_ ? requested_->generation : 0; }

private:
    double now_s() const;
    void frame();
    void touch();
    bool is_lively() const;
    bool something_moves() const;
    double next_frame_s() const;
    double patience_s() const;
    void watch_shaders();
    void review_code();
    void lower_scene();
    void trust(const std::vector<graph::OwnType>& types);
    void save_own_node(const std::string& type);
    void fill_readings();
    bool take_result();
    void await_first_picture(double seconds);
    void forget_refusal();
    bool request_picture(bool hands_moving);
    bool follow(const ui::Editor::Output& output, double frame_start_s);
    bool picture_finished() const;
    renderer::PictureRequest wanted_picture() const;
    void keep_layers(renderer::PictureRequest& request) const;
    void perform(const ui::Request& request);
    void choose(const ui::ChooseFile& request);
    void answer_dialog();
    void chosen(const ui::ChooseFile& request, const std::filesystem::path& path);
    void open(const std::filesystem::path& path);
    void open_example(const std::string& name);
    void take_dropped(const std::filesystem::path& file);
    void use_picture(const ui::UsePicture& request);
    void save(const std::optional<std::filesystem::path>& path);
    void export_shader(const ui::ExportFile& request);
    void export_picture(const std::filesystem::path& path);
    void write_export();
    void measure_nodes();
    void inspect_ray(const ui::InspectRay& request);
    void save_group(const ui::SaveGroup& request);
    void list_groups();
    void list_recoverable();
    void recover(const std::string& id);
    void discard_recovered(const std::string& id);
    void scene_replaced();
    void play_script();
    void write_places();
    void leave_view();
    void show_view();
    void say_opened();
    void say(std::string sentence, bool is_error = false);
    // Runs `action`; a failure becomes the status line's sentence.
    bool attempt(const std::function<void()>& action);

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    WorkbenchOptions options_;
    UserFolders folders_;
    std::optional<std::filesystem::path> user_nodes_;  // the folder
    WindowState state_;
    RecentFiles recent_;
    EditSession session_;
    CodeReview review_;
    Autosave autosave_;
    GroupLibrary groups_;
    Window window_;
    ExamplePictures example_pictures_;
    renderer::RenderThread render_thread_;
    PictureShelf pictures_;
    ShownScene scene_{Window::wake};
    std::vector<std::string> font_families_;  // empty until somebody asks
    ShownPicture picture_;
    std::optional<renderer::DrawnPicture> drawn_;  // what it shows
    StepsTexture steps_texture_;
    InspectedRay ray_;
    NodeCostMeter node_costs_{Window::wake};
    ui::Editor editor_;
    ui::Readings readings_;

    NativeDialog dialog_;
    std::optional<ui::ChooseFile> dialog_request_;
    std::optional<FolderWatch> watch_, user_nodes_watch_;
    std::optional<Script> script_;
    std::optional<PictureExport> export_;  // to be written when the picture is finished
    std::string reload_error_, compile_error_;
    std::uint64_t refused_generation_ = 0;  // of the picture that compile_error_ is about
    bool quit_ = false;
    int frames_owed_ = 0;
    double draw_s_ = 0;     // what drawing the window and showing it takes: of late, the worst
    bool hurried_ = false;  // what the hand waits for is there: it is drawn at once
    double last_frame_s_ = 0, last_touch_s_ = 0, last_change_s_ = 0;
    std::optional<double> redraw_at_s_;  // the window looks different then, though nobody does anything
    std::optional<renderer::PictureRequest> requested_;
    std::uint64_t shown_generation_ = 0;
    std::uint64_t awaited_generation_ = 0;  // of an edit whose first picture is not shown yet; 0 = of none
    std::uint64_t pictured_generation_ = 0;
    FrameTimes frame_times_;
    int frames_drawn_ = 0, placed_frame_ = 0;
};

}  // namespace fieldwright::app
