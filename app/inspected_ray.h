// The ray that is inspected: it stays where it is in the world while the scene around it changes.
#pragma once

#include "renderer/ray_walk.h"
#include "ui/readings.h"

#include <memory>
#include <optional>

namespace fieldwright::app {

class InspectedRay {
public:
    // Through a pixel of the request's picture. graph::Failure when a node is not compiled into this program.
    void choose(const graph::Program& program, const renderer::FrameRequest& request, glm::ivec2 pixel);
    // Walks again when the program or the time is another one.
    void follow(const std::shared_ptr<const graph::Program>& program, float time_s);
    const std::shared_ptr<const ui::RayReading>& reading() const { return reading_; }  // null while none is inspected
    void forget();

private:
    std::optional<renderer::WorldRay> ray_;
    std::shared_ptr<const graph::Program> program_;  // that was walked through
    float time_s_ = 0;
    std::shared_ptr<const ui::RayReading> reading_;
};

}  // namespace fieldwright::app
