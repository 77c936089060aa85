// Draws a frame on all cores, tile by tile.
#include "renderer/cpu_tile.h"
#include "renderer/devices.h"
#include "renderer/slice_tile.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>

namespace fieldwright::renderer {
namespace {

constexpr int tiles_per_thread = 8;  // or threads wait for the last ones

// As large as they may be, or halved until there are enough of them; no smaller than what is marched at once.
std::vector<Area> tiles(int width, int height, int threads)
{
    int across = tile_width, down = tile_height;
    auto count = [&] { return ((width + across - 1) / across) * ((height + down - 1) / down); };
    while (across * down > field::row_width && count() < tiles_per_thread * threads)
        (across > down ? across : down) /= 2;
    std::vector<Area> areas;
    for (int y = 0; y < height; y += down)
        for (int x = 0; x < width; x += across)
            areas.push_back({x, y, std::min(across, width - x), std::min(down, height - y)});
    return areas;
}

// Draws all tiles, each by `draw_tile`, on all cores. False when the watch cancelled it.
template <typename DrawTile>
bool draw_tiles(const Frame& frame, const Watch& watch, const DrawTile& draw_tile)
{
    const std::vector<Area> areas = tiles(frame.width, frame.height, tbb::this_task_arena::max_concurrency());
    std::mutex progress_mutex;
    std::atomic<bool> stopped = false;
    std::size_t drawn = 0;
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        if (stopped || watch.stops() || !draw_tile(areas[i])) {
            stopped = true;
            return;
        }
        if (watch.part_drawn) watch.part_drawn(frame, areas[i]);
        if (!watch.progress) return;
        std::lock_guard lock(progress_mutex);
        watch.progress(static_cast<float>(++drawn) / static_cast<float>(areas.size()));
    });
    return !stopped;
}

// Distances of many points by one thread, 256 at a time.
class PointEvaluator {
public:
    PointEvaluator(const field::Evaluator& evaluator, const std::vector<float>& block)
        : evaluator_(evaluator), block_(block), workspace_(evaluator)
    {
    }
    std::vector<float> operator()(std::span<const glm::vec3> points)
    {
        std::vector<float> distances;
        distances.reserve(points.size());
        for (std::size_t first = 0; first < points.size(); first += field::row_width) {
            std::size_t count = std::min<std::size_t>(field::row_width, points.size() - first);
            for (int k = 0; k < 3; ++k)
                for (std::size_t i = 0; i < count; ++i) workspace_.input(k)[i] = points[first + i][k];
            evaluator_.evaluate(workspace_, block_, static_cast<int>(count));
            distances.insert(distances.end(), workspace_.result(0), workspace_.result(0) + count);
        }
        return distances;
    }

private:
    const field::Evaluator& evaluator_;
    const std::vector<float>& block_;
    field::Evaluator::Workspace workspace_;
};

bool draw_slice(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch)
{
    const std::vector<float> block = field::evaluate_frame(program, request.time);
    const field::Evaluator evaluator(program, program.distance);
    frame.covered.clear();
    tbb::enumerable_thread_specific<PointEvaluator> evaluators([&] { return PointEvaluator(evaluator, block); });
    frame.evaluations = 0;
    return draw_tiles(frame, watch, [&](const Area& area) {
        draw_slice_area(frame, request, area, std::ref(evaluators.local()));
        return true;
    });
}

}  // namespace

bool runs_on_cpu(const graph::Program& program)
{
    const std::map<std::string, std::string>& built_in = graph::embedded_texts();
    auto is_built_in = [&](const graph::SourceFile& file) {
        auto known = built_in.find(file.path);
        return known != built_in.end() && known->second == program.library->text(file.path);
    };
    const auto& files = program.library->render_files();
    return !program.gpu_only && std::all_of(files.begin(), files.end(), is_built_in);
}

bool draw_on_cpu(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch)
{
    if (request.slice) return draw_slice(frame, program, request, watch);
    const CpuScene scene(program, request);
    frame.covered.resize(scene.features.coverage ? frame.colour.size() : 0);
    tbb::enumerable_thread_specific<TileRenderer> renderers([&] { return TileRenderer(scene); });
    bool drawn = draw_tiles(frame, watch, [&](const Area& area) { return renderers.local().draw(area, frame, watch); });
    frame.evaluations = 0;
    for (const TileRenderer& renderer : renderers) frame.evaluations += renderer.evaluations();
    return drawn;
}

Frame render_on_cpu(const graph::Program& program, const FrameRequest& request, const Progress& progress)
{
    const DrawnPixels drawn = drawn_pixels(request);
    Frame frame(drawn.width, drawn.height, request.layers);
    draw_on_cpu(frame, program, request, {.progress = progress});
    return frame;
}

}  // namespace fieldwright::renderer
