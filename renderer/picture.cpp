// Views and anaglyphs by the shading library's functions, and the sRGB encoding.
#include "renderer/picture.h"

#include "renderer/rows.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>

namespace fieldwright::renderer {
namespace {

using field::row_width;
using Pixels = std::vector<glm::vec3>;  // linear Rec.709

template <typename Draw>
void for_rows(std::size_t pixels, Draw draw)
{
    std::size_t batches = (pixels + row_width - 1) / row_width;
    tbb::parallel_for(std::size_t{0}, batches, [&](std::size_t batch) {
        std::size_t first = batch * row_width;
        draw(first, static_cast<int>(std::min<std::size_t>(row_width, pixels - first)));
    });
}

Rows rows_of(const Pixels& pixels, std::size_t first, int count)
{
    Rows rows(3);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) rows.lane(k)[i] = pixels[first + static_cast<std::size_t>(i)][k];
    return rows;
}

template <typename Number>
Rows rows_of(const std::vector<Number>& numbers, std::size_t first, int count)
{
    Rows rows(1);
    for (int i = 0; i < count; ++i) rows.lane(0)[i] = static_cast<float>(numbers[first + static_cast<std::size_t>(i)]);
    return rows;
}

void store(Pixels& pixels, std::size_t first, int count, const Rows& rows)
{
    for (int i = 0; i < count; ++i) pixels[first + static_cast<std::size_t>(i)] = rows.vec3(0, i);
}

// The kernels know no infinity: a miss is a negative depth.
Rows finite_depth(const std::vector<float>& depth, std::size_t first, int count)
{
    Rows rows = rows_of(depth, first, count);
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(rows.lane(0)[i])) rows.lane(0)[i] = -1.0f;
    return rows;
}

const char* function_of(View view)
{
    switch (view) {
        case View::beauty: return "view_beauty";
        case View::steps: return "view_steps";
        case View::normal: return "view_normal";
        case View::depth: return "view_depth";
        case View::id: break;
    }
    return "view_id";
}

Pixels view_pixels(const Frame& frame, View view, int step_limit)
{
    Pixels pixels(frame.colour.size());
    const RowFunction show(function_of(view), field::kernels());
    Rows limit(1);
    limit.fill(0, static_cast<float>(step_limit));
    for_rows(pixels.size(), [&](std::size_t first, int count) {
        Rows shown(3);
        switch (view) {
            case View::beauty: show(shown, count, rows_of(frame.colour, first, count)); break;
            case View::steps:
                show(shown, count, rows_of(frame.steps, first, count), limit, rows_of(frame.exhausted, first, count));
                break;
            case View::normal: show(shown, count, rows_of(frame.normal, first, count)); break;
            case View::depth: show(shown, count, finite_depth(frame.depth, first, count)); break;
            case View::id: show(shown, count, rows_of(frame.node_id, first, count)); break;
        }
        store(pixels, first, count, shown);
    });
    return pixels;
}

Picture encoded(const Pixels& pixels, int width, int height)
{
    Picture picture{width, height, std::vector<unsigned char>(3 * pixels.size())};
    const RowFunction srgb_encode("srgb_encode", field::kernels());
    for_rows(pixels.size(), [&](std::size_t first, int count) {
        Rows srgb(3);
        srgb_encode(srgb, count, rows_of(pixels, first, count));
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < 3; ++k)
                picture.rgb[3 * (first + static_cast<std::size_t>(i)) + static_cast<std::size_t>(k)] =
                    static_cast<unsigned char>(std::floor(255.0f * srgb.lane(k)[i] + 0.5f));
    });
    return picture;
}

// The enumerators are in the order of their names.
template <typename Kind>
std::optional<Kind> by_name(const std::vector<std::string>& names, std::string_view name)
{
    auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Kind>(found - names.begin());
}

}  // namespace

const std::vector<std::string>& view_names()
{
    static const std::vector<std::string> names = {"beauty", "steps", "normal", "depth", "id"};
    return names;
}

const std::vector<std::string>& stereo_names()
{
    static const std::vector<std::string> names = {"off", "naive", "dubois"};
    return names;
}

std::optional<View> view_from_name(std::string_view name) { return by_name<View>(view_names(), name); }

std::optional<Stereo> stereo_from_name(std::string_view name) { return by_name<Stereo>(stereo_names(), name); }

Picture picture(const Frame& frame, View view, int step_limit)
{
    return encoded(view_pixels(frame, view, step_limit), frame.width, frame.height);
}

Picture anaglyph(const Frame& left, const Frame& right, View view, int step_limit, Stereo stereo)
{
    if (stereo == Stereo::off) return picture(left, view, step_limit);
    const Pixels left_pixels = view_pixels(left, view, step_limit), right_pixels = view_pixels(right, view, step_limit);
    const RowFunction combine(stereo == Stereo::naive ? "naive_anaglyph" : "dubois_anaglyph", field::kernels());
    Pixels pixels(left_pixels.size());
    for_rows(pixels.size(), [&](std::size_t first, int count) {
        Rows combined(3);
        combine(combined, count, rows_of(left_pixels, first, count), rows_of(right_pixels, first, count));
        store(pixels, first, count, combined);
    });
    return encoded(pixels, left.width, left.height);
}

}  // namespace fieldwright::renderer
