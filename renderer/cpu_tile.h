// One tile of a CPU picture. All its pixels take turns together: in the first their eye rays, in each further one the
// next ray that mirrors and glass have sent on. A turn marches, casts the shadow rays, and shades.
#pragma once

#include "renderer/cpu_marcher.h"

namespace fieldwright::renderer {

// One thread's rows; draws one tile after the other. What a tile shows does not depend on the tiles before it.
class TileRenderer {
public:
    explicit TileRenderer(const CpuScene& scene);

    // False, and nothing drawn, when the watch cancelled it.
    bool draw(const Area& area, Frame& frame, const Watch& watch);
    std::int64_t evaluations() const { return marcher_.evaluations(); }  // of the field, by all tiles so far

private:
    struct Shading;  // rows of up to 256 hits

    void start_eyes(const Area& area);
    std::vector<int> start_bounces(Pixels pixels);
    bool trace(Pixels pixels, bool first_turn, const Watch& watch);
    void sort_pixels(Pixels pixels);
    bool cast_shadows(int light, const Watch& watch);
    void shade_hits(Pixels pixels, bool first_turn);
    void split_light(Shading& shading);
    void shade_sky(Shading& shading);
    void shade_lights(Shading& shading);
    void shade_misses(Pixels pixels, bool first_turn);
    Rows fog_transmittance(Pixels pixels, bool hit);
    void mix_fog(Rows& colour, const Rows& through, int count) const;
    void bring(Pixels pixels, const Rows& colour, bool first_turn);
    void send_on(const Shading& shading);
    void push(Pixels pixels, const Rows& bounces);
    void keep_layers(const Shading& shading);
    void store_eyes(const Area& area, Frame& frame) const;
    void store_layers(const Area& area, Frame& frame) const;
    void store_colours(const Area& area, Frame& frame) const;

    const CpuScene& scene_;
    CpuMarcher marcher_;
    Stage surface_, ray_, sky_;
    std::vector<Stage> lights_;

    // By pixel of the tile.
    Rows walked_, shadows_;         // probes of this turn
    Rows side_;                     // factor on the distances of this turn's ray
    Rows remaining_;                // budget
    Rows forward_share_;            // of the eye ray; depth = length * share
    Rows position_, normal_, ids_;  // ids: node, material
    Rows visibility_;               // one lane per shadowed light
    Rows shadow_steps_;             // of all of them
    Rows colour_, reflection_;      // of the eye ray; of all others, weighted
    Rows layers_;                   // of the eye ray, in the order of LayerLane
    Rows bounce_;                   // of this turn's ray
    std::vector<Rows> waiting_;     // a stack of bounces
    std::vector<int> waiting_count_;
    std::vector<int> hits_, misses_;
};

}  // namespace fieldwright::renderer
