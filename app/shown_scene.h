// What follows from the live document: its program, problems, bounds and shader text. Derived; rebuilt when it changes.
#pragma once

#include "graph/program.h"
#include "ui/readings.h"

#include <map>
#include <memory>
#include <string>

namespace fieldwright::app {

class ShownScene {
public:
    // Lowers the document. Call when it, or the library, changed.
    void update(const graph::Document& document, const std::shared_ptr<const graph::Library>& library);

    const std::shared_ptr<const graph::Program>& program() const { return program_; }
    bool has_camera() const { return has_camera_; }  // one is wired to the output
    // The box around a field node's surface, in its own space; the whole scene's for no node. Nothing for other nodes.
    std::optional<ui::Measured> bounds_of(graph::NodeId node);
    // The scene as a readable shader, at a time in seconds.
    std::shared_ptr<const std::string> shader_text(float time_s);

private:
    graph::Document document_;
    std::shared_ptr<const graph::Library> library_;
    std::shared_ptr<const graph::Program> program_;
    bool has_camera_ = false;
    std::map<graph::NodeId, std::optional<ui::Measured>> bounds_;  // of this document
    std::shared_ptr<const std::string> shader_text_;               // of this document
};

}  // namespace fieldwright::app
