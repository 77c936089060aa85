// Copies between rows and pools.
#include "renderer/pixel_rows.h"

namespace fieldwright::renderer {

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

void mix_in(Rows& pool, int pool_lane, const Rows& from, int lanes, const Rows& share, Pixels pixels)
{
    for (int k = 0; k < lanes; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            float& there = pool.lane(pool_lane + k)[pixels[i]];
            there = glm::mix(there, from.lane(k)[i], share.lane(0)[pixels[i]]);
        }
}

void copy_lanes(Rows& to, int to_lane, const Rows& from, int from_lane, int lanes, int count)
{
    for (int k = 0; k < lanes; ++k) std::copy_n(from.lane(from_lane + k), count, to.lane(to_lane + k));
}

}  // namespace fieldwright::renderer
