// What each node costs: how much less time the CPU takes for the picture without it.
#pragma once

#include "graph/program.h"
#include "renderer/frame.h"
#include "ui/readings.h"

#include <mutex>
#include <thread>

namespace fieldwright::app {

struct CostTask {
    graph::Document document;  // at rest
    std::shared_ptr<const graph::Library> library;
    graph::BakedImages images;
    renderer::FrameRequest picture;
};

// The document with a field node replaced by a box around it, or by nothing where it has no end.
graph::Document without_node(const CostTask& task, graph::NodeId node);

// Processor time in milliseconds that a small picture of the document takes on one core, scaled up to the size of
// task.picture on all cores.
double picture_ms(const CostTask& task, const graph::Document& document);

// Measures on a thread of its own, at the lowest priority, when asked.
class NodeCostMeter {
public:
    explicit NodeCostMeter(void (*on_ready)()) : on_ready_(on_ready) {}

    void measure(CostTask task);  // gives up what is being measured
    void forget();                // the document is another one
    ui::NodeCosts costs() const;  // as far as they are known

private:
    void run(const std::stop_token& stop, const CostTask& task);
    void publish(const ui::NodeCosts& costs);

    void (*on_ready_)();
    mutable std::mutex mutex_;
    ui::NodeCosts costs_;
    std::jthread thread_;
};

}  // namespace fieldwright::app
