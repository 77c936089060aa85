// Rows stay filled: probes that are done make room for waiting ones.
#include "renderer/cpu_marcher.h"

#include <algorithm>

namespace fieldwright::renderer {
namespace {

using field::row_width;

constexpr int refill_share = 8;  // probes move when one in so many is done

}  // namespace

Stage::Stage(const field::Evaluator& stage_evaluator, const std::vector<float>& stage_block)
    : evaluator(stage_evaluator), block(stage_block), workspace(stage_evaluator)
{
}

void Stage::operator()(Rows& result, const Rows& input, int count)
{
    for (int k = 0; k < input.lanes(); ++k) std::copy_n(input.lane(k), count, workspace.input(k));
    evaluator.evaluate(workspace, block, count);
    for (int k = 0; k < result.lanes(); ++k) std::copy_n(workspace.result(k), count, result.lane(k));
}

CpuMarcher::CpuMarcher(const CpuScene& scene)
    : scene_(scene),
      distance_(scene.distance, scene.block),
      marching_(scene.lanes.probe),
      advanced_(scene.lanes.probe),
      narrowed_(scene.lanes.probe),
      point_(3),
      d_(1),
      done_(1),
      side_(1),
      pixel_of_(row_width)
{
}

bool CpuMarcher::march(Rows& probes, const Rows* sides, Pixels waiting, const Watch& watch)
{
    int active = 0;
    while (active < row_width && !waiting.empty()) take_waiting(probes, sides, waiting, active++);
    while (active > 0) {
        if (stops(watch)) return false;
        while (refill_share * step(active, sides != nullptr) < active) {
        }
        active = replace_done(probes, sides, waiting, active);
    }
    return true;
}

// Tiles of heavy scenes take tens of milliseconds, steps of light ones less than asking.
bool CpuMarcher::stops(const Watch& watch)
{
    auto now = std::chrono::steady_clock::now();
    if (now - last_asked_ < std::chrono::milliseconds(1)) return false;
    last_asked_ = now;
    return watch.stops();
}

void CpuMarcher::take_waiting(const Rows& probes, const Rows* sides, Pixels& waiting, int to)
{
    marching_.copy(to, probes, waiting.front());
    if (sides) side_.copy(to, *sides, waiting.front());
    pixel_of_[static_cast<std::size_t>(to)] = waiting.front();
    waiting = waiting.subspan(1);
}

// One distance for each probe; how many of them are done.
int CpuMarcher::step(int active, bool has_sides)
{
    evaluations_ += active;
    scene_.probe_point(point_, active, marching_, scene_.march);
    distance_(d_, point_, active);
    if (has_sides)
        for (int i = 0; i < active; ++i) d_.lane(0)[i] *= side_.lane(0)[i];
    scene_.advance(advanced_, active, marching_, d_, scene_.march);
    if (scene_.features.cones) {
        scene_.narrowed(narrowed_, active, marching_, advanced_, d_, scene_.march);
        std::swap(advanced_, narrowed_);
    }
    std::swap(marching_, advanced_);
    scene_.probe_done(done_, active, marching_);
    return static_cast<int>(std::count(done_.lane(0), done_.lane(0) + active, 1.0f));
}

// Waiting probes take the places of those that are done, then the last ones do; how many there are.
int CpuMarcher::replace_done(Rows& probes, const Rows* sides, Pixels& waiting, int active)
{
    for (int i = active - 1; i >= 0; --i) {
        if (done_.lane(0)[i] < 0.5f) continue;
        probes.copy(pixel_of_[static_cast<std::size_t>(i)], marching_, i);
        if (!waiting.empty()) {
            take_waiting(probes, sides, waiting, i);
        } else if (i != --active) {
            marching_.copy(i, marching_, active);
            side_.copy(i, side_, active);
            pixel_of_[static_cast<std::size_t>(i)] = pixel_of_[static_cast<std::size_t>(active)];
        }
    }
    return active;
}

}  // namespace fieldwright::renderer
