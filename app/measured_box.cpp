// Lowers a node alone and evaluates the bounds of it.
#include "app/measured_box.h"

#include "field/evaluator.h"

namespace fieldwright::app {

std::optional<ui::Measured> measured_box(const graph::Document& document,
                                         const std::shared_ptr<const graph::Library>& library,
                                         const graph::BakedImages& images, graph::SlopeMemo& slopes, graph::NodeId node)
{
    graph::LowerOptions options;
    options.bounds = true;
    options.root = node;
    options.images = &images;
    options.slopes = &slopes;
    graph::Program program = graph::lower(document, library, options);
    if (program.bounds < 0) return std::nullopt;
    std::int32_t slot = program.values[static_cast<std::size_t>(program.bounds)].slot;
    if (slot < 0) return std::nullopt;
    std::vector<float> block = field::evaluate_frame(program, 0);
    const float* box = &block[static_cast<std::size_t>(slot)];
    return ui::Measured{{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
}

}  // namespace fieldwright::app
