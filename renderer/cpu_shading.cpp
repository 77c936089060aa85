// What a tile's rays bring: as shaders/gpu/sight.glsl shades where they hit, and what they send on.
#include "renderer/cpu_tile.h"
#include "renderer/pixel_rows.h"

#include <algorithm>
#include <functional>

namespace fieldwright::renderer {
namespace {

using field::row_width;

Rows joined(const Rows& a, const Rows& b)
{
    Rows rows(a.lanes() + b.lanes());
    for (int k = 0; k < rows.lanes(); ++k) {
        const float* from = k < a.lanes() ? a.lane(k) : b.lane(k - a.lanes());
        std::copy_n(from, row_width, rows.lane(k));
    }
    return rows;
}

void add(Rows& to, const Rows& from, int count)
{
    for (int k = 0; k < to.lanes(); ++k)
        for (int i = 0; i < count; ++i) to.lane(k)[i] += from.lane(k)[i];
}

}  // namespace

struct TileRenderer::Shading {
    Shading(const StructureLanes& lanes, Pixels shaded)
        : pixels(shaded), count(size(shaded)), surface(lanes.material + 2)
    {
    }

    Pixels pixels;
    int count;
    Rows position{3}, normal{3}, direction{3}, side{1};
    Rows surface;                                // material, its id, the node's
    Rows split{0}, scattering{0}, under_sky{0};  // with bounces: of the light, and the materials of what is left
    Rows ambient{3}, emission{3}, diffuse{3}, specular{3}, colour{3};
    Rows visible_lights{1};  // how many of those that cast shadows
    Rows fog{1};             // the share that comes through
};

void TileRenderer::shade_hits(Pixels pixels, Turn turn)
{
    const StructureLanes& lanes = scene_.lanes;
    Shading shading(lanes, pixels);
    int count = shading.count;
    gather(shading.position, 0, position_, 0, 3, pixels);
    gather(shading.normal, 0, normal_, 0, 3, pixels);
    gather(shading.direction, 0, walked_, lanes.probe_direction, 3, pixels);
    gather(shading.side, 0, side_, 0, 1, pixels);
    surface_(shading.surface, shading.position, count);
    shading.fog = fog_transmittance(pixels, true);
    if (turn == Turn::eye) {
        scatter(ids_, 0, shading.surface, lanes.material + 1, 1, pixels);
        scatter(ids_, 1, shading.surface, lanes.material, 1, pixels);
    }
    if (scene_.features.bounces) split_light(shading);
    shade_sky(shading);
    shade_lights(shading);
    for (const Rows* part : {&shading.ambient, &shading.emission, &shading.diffuse, &shading.specular})
        add(shading.colour, *part, count);
    if (turn != Turn::bounce && scene_.request.layers) keep_layers(shading, turn);
    mix_fog(shading.colour, shading.fog, count);
    bring(pixels, shading.colour, turn);
    if (scene_.features.bounces) send_on(shading);
}

// What is mirrored and refracted is not scattered.
void TileRenderer::split_light(Shading& shading)
{
    const StructureLanes& lanes = scene_.lanes;
    int count = shading.count;
    shading.split = Rows(lanes.split);
    shading.scattering = Rows(lanes.material);
    shading.under_sky = Rows(lanes.material);
    scene_.split_light(shading.split, count, shading.surface, shading.normal, shading.direction, shading.side);
    scene_.scattering_material(shading.scattering, count, shading.surface, shading.split);
    scene_.ambient_material(shading.under_sky, count, shading.scattering);
}

void TileRenderer::shade_sky(Shading& shading)
{
    const Rows& material = scene_.features.bounces ? shading.under_sky : shading.surface;
    Rows look(3), spread(1), sky(3);
    int count = shading.count;
    scene_.ambient_direction(look, count, material, shading.normal, shading.direction);
    scene_.ambient_spread(spread, count, material);
    sky_(sky, joined(look, spread), count);
    scene_.shade_ambient(shading.ambient, count, material, sky,
                         gathered(walked_, scene_.lanes.probe_openness, 1, shading.pixels));
    copy_lanes(shading.emission, 0, shading.surface, scene_.lanes.material_emission, 3, count);
}

void TileRenderer::shade_lights(Shading& shading)
{
    const Rows& material = scene_.features.bounces ? shading.scattering : shading.surface;
    int count = shading.count;
    Rows view(3), light(scene_.lanes.light), visibility(1), part(3);
    for (int k = 0; k < 3; ++k)
        std::transform(shading.direction.lane(k), shading.direction.lane(k) + count, view.lane(k),
                       std::negate<float>());
    for (std::size_t index = 0; index < lights_.size(); ++index) {
        bool shadowed = static_cast<int>(index) < scene_.shadow_count, tinted = scene_.features.tinted_shadows;
        if (shadowed && !tinted) gather(visibility, 0, visibility_, static_cast<int>(index), 1, shading.pixels);
        else visibility.fill(0, 1.0f);
        for (int i = 0; i < count; ++i) visibility.lane(0)[i] *= shading.side.lane(0)[i] > 0 ? 1.0f : 0.0f;
        lights_[index](light, shading.position, count);
        Rows seen = visibility;
        if (shadowed && tinted) tint_light(light, static_cast<int>(index), seen, shading.pixels);
        if (shadowed) add(shading.visible_lights, seen, count);
        if (!scene_.request.layers) {
            scene_.shade_light(part, count, material, shading.normal, view, light, visibility);
            add(shading.diffuse, part, count);
            continue;
        }
        scene_.shade_diffuse(part, count, material, shading.normal, light, visibility);
        add(shading.diffuse, part, count);
        scene_.shade_specular(part, count, material, shading.normal, view, light, visibility);
        add(shading.specular, part, count);
    }
}

void TileRenderer::shade_misses(Pixels pixels, Turn turn)
{
    Rows colour(3), no_spread(1);
    sky_(colour, joined(gathered(walked_, scene_.lanes.probe_direction, 3, pixels), no_spread), size(pixels));
    mix_fog(colour, fog_transmittance(pixels, false), size(pixels));
    if (edges_ && turn != Turn::bounce && !scene_.request.sky)  // a backdrop is laid there
        for (int k = 0; k < 3; ++k) colour.fill(k, 0.0f);
    bring(pixels, colour, turn);
    if (turn == Turn::bounce || !scene_.request.layers) return;
    Rows nothing(LayerLane::count);
    nothing.fill(LayerLane::shadow, 1.0f);
    copy_lanes(nothing, LayerLane::emission, colour, 0, 3, size(pixels));
    keep(layers_, 0, nothing, turn == Turn::eye ? LayerLane::count : LayerLane::albedo, pixels, turn);
}

// The share of light that comes through the air on this turn's way; all of it inside solids.
Rows TileRenderer::fog_transmittance(Pixels pixels, bool hit)
{
    const StructureLanes& lanes = scene_.lanes;
    Rows through(1), way(1), t(1);
    through.fill(0, 1.0f);
    if (!scene_.features.fog) return through;
    if (scene_.features.bounces) gather(way, 0, bounce_, lanes.bounce_way, 1, pixels);
    if (hit) gather(t, 0, walked_, lanes.probe_t, 1, pixels);
    else t.fill(0, scene_.far_limit);
    scene_.fog_transmittance(through, size(pixels), scene_.fog, gathered(walked_, lanes.probe_origin, 3, pixels),
                             gathered(walked_, lanes.probe_direction, 3, pixels), way, t);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (side_.lane(0)[pixels[i]] < 0) through.lane(0)[i] = 1.0f;
    return through;
}

void TileRenderer::mix_fog(Rows& colour, const Rows& through, int count) const
{
    if (!scene_.features.fog) return;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < count; ++i)
            colour.lane(k)[i] = glm::mix(scene_.fog_colour[k], colour.lane(k)[i], through.lane(0)[i]);
}

// What a turn's rays bring themselves.
void TileRenderer::bring(Pixels pixels, const Rows& colour, Turn turn)
{
    if (turn != Turn::bounce) return keep(colour_, 0, colour, 3, pixels, turn);
    Rows weight(3);
    scene_.bounce_weight(weight, size(pixels), gathered(bounce_, pixels),
                         gathered(walked_, scene_.lanes.probe_t, 1, pixels));
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            reflection_.lane(k)[pixels[i]] += weight.lane(k)[i] * colour.lane(k)[i];
}

void TileRenderer::send_on(const Shading& shading)
{
    const StructureLanes& lanes = scene_.lanes;
    int count = shading.count;
    Rows bounce = gathered(bounce_, shading.pixels), t = gathered(walked_, lanes.probe_t, 1, shading.pixels);
    Rows weight(3), next(lanes.bounce);
    scene_.bounce_weight(weight, count, bounce, t);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < count; ++i) weight.lane(k)[i] *= shading.fog.lane(0)[i];
    scene_.mirrored_bounce(next, count, bounce, shading.split, weight, shading.position, shading.normal, t,
                           scene_.march);
    push(shading.pixels, next);
    scene_.refracted_bounce(next, count, bounce, shading.split, weight, shading.surface, shading.position,
                            shading.normal, t, scene_.march);
    push(shading.pixels, next);
}

void TileRenderer::push(Pixels pixels, const Rows& bounces)
{
    Rows shows(1);
    scene_.bounce_shows(shows, size(pixels), bounces);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (shows.lane(0)[i] < 0.5f) continue;
        int& count = waiting_count_[static_cast<std::size_t>(pixels[i])];
        waiting_[static_cast<std::size_t>(count++)].copy(pixels[i], bounces, static_cast<int>(i));
    }
}

void TileRenderer::keep_layers(const Shading& shading, Turn turn)
{
    const Rows& fog = shading.fog;
    int count = shading.count;
    auto keep_light = [&](int lane, Rows part) {
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < count; ++i) part.lane(k)[i] *= fog.lane(0)[i];
        keep(layers_, lane, part, 3, shading.pixels, turn);
    };
    keep_light(LayerLane::ambient, shading.ambient);
    keep_light(LayerLane::diffuse, shading.diffuse);
    keep_light(LayerLane::specular, shading.specular);
    Rows own = shading.emission, visible = shading.visible_lights;
    mix_fog(own, fog, count);
    keep(layers_, LayerLane::emission, own, 3, shading.pixels, turn);
    if (turn != Turn::eye) return;
    scatter(layers_, LayerLane::albedo, shading.surface, scene_.lanes.material_albedo, 3, shading.pixels);
    for (int i = 0; i < count; ++i)
        visible.lane(0)[i] =
            scene_.shadow_count > 0 ? visible.lane(0)[i] / static_cast<float>(scene_.shadow_count) : 1.0f;
    scatter(layers_, LayerLane::shadow, visible, 0, 1, shading.pixels);
}

}  // namespace fieldwright::renderer
