// The window under load, at 1280x720. csg(300) while a shader compiles: UI time, whole frames, the first picture after an
// edit, pictures and links during a drag, and what it costs when nothing happens. Then the same hands while a heavy scene
// renders: 1,000 primitives of glass and mirrors, four bounces. Needs a display.
#include "codegen/features.h"
#include "graph/edits.h"
#include "graph/layout.h"
#include "graph/scene_file.h"
#include "tests/bench/csg_scene.h"
#include "tests/bench/driven_window.h"
#include "tests/bench/processor.h"
#include "tests/graph/temporary_folder.h"
#include "ui/keys.h"
#include "ui/node_geometry.h"

#include <random>

namespace fieldwright::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Kind = ui::InputEvent::Kind;

constexpr int primitives = 300, edits = 60;
constexpr int heavy_primitives = 1000, heavy_bounces = 4, heavy_edits = 20;
constexpr double phase_seconds = 4, idle_seconds = 3;
constexpr double ui_limit_s = 0.016, whole_limit_s = 0.05;
constexpr std::size_t detailed_nodes = 100;

// Lays the scene out and writes it to a file of its own.
std::filesystem::path kept(graph::Document document, const graph::Library& library, const std::filesystem::path& path)
{
    auto refused = graph::arrange(
        document, {}, [&](graph::NodeId id) { return ui::node_size(*library.type(document.root.find(id)->type)); });
    demand(!refused, "the scene is laid out");
    graph::save_scene(path, document, library);
    return path;
}

// UI time by the clock counts what other programs took meanwhile; the processor's does not.
void print_frames(const char* what, const FrameLog& log)
{
    double ui = percentile(log.ui_s, 0.99), whole = percentile(log.whole_s, 0.99);
    std::printf(
        "%-24s %4zu frames: UI %5.1f ms median, %5.1f ms p99 (< 16): %s; whole %5.1f ms median, %5.1f ms p99 (<= 50): "
        "%s\n",
        what, log.ui_s.size(), 1e3 * percentile(log.ui_s, 0.5), 1e3 * ui, verdict(ui < ui_limit_s),
        1e3 * percentile(log.whole_s, 0.5), 1e3 * whole, verdict(whole <= whole_limit_s));
}

// A zoom at which as many nodes are on the canvas in detail as the promise allows.
std::size_t show_detailed_nodes(DrivenWindow& driven)
{
    ui::ViewState& view = driven.workbench().editor().view;
    view.panes.canvas_share = 0.6f;
    auto count = [&] {
        const ui::WidgetRects& rects = driven.workbench().editor().rects;
        ui::WidgetRect canvas = *rects.find("canvas");
        std::size_t shown = 0;
        for (const auto& [name, rect] : rects.all()) {
            glm::vec2 at = rect.centre();
            bool visible = at.x > canvas.low.x && at.y > canvas.low.y && at.x < canvas.high.x && at.y < canvas.high.y;
            shown += visible && name.starts_with("canvas/node/") && name.ends_with("/out");
        }
        return shown;
    };
    const std::vector<graph::Node>& nodes = driven.workbench().session().document().root.nodes;
    glm::vec2 middle{0, 0};
    for (const graph::Node& node : nodes) middle += node.position / static_cast<float>(nodes.size());
    for (view.canvas.zoom = 1; view.canvas.zoom > 0.52f; view.canvas.zoom *= 0.95f) {
        ui::WidgetRect canvas = *driven.workbench().editor().rects.find("canvas");
        view.canvas.pan_px = 0.5f * (canvas.high - canvas.low) - view.canvas.zoom * middle;
        driven.move({400, 600});
        driven.run(0.1);
        if (count() >= detailed_nodes) break;
    }
    return count();
}

FrameLog hover(DrivenWindow& driven)
{
    glm::vec2 canvas = driven.place("canvas");
    return driven.measure(
        phase_seconds, [&](double s) { driven.move(canvas + 150.0f * glm::vec2(std::cos(3 * s), std::sin(4 * s))); });
}

FrameLog orbit(DrivenWindow& driven)
{
    glm::vec2 viewport = driven.place("viewport");
    driven.move(viewport);
    driven.run(0.1);
    driven.button(true);
    FrameLog log = driven.measure(phase_seconds, [&](double s) {
        driven.move(viewport + 150.0f * glm::vec2(std::sin(2 * s), 0.3f * std::cos(2 * s)));
    });
    driven.button(false);
    driven.run(0.1);
    return log;
}

void measure_frames(DrivenWindow& driven)
{
    print_frames("moving over the canvas", hover(driven));
    FrameLog log = orbit(driven);
    print_frames("orbiting", log);
    std::printf("%-24s %.1f pictures per second\n", "", log.pictures / phase_seconds);
}

void select_a_ball(DrivenWindow& driven)
{
    graph::NodeId ball;
    for (const graph::Node& node : driven.workbench().session().document().root.nodes)
        if (node.type == "sphere") ball = node.id;
    driven.workbench().editor().view.selection.only(ball);
}

FrameLog drag(DrivenWindow& driven)
{
    select_a_ball(driven);
    driven.move({1, 1});
    driven.run(0.3);
    glm::vec2 field = driven.place("inspector/radius");
    driven.move(field);
    driven.run(0.2);
    std::size_t steps = driven.workbench().session().history().size();
    driven.button(true);
    // Always to the right of where it began: a drag that ends with the value it had is no step.
    FrameLog log =
        driven.measure(phase_seconds, [&](double s) { driven.move(field + glm::vec2(20 + 15 * std::sin(3 * s), 0)); });
    driven.button(false);
    driven.run(0.3);
    demand(driven.workbench().session().history().size() == steps + 1, "a drag is one step");
    return log;
}

void measure_drag(DrivenWindow& driven)
{
    int links = driven.workbench().rendering().links;
    FrameLog log = drag(driven);
    links = driven.workbench().rendering().links - links;
    print_frames("dragging a value", log);
    double rate = log.pictures / phase_seconds;
    std::printf("%-24s %.1f pictures per second (>= 10): %s; programs linked: %d (0): %s\n", "", rate,
                verdict(rate >= 10), links, verdict(links == 0));
}

// A key that comes when it comes: in the midst of a frame, while the window sleeps, while the last picture gets finer.
class Keystroke {
public:
    explicit Keystroke(Clock::time_point at)
        : at_(at), thread_([this] {
              std::this_thread::sleep_until(at_);
              pressed_ = true;
              app::Window::wake();
          })
    {
    }
    ~Keystroke() { thread_.join(); }
    bool pressed() const { return pressed_; }

private:
    Clock::time_point at_;
    std::atomic<bool> pressed_ = false;
    std::thread thread_;
};

// Mutes or unmutes the selected node; seconds from the key to the end of the frame that shows the first picture of it.
double edit_seconds(DrivenWindow& driven, double delay_s, FrameLog& log)
{
    app::Workbench& workbench = driven.workbench();
    auto at = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(delay_s));
    Keystroke keystroke(at);
    bool told = false;
    std::uint64_t before = 0;
    while (seconds_since(at) < 10) {
        if (!told && keystroke.pressed()) {
            before = workbench.asked_generation();
            for (bool down : {true, false}) workbench.input().push({.kind = Kind::key, .code = 'M', .down = down});
            told = true;
        }
        int drawn = workbench.frames_drawn();
        workbench.turn();
        if (workbench.frames_drawn() != drawn) log.note(workbench);
        if (told && workbench.pictured_generation() > before) break;
    }
    return seconds_since(at);
}

void measure_edits(DrivenWindow& driven)
{
    std::vector<double> seconds;
    FrameLog log;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> delay_s(0.15, 0.5);
    select_a_ball(driven);
    driven.move(driven.place("canvas"));
    driven.run(0.5);
    for (int edit = 0; edit < edits; ++edit) seconds.push_back(edit_seconds(driven, delay_s(random), log));
    print_frames("editing", log);
    double worst = percentile(seconds, 1), median = percentile(seconds, 0.5);
    std::printf("%-24s %d edits: %.0f / %.0f / %.0f / %.0f ms (min, median, p99, max); every one <= 100 ms: %s\n",
                "first picture after edit", edits, 1e3 * percentile(seconds, 0), 1e3 * median,
                1e3 * percentile(seconds, 0.99), 1e3 * worst, verdict(worst <= 0.1));
}

void measure_idle(DrivenWindow& driven)
{
    auto start = Clock::now();
    while (!(driven.workbench().readings().picture.full && !driven.workbench().rendering().busy) &&
           seconds_since(start) < 120)
        driven.workbench().turn();
    driven.run(1);
    double before = processor_seconds();
    int frames = driven.workbench().frames_drawn();
    driven.run(idle_seconds);
    double share = (processor_seconds() - before) / idle_seconds;
    std::printf("%-24s %.2f %% of a core (< 2 %%): %s; %d frames\n", "at rest", 100 * share, verdict(share < 0.02),
                driven.workbench().frames_drawn() - frames);
}

void measure_loaded(const graph::Library& library, const std::filesystem::path& folder, graph::Document document)
{
    std::size_t nodes = document.root.nodes.size();
    DrivenWindow driven(kept(std::move(document), library, folder / "csg.scene.json"), folder / "state");
    std::size_t shown = show_detailed_nodes(driven);
    std::printf("csg(%d), %zu nodes, %zu of them in detail on the canvas, 1280x720\n", primitives, nodes, shown);
    {
        Compiling compiling(driven.workbench().readings().program);
        measure_frames(driven);
        measure_drag(driven);
        measure_edits(driven);
        std::printf("%-24s %d times meanwhile\n", "the scene was compiled", compiling.compiled());
    }
    measure_idle(driven);
}

// By the clock, UI time holds what other programs took of the processor meanwhile.
void print_heavy(const char* what, const FrameLog& log)
{
    std::printf("  %-22s %4zu", what, log.ui_s.size());
    for (const auto* seconds : {&log.ui_s, &log.ui_processor_s, &log.edit_processor_s, &log.whole_s})
        std::printf("   %5.1f %5.1f %5.1f", 1e3 * percentile(*seconds, 0.5), 1e3 * percentile(*seconds, 0.99),
                    1e3 * percentile(*seconds, 1));
    std::printf("   %-7s  %s\n", verdict(percentile(log.ui_s, 0.99) < ui_limit_s),
                verdict(percentile(log.ui_processor_s, 0.99) < ui_limit_s));
}

// Every frame is drawn while a picture is in the making.
void measure_heavy(const graph::Library& library, const std::filesystem::path& folder, graph::Document document)
{
    std::size_t nodes = document.root.nodes.size();
    DrivenWindow driven(kept(std::move(document), library, folder / "heavy.scene.json"), folder / "heavy_state");
    std::shared_ptr<const graph::Program> program = driven.workbench().readings().program;
    demand(program->problems.empty() && codegen::features_of(*program, program->block).bounces, "glass and mirrors");
    std::printf("\ncsg(%d) of glass and mirrors, %d bounces, %zu nodes, 1280x720; ms: median, p99, max\n",
                heavy_primitives, program->bounces, nodes);
    std::printf("  %-22s %4s   %-17s   %-17s   %-17s   %-17s   p99 of UI < 16 ms\n", "", "", "UI by the clock",
                "of the processor", "lowering edits", "whole frame");
    using Hand = FrameLog (*)(DrivenWindow&);
    constexpr std::pair<const char*, Hand> hands[] = {
        {"moving over the canvas", hover}, {"orbiting", orbit}, {"dragging a value", drag}};
    for (bool whole_graph : {true, false}) {
        if (whole_graph) driven.workbench().editor().run("view.frame_all_nodes");
        else show_detailed_nodes(driven);
        driven.run(0.5);
        std::printf(whole_graph ? "all nodes on the canvas\n" : "nodes in detail\n");
        for (const auto& [what, hand] : hands) {
            FrameLog log = hand(driven);
            print_heavy(what, log);
            demand(log.rendering == static_cast<int>(log.ui_s.size()),
                   "frames, and those while a picture is in the making");
        }
    }
}

void run()
{
    graph::TemporaryFolder folder;
    auto library = graph::Library::embedded();
    measure_loaded(*library, folder.path(), csg_document(csg_scene(primitives), library));
    measure_heavy(*library, folder.path(), csg_of_glass(csg_scene(heavy_primitives), heavy_bounces, library));
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }
