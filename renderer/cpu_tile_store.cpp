// What a tile's turns have found, in the frame.
#include "renderer/cpu_tile.h"

#include <limits>

namespace fieldwright::renderer {
namespace {

std::size_t place_of(int pixel, const Area& area, const Frame& frame)
{
    return static_cast<std::size_t>(area.y + pixel / area.width) * static_cast<std::size_t>(frame.width) +
           static_cast<std::size_t>(area.x + pixel % area.width);
}

}  // namespace

// After the first turn, whose rays are the eye's.
void TileRenderer::store_eyes(const Area& area, Frame& frame) const
{
    const StructureLanes& lanes = scene_.lanes;
    for (int pixel = 0; pixel < area.width * area.height; ++pixel) {
        std::size_t to = place_of(pixel, area, frame);
        frame.depth[to] = std::numeric_limits<float>::infinity();
        frame.normal[to] = glm::vec3(0);
        frame.node_id[to] = frame.material_id[to] = 0;
        frame.steps[to] = static_cast<int>(walked_.lane(lanes.probe_steps)[pixel]);
        frame.exhausted[to] = walked_.lane(lanes.probe_exhausted)[pixel] > 0.5f || remaining_.lane(0)[pixel] < 0.5f;
    }
    for (int pixel : hits_) {
        std::size_t to = place_of(pixel, area, frame);
        frame.depth[to] = walked_.lane(lanes.probe_t)[pixel] * forward_share_.lane(0)[pixel];
        frame.normal[to] = normal_.vec3(0, pixel);
        frame.node_id[to] = static_cast<int>(ids_.lane(0)[pixel]);
        frame.material_id[to] = static_cast<int>(ids_.lane(1)[pixel]);
    }
}

// Too.
void TileRenderer::store_layers(const Area& area, Frame& frame) const
{
    const StructureLanes& lanes = scene_.lanes;
    Layers& layers = *frame.layers;
    for (int pixel = 0; pixel < area.width * area.height; ++pixel) {
        std::size_t to = place_of(pixel, area, frame);
        layers.albedo[to] = layers_.vec3(LayerLane::albedo, pixel);
        layers.shadow[to] = layers_.lane(LayerLane::shadow)[pixel];
        layers.shadow_steps[to] = static_cast<int>(shadow_steps_.lane(0)[pixel]);
        layers.position[to] = glm::vec3(0);
        layers.occlusion[to] = 1.0f;
        layers.gradient_length[to] = 0.0f;
        layers.minimum_cone_ratio[to] = walked_.lane(lanes.probe_cone_ratio)[pixel];
    }
    for (int pixel : hits_) {
        std::size_t to = place_of(pixel, area, frame);
        layers.position[to] = position_.vec3(0, pixel);
        layers.occlusion[to] = walked_.lane(lanes.probe_openness)[pixel];
        layers.gradient_length[to] = glm::length(walked_.vec3(lanes.probe_gradient, pixel));
    }
}

void TileRenderer::store_colours(const Area& area, Frame& frame) const
{
    for (int pixel = 0; pixel < area.width * area.height; ++pixel) {
        std::size_t to = place_of(pixel, area, frame);
        frame.colour[to] = colour_.vec3(0, pixel) + reflection_.vec3(0, pixel);
        frame.exhausted[to] = frame.exhausted[to] || remaining_.lane(0)[pixel] < 0.5f;
        if (edges_) frame.covered[to] = covered_.lane(0)[pixel];
        if (!frame.layers) continue;
        Layers& layers = *frame.layers;
        layers.ambient[to] = layers_.vec3(LayerLane::ambient, pixel);
        layers.diffuse[to] = layers_.vec3(LayerLane::diffuse, pixel);
        layers.specular[to] = layers_.vec3(LayerLane::specular, pixel);
        layers.reflection[to] = reflection_.vec3(0, pixel);
        layers.emission[to] = layers_.vec3(LayerLane::emission, pixel);
    }
}

}  // namespace fieldwright::renderer
