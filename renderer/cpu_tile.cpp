// Eye rays, shadow rays and shading of one tile.
#include "renderer/cpu_tile.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace fieldwright::renderer {
namespace {

using field::row_width;

// Lanes a whole number of pages apart would share a few places of the cache.
constexpr int pool_capacity = tile_width * tile_height + 16;
constexpr int refill_share = 8;  // probes move when one in so many is done

// Lanes of a pool's pixels into a row, side by side.
void gather(Rows& to, int to_lane, const Rows& pool, int pool_lane, int lanes, std::span<const int> pixels)
{
    for (int k = 0; k < lanes; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i) to.lane(to_lane + k)[i] = pool.lane(pool_lane + k)[pixels[i]];
}

Rows gathered(const Rows& pool, int first_lane, int lanes, std::span<const int> pixels)
{
    Rows rows(lanes);
    gather(rows, 0, pool, first_lane, lanes, pixels);
    return rows;
}

Rows gathered(const Rows& pool, std::span<const int> pixels) { return gathered(pool, 0, pool.lanes(), pixels); }

void scatter(Rows& pool, int pool_lane, const Rows& from, int from_lane, int lanes, std::span<const int> pixels)
{
    for (int k = 0; k < lanes; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pool.lane(pool_lane + k)[pixels[i]] = from.lane(from_lane + k)[i];
}

template <typename Visit>
void for_batches(std::span<const int> pixels, Visit visit)
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

int size(std::span<const int> pixels) { return static_cast<int>(pixels.size()); }

}  // namespace

TileRenderer::Stage::Stage(const field::Evaluator& stage_evaluator, const std::vector<float>& stage_block)
    : evaluator(stage_evaluator), block(stage_block), workspace(stage_evaluator)
{
}

void TileRenderer::Stage::operator()(Rows& result, const Rows& input, int count)
{
    for (int k = 0; k < input.lanes(); ++k) std::copy_n(input.lane(k), count, workspace.input(k));
    evaluator.evaluate(workspace, block, count);
    for (int k = 0; k < result.lanes(); ++k) std::copy_n(workspace.result(k), count, result.lane(k));
}

TileRenderer::TileRenderer(const CpuScene& scene)
    : scene_(scene),
      distance_(scene.distance, scene.block),
      surface_(scene.surface, scene.block),
      ray_(scene.ray, scene.block),
      sky_(scene.sky, scene.block),
      eyes_(scene.lanes.probe, pool_capacity),
      shadows_(scene.lanes.probe, pool_capacity),
      remaining_(1, pool_capacity),
      direction_(3, pool_capacity),
      forward_share_(1, pool_capacity),
      position_(3, pool_capacity),
      normal_(3, pool_capacity),
      ids_(2, pool_capacity),
      lit_(std::max(scene.shadow_count, 1), pool_capacity),
      colour_(3, pool_capacity),
      marching_(scene.lanes.probe),
      advanced_(scene.lanes.probe),
      point_(3),
      d_(1),
      done_(1),
      pixel_of_(row_width)
{
    for (const field::Evaluator& light : scene.lights) lights_.emplace_back(light, scene.block);
}

bool TileRenderer::draw(const Area& area, Frame& frame, const Watch& watch)
{
    watch_ = &watch;
    start_eyes(area);
    std::vector<int> pixels = pixels_of(area);
    if (!march(eyes_, pixels)) return false;
    std::copy_n(eyes_.lane(scene_.lanes.probe_budget), pixels.size(), remaining_.lane(0));
    sort_pixels(pixels);
    for (int light = 0; light < scene_.shadow_count; ++light)
        if (!cast_shadows(light)) return false;
    for_batches(hits_, [&](Pixels batch) { shade_hits(batch); });
    for_batches(misses_, [&](Pixels batch) { shade_misses(batch); });
    store(area, frame);
    return true;
}

// uv as gl_FragCoord gives it: pixel centres, y up, one unit is half the height.
void TileRenderer::start_eyes(const Area& area)
{
    const StructureLanes& lanes = scene_.lanes;
    auto width = static_cast<float>(scene_.request.width), height = static_cast<float>(scene_.request.height);
    std::vector<int> pixels = pixels_of(area);
    Rows uv(2), camera_ray(lanes.ray), ray(lanes.ray), probe(lanes.probe);
    for_batches(pixels, [&](Pixels batch) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            int x = area.x + batch[i] % area.width, y = area.y + batch[i] / area.width;
            uv.lane(0)[i] = (2.0f * (static_cast<float>(x) + 0.5f) - width) / height;
            uv.lane(1)[i] = (2.0f * (height - static_cast<float>(y) - 0.5f) - height) / height;
        }
        if (scene_.view_camera) scene_.view_ray(camera_ray, size(batch), uv, *scene_.view_camera);
        else ray_(camera_ray, uv, size(batch));
        scene_.stereo_ray(ray, size(batch), camera_ray, scene_.eye, scene_.interaxial, scene_.convergence);
        scene_.eye_probe(probe, size(batch), ray, scene_.march, scene_.budget);
        scatter(eyes_, 0, probe, 0, lanes.probe, batch);
        scatter(direction_, 0, ray, lanes.ray_direction, 3, batch);
        for (std::size_t i = 0; i < batch.size(); ++i)
            forward_share_.lane(0)[batch[i]] = glm::dot(ray.vec3(lanes.ray_direction, static_cast<int>(i)),
                                                        ray.vec3(lanes.ray_forward, static_cast<int>(i)));
    });
}

// Walks the waiting pixels' probes to their end. Rows stay filled: probes that are done make room for waiting ones.
bool TileRenderer::march(Rows& probes, Pixels waiting)
{
    int active = 0;
    while (active < row_width && !waiting.empty()) take_waiting(probes, waiting, active++);
    while (active > 0) {
        if (stops()) return false;
        while (refill_share * step(active) < active) {
        }
        active = replace_done(probes, waiting, active);
    }
    return true;
}

// Tiles of heavy scenes take tens of milliseconds, steps of light ones less than asking.
bool TileRenderer::stops()
{
    auto now = std::chrono::steady_clock::now();
    if (now - last_asked_ < std::chrono::milliseconds(1)) return false;
    last_asked_ = now;
    return watch_->stops();
}

void TileRenderer::take_waiting(const Rows& probes, Pixels& waiting, int to)
{
    marching_.copy(to, probes, waiting.front());
    pixel_of_[static_cast<std::size_t>(to)] = waiting.front();
    waiting = waiting.subspan(1);
}

// One distance for each probe; how many of them are done.
int TileRenderer::step(int active)
{
    scene_.probe_point(point_, active, marching_, scene_.march);
    distance_(d_, point_, active);
    scene_.advance(advanced_, active, marching_, d_, scene_.march);
    std::swap(marching_, advanced_);
    scene_.probe_done(done_, active, marching_);
    return static_cast<int>(std::count(done_.lane(0), done_.lane(0) + active, 1.0f));
}

// Waiting probes take the places of those that are done, then the last ones do; how many there are.
int TileRenderer::replace_done(Rows& probes, Pixels& waiting, int active)
{
    for (int i = active - 1; i >= 0; --i) {
        if (done_.lane(0)[i] < 0.5f) continue;
        probes.copy(pixel_of_[static_cast<std::size_t>(i)], marching_, i);
        if (!waiting.empty()) {
            take_waiting(probes, waiting, i);
        } else if (i != --active) {
            marching_.copy(i, marching_, active);
            pixel_of_[static_cast<std::size_t>(i)] = pixel_of_[static_cast<std::size_t>(active)];
        }
    }
    return active;
}

// Hits and misses of the eye rays, and where the hits are.
void TileRenderer::sort_pixels(Pixels pixels)
{
    hits_.clear();
    misses_.clear();
    Rows missed(1), point(3), normal(3);
    for_batches(pixels, [&](Pixels batch) {
        scene_.probe_missed(missed, size(batch), gathered(eyes_, batch));
        for (std::size_t i = 0; i < batch.size(); ++i) (missed.lane(0)[i] > 0.5f ? misses_ : hits_).push_back(batch[i]);
    });
    for_batches(hits_, [&](Pixels batch) {
        Rows probe = gathered(eyes_, batch);
        scene_.probe_point(point, size(batch), probe, scene_.march);
        scene_.probe_normal(normal, size(batch), probe);
        scatter(position_, 0, point, 0, 3, batch);
        scatter(normal_, 0, normal, 0, 3, batch);
    });
}

bool TileRenderer::cast_shadows(int light)
{
    const StructureLanes& lanes = scene_.lanes;
    Rows rows(lanes.light), probe(lanes.probe), flag(1);
    std::vector<int> waiting;
    for_batches(hits_, [&](Pixels batch) {
        Rows position = gathered(position_, batch);
        lights_[static_cast<std::size_t>(light)](rows, position, size(batch));
        scene_.shadow_probe(probe, size(batch), position, gathered(normal_, batch), rows, scene_.march,
                            gathered(remaining_, batch));
        scatter(shadows_, 0, probe, 0, lanes.probe, batch);
        scene_.probe_done(flag, size(batch), probe);
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (flag.lane(0)[i] < 0.5f) waiting.push_back(batch[i]);
    });
    if (!march(shadows_, waiting)) return false;
    for_batches(hits_, [&](Pixels batch) {
        Rows walked = gathered(shadows_, batch);
        scene_.probe_missed(flag, size(batch), walked);
        scatter(lit_, light, flag, 0, 1, batch);
        scatter(remaining_, 0, walked, lanes.probe_budget, 1, batch);
    });
    return true;
}

void TileRenderer::shade_hits(Pixels pixels)
{
    const StructureLanes& lanes = scene_.lanes;
    int count = size(pixels);
    Rows position = gathered(position_, pixels), normal = gathered(normal_, pixels),
         direction = gathered(direction_, pixels), view(3);
    for (int k = 0; k < 3; ++k)
        std::transform(direction.lane(k), direction.lane(k) + count, view.lane(k), std::negate<float>());

    Rows surface(lanes.material + 2), look(3), sky(3), colour(3), light(lanes.light), contribution(3), visibility(1);
    surface_(surface, position, count);
    scene_.ambient_direction(look, count, surface, normal, direction);
    sky_(sky, look, count);
    scene_.shade_ambient(colour, count, surface, sky, gathered(eyes_, lanes.probe_openness, 1, pixels));
    for (std::size_t index = 0; index < lights_.size(); ++index) {
        bool shadowed = static_cast<int>(index) < scene_.shadow_count;
        if (shadowed) gather(visibility, 0, lit_, static_cast<int>(index), 1, pixels);
        else visibility.fill(0, 1.0f);
        lights_[index](light, position, count);
        scene_.shade_light(contribution, count, surface, normal, view, light, visibility);
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < count; ++i) colour.lane(k)[i] += contribution.lane(k)[i];
    }
    scatter(colour_, 0, colour, 0, 3, pixels);
    scatter(ids_, 0, surface, lanes.material + 1, 1, pixels);
    scatter(ids_, 1, surface, lanes.material, 1, pixels);
}

void TileRenderer::shade_misses(Pixels pixels)
{
    Rows sky(3);
    sky_(sky, gathered(direction_, pixels), size(pixels));
    scatter(colour_, 0, sky, 0, 3, pixels);
}

void TileRenderer::store(const Area& area, Frame& frame) const
{
    const StructureLanes& lanes = scene_.lanes;
    auto at = [&](int pixel) {
        return static_cast<std::size_t>(area.y + pixel / area.width) * static_cast<std::size_t>(frame.width) +
               static_cast<std::size_t>(area.x + pixel % area.width);
    };
    for (int pixel = 0; pixel < area.width * area.height; ++pixel) {
        std::size_t to = at(pixel);
        frame.colour[to] = colour_.vec3(0, pixel);
        frame.depth[to] = std::numeric_limits<float>::infinity();
        frame.normal[to] = glm::vec3(0);
        frame.node_id[to] = frame.material_id[to] = 0;
        frame.steps[to] = static_cast<int>(eyes_.lane(lanes.probe_steps)[pixel]);
        frame.exhausted[to] = eyes_.lane(lanes.probe_exhausted)[pixel] > 0.5f || remaining_.lane(0)[pixel] < 0.5f;
    }
    for (int pixel : hits_) {
        std::size_t to = at(pixel);
        frame.depth[to] = eyes_.lane(lanes.probe_t)[pixel] * forward_share_.lane(0)[pixel];
        frame.normal[to] = normal_.vec3(0, pixel);
        frame.node_id[to] = static_cast<int>(ids_.lane(0)[pixel]);
        frame.material_id[to] = static_cast<int>(ids_.lane(1)[pixel]);
    }
}

}  // namespace fieldwright::renderer
