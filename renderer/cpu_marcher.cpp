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

CpuMarcher::CpuMarcher(const CpuScene& scene, Of of)
    : scene_(scene),
      of_(of),
      distance_(scene.distance, scene.block),
      marching_(of == Of::edges ? scene.lanes.edge : scene.lanes.probe),
      advanced_(scene.lanes.probe),
      narrowed_(scene.lanes.probe),
      next_edge_(of == Of::edges ? scene.lanes.edge : 0),
      point_(3),
      d_(1),
      done_(1),
      side_(1),
      pixel_of_(row_width)
{
}

bool CpuMarcher::march(Rows& probes, const Rows* sides, Pixels waiting, const Rows& settings, const Watch& watch)
{
    int active = 0;
    while (active < row_width && !waiting.empty()) take_waiting(probes, sides, waiting, active++);
    while (active > 0) {
        if (stops(watch)) return false;
        int done = 0;
        do {
            evaluations_ += active - done;
            done = step(active, sides != nullptr, settings);
        } while (refill_share * done < active);
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
int CpuMarcher::step(int active, bool has_sides, const Rows& settings)
{
    const RowFunction& point = of_ == Of::edges ? scene_.edge_point : scene_.probe_point;
    point(point_, active, marching_, settings);
    distance_(d_, point_, active);
    if (has_sides)
        for (int i = 0; i < active; ++i) d_.lane(0)[i] *= side_.lane(0)[i];
    advance(active, settings);
    return static_cast<int>(std::count(done_.lane(0), done_.lane(0) + active, 1.0f));
}

// The probes, or edges, after the distances; and which are done.
void CpuMarcher::advance(int active, const Rows& settings)
{
    scene_.advance(advanced_, active, marching_, d_, settings);
    if (scene_.features.cones) {
        scene_.narrowed(narrowed_, active, marching_, advanced_, d_, settings);
        std::swap(advanced_, narrowed_);
    }
    if (of_ == Of::probes) {
        std::swap(marching_, advanced_);
        return scene_.probe_done(done_, active, marching_);
    }
    scene_.next_edge(next_edge_, active, marching_, advanced_, d_, settings);
    std::swap(marching_, next_edge_);
    scene_.edge_done(done_, active, marching_);
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
