// Views by the shading library's functions, both eyes as one picture, and the sRGB encoding.
#include "renderer/picture.h"

#include "renderer/srgb_table.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>

namespace fieldwright::renderer {
namespace {

using field::row_width;

constexpr int band_height = 16;               // px, of what one thread encodes at a time
constexpr std::size_t fight_samples = 20011;  // prime, so that they make no pattern with the rows
constexpr unsigned char fight_colour[] = {255, 214, 10};
constexpr glm::vec3 exhausted_colour(1, 0, 1);

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

void load(Rows& rows, const ViewSource& source, std::size_t first, int count)
{
    if (source.colours) load(rows, *source.colours, first, count);
    if (source.numbers) load(rows, *source.numbers, first, count);
    if (source.counts) load(rows, *source.counts, first, count);
}

// The kernels know no infinity: a miss is a negative depth.
void mark_misses(Rows& depth, int count)
{
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(depth.lane(0)[i])) depth.lane(0)[i] = -1.0f;
}

const char* function_of(View view)
{
    switch (view) {
        case View::normal: return "view_normal";
        case View::depth: return "view_depth";
        case View::id:
        case View::material: return "view_id";
        case View::albedo:
        case View::slice: return "view_plain";
        case View::position: return "view_position";
        case View::shadow:
        case View::occlusion: return "view_share";
        default: return "view_beauty";
    }
}

void store_bytes(unsigned char* rgb, const Rows& linear, int count)
{
    const SrgbTable& table = SrgbTable::shared();
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) rgb[3 * i + k] = table.byte(linear.lane(k)[i]);
}

// As the bytes that a picture of them would have.
void encode_lanes(Rows& bytes, const Rows& linear, int count)
{
    const SrgbTable& table = SrgbTable::shared();
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < count; ++i) bytes.lane(k)[i] = static_cast<float>(table.byte(linear.lane(k)[i]));
}

float most_steps(const Display& display, int step_limit)
{
    return static_cast<float>(std::max(display.full_scale > 0 ? display.full_scale : step_limit, 1));
}

// Diagonals, so wide that they are seen as stripes on every screen.
bool on_stripe(int x, int y) { return (x + y) / 4 % 2 == 0; }

}  // namespace

float scale_end(const Display& display, int step_limit)
{
    float own = kind_of(display.view).scale_end;
    return own > 0 ? own : most_steps(display, step_limit);
}

Picture blank_picture(glm::ivec2 size_px)
{
    auto bytes = 3 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
    return {size_px.x, size_px.y, std::vector<unsigned char>(bytes)};
}

Picture enlarged(const Picture& picture, int times)
{
    Picture large = blank_picture(times * glm::ivec2(picture.width, picture.height));
    if (!picture.alpha.empty()) large.alpha.resize(large.rgb.size() / 3);
    for (std::size_t i = 0; i < large.rgb.size() / 3; ++i) {
        auto width = static_cast<std::size_t>(large.width), step = static_cast<std::size_t>(times);
        std::size_t from = i / width / step * static_cast<std::size_t>(picture.width) + i % width / step;
        std::copy_n(&picture.rgb[3 * from], 3, &large.rgb[3 * i]);
        if (!picture.alpha.empty()) large.alpha[i] = picture.alpha[from];
    }
    return large;
}

struct PictureEncoder::Scratch {
    Rows left{3}, right{3}, mixed{3}, input{3}, toned{3};
};

// Pixels of one row, side by side.
struct PictureEncoder::Run {
    Picture& picture;
    const Frame &left, &right;
    int x, y, count;

    std::size_t first() const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(left.width) + static_cast<std::size_t>(x);
    }
    unsigned char* rgb(int shift_x = 0, int shift_y = 0) const
    {
        auto row = static_cast<std::size_t>(y + shift_y) * static_cast<std::size_t>(picture.width);
        return &picture.rgb[3 * (row + static_cast<std::size_t>(x + shift_x))];
    }
};

PictureEncoder::PictureEncoder(const Display& display, int step_limit)
    : display_(display),
      step_scale_(most_steps(display, step_limit)),
      heat_scale_(scale_end(display, step_limit)),
      show_(function_of(display.view), field::kernels()),
      look_(display.look)
{
}

glm::ivec2 PictureEncoder::size_px(glm::ivec2 frame_size_px) const
{
    StereoLayout layout = mode_of(display_.stereo).layout;
    return frame_size_px * glm::ivec2(layout == StereoLayout::beside ? 2 : 1, layout == StereoLayout::below ? 2 : 1);
}

void PictureEncoder::show_heat(Rows& shown, const Frame& frame, const ViewSource& source, std::size_t first,
                               int count) const
{
    for (int i = 0; i < count; ++i) {
        std::size_t pixel = first + static_cast<std::size_t>(i);
        bool stopped = display_.view == View::steps && frame.exhausted[pixel];
        float number = source.counts ? static_cast<float>((*source.counts)[pixel]) : (*source.numbers)[pixel];
        glm::vec3 colour = stopped ? exhausted_colour : map_colour(display_.colour_map, number / heat_scale_);
        for (int k = 0; k < 3; ++k) shown.lane(k)[i] = colour[k];
    }
}

// Magenta light, the more the more steps the ray took.
void PictureEncoder::add_glow(Rows& shown, const Frame& frame, std::size_t first, int count) const
{
    for (int i = 0; i < count; ++i) {
        std::size_t pixel = first + static_cast<std::size_t>(i);
        float share = static_cast<float>(frame.steps[pixel]) / step_scale_;
        float glow = frame.exhausted[pixel] ? 1.0f : std::min(share, 1.0f);
        for (int k : {0, 2}) shown.lane(k)[i] += glow;
    }
}

// Colours of a pixel that is half transparent are those of its opaque half.
void PictureEncoder::show_beauty(Rows& shown, const Frame& frame, std::size_t first, int count, Scratch& scratch) const
{
    load(scratch.input, frame.colour, first, count);
    bool divides = !frame.alpha.empty() && display_.stereo == Stereo::off;
    for (int i = 0; divides && i < count; ++i)
        for (int k = 0; k < 3; ++k)
            scratch.input.lane(k)[i] /= std::max(frame.alpha[first + static_cast<std::size_t>(i)], 1e-6f);
    if (look_.changes_nothing()) return show_(shown, count, scratch.input);
    look_(scratch.toned, count, scratch.input);
    show_(shown, count, scratch.toned);
}

void PictureEncoder::show(Rows& shown, const Frame& frame, std::size_t first, int count, Scratch& scratch) const
{
    bool beauty = display_.view == View::beauty || display_.view == View::glow;
    if (beauty) show_beauty(shown, frame, first, count, scratch);
    if (display_.view == View::glow) add_glow(shown, frame, first, count);
    if (beauty) return;
    ViewSource source = source_of(frame, display_.view);
    bool exists = source.colours || source.numbers || source.counts;
    if (exists && kind_of(display_.view).scale_title) return show_heat(shown, frame, source, first, count);
    if (!exists)
        for (int k = 0; k < 3; ++k) scratch.input.fill(k, 0);
    load(scratch.input, source, first, count);
    if (display_.view == View::depth) mark_misses(scratch.input, count);
    show_(shown, count, scratch.input);
}

// What is in `scratch` of both eyes, as one.
void PictureEncoder::mix(const EyeMix& mix, unsigned char* rgb, int count, Scratch& scratch) const
{
    if (display_.stereo_space == StereoSpace::linear) {
        mix_eyes(scratch.mixed, count, mix, scratch.left, scratch.right, 1);
        return store_bytes(rgb, scratch.mixed, count);
    }
    Rows left(3), right(3);
    encode_lanes(left, scratch.left, count);
    encode_lanes(right, scratch.right, count);
    mix_eyes(scratch.mixed, count, mix, left, right, 255);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) rgb[3 * i + k] = static_cast<unsigned char>(scratch.mixed.lane(k)[i] + 0.5f);
}

void PictureEncoder::mark_fights(const Run& run, Stereo stereo, const Rows& left) const
{
    glm::ivec2 at = display_.origin + glm::ivec2(run.x, run.y);
    for (int i = 0; i < run.count; ++i)
        if (on_stripe(at.x + i, at.y) && eyes_fight(stereo, display_.stereo_space, left.vec3(0, i)))
            std::copy(std::begin(fight_colour), std::end(fight_colour), run.rgb() + 3 * i);
}

int PictureEncoder::divider(const Frame& frame) const
{
    return static_cast<int>(display_.split * static_cast<float>(frame.width));
}

void PictureEncoder::encode_run(const Run& run, Scratch& scratch) const
{
    const StereoMode& mode = mode_of(display_.stereo);
    bool only_right = mode.layout == StereoLayout::rows && (display_.origin.y + run.y) % 2 == 1;
    show(scratch.left, only_right ? run.right : run.left, run.first(), run.count, scratch);
    if (mode.layout != StereoLayout::mixed) store_bytes(run.rgb(), scratch.left, run.count);
    if (mode.layout == StereoLayout::one_eye || mode.layout == StereoLayout::rows) return;
    show(scratch.right, run.right, run.first(), run.count, scratch);
    if (mode.layout == StereoLayout::beside) return store_bytes(run.rgb(run.left.width, 0), scratch.right, run.count);
    if (mode.layout == StereoLayout::below) return store_bytes(run.rgb(0, run.left.height), scratch.right, run.count);
    Stereo stereo = run.x < divider(run.left) ? Stereo::naive : display_.stereo;
    mix(mix_of(stereo, display_.stereo_space), run.rgb(), run.count, scratch);
    if (display_.rivalry) mark_fights(run, stereo, scratch.left);
}

void PictureEncoder::encode(Picture& picture, const Area& area, const Frame& left, const Frame& right) const
{
    Scratch scratch;
    const Frame &first = display_.swap_eyes ? right : left, &second = display_.swap_eyes ? left : right;
    int border = divider(left), end = area.x + area.width;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x, count = 0; x < end; x += count) {
            count = std::min(row_width, end - x);
            if (x < border) count = std::min(count, border - x);
            encode_run({picture, first, second, x, y, count}, scratch);
        }
}

Picture picture(const Frame& left, const Frame& right, const Display& display, int step_limit)
{
    const PictureEncoder encoder(display, step_limit);
    Picture picture = blank_picture(encoder.size_px({left.width, left.height}));
    if (display.view == View::beauty && display.stereo == Stereo::off)
        for (float alpha : left.alpha) picture.alpha.push_back(static_cast<unsigned char>(255.0f * alpha + 0.5f));
    int bands = (left.height + band_height - 1) / band_height;
    tbb::parallel_for(0, bands, [&](int band) {
        int y = band * band_height;
        encoder.encode(picture, {0, y, left.width, std::min(band_height, left.height - y)}, left, right);
    });
    return picture;
}

Picture picture(const Frame& frame, View view, int step_limit, const Look& look)
{
    return picture(frame, frame, Display{.view = view, .look = look}, step_limit);
}

double fighting_share(const Frame& frame, Stereo stereo, StereoSpace space)
{
    std::size_t stride = std::max<std::size_t>(frame.colour.size() / fight_samples, 1), seen = 0, fights = 0;
    for (std::size_t i = stride / 2; i < frame.colour.size(); i += stride, ++seen)
        if (eyes_fight(stereo, space, frame.colour[i])) ++fights;
    return static_cast<double>(fights) / static_cast<double>(std::max<std::size_t>(seen, 1));
}

}  // namespace fieldwright::renderer
