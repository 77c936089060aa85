// What the program knows and the window shows: plain values, filled by app before every frame.
#pragma once

#include "graph/program.h"

#include "ui/choices.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fieldwright::ui {

// The newest picture of the viewport.
struct PictureReading {
    ImTextureID texture = nullptr;        // null while there is none
    int width = 0, height = 0;            // px it was drawn with
    bool full = false;                    // full resolution; else it is being refined
    int samples = 1, samples_wanted = 1;  // of a pixel, in it and in the end
    float progress = 0;                   // of the picture being drawn, 0 to 1
    float draw_ms = 0;
    float mean_steps = 0;  // of eye rays
    int p99_steps = 0;     // 99 of 100 rays take at most so many
    int max_steps = 0;
    float exhausted_share = 0;             // of pixels out of steps
    std::optional<double> fighting_share;  // of pixels over whose colour the eyes fight; nothing of one eye
    double evaluations = 0;                // of the field, by all rays; 0 = not counted
    std::string device;                    // "cpu", "gpu llvmpipe", ...
    bool compiling = false;                // a shader is on its way
    double pictures_per_second = 0;        // while something moves
};

// Nearest and farthest of what is seen, without the last hundredth on either side.
struct DepthRange {
    float near = 0, far = 0;  // m
};

// The steps of the last picture as a small picture of its own.
struct StepsPicture {
    ImTextureID texture = nullptr;
    int width = 0, height = 0;  // px
};

// Drawing time of the nodes on the CPU: what the picture would take less without each.
struct NodeCosts {
    bool measuring = false;
    float progress = 0;                       // 0 to 1
    double picture_ms = 0;                    // the whole picture; 0 = not measured
    std::map<graph::NodeId, double> by_node;  // ms
    std::string failure;                      // why there is none
};

// The ray that is inspected: what the marcher saw on its way.
struct RayReading {
    struct Step {
        float t, distance, cone_ratio;  // m, m, distance by way
    };
    enum class End { hit, missed, out_of_steps };

    glm::vec3 origin{0}, direction{0, 0, -1};  // world space
    std::vector<Step> steps;
    End end = End::missed;
    float t_end = 0;  // m

    glm::vec3 at(float t) const { return origin + t * direction; }
};

struct Measured {  // the box around a surface; unbounded sides are 1e6
    glm::vec3 centre{0}, half_size{0};
};

// A smooth combiner over the difference of its two distances, computed by its own function.
struct BlendCurve {
    float size = 0;             // m: it blends where the two distances differ by less
    bool of_sum = false;        // b counts from its inside, as it is taken away: the axis is a + b
    std::vector<float> across;  // a - b, or a + b, m; evenly spaced
    std::vector<float> a, b;    // m; b with its sign turned when `of_sum`
    std::vector<float> result;  // m
    std::vector<float> slope;   // of the result by that of a: 1 all a, -1 all b
};

// Cells of drawings that a solid made of them does not show, by the drawing's node; from its lower left corner.
using MissedCells = std::map<graph::NodeId, std::vector<glm::ivec2>>;

struct RecentFile {
    std::string path;
    bool missing = false;
};

struct Example {  // a scene that is built into the program
    std::string name, title, sentence;
    ImTextureID picture = nullptr;  // 16 : 9
};

struct Recovered {  // an autosave that a crash left behind
    std::string id, title, when;
};

struct ForeignCode {  // of an own type that nobody here wrote
    std::string type, text;
    bool operator==(const ForeignCode&) const = default;
};

struct SavedGroup {        // of the user's library
    graph::NodeType type;  // what it will be here
    std::string text;      // holds the group
};

struct Readings {
    // Lowered from the document of this frame.
    std::shared_ptr<const graph::Program> program;
    std::vector<graph::Problem> problems;             // the program's, the compiler's and the hot reload's
    std::shared_ptr<const MissedCells> missed_cells;  // null while nobody looked
    std::shared_ptr<const std::string> shader_text;   // live GLSL of the shown scene; null while none was asked for
    std::vector<std::string> export_targets;          // "glsl", "shadertoy"

    PictureReading picture;
    // Of the members of `ViewState` of these names.
    std::vector<ViewChoice> views;
    std::vector<StereoChoice> stereo_modes;
    std::vector<ColourMapChoice> colour_maps;
    std::vector<Choice> slice_styles;
    // What the picture shows at a pixel of it (top-left origin).
    std::function<graph::NodeId(int x, int y)> node_at;
    std::function<std::optional<float>(int x, int y)> depth_at;  // m along the view axis; nothing on a miss
    // Of what the picture shows, m along the view axis; nothing where it shows only sky.
    std::function<std::optional<DepthRange>()> depth_range;
    StepsPicture steps_picture;  // while the cost panel is open
    NodeCosts node_costs;
    std::shared_ptr<const RayReading> ray;  // null while none is inspected
    // In the node's own space, before what its readers do to it. NodeId{} = the whole scene.
    std::function<std::optional<Measured>(graph::NodeId)> bounds_of;
    std::function<std::optional<BlendCurve>(graph::NodeId)> blend_of;  // of a smooth combiner; nothing of others

    // History.
    std::vector<std::string> step_names;  // "start" first
    std::size_t step = 0;

    // File.
    std::string file_name;  // "first.scene.json", or "untitled"
    std::string file_path;  // empty while never saved
    bool dirty = false;
    bool changed_on_disk = false;
    std::string overwrite_warning;  // why else to ask before saving to that file
    std::vector<RecentFile> recent;
    std::vector<Recovered> recovered;
    std::vector<ForeignCode> foreign_code;  // waits to be allowed
    std::vector<SavedGroup> saved_groups;
    // Families of the fonts that are installed, by name; found when it is first asked.
    std::function<const std::vector<std::string>&()> font_families;
    std::vector<Example> examples;  // the best to begin with first
    bool dialog_open = false;       // a native file dialog is up; the window waits for nothing

    std::string status;    // last outcome worth saying: "Saved first.scene.json"
    int status_count = 0;  // of outcomes said: the same may be said again
    bool status_is_error = false;
    double time_s = 0;  // of the scene, played or set
    double frames_per_second = 0;
    bool has_camera = false;  // the scene has a camera wired to its output
};

}  // namespace fieldwright::ui
