// Where the silhouettes of solids made of three drawings differ from the drawings: cells that no part of the solid lies
// behind, because the other two drawings leave nothing there.
#pragma once

#include "graph/program.h"
#include "ui/readings.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace fieldwright::app {

struct Silhouettes {
    std::vector<graph::Problem> notes;  // on the solids
    ui::MissedCells missed;
};

// Looks along each view of every `three_extrusions` node at the middle of every filled cell of the drawing wired to it.
// Gives up, with what it has, once `cancelled`.
Silhouettes compare_silhouettes(const graph::Document& document, const std::shared_ptr<const graph::Library>& library,
                                const std::atomic<bool>& cancelled);

// Compares on a thread of its own: always the newest document it was given, one at a time.
class SilhouetteWatch {
public:
    explicit SilhouetteWatch(void (*on_ready)()) : on_ready_(on_ready) {}
    ~SilhouetteWatch();
    SilhouetteWatch(const SilhouetteWatch&) = delete;
    SilhouetteWatch& operator=(const SilhouetteWatch&) = delete;

    void look_at(const graph::Document& document, std::shared_ptr<const graph::Library> library);
    bool take();                                           // a newer answer came
    const Silhouettes& answer() const { return answer_; }  // of the last document that was looked at to the end

private:
    struct Task {
        graph::Document document;
        std::shared_ptr<const graph::Library> library;
    };
    void run();

    void (*on_ready_)();
    Silhouettes answer_;

    std::mutex mutex_;  // guards the four below
    std::optional<Task> task_;
    std::optional<Silhouettes> ready_;
    bool running_ = false;
    bool outdated_ = false;  // what is being compared is of a document that has gone
    std::atomic<bool> cancelled_ = false;
    std::thread thread_;
};

}  // namespace fieldwright::app
