// Eye rays, shadow rays, bounces and shading of one tile, as shaders/gpu/pixel.glsl does it for one pixel.
#include "renderer/cpu_tile.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace fieldwright::renderer {
namespace {

using field::row_width;

// First lanes of the layers of a pixel.
enum LayerLane { ambient = 0, diffuse = 3, specular = 6, emission = 9, albedo = 12, shadow = 15, layer_lanes = 16 };

// Lanes of a pool's pixels into a row, side by side.
void gather(Rows& to, int to_lane, const Rows& pool, int pool_lane, int lanes, Pixels pixels)
{
    for (int k = 0; k < lanes; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i) to.lane(to_lane + k)[i] = pool.lane(pool_lane + k)[pixels[i]];
}

Rows gathered(const Rows& pool, int first_lane, int lanes, Pixels pixels)
{
    Rows rows(lanes);
    gather(rows, 0, pool, first_lane, lanes, pixels);
    return rows;
}

Rows gathered(const Rows& pool, Pixels pixels) { return gathered(pool, 0, pool.lanes(), pixels); }

void scatter(Rows& pool, int pool_lane, const Rows& from, int from_lane, int lanes, Pixels pixels)
{
    for (int k = 0; k < lanes; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pool.lane(pool_lane + k)[pixels[i]] = from.lane(from_lane + k)[i];
}

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

void copy(Rows& to, const Rows& from, int from_lane, int lanes, int count)
{
    for (int k = 0; k < lanes; ++k) std::copy_n(from.lane(from_lane + k), count, to.lane(k));
}

template <typename Visit>
void for_batches(Pixels pixels, Visit visit)
{
    for (std::size_t first = 0; first < pixels.size(); first += row_width)
        visit(pixels.subspan(first, std::min<std::size_t>(row_width, pixels.size() - first)));
}

std::vector<int> pixels_of(const Area& area)
{
    std::vector<int> pixels(static_cast<std::size_t>(area.width * area.height));
    std::iota(pixels.begin(), pixels.end(), 0);
    return pixels;
}

int size(Pixels pixels) { return static_cast<int>(pixels.size()); }

std::size_t place_of(int pixel, const Area& area, const Frame& frame)
{
    return static_cast<std::size_t>(area.y + pixel / area.width) * static_cast<std::size_t>(frame.width) +
           static_cast<std::size_t>(area.x + pixel % area.width);
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

TileRenderer::TileRenderer(const CpuScene& scene)
    : scene_(scene),
      marcher_(scene),
      surface_(scene.surface, scene.block),
      ray_(scene.ray, scene.block),
      sky_(scene.sky, scene.block),
      walked_(scene.lanes.probe, pool_capacity),
      shadows_(scene.lanes.probe, pool_capacity),
      side_(1, pool_capacity),
      remaining_(1, pool_capacity),
      forward_share_(1, pool_capacity),
      position_(3, pool_capacity),
      normal_(3, pool_capacity),
      ids_(2, pool_capacity),
      visibility_(std::max(scene.shadow_count, 1), pool_capacity),
      shadow_steps_(1, pool_capacity),
      colour_(3, pool_capacity),
      reflection_(3, pool_capacity),
      layers_(scene.request.layers ? layer_lanes : 0, pool_capacity),
      bounce_(scene.features.bounces ? scene.lanes.bounce : 0, pool_capacity),
      waiting_count_(pool_capacity)
{
    for (const field::Evaluator& light : scene.lights) lights_.emplace_back(light, scene.block);
    side_.fill(0, 1.0f);
    if (!scene.features.bounces) return;
    int depth = static_cast<int>(scene.bounces.lane(0)[0]) + 2;
    for (int i = 0; i < depth; ++i) waiting_.emplace_back(scene.lanes.bounce, pool_capacity);
}

bool TileRenderer::draw(const Area& area, Frame& frame, const Watch& watch)
{
    start_eyes(area);
    std::vector<int> pixels = pixels_of(area);
    if (!trace(pixels, true, watch)) return false;
    store_eyes(area, frame);
    if (frame.layers) store_layers(area, frame);
    if (scene_.features.bounces)
        while (!(pixels = start_bounces(pixels)).empty())
            if (!trace(pixels, false, watch)) return false;
    store_colours(area, frame);
    return true;
}

// uv as gl_FragCoord gives it: pixel centres, y up, one unit is half the height.
void TileRenderer::start_eyes(const Area& area)
{
    const StructureLanes& lanes = scene_.lanes;
    auto width = static_cast<float>(scene_.request.width), height = static_cast<float>(scene_.request.height);
    const glm::vec2 offset = scene_.request.offset;
    const Area part = drawn_area(scene_.request);
    // uv, and where the ray crosses the lens.
    Rows uv(4), camera_ray(lanes.ray), ray(lanes.ray), probe(lanes.probe), bounce(lanes.bounce);
    uv.fill(2, scene_.request.lens.x);
    uv.fill(3, scene_.request.lens.y);
    for_batches(pixels_of(area), [&](Pixels batch) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            int x = part.x + area.x + batch[i] % area.width, y = part.y + area.y + batch[i] / area.width;
            uv.lane(0)[i] = (2.0f * (static_cast<float>(x) + 0.5f + offset.x) - width) / height;
            uv.lane(1)[i] = (2.0f * (height - static_cast<float>(y) - 0.5f + offset.y) - height) / height;
        }
        if (scene_.view) scene_.view_ray(camera_ray, size(batch), uv, *scene_.view);
        else ray_(camera_ray, uv, size(batch));
        scene_.stereo_ray(ray, size(batch), camera_ray, scene_.eye, scene_.interaxial, scene_.convergence,
                          scene_.toe_in);
        scene_.eye_probe(probe, size(batch), ray, scene_.march, scene_.budget);
        scatter(walked_, 0, probe, 0, lanes.probe, batch);
        for (std::size_t i = 0; i < batch.size(); ++i)
            forward_share_.lane(0)[batch[i]] = glm::dot(ray.vec3(lanes.ray_direction, static_cast<int>(i)),
                                                        ray.vec3(lanes.ray_forward, static_cast<int>(i)));
        if (!scene_.features.bounces) return;
        scene_.eye_bounce(bounce, size(batch), ray, scene_.march);
        scatter(bounce_, 0, bounce, 0, lanes.bounce, batch);
        scatter(side_, 0, bounce, lanes.bounce_side, 1, batch);
    });
    std::fill(waiting_count_.begin(), waiting_count_.end(), 0);
    for (int k = 0; k < 3; ++k) reflection_.fill(k, 0.0f);
    shadow_steps_.fill(0, 0.0f);
}

// The pixels that have another ray waiting, which becomes this turn's.
std::vector<int> TileRenderer::start_bounces(Pixels pixels)
{
    const StructureLanes& lanes = scene_.lanes;
    std::vector<int> going;
    for (int pixel : pixels) {
        int& count = waiting_count_[static_cast<std::size_t>(pixel)];
        if (count == 0) continue;
        bounce_.copy(pixel, waiting_[static_cast<std::size_t>(--count)], pixel);
        side_.lane(0)[pixel] = bounce_.lane(lanes.bounce_side)[pixel];
        going.push_back(pixel);
    }
    Rows probe(lanes.probe);
    for_batches(going, [&](Pixels batch) {
        scene_.bounce_probe(probe, size(batch), gathered(bounce_, batch), scene_.march, gathered(remaining_, batch),
                            scene_.bounces, scene_.overhead);
        scatter(walked_, 0, probe, 0, lanes.probe, batch);
    });
    return going;
}

// What the pixels' rays of this turn bring.
bool TileRenderer::trace(Pixels pixels, bool first_turn, const Watch& watch)
{
    const Rows* sides = scene_.features.bounces ? &side_ : nullptr;
    std::vector<int> waiting;
    Rows done(1);
    for_batches(pixels, [&](Pixels batch) {
        scene_.probe_done(done, size(batch), gathered(walked_, batch));
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (done.lane(0)[i] < 0.5f) waiting.push_back(batch[i]);
    });
    if (!marcher_.march(walked_, sides, waiting, watch)) return false;
    for (int pixel : pixels) remaining_.lane(0)[pixel] = walked_.lane(scene_.lanes.probe_budget)[pixel];
    sort_pixels(pixels);
    for (int light = 0; light < scene_.shadow_count; ++light)
        if (!cast_shadows(light, watch)) return false;
    for_batches(hits_, [&](Pixels batch) { shade_hits(batch, first_turn); });
    for_batches(misses_, [&](Pixels batch) { shade_misses(batch, first_turn); });
    return true;
}

// Hits and misses of this turn's rays, and where the hits are.
void TileRenderer::sort_pixels(Pixels pixels)
{
    hits_.clear();
    misses_.clear();
    Rows missed(1), point(3), normal(3);
    for_batches(pixels, [&](Pixels batch) {
        scene_.probe_missed(missed, size(batch), gathered(walked_, batch));
        for (std::size_t i = 0; i < batch.size(); ++i) (missed.lane(0)[i] > 0.5f ? misses_ : hits_).push_back(batch[i]);
    });
    for_batches(hits_, [&](Pixels batch) {
        Rows probe = gathered(walked_, batch);
        scene_.probe_point(point, size(batch), probe, scene_.march);
        scene_.probe_normal(normal, size(batch), probe);
        scatter(position_, 0, point, 0, 3, batch);
        scatter(normal_, 0, normal, 0, 3, batch);
    });
}

// Inside a solid no light is seen.
bool TileRenderer::cast_shadows(int light, const Watch& watch)
{
    const StructureLanes& lanes = scene_.lanes;
    Stage& shining = lights_[static_cast<std::size_t>(light)];
    const Rows& shadow = scene_.shadows[static_cast<std::size_t>(light)];
    Rows rows(lanes.light), probe(lanes.probe), flag(1), visibility(1);
    std::vector<int> outside, waiting;
    std::copy_if(hits_.begin(), hits_.end(), std::back_inserter(outside),
                 [&](int pixel) { return side_.lane(0)[pixel] > 0; });
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
    if (!marcher_.march(shadows_, nullptr, waiting, watch)) return false;
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

void TileRenderer::shade_hits(Pixels pixels, bool first_turn)
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
    if (first_turn) {
        scatter(ids_, 0, shading.surface, lanes.material + 1, 1, pixels);
        scatter(ids_, 1, shading.surface, lanes.material, 1, pixels);
    }
    if (scene_.features.bounces) split_light(shading);
    shade_sky(shading);
    shade_lights(shading);
    for (const Rows* part : {&shading.ambient, &shading.emission, &shading.diffuse, &shading.specular})
        add(shading.colour, *part, count);
    if (first_turn && scene_.request.layers) keep_layers(shading);
    mix_fog(shading.colour, shading.fog, count);
    bring(pixels, shading.colour, first_turn);
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
    copy(shading.emission, shading.surface, scene_.lanes.material_emission, 3, count);
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
        bool shadowed = static_cast<int>(index) < scene_.shadow_count;
        if (shadowed) gather(visibility, 0, visibility_, static_cast<int>(index), 1, shading.pixels);
        else visibility.fill(0, 1.0f);
        for (int i = 0; i < count; ++i) visibility.lane(0)[i] *= shading.side.lane(0)[i] > 0 ? 1.0f : 0.0f;
        if (shadowed) add(shading.visible_lights, visibility, count);
        lights_[index](light, shading.position, count);
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

void TileRenderer::shade_misses(Pixels pixels, bool first_turn)
{
    Rows colour(3), no_spread(1);
    sky_(colour, joined(gathered(walked_, scene_.lanes.probe_direction, 3, pixels), no_spread), size(pixels));
    mix_fog(colour, fog_transmittance(pixels, false), size(pixels));
    bring(pixels, colour, first_turn);
    if (!first_turn || !scene_.request.layers) return;
    for (int lane = 0; lane < layer_lanes; ++lane)
        for (int pixel : pixels) layers_.lane(lane)[pixel] = lane == shadow ? 1.0f : 0.0f;
    scatter(layers_, emission, colour, 0, 3, pixels);
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
void TileRenderer::bring(Pixels pixels, const Rows& colour, bool first_turn)
{
    if (first_turn) return scatter(colour_, 0, colour, 0, 3, pixels);
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

void TileRenderer::keep_layers(const Shading& shading)
{
    int count = shading.count;
    auto keep = [&](LayerLane lane, Rows part, bool fades) {
        for (int k = 0; k < part.lanes(); ++k)
            for (int i = 0; i < count && fades; ++i) part.lane(k)[i] *= shading.fog.lane(0)[i];
        scatter(layers_, lane, part, 0, part.lanes(), shading.pixels);
    };
    keep(ambient, shading.ambient, true);
    keep(diffuse, shading.diffuse, true);
    keep(specular, shading.specular, true);
    Rows own = shading.emission, colour(3), visible = shading.visible_lights;
    mix_fog(own, shading.fog, count);
    keep(emission, own, false);
    copy(colour, shading.surface, scene_.lanes.material_albedo, 3, count);
    keep(albedo, colour, false);
    for (int i = 0; i < count; ++i)
        visible.lane(0)[i] =
            scene_.shadow_count > 0 ? visible.lane(0)[i] / static_cast<float>(scene_.shadow_count) : 1.0f;
    keep(shadow, visible, false);
}

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
        layers.ambient[to] = layers_.vec3(ambient, pixel);
        layers.diffuse[to] = layers_.vec3(diffuse, pixel);
        layers.specular[to] = layers_.vec3(specular, pixel);
        layers.emission[to] = layers_.vec3(emission, pixel);
        layers.albedo[to] = layers_.vec3(albedo, pixel);
        layers.shadow[to] = layers_.lane(shadow)[pixel];
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
        if (frame.layers) frame.layers->reflection[to] = reflection_.vec3(0, pixel);
    }
}

}  // namespace fieldwright::renderer
