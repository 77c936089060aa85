// One tile of a CPU picture: its pixels' probes are marched 256 at a time, ray by ray.
#pragma once

#include "renderer/cpu_scene.h"

#include <chrono>
#include <span>
#include <vector>

namespace fieldwright::renderer {

inline constexpr int tile_width = 64, tile_height = 32;  // px, at most

// One thread's rows; draws one tile after the other. What a tile shows does not depend on the tiles before it.
class TileRenderer {
public:
    explicit TileRenderer(const CpuScene& scene);

    // False, and nothing drawn, when the watch cancelled it.
    bool draw(const Area& area, Frame& frame, const Watch& watch);

private:
    using Pixels = std::span<const int>;  // of the tile: x + y * width

    // An evaluator with this thread's rows.
    struct Stage {
        Stage(const field::Evaluator& evaluator, const std::vector<float>& block);
        void operator()(Rows& result, const Rows& input, int count);

        const field::Evaluator& evaluator;
        const std::vector<float>& block;
        field::Evaluator::Workspace workspace;
    };

    void start_eyes(const Area& area);
    bool march(Rows& probes, Pixels waiting);
    bool stops();
    void take_waiting(const Rows& probes, Pixels& waiting, int to);
    int step(int active);
    int replace_done(Rows& probes, Pixels& waiting, int active);
    void sort_pixels(Pixels pixels);
    bool cast_shadows(int light);
    void shade_hits(Pixels pixels);
    void shade_misses(Pixels pixels);
    void store(const Area& area, Frame& frame) const;

    const CpuScene& scene_;
    Stage distance_, surface_, ray_, sky_;
    std::vector<Stage> lights_;

    // By pixel of the tile.
    Rows eyes_, shadows_;             // probes
    Rows remaining_;                  // budget
    Rows direction_, forward_share_;  // of the eye ray; depth = length * share
    Rows position_, normal_, ids_;    // ids: node, material
    Rows lit_;                        // one lane per shadowed light
    Rows colour_;
    std::vector<int> hits_, misses_;

    // By lane of the batch being marched.
    Rows marching_, advanced_, point_, d_, done_;
    std::vector<int> pixel_of_;

    const Watch* watch_ = nullptr;
    std::chrono::steady_clock::time_point last_asked_;
};

}  // namespace fieldwright::renderer
