// Rays through cells, a few samples of all of them at a time.
#include "app/silhouettes.h"

#include "field/evaluator.h"
#include "graph/drawing.h"
#include "graph/expansion.h"
#include "graph/known_types.h"
#include "renderer/low_priority.h"

#include <algorithm>
#include <array>

namespace fieldwright::app {
namespace {

using graph::Node;
using graph::NodeId;

constexpr unsigned sample_count = 256, samples_at_once = 16;  // along a ray, through the solid's box

// A view of the solid: where a point of the drawing's plane lies in space, at a way along the line of sight.
struct View {
    const char *socket, *shown, *words;
    int axis;  // along which it looks

    glm::vec3 place(glm::vec2 p, float way) const
    {
        if (axis == 2) return {p.x, p.y, way};
        return axis == 0 ? glm::vec3(way, p.y, -p.x) : glm::vec3(p.x, way, -p.y);
    }
};

constexpr std::array views = {View{"a", "front", "front view", 2}, View{"b", "right", "right view", 0},
                              View{"c", "above", "view from above", 1}};

template <typename T>
const T* value_of(const Node& node, std::string_view name)
{
    const graph::Value* value = node.input(name) ? nullptr : node.parameter(name);
    return value ? std::get_if<T>(value) : nullptr;
}

// A drawing as it lies in its plane.
struct Sheet {
    graph::Drawing drawing;
    float cell_size;  // m

    glm::vec2 middle(glm::ivec2 cell) const
    {
        return (glm::vec2(cell) + 0.5f - 0.5f * static_cast<float>(drawing.side())) * cell_size;
    }
};

std::optional<Sheet> sheet_of(const Node& node, const graph::Library& library)
{
    const graph::NodeType* type = library.type(node.type);
    if (!type || node.muted) return std::nullopt;
    for (const graph::Parameter& parameter : type->parameters) {
        if (parameter.unit != graph::drawing_unit || parameter.kind != graph::ParameterKind::list) continue;
        const auto* rectangles = value_of<graph::PointList>(node, parameter.name);
        const auto* cells = value_of<int>(node, graph::drawing_unit);
        const auto* size = value_of<float>(node, "size");
        if (!rectangles || !cells || !size) return std::nullopt;
        graph::Drawing drawing(*rectangles, *cells);
        return Sheet{drawing, *size / static_cast<float>(drawing.side())};
    }
    return std::nullopt;
}

// The solid alone, in its own space.
struct Solid {
    graph::Program program;
    std::vector<float> block;
    std::array<float, 3> low{}, high{};

    Solid(const graph::Document& document, const std::shared_ptr<const graph::Library>& library, NodeId node)
        : program(graph::lower(document, library, {.bounds = true, .root = node}))
    {
        if (program.gpu_only) return;
        block = field::evaluate_frame(program, 0);
        auto slot = static_cast<std::size_t>(program.values[static_cast<std::size_t>(program.bounds)].slot);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float centre = block[slot + axis], half = block[slot + 3 + axis];
            if (half > 1e4f) centre = 0, half = 1;  // the same all along
            low[axis] = centre - half;
            high[axis] = centre + half;
        }
    }
};

// 0, 128, 64, 192 ...: samples that halve the gaps between those before.
unsigned bit_reversed(unsigned number)
{
    unsigned result = 0;
    for (unsigned bit = 1; bit < sample_count; bit *= 2) result = 2 * result + (number & bit ? 1 : 0);
    return result;
}

std::vector<glm::ivec2> filled_cells(const graph::Drawing& drawing)
{
    std::vector<glm::ivec2> cells;
    for (int y = 0; y < drawing.side(); ++y)
        for (int x = 0; x < drawing.side(); ++x)
            if (drawing.filled(x, y)) cells.emplace_back(x, y);
    return cells;
}

// The filled cells behind which no sample lies in the solid.
std::vector<glm::ivec2> missed_cells(const Solid& solid, const View& view, const Sheet& sheet,
                                     const std::atomic<bool>& cancelled)
{
    std::vector<glm::ivec2> missed = filled_cells(sheet.drawing);
    auto axis = static_cast<std::size_t>(view.axis);
    for (unsigned sample = 0; sample < sample_count && !missed.empty() && !cancelled; sample += samples_at_once) {
        std::vector<glm::vec3> points;
        for (glm::ivec2 cell : missed)
            for (unsigned i = sample; i < sample + samples_at_once; ++i) {
                float share = (static_cast<float>(bit_reversed(i)) + 0.5f) / static_cast<float>(sample_count);
                points.push_back(view.place(sheet.middle(cell), glm::mix(solid.low[axis], solid.high[axis], share)));
            }
        std::vector<float> distances = field::distances(solid.program, solid.block, points);
        std::vector<glm::ivec2> left;
        for (std::size_t i = 0; i < missed.size(); ++i) {
            auto first = distances.begin() + static_cast<std::ptrdiff_t>(i * samples_at_once);
            if (std::none_of(first, first + samples_at_once, [](float distance) { return distance <= 0; }))
                left.push_back(missed[i]);
        }
        missed = std::move(left);
    }
    return missed;
}

// A scene whose groups are expanded, and whose nodes its nodes are.
struct Scene {
    graph::Document document;
    std::vector<graph::InnerCopy> copies;

    graph::Problem note_on(NodeId node, std::string sentence) const
    {
        std::vector<NodeId> path = graph::path_of(copies, node);
        return {path.front(), std::move(sentence), graph::Problem::Severity::note, {path.begin() + 1, path.end()}};
    }
    NodeId original(NodeId node) const { return graph::path_of(copies, node).back(); }
};

Scene scene_of(const graph::Document& document, const graph::Library& library)
{
    if (document.groups.empty()) return {document, {}};
    graph::Expansion expansion = graph::expanded(document, library);
    return {std::move(expansion.document), std::move(expansion.copies)};
}

void compare(const Scene& scene, const std::shared_ptr<const graph::Library>& library, const Node& node,
             const std::atomic<bool>& cancelled, Silhouettes& into)
{
    const graph::Document& document = scene.document;
    std::optional<Solid> solid;
    for (const View& view : views) {
        const Node* source = document.root.find(node.input(view.socket));
        const bool* shown = value_of<bool>(node, view.shown);
        std::optional<Sheet> sheet = source && shown && *shown ? sheet_of(*source, *library) : std::nullopt;
        if (!sheet || cancelled) continue;
        if (!solid) solid.emplace(document, library, node.id);
        if (solid->program.gpu_only) return;
        std::vector<glm::ivec2> missed = missed_cells(*solid, view, *sheet, cancelled);
        if (missed.empty()) continue;
        into.notes.push_back(scene.note_on(
            node.id, "the " + std::string(view.words) + " misses " + std::to_string(missed.size()) + " of " +
                         std::to_string(sheet->drawing.count()) + " cells: the other views leave nothing behind them"));
        std::vector<glm::ivec2>& cells = into.missed[scene.original(source->id)];
        cells.insert(cells.end(), missed.begin(), missed.end());
    }
}

bool is_solid(const Node& node) { return node.type == graph::known_types::three_extrusions && !node.muted; }

bool has_solids(const graph::Document& document)
{
    bool found = false;
    graph::for_each_graph(document, [&](const graph::Graph& graph) {
        found = found || std::any_of(graph.nodes.begin(), graph.nodes.end(), is_solid);
    });
    return found;
}

}  // namespace

Silhouettes compare_silhouettes(const graph::Document& document, const std::shared_ptr<const graph::Library>& library,
                                const std::atomic<bool>& cancelled)
{
    Silhouettes silhouettes;
    Scene scene = scene_of(document, *library);
    for (const Node& node : scene.document.root.nodes)
        if (is_solid(node)) compare(scene, library, node, cancelled, silhouettes);
    return silhouettes;
}

SilhouetteWatch::~SilhouetteWatch()
{
    cancelled_ = true;
    if (thread_.joinable()) thread_.join();
}

void SilhouetteWatch::look_at(const graph::Document& document, std::shared_ptr<const graph::Library> library)
{
    std::lock_guard lock(mutex_);
    if (!has_solids(document)) {
        task_.reset();
        ready_.emplace();
        outdated_ = running_;
        return;
    }
    task_ = Task{document, std::move(library)};
    if (std::exchange(running_, true)) return;
    if (thread_.joinable()) thread_.join();
    thread_ = std::thread([this] { run(); });
}

bool SilhouetteWatch::take()
{
    std::lock_guard lock(mutex_);
    if (!ready_) return false;
    answer_ = std::move(*ready_);
    ready_.reset();
    return true;
}

void SilhouetteWatch::run()
{
    renderer::lower_priority("silhouettes", renderer::Priority::compile);
    while (true) {
        std::optional<Task> task;
        {
            std::lock_guard lock(mutex_);
            task.swap(task_);
            if (!task || cancelled_) {
                running_ = outdated_ = false;
                return;
            }
        }
        Silhouettes silhouettes = compare_silhouettes(task->document, task->library, cancelled_);
        {
            std::lock_guard lock(mutex_);
            if (!std::exchange(outdated_, false)) ready_ = std::move(silhouettes);
        }
        on_ready_();
    }
}

}  // namespace fieldwright::app
