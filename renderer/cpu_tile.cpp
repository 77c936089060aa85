// The turns of a tile, as shaders/gpu/pixel.glsl does it for one pixel.
#include "renderer/cpu_tile.h"

#include "renderer/pixel_rows.h"

#include <algorithm>
#include <numeric>

namespace fieldwright::renderer {
namespace {

using field::row_width;

std::vector<int> pixels_of(const Area& area)
{
    std::vector<int> pixels(static_cast<std::size_t>(area.width * area.height));
    std::iota(pixels.begin(), pixels.end(), 0);
    return pixels;
}

}  // namespace

TileRenderer::TileRenderer(const CpuScene& scene)
    : scene_(scene),
      marcher_(scene),
      surface_(scene.surface, scene.block),
      ray_(scene.ray, scene.block),
      sky_(scene.sky, scene.block),
      walked_(scene.features.coverage ? scene.lanes.edge : scene.lanes.probe, pool_capacity),
      shadows_(scene.lanes.probe, pool_capacity),
      side_(1, pool_capacity),
      remaining_(1, pool_capacity),
      forward_share_(1, pool_capacity),
      position_(3, pool_capacity),
      normal_(3, pool_capacity),
      ids_(2, pool_capacity),
      visibility_(std::max(scene.shadow_count, 1) * (scene.features.tinted_shadows ? 3 : 1), pool_capacity),
      beams_(scene.features.tinted_shadows ? scene.lanes.beam : 0, pool_capacity),
      beam_side_(1, pool_capacity),
      shadow_steps_(1, pool_capacity),
      colour_(3, pool_capacity),
      reflection_(3, pool_capacity),
      layers_(scene.request.layers ? LayerLane::count : 0, pool_capacity),
      covered_(1, pool_capacity),
      bounce_(scene.features.bounces ? scene.lanes.bounce : 0, pool_capacity),
      waiting_count_(pool_capacity)
{
    if (scene.features.coverage) edges_.emplace(scene);
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
    if (!trace(pixels, Turn::eye, watch)) return false;
    store_eyes(area, frame);
    if (frame.layers) store_layers(area, frame);
    if (!trace_bounces(std::move(pixels), watch)) return false;
    if (edges_ && !trace_beyond(watch)) return false;
    store_colours(area, frame);
    return true;
}

// The pixels' further rays, one a turn.
bool TileRenderer::trace_bounces(std::vector<int> pixels, const Watch& watch)
{
    if (!scene_.features.bounces) return true;
    while (!(pixels = start_bounces(pixels)).empty())
        if (!trace(pixels, Turn::bounce, watch)) return false;
    return true;
}

// What lies beyond the edges of those pixels that have one.
bool TileRenderer::trace_beyond(const Watch& watch)
{
    const std::vector<int>& pixels = edges_->shared();
    for_batches(pixels, [&](Pixels batch) {
        Rows probe(scene_.lanes.probe), rays = edges_->rays_beyond(batch);
        scene_.eye_probe(probe, size(batch), rays, scene_.march, gathered(remaining_, batch));
        scatter(walked_, 0, probe, 0, scene_.lanes.probe, batch);
        if (scene_.features.bounces) start_eye_bounces(batch, rays);
    });
    weigh_bounces(pixels, 0, 1);
    return trace(pixels, Turn::beyond, watch) && trace_bounces(pixels, watch);
}

// uv as gl_FragCoord gives it: pixel centres, y up, one unit is half the height.
void TileRenderer::start_eyes(const Area& area)
{
    const StructureLanes& lanes = scene_.lanes;
    auto width = static_cast<float>(scene_.request.width), height = static_cast<float>(scene_.request.height);
    const glm::vec2 offset = scene_.request.offset;
    const DrawnPixels drawn = drawn_pixels(scene_.request);
    Rows uv_and_lens(4), pixel(2), lens(2), probe(lanes.probe);
    uv_and_lens.fill(2, scene_.request.lens.x);
    uv_and_lens.fill(3, scene_.request.lens.y);
    for_batches(pixels_of(area), [&](Pixels batch) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            int x = drawn.x + drawn.step * (area.x + batch[i] % area.width);
            int y = drawn.y + drawn.step * (area.y + batch[i] / area.width);
            uv_and_lens.lane(0)[i] = (2.0f * (static_cast<float>(x) + 0.5f + offset.x) - width) / height;
            uv_and_lens.lane(1)[i] = (2.0f * (height - static_cast<float>(y) - 0.5f + offset.y) - height) / height;
            pixel.lane(0)[i] = static_cast<float>(x / drawn.step);
            pixel.lane(1)[i] = static_cast<float>((scene_.request.height - 1 - y) / drawn.step);
        }
        if (scene_.features.lens) {
            scene_.turned_lens(lens, size(batch), scene_.lens, pixel);
            copy_lanes(uv_and_lens, 2, lens, 0, 2, size(batch));
        }
        Rows ray = eye_rays(uv_and_lens, {0, 0}, size(batch));
        scene_.eye_probe(probe, size(batch), ray, scene_.march, scene_.budget);
        scatter(walked_, 0, probe, 0, lanes.probe, batch);
        for (std::size_t i = 0; i < batch.size(); ++i)
            forward_share_.lane(0)[batch[i]] = glm::dot(ray.vec3(lanes.ray_direction, static_cast<int>(i)),
                                                        ray.vec3(lanes.ray_forward, static_cast<int>(i)));
        if (edges_)
            edges_->watch(walked_, batch, ray, eye_rays(uv_and_lens, {2.0f / height, 0}, size(batch)),
                          eye_rays(uv_and_lens, {0, 2.0f / height}, size(batch)));
        if (scene_.features.bounces) start_eye_bounces(batch, ray);
    });
    std::fill(waiting_count_.begin(), waiting_count_.end(), 0);
    for (int k = 0; k < 3; ++k) reflection_.fill(k, 0.0f);
    shadow_steps_.fill(0, 0.0f);
}

// Rays of the camera, or of one of its eyes. shift: of all uv.
Rows TileRenderer::eye_rays(const Rows& uv_and_lens, glm::vec2 shift, int count)
{
    Rows shifted = uv_and_lens, camera_ray(scene_.lanes.ray), ray(scene_.lanes.ray);
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < count; ++i) shifted.lane(k)[i] += shift[k];
    if (scene_.view) scene_.view_ray(camera_ray, count, shifted, *scene_.view);
    else ray_(camera_ray, shifted, count);
    scene_.stereo_ray(ray, count, camera_ray, scene_.eye, scene_.interaxial, scene_.convergence, scene_.toe_in);
    return ray;
}

void TileRenderer::start_eye_bounces(Pixels batch, const Rows& rays)
{
    Rows bounce(scene_.lanes.bounce);
    scene_.eye_bounce(bounce, size(batch), rays, scene_.march);
    scatter(bounce_, 0, bounce, 0, scene_.lanes.bounce, batch);
    scatter(side_, 0, bounce, scene_.lanes.bounce_side, 1, batch);
}

// What the eye rays send on weighs as they do: alone + shared x the share beyond the pixel's edge.
void TileRenderer::weigh_bounces(Pixels pixels, float alone, float shared)
{
    if (!scene_.features.bounces) return;
    for (int pixel : pixels)
        for (int k = 0; k < 3; ++k)
            bounce_.lane(scene_.lanes.bounce_weight + k)[pixel] = alone + shared * edges_->share().lane(0)[pixel];
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
bool TileRenderer::trace(Pixels pixels, Turn turn, const Watch& watch)
{
    const Rows* sides = scene_.features.bounces ? &side_ : nullptr;
    bool looks_for_edges = edges_ && turn == Turn::eye;
    std::vector<int> waiting;
    Rows done(1);
    for_batches(pixels, [&](Pixels batch) {
        scene_.probe_done(done, size(batch), gathered(walked_, batch));
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (done.lane(0)[i] < 0.5f) waiting.push_back(batch[i]);
    });
    bool walked = looks_for_edges ? edges_->march(walked_, waiting, watch)
                                  : marcher_.march(walked_, sides, waiting, scene_.march, watch);
    if (!walked) return false;
    if (looks_for_edges) {
        edges_->find(walked_, pixels);
        weigh_bounces(pixels, 1, -1);
    }
    for (int pixel : pixels) remaining_.lane(0)[pixel] = walked_.lane(scene_.lanes.probe_budget)[pixel];
    sort_pixels(pixels);
    if (edges_ && turn != Turn::bounce) keep_covered(turn);
    for (int light = 0; light < scene_.shadow_count; ++light)
        if (!cast_shadows(light, watch)) return false;
    for_batches(hits_, [&](Pixels batch) { shade_hits(batch, turn); });
    for_batches(misses_, [&](Pixels batch) { shade_misses(batch, turn); });
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

// The share of the pixels in which something was hit.
void TileRenderer::keep_covered(Turn turn)
{
    for (const std::vector<int>* pixels : {&hits_, &misses_}) {
        Rows hit(1);
        hit.fill(0, pixels == &hits_ ? 1.0f : 0.0f);
        for_batches(*pixels, [&](Pixels batch) { keep(covered_, 0, hit, 1, batch, turn); });
    }
}

// Of both eye rays of a pixel: the first one's, and then that of the one beyond the edge for its share.
void TileRenderer::keep(Rows& pool, int pool_lane, const Rows& from, int lanes, Pixels pixels, Turn turn) const
{
    if (turn == Turn::eye) scatter(pool, pool_lane, from, 0, lanes, pixels);
    else mix_in(pool, pool_lane, from, lanes, edges_->share(), pixels);
}

}  // namespace fieldwright::renderer
