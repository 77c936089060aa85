// Shadow rays of a tile's hits; through glass they go on, all pixels from surface to surface together: the legs of
// shaders/gpu/sight.glsl.
#include "renderer/cpu_tile.h"
#include "renderer/pixel_rows.h"

#include <algorithm>

namespace fieldwright::renderer {

// Inside a solid no light is seen.
bool TileRenderer::cast_shadows(int light, const Watch& watch)
{
    const StructureLanes& lanes = scene_.lanes;
    Stage& shining = lights_[static_cast<std::size_t>(light)];
    const Rows& shadow = scene_.shadows[static_cast<std::size_t>(light)];
    Rows rows(lanes.light), visibility(1);
    std::vector<int> outside;
    std::copy_if(hits_.begin(), hits_.end(), std::back_inserter(outside),
                 [&](int pixel) { return side_.lane(0)[pixel] > 0; });
    std::vector<int> waiting = start_shadows(light, outside);
    if (scene_.features.tinted_shadows) return cast_beams(light, outside, std::move(waiting), watch);
    if (!marcher_.march(shadows_, nullptr, waiting, scene_.march_of_shadows, watch)) return false;
    for_batches(outside, [&](Pixels batch) {
        Rows walked = gathered(shadows_, batch);
        shining(rows, gathered(position_, batch), size(batch));
        scene_.shadow_visibility(visibility, size(batch), walked, rows, shadow);
        scatter(visibility_, light, visibility, 0, 1, batch);
        scatter(remaining_, 0, walked, lanes.probe_budget, 1, batch);
        for (std::size_t i = 0; i < batch.size(); ++i)
            shadow_steps_.lane(0)[batch[i]] += walked.lane(lanes.probe_steps)[i];
    });
    return true;
}

// Shadow rays of pixels; those that have a way to go.
std::vector<int> TileRenderer::start_shadows(int light, Pixels outside)
{
    const StructureLanes& lanes = scene_.lanes;
    Stage& shining = lights_[static_cast<std::size_t>(light)];
    const Rows& shadow = scene_.shadows[static_cast<std::size_t>(light)];
    Rows rows(lanes.light), probe(lanes.probe), flag(1);
    std::vector<int> waiting;
    for_batches(outside, [&](Pixels batch) {
        Rows position = gathered(position_, batch);
        shining(rows, position, size(batch));
        scene_.shadow_probe(probe, size(batch), position, gathered(normal_, batch), rows, shadow, scene_.march,
                            gathered(remaining_, batch));
        scatter(shadows_, 0, probe, 0, lanes.probe, batch);
        scene_.probe_done(flag, size(batch), probe);
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (flag.lane(0)[i] < 0.5f) waiting.push_back(batch[i]);
    });
    return waiting;
}

bool TileRenderer::cast_beams(int light, Pixels outside, std::vector<int> waiting, const Watch& watch)
{
    const StructureLanes& lanes = scene_.lanes;
    Rows beam(lanes.beam), visibility(3), flag(1);
    scene_.make_beam(beam, field::row_width);
    for_batches(outside, [&](Pixels batch) { scatter(beams_, 0, beam, 0, lanes.beam, batch); });
    beam_side_.fill(0, 1.0f);
    std::vector<int> going = waiting;
    for (int crossing = 0; crossing <= beam_crossings && !going.empty(); ++crossing) {
        if (!marcher_.march(shadows_, &beam_side_, waiting, scene_.march_of_shadows, watch)) return false;
        going = cross_surfaces(light, going);
        waiting.clear();
        for_batches(going, [&](Pixels batch) {
            scene_.probe_done(flag, size(batch), gathered(shadows_, batch));
            for (std::size_t i = 0; i < batch.size(); ++i)
                if (flag.lane(0)[i] < 0.5f) waiting.push_back(batch[i]);
        });
    }
    for_batches(outside, [&](Pixels batch) {
        Rows walked = gathered(shadows_, batch);
        scene_.beam_visibility(visibility, size(batch), gathered(beams_, batch), walked);
        scatter(visibility_, 3 * light, visibility, 0, 3, batch);
        scatter(remaining_, 0, walked, lanes.probe_budget, 1, batch);
        for (std::size_t i = 0; i < batch.size(); ++i)
            shadow_steps_.lane(0)[batch[i]] += walked.lane(lanes.probe_steps)[i];
    });
    return true;
}

// Where legs of shadow rays ended: what light is left, and the pixels whose rays go on or have passed more.
std::vector<int> TileRenderer::cross_surfaces(int light, Pixels pixels)
{
    const StructureLanes& lanes = scene_.lanes;
    const Rows& shadow = scene_.shadows[static_cast<std::size_t>(light)];
    Rows rows(lanes.light), flag(1), point(3), surface(lanes.material + 2), beam(lanes.beam), leg(lanes.probe);
    std::vector<int> asking, going;
    for_batches(pixels, [&](Pixels batch) {
        lights_[static_cast<std::size_t>(light)](rows, gathered(position_, batch), size(batch));
        scene_.beam_asks(flag, size(batch), gathered(shadows_, batch), rows, shadow);
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (flag.lane(0)[i] > 0.5f) asking.push_back(batch[i]);
    });
    for_batches(asking, [&](Pixels batch) {
        Rows walked = gathered(shadows_, batch);
        scene_.beam_point(point, size(batch), walked);
        surface_(surface, point, size(batch));
        lights_[static_cast<std::size_t>(light)](rows, gathered(position_, batch), size(batch));
        scene_.beam_behind(beam, size(batch), gathered(beams_, batch), walked, surface, rows, shadow);
        scene_.next_leg(leg, size(batch), walked, beam, shadow, scene_.march);
        scatter(beams_, 0, beam, 0, lanes.beam, batch);
        scatter(beam_side_, 0, beam, lanes.beam_side, 1, batch);
        scatter(shadows_, 0, leg, 0, lanes.probe, batch);
        scene_.beam_stopped(flag, size(batch), leg);
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (flag.lane(0)[i] < 0.5f) going.push_back(batch[i]);
    });
    return going;
}

// The light behind what it came through; `visibility` becomes the share of its brightness.
void TileRenderer::tint_light(Rows& light, int index, Rows& visibility, Pixels pixels) const
{
    Rows tint = gathered(visibility_, 3 * index, 3, pixels), share(1);
    scene_.brightness(share, size(pixels), tint);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        visibility.lane(0)[i] *= share.lane(0)[i];
        for (int k = 0; k < 3; ++k) light.lane(scene_.lanes.light_radiance + k)[i] *= tint.lane(k)[i];
    }
}

}  // namespace fieldwright::renderer
