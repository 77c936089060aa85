// Edges through a tile's pixels (shaders/render/coverage.glsl): found along the eye rays, and the rays beyond them.
#pragma once

#include "renderer/pixel_rows.h"

namespace fieldwright::renderer {

class CpuEdges {
public:
    explicit CpuEdges(const CpuScene& scene);

    // Makes probes of eye rays, the first lanes of `walked`, edges. beside, above: the rays of the next pixels.
    void watch(Rows& walked, Pixels batch, const Rows& ray, const Rows& beside, const Rows& above);
    // Walks the waiting pixels' edges to their end. False when the watch cancelled it.
    bool march(Rows& walked, Pixels waiting, const Watch& watch)
    {
        return marcher_.march(walked, nullptr, waiting, scene_.march, watch);
    }
    // Looks at what was walked.
    void find(const Rows& walked, Pixels pixels);

    const std::vector<int>& shared() const { return shared_; }  // pixels with an edge through them
    const Rows& share() const { return share_; }                // by pixel: that of what lies beyond it
    Rows rays_beyond(Pixels batch) const;                       // of shared pixels
    std::int64_t evaluations() const { return marcher_.evaluations(); }

private:
    const CpuScene& scene_;
    CpuMarcher marcher_;
    Rows ray_, footprint_, beyond_, share_;  // by pixel
    std::vector<int> shared_;
};

}  // namespace fieldwright::renderer
