// Views and anaglyphs by the shading library's functions, and the sRGB encoding.
#include "renderer/picture.h"

#include "renderer/srgb_table.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>

namespace fieldwright::renderer {
namespace {

using field::row_width;

constexpr int band_height = 16;  // px, of what one thread encodes at a time

void load(Rows& rows, const std::vector<glm::vec3>& pixels, std::size_t first, int count)
{
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < count; ++i) rows.lane(k)[i] = pixels[first + static_cast<std::size_t>(i)][k];
}

template <typename Number>
void load(Rows& rows, const std::vector<Number>& numbers, std::size_t first, int count)
{
    for (int i = 0; i < count; ++i) rows.lane(0)[i] = static_cast<float>(numbers[first + static_cast<std::size_t>(i)]);
}

// The kernels know no infinity: a miss is a negative depth.
void load_depth(Rows& rows, const std::vector<float>& depth, std::size_t first, int count)
{
    load(rows, depth, first, count);
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(rows.lane(0)[i])) rows.lane(0)[i] = -1.0f;
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

void store_bytes(unsigned char* rgb, const Rows& linear, int count)
{
    const SrgbTable& table = SrgbTable::shared();
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) rgb[3 * i + k] = table.byte(linear.lane(k)[i]);
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

struct PictureEncoder::Scratch {
    Rows left{3}, right{3}, combined{3}, input{3};
};

PictureEncoder::PictureEncoder(View view, int step_limit, Stereo stereo)
    : view_(view),
      stereo_(stereo),
      show_(function_of(view), field::kernels()),
      combine_(stereo == Stereo::naive ? "naive_anaglyph" : "dubois_anaglyph", field::kernels())
{
    if (view == View::steps) fill_step_colours(step_limit);
}

void PictureEncoder::fill_step_colours(int step_limit)
{
    Rows steps(1), limit(1), exhausted(1), shown(3);
    limit.fill(0, static_cast<float>(step_limit));
    for (int first = 0; first <= step_limit + 1; first += row_width) {
        int count = std::min(row_width, step_limit + 2 - first);
        for (int i = 0; i < count; ++i) {
            steps.lane(0)[i] = static_cast<float>(first + i);
            exhausted.lane(0)[i] = first + i > step_limit ? 1.0f : 0.0f;
        }
        show_(shown, count, steps, limit, exhausted);
        for (int i = 0; i < count; ++i) step_colours_.push_back(shown.vec3(0, i));
    }
}

void PictureEncoder::show_steps(Rows& shown, const Frame& frame, std::size_t first, int count) const
{
    for (int i = 0; i < count; ++i) {
        std::size_t pixel = first + static_cast<std::size_t>(i), last = step_colours_.size() - 1;
        auto steps = static_cast<std::size_t>(std::max(frame.steps[pixel], 0));
        const glm::vec3& colour = step_colours_[frame.exhausted[pixel] ? last : std::min(steps, last - 1)];
        for (int k = 0; k < 3; ++k) shown.lane(k)[i] = colour[k];
    }
}

void PictureEncoder::show(Rows& shown, const Frame& frame, std::size_t first, int count, Scratch& scratch) const
{
    Rows& input = scratch.input;
    switch (view_) {
        case View::beauty: load(input, frame.colour, first, count); break;
        case View::steps: return show_steps(shown, frame, first, count);
        case View::normal: load(input, frame.normal, first, count); break;
        case View::depth: load_depth(input, frame.depth, first, count); break;
        case View::id: load(input, frame.node_id, first, count); break;
    }
    show_(shown, count, input);
}

void PictureEncoder::encode(Picture& picture, const Area& area, const Frame& left, const Frame& right) const
{
    Scratch scratch;
    auto encode_run = [&](std::size_t first, int count) {
        show(scratch.left, left, first, count, scratch);
        unsigned char* rgb = &picture.rgb[3 * first];
        if (stereo_ == Stereo::off) return store_bytes(rgb, scratch.left, count);
        show(scratch.right, right, first, count, scratch);
        combine_(scratch.combined, count, scratch.left, scratch.right);
        store_bytes(rgb, scratch.combined, count);
    };
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = 0; x < area.width; x += row_width) {
            auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(area.x + x);
            encode_run(first, std::min(row_width, area.width - x));
        }
}

Picture picture(const Frame& frame, View view, int step_limit)
{
    return anaglyph(frame, frame, view, step_limit, Stereo::off);
}

Picture anaglyph(const Frame& left, const Frame& right, View view, int step_limit, Stereo stereo)
{
    Picture picture{left.width, left.height, std::vector<unsigned char>(3 * left.colour.size())};
    const PictureEncoder encoder(view, step_limit, stereo);
    int bands = (left.height + band_height - 1) / band_height;
    tbb::parallel_for(0, bands, [&](int band) {
        int y = band * band_height;
        encoder.encode(picture, {0, y, left.width, std::min(band_height, left.height - y)}, left, right);
    });
    return picture;
}

}  // namespace fieldwright::renderer
