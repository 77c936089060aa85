// What follows from the live document: its program, problems, bounds and shader text. Derived; rebuilt when it changes.
#pragma once

#include "app/baking.h"
#include "app/silhouettes.h"
#include "graph/program.h"
#include "graph/slope.h"
#include "ui/readings.h"

#include <map>
#include <memory>
#include <string>

namespace fieldwright::app {

class ShownScene {
public:
    // `on_ready` is called on another thread when `poll` would take something.
    explicit ShownScene(void (*on_ready)() = [] {}) : silhouettes_(on_ready) {}

    // Lowers the document. Call when it, the library or a picture changed.
    void update(const graph::Document& document, const std::shared_ptr<const graph::Library>& library,
                graph::BakedImages images);

    // Remakes what the document holds ready-made of what was edited since. Before `update`.
    void bake(graph::Document& document, const graph::Library& library) { baking_.bake(document, library); }

    const std::shared_ptr<const graph::Program>& program() const { return program_; }
    // The program's, those of what is baked and of the newest silhouettes.
    std::vector<graph::Problem> problems() const;
    // Takes what was found out meanwhile; true when there was something.
    bool poll();
    const std::shared_ptr<const ui::MissedCells>& missed_cells() const { return missed_cells_; }
    bool has_camera() const { return has_camera_; }  // one is wired to the output
    // The box around a field node's surface, in its own space; the whole scene's for no node. Nothing for other nodes.
    std::optional<ui::Measured> bounds_of(graph::NodeId node);
    std::optional<ui::BlendCurve> blend_of(graph::NodeId node, float time_s) const;
    // The scene as a readable shader, or why it cannot be one as a comment, at a time in seconds.
    std::shared_ptr<const std::string> shader_text(float time_s);

private:
    bool is_drawn_alike(const graph::Document& document, const graph::Library& library,
                        const graph::BakedImages& images) const;

    graph::Document document_;
    std::shared_ptr<const graph::Library> library_;
    graph::BakedImages images_;
    graph::SlopeMemo slopes_;
    std::shared_ptr<const graph::Program> program_;
    Baking baking_;
    SilhouetteWatch silhouettes_;
    std::shared_ptr<const ui::MissedCells> missed_cells_;  // of the newest silhouettes
    std::vector<graph::Problem> problems_;                 // without those of the silhouettes
    bool has_camera_ = false;
    std::map<graph::NodeId, std::optional<ui::Measured>> bounds_;  // of this document
    std::shared_ptr<const std::string> shader_text_;               // of this document
};

}  // namespace fieldwright::app
