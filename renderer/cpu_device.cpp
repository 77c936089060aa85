// Draws a frame on all cores, tile by tile.
#include "renderer/cpu_tile.h"
#include "renderer/devices.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <mutex>

namespace fieldwright::renderer {
namespace {

std::vector<TileArea> tiles(int width, int height)
{
    std::vector<TileArea> areas;
    for (int y = 0; y < height; y += tile_height)
        for (int x = 0; x < width; x += tile_width)
            areas.push_back({x, y, std::min(tile_width, width - x), std::min(tile_height, height - y)});
    return areas;
}

}  // namespace

Frame render_on_cpu(const graph::Program& program, const FrameRequest& request, const Progress& progress)
{
    const CpuScene scene(program, request);
    Frame frame(request.width, request.height);
    const std::vector<TileArea> areas = tiles(request.width, request.height);
    tbb::enumerable_thread_specific<TileRenderer> renderers([&] { return TileRenderer(scene); });
    std::mutex progress_mutex;
    std::size_t drawn = 0;
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        renderers.local().draw(areas[i], frame);
        if (!progress) return;
        std::lock_guard lock(progress_mutex);
        progress(static_cast<float>(++drawn) / static_cast<float>(areas.size()));
    });
    return frame;
}

}  // namespace fieldwright::renderer
