// Draws a frame on all cores, tile by tile.
#include "renderer/cpu_tile.h"
#include "renderer/devices.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <atomic>
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
    const CpuScene scene(program, request);
    const std::vector<Area> areas = tiles(request.width, request.height, tbb::this_task_arena::max_concurrency());
    tbb::enumerable_thread_specific<TileRenderer> renderers([&] { return TileRenderer(scene); });
    std::mutex progress_mutex;
    std::atomic<bool> stopped = false;
    std::size_t drawn = 0;
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        if (stopped || watch.stops() || !renderers.local().draw(areas[i], frame, watch)) {
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

Frame render_on_cpu(const graph::Program& program, const FrameRequest& request, const Progress& progress)
{
    Frame frame(request.width, request.height);
    draw_on_cpu(frame, program, request, {.progress = progress});
    return frame;
}

}  // namespace fieldwright::renderer
