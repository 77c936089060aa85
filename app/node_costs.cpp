// Pictures without a node, and the time they take.
#include "app/node_costs.h"

#include "app/measured_box.h"
#include "app/stopwatch.h"
#include "graph/edits.h"
#include "graph/groups.h"
#include "graph/slope.h"
#include "renderer/devices.h"
#include "renderer/low_priority.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::app {
namespace {

using graph::NodeId;

constexpr float unbounded = 1e5f;       // m, of half a box
constexpr int measured_pixels = 24000;  // of the small picture
constexpr int repeats = 3;              // the quickest counts: what disturbs only adds

renderer::FrameRequest small_picture(renderer::FrameRequest request)
{
    double pixels = static_cast<double>(request.width) * request.height;
    double shrink = std::min(1.0, std::sqrt(measured_pixels / std::max(pixels, 1.0)));
    request.width = std::max(static_cast<int>(request.width * shrink), 16);
    request.height = std::max(static_cast<int>(request.height * shrink), 16);
    request.slice.reset();
    request.layers = false;
    return request;
}

// A box in the node's place, among the nodes of `document.root`; none when the node has no end.
NodeId add_bound(graph::Document& document, const graph::Library& library, const ui::Measured& box, int dimension)
{
    if (glm::length(box.half_size) > unbounded) return {};
    bool flat = dimension == 2;
    NodeId shape = graph::add_node(document, library, flat ? "rectangle" : "box");
    NodeId moved = graph::add_node(document, library, flat ? "translate_2d" : "translate");
    glm::vec3 half = glm::clamp(box.half_size, glm::vec3(0.001f), glm::vec3(100));
    auto vector = [&](glm::vec3 v) { return flat ? graph::Value(glm::vec2(v)) : graph::Value(v); };
    graph::set_parameter(document, library, shape, "half_size", vector(half));
    graph::set_parameter(document, library, moved, "offset", vector(box.centre));
    graph::connect(document, library, shape, moved, "d");
    return moved;
}

void replace(graph::Document& document, const graph::Library& library, NodeId node, NodeId by)
{
    std::vector<graph::Wire> wires;
    for (const graph::Node& reader : document.root.nodes)
        for (const auto& [socket, source] : reader.inputs)
            if (source == node) wires.push_back({by, reader.id, socket});
    if (by && !graph::connect_all(document, library, wires)) return;
    for (const graph::Wire& wire : wires) graph::disconnect(document, wire.target, wire.socket);
}

std::vector<NodeId> field_nodes(const graph::Document& document, const graph::Library& library)
{
    std::vector<NodeId> found;
    graph::for_each_graph(document, [&](const graph::Graph& graph) {
        for (const graph::Node& node : graph.nodes) {
            const graph::NodeType* type = library.type(node.type);
            if (type && type->is_field() && type->category != "output" && !node.muted) found.push_back(node.id);
        }
    });
    return found;
}

std::string group_of(const graph::Document& document, NodeId node)
{
    for (const graph::Group& group : document.groups)
        if (group.graph.find(node)) return group.name;
    return {};
}

}  // namespace

graph::Document without_node(const CostTask& task, NodeId node)
{
    graph::Document document = task.document;
    int dimension = graph::field_dimension(document, *task.library, node);
    graph::SlopeMemo slopes;
    std::optional<ui::Measured> box = measured_box(document, task.library, task.images, slopes, node);
    std::string group = group_of(document, node);
    std::optional<graph::Entered> entered;
    if (!group.empty()) entered.emplace(document, group);
    NodeId bound = box ? add_bound(document, *task.library, *box, dimension) : NodeId{};
    replace(document, *task.library, node, bound);
    return document;
}

double picture_ms(const CostTask& task, const graph::Document& document)
{
    renderer::FrameRequest request = small_picture(task.picture);
    graph::Program program = graph::lower(document, task.library, {.images = &task.images});
    renderer::Frame frame(request.width, request.height);
    tbb::task_arena alone(1);  // this thread draws everything, so that its time is the picture's
    double best_s = 1e9;
    for (int i = 0; i < repeats; ++i) {
        Stopwatch watch;
        alone.execute([&] { renderer::draw_on_cpu(frame, program, request, {}); });
        best_s = std::min(best_s, watch.taken().processor_s);
    }
    double pixels = static_cast<double>(task.picture.width) * task.picture.height;
    double share = pixels / (static_cast<double>(request.width) * request.height);
    return 1e3 * best_s * share / std::max(1u, std::thread::hardware_concurrency());
}

void NodeCostMeter::measure(CostTask task)
{
    thread_ = {};  // stops and waits
    publish({.measuring = true});
    thread_ = std::jthread([this, task = std::move(task)](const std::stop_token& stop) { run(stop, task); });
}

void NodeCostMeter::forget()
{
    thread_.request_stop();
    std::lock_guard lock(mutex_);
    costs_ = {};
}

ui::NodeCosts NodeCostMeter::costs() const
{
    std::lock_guard lock(mutex_);
    return costs_;
}

void NodeCostMeter::publish(const ui::NodeCosts& costs)
{
    std::lock_guard lock(mutex_);
    costs_ = costs;
}

void NodeCostMeter::run(const std::stop_token& stop, const CostTask& task)
{
    renderer::lower_priority("node costs", renderer::Priority::compile);
    ui::NodeCosts costs{.measuring = true};
    try {
        double whole = picture_ms(task, task.document);
        std::vector<NodeId> nodes = field_nodes(task.document, *task.library);
        for (std::size_t i = 0; i < nodes.size() && !stop.stop_requested(); ++i) {
            double without = picture_ms(task, without_node(task, nodes[i]));
            costs.by_node[nodes[i]] = std::max(whole - without, 0.0);
            costs.progress = static_cast<float>(i + 1) / static_cast<float>(nodes.size());
            if (!stop.stop_requested()) publish(costs), on_ready_();
        }
        costs.picture_ms = whole;
    } catch (const std::exception& failure) {
        costs = {.failure = failure.what()};
    }
    costs.measuring = false;
    if (!stop.stop_requested()) publish(costs), on_ready_();
}

}  // namespace fieldwright::app
