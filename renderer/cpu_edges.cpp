// What coverage.glsl says of each pixel.
#include "renderer/cpu_edges.h"

namespace fieldwright::renderer {

CpuEdges::CpuEdges(const CpuScene& scene)
    : scene_(scene),
      marcher_(scene, CpuMarcher::Of::edges),
      ray_(scene.lanes.ray, pool_capacity),
      footprint_(scene.lanes.footprint, pool_capacity),
      beyond_(scene.lanes.beyond, pool_capacity),
      share_(1, pool_capacity)
{
}

void CpuEdges::watch(Rows& walked, Pixels batch, const Rows& ray, const Rows& beside, const Rows& above)
{
    Rows footprint(scene_.lanes.footprint), edge(scene_.lanes.edge);
    scene_.make_footprint(footprint, size(batch), ray, beside, above);
    scene_.watched_edge(edge, size(batch), gathered(walked, 0, scene_.lanes.probe, batch), footprint);
    scatter(walked, 0, edge, 0, scene_.lanes.edge, batch);
    scatter(ray_, 0, ray, 0, scene_.lanes.ray, batch);
    scatter(footprint_, 0, footprint, 0, scene_.lanes.footprint, batch);
}

void CpuEdges::find(const Rows& walked, Pixels pixels)
{
    Rows beyond(scene_.lanes.beyond);
    shared_.clear();
    for_batches(pixels, [&](Pixels batch) {
        scene_.edge_beyond(beyond, size(batch), gathered(walked, batch), gathered(footprint_, batch));
        scatter(beyond_, 0, beyond, 0, scene_.lanes.beyond, batch);
        scatter(share_, 0, beyond, 0, 1, batch);
        std::copy_if(batch.begin(), batch.end(), std::back_inserter(shared_),
                     [&](int pixel) { return share_.lane(0)[pixel] > 0; });
    });
}

Rows CpuEdges::rays_beyond(Pixels batch) const
{
    Rows rays(scene_.lanes.ray);
    scene_.beyond_ray(rays, size(batch), gathered(ray_, batch), gathered(footprint_, batch), gathered(beyond_, batch));
    return rays;
}

}  // namespace fieldwright::renderer
