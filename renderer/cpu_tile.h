// One tile of a CPU picture. All its pixels take turns together: in the first their eye rays, in each further one the
// next ray that mirrors and glass have sent on; then those with an edge through them once more, beyond it. A turn marches,
// casts the shadow rays, and shades.
#pragma once

#include "renderer/cpu_edges.h"

#include <optional>

namespace fieldwright::renderer {

// One thread's rows; draws one tile after the other. What a tile shows does not depend on the tiles before it.
class TileRenderer {
public:
    explicit TileRenderer(const CpuScene& scene);

    // False, and nothing drawn, when the watch cancelled it.
    bool draw(const Area& area, Frame& frame, const Watch& watch);
    // Of the field, by all tiles so far.
    std::int64_t evaluations() const { return marcher_.evaluations() + (edges_ ? edges_->evaluations() : 0); }

private:
    struct Shading;  // rows of up to 256 hits
    // First lanes of the layers of a pixel, of light before others.
    struct LayerLane {
        static constexpr int ambient = 0, diffuse = 3, specular = 6, emission = 9, albedo = 12, shadow = 15, count = 16;
    };
    enum class Turn { eye, beyond, bounce };

    void start_eyes(const Area& area);
    Rows eye_rays(const Rows& uv_and_lens, glm::vec2 shift, int count);
    void start_eye_bounces(Pixels batch, const Rows& rays);
    void weigh_bounces(Pixels pixels, float alone, float shared);
    bool trace_bounces(std::vector<int> pixels, const Watch& watch);
    bool trace_beyond(const Watch& watch);
    std::vector<int> start_bounces(Pixels pixels);
    bool trace(Pixels pixels, Turn turn, const Watch& watch);
    void sort_pixels(Pixels pixels);
    bool cast_shadows(int light, const Watch& watch);
    std::vector<int> start_shadows(int light, Pixels outside);
    bool cast_beams(int light, Pixels outside, std::vector<int> waiting, const Watch& watch);
    std::vector<int> cross_surfaces(int light, Pixels pixels);
    void tint_light(Rows& light, int index, Rows& visibility, Pixels pixels) const;
    void keep_covered(Turn turn);
    void keep(Rows& pool, int pool_lane, const Rows& from, int lanes, Pixels pixels, Turn turn) const;
    void shade_hits(Pixels pixels, Turn turn);
    void split_light(Shading& shading);
    void shade_sky(Shading& shading);
    void shade_lights(Shading& shading);
    void shade_misses(Pixels pixels, Turn turn);
    Rows fog_transmittance(Pixels pixels, bool hit);
    void mix_fog(Rows& colour, const Rows& through, int count) const;
    void bring(Pixels pixels, const Rows& colour, Turn turn);
    void send_on(const Shading& shading);
    void push(Pixels pixels, const Rows& bounces);
    void keep_layers(const Shading& shading, Turn turn);
    void store_eyes(const Area& area, Frame& frame) const;
    void store_layers(const Area& area, Frame& frame) const;
    void store_colours(const Area& area, Frame& frame) const;

    const CpuScene& scene_;
    CpuMarcher marcher_;
    std::optional<CpuEdges> edges_;  // where they share pixels
    Stage surface_, ray_, sky_;
    std::vector<Stage> lights_;

    // By pixel of the tile.
    Rows walked_, shadows_;         // probes of this turn; of eye rays edges, where they are looked for
    Rows side_;                     // factor on the distances of this turn's ray
    Rows remaining_;                // budget
    Rows forward_share_;            // of the eye ray; depth = length * share
    Rows position_, normal_, ids_;  // ids: node, material
    Rows visibility_;               // per shadowed light one lane, or with tinted shadows three
    Rows beams_, beam_side_;        // of tinted shadows; the side of the beam once more
    Rows shadow_steps_;             // of all of them
    Rows colour_, reflection_;      // of the eye ray; of all others, weighted
    Rows layers_;                   // of the eye ray, in the order of LayerLane
    Rows covered_;                  // share in which an eye ray hit something
    Rows bounce_;                   // of this turn's ray
    std::vector<Rows> waiting_;     // a stack of bounces
    std::vector<int> waiting_count_;
    std::vector<int> hits_, misses_;
};

}  // namespace fieldwright::renderer
