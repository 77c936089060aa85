// Probes of a pool, marched 256 at a time by one thread.
#pragma once

#include "renderer/cpu_scene.h"

#include <chrono>
#include <span>
#include <vector>

namespace fieldwright::renderer {

// Lanes a whole number of pages apart would share a few places of the cache.
inline constexpr int tile_width = 64, tile_height = 32;  // px, at most
inline constexpr int pool_capacity = tile_width * tile_height + 16;

using Pixels = std::span<const int>;  // of a tile: x + y * width

// An evaluator with one thread's rows.
struct Stage {
    Stage(const field::Evaluator& evaluator, const std::vector<float>& block);
    void operator()(Rows& result, const Rows& input, int count);

    const field::Evaluator& evaluator;
    const std::vector<float>& block;
    field::Evaluator::Workspace workspace;
};

class CpuMarcher {
public:
    // What it walks: probes, or edges, whose first lanes are probes.
    enum class Of { probes, edges };
    explicit CpuMarcher(const CpuScene& scene, Of of = Of::probes);

    // Walks the waiting pixels' probes to their end, by the `settings` of the march. `sides`, by pixel: factors on the
    // distances. False when the watch cancelled it.
    bool march(Rows& probes, const Rows* sides, Pixels waiting, const Rows& settings, const Watch& watch);
    // Of the field so far, by probes under way: those that are done and not yet replaced do not count.
    std::int64_t evaluations() const { return evaluations_; }

private:
    bool stops(const Watch& watch);
    void take_waiting(const Rows& probes, const Rows* sides, Pixels& waiting, int to);
    int step(int active, bool has_sides, const Rows& settings);
    void advance(int active, const Rows& settings);
    int replace_done(Rows& probes, const Rows* sides, Pixels& waiting, int active);

    const CpuScene& scene_;
    Of of_;
    Stage distance_;
    Rows marching_, advanced_, narrowed_, next_edge_, point_, d_, done_, side_;  // by lane of the batch
    std::vector<int> pixel_of_;
    std::int64_t evaluations_ = 0;
    std::chrono::steady_clock::time_point last_asked_;
};

}  // namespace fieldwright::renderer
