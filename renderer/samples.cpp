// Low-discrepancy samples, backdrops and sums.
#include "renderer/samples.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fieldwright::renderer {
namespace {

constexpr int checker_px = 12;
constexpr int weave_step = 2;
constexpr float light_square = 0.36f, dark_square = 0.28f;  // linear

// The part of a whole number of steps from the middle that is left after whole turns.
float turned(int sample, double step)
{
    double x = 0.5 + sample * step;
    return static_cast<float>(x - std::floor(x));
}

// Powers of the root of x^(d + 1) = x + 1, for d = 2 and d = 3.
glm::vec2 point_in_pixel(int sample)
{
    return {turned(sample, 0.7548776662466927), turned(sample, 0.5698402909980532)};
}

glm::vec3 point_in_lens_and_time(int sample)
{
    return {turned(sample, 0.8191725133961644), turned(sample, 0.671043606703789), turned(sample, 0.5497004779019701)};
}

// The square on the disk, rings on rings (P. Shirley and K. Chiu, "A low distortion map between disk and square", 1997).
glm::vec2 on_disk(glm::vec2 square)
{
    glm::vec2 s = 2.0f * square - glm::vec2(1.0f);
    if (s.x == 0 && s.y == 0) return {0, 0};
    constexpr float quarter = std::numbers::pi_v<float> / 4;
    bool across = std::abs(s.x) > std::abs(s.y);
    float radius = across ? s.x : s.y, angle = across ? quarter * (s.y / s.x) : 2 * quarter - quarter * (s.x / s.y);
    return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

glm::vec2 point_in_grid(int sample, int side)
{
    auto at = [&](int i) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(side); };
    return {at(sample % side), at(sample / side)};
}

glm::vec3 backdrop_at(const Exposure& exposure, int x, int y)
{
    if (exposure.backdrop == graph::Backdrop::colour) return exposure.backdrop_colour;
    if (!exposure.checkered) return glm::vec3(0);
    return glm::vec3((x / checker_px + y / checker_px) % 2 == 0 ? light_square : dark_square);
}

// What is a sum of light: colours first.
template <typename SomeFrame>
auto light_buffers(SomeFrame& frame)
{
    std::vector<decltype(&frame.colour)> buffers = {&frame.colour};
    if (auto& layers = frame.layers)
        for (auto* layer :
             {&layers->ambient, &layers->diffuse, &layers->specular, &layers->reflection, &layers->emission})
            buffers.push_back(layer);
    return buffers;
}

// Share of the pixel in which something was hit.
float covered(const Frame& frame, std::size_t pixel)
{
    if (!frame.covered.empty()) return frame.covered[pixel];
    return std::isfinite(frame.depth[pixel]) ? 1.0f : 0.0f;
}

// Devices that smooth edges bring none of the sky where a backdrop is laid; others bring all of it.
glm::vec3 before_backdrop(const Frame& frame, const glm::vec3& light, const glm::vec3& backdrop, float covered)
{
    return (frame.covered.empty() ? glm::vec3(0) : light) + (1 - covered) * backdrop;
}

// A lattice's pixels in their places among those of a larger frame.
template <typename T>
void weave(std::vector<T>& to, const std::vector<T>& from, const Frame& whole, const Frame& lattice, glm::ivec2 first)
{
    for (int y = 0; y < lattice.height; ++y)
        for (int x = 0; x < lattice.width; ++x) {
            int row = first.y + weave_step * y, column = first.x + weave_step * x;
            to[static_cast<std::size_t>(row * whole.width + column)] =
                from[static_cast<std::size_t>(y * lattice.width + x)];
        }
}

// What is summed of samples: light, and where there was a hit.
void weave_frame(Frame& whole, const Frame& lattice, glm::ivec2 first)
{
    auto to = light_buffers(whole);
    auto from = light_buffers(lattice);
    for (std::size_t k = 0; k < to.size(); ++k) weave(*to[k], *from[k], whole, lattice, first);
    weave(whole.depth, lattice.depth, whole, lattice, first);
    whole.covered.resize(lattice.covered.empty() ? 0 : whole.colour.size());
    if (!whole.covered.empty()) weave(whole.covered, lattice.covered, whole, lattice, first);
}

// Sample `sample` of the pixels of one lattice: a share of the shutter and a turn of the lens on.
FrameRequest lattice_of(const FrameRequest& picture, const Exposure& exposure, int sample, int lattice)
{
    FrameRequest request = sample_of(picture, exposure, sample);
    float share = point_in_lens_and_time(sample).z + static_cast<float>(lattice) / (weave_step * weave_step);
    request.time = picture.time + exposure.shutter * (share - std::floor(share) - 0.5f);
    // Diagonal neighbours first.
    request.lattice = {weave_step, (lattice ^ (lattice >> 1)) & 1, lattice & 1};
    for (int turn = 0; turn < lattice; ++turn) request.lens = {-request.lens.y, request.lens.x};
    return request;
}

template <typename Visit>
void for_pixels(std::size_t count, const Visit& visit)
{
    constexpr std::size_t run = 4096;
    tbb::parallel_for(std::size_t{0}, (count + run - 1) / run, [&](std::size_t part) {
        for (std::size_t i = part * run; i < std::min(count, (part + 1) * run); ++i) visit(i);
    });
}

}  // namespace

Exposure exposure_of(const graph::PictureSettings& settings)
{
    Exposure exposure;
    exposure.samples = settings.samples;
    exposure.shutter = settings.shutter;
    exposure.backdrop = settings.backdrop;
    exposure.backdrop_colour = settings.backdrop_colour;
    return exposure;
}

bool shows_sky(const Exposure& exposure) { return exposure.backdrop == graph::Backdrop::sky; }

int sample_count(const Exposure& exposure)
{
    return exposure.grid > 0 ? exposure.grid * exposure.grid : std::max(exposure.samples, 1);
}

FrameRequest sample_of(const FrameRequest& picture, const Exposure& exposure, int sample)
{
    FrameRequest request = picture;
    glm::vec2 pixel = exposure.grid > 0 ? point_in_grid(sample, exposure.grid) : point_in_pixel(sample);
    glm::vec3 lens_and_time = point_in_lens_and_time(sample);
    request.offset = pixel - glm::vec2(0.5f);
    request.lens = on_disk(glm::vec2(lens_and_time));
    request.time = picture.time + exposure.shutter * (lens_and_time.z - 0.5f);
    request.sky = shows_sky(exposure);
    return request;
}

bool draw_sample(Frame& frame, const FrameRequest& picture, const Exposure& exposure, int sample,
                 const DrawRequest& draw)
{
    if (sample == 0 || exposure.shutter == 0) return draw(frame, sample_of(picture, exposure, sample));
    const Area area = drawn_area(picture);
    for (int lattice = 0; lattice < weave_step * weave_step; ++lattice) {
        FrameRequest request = lattice_of(picture, exposure, sample, lattice);
        const DrawnPixels pixels = drawn_pixels(request);
        Frame part(pixels.width, pixels.height, request.layers);
        if (!part.colour.empty() && !draw(part, request)) return false;
        weave_frame(frame, part, {pixels.x - area.x, pixels.y - area.y});
    }
    return true;
}

void lay_backdrop(Frame& frame, const Area& area, const Exposure& exposure, const Area& part)
{
    if (shows_sky(exposure)) return;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x);
            float hit = covered(frame, pixel);
            if (hit == 1) continue;
            glm::vec3 backdrop = backdrop_at(exposure, part.x + x, part.y + y);
            frame.colour[pixel] = before_backdrop(frame, frame.colour[pixel], backdrop, hit);
            if (!frame.layers) continue;
            glm::vec3& emission = frame.layers->emission[pixel];
            emission = before_backdrop(frame, emission, backdrop, hit);
        }
}

void Accumulator::add(const Frame& sample, const Exposure& exposure)
{
    const std::vector<const std::vector<glm::vec3>*> light = light_buffers(sample);
    std::size_t pixels = sample.colour.size();
    if (count_ == 0) {
        sums_.assign(light.size(), std::vector<glm::vec3>(pixels, glm::vec3(0)));
        hits_.assign(pixels, 0.0f);
    }
    ++count_;
    bool transparent = exposure.backdrop == graph::Backdrop::transparent;
    for_pixels(pixels, [&](std::size_t i) {
        for (std::size_t k = 0; k < light.size(); ++k) sums_[k][i] += (*light[k])[i];
        hits_[i] += transparent ? covered(sample, i) : 1.0f;
    });
}

void Accumulator::resolve(Frame& frame, const Exposure& exposure) const
{
    float share = 1.0f / static_cast<float>(std::max(count_, 1));
    bool transparent = exposure.backdrop == graph::Backdrop::transparent && !exposure.checkered;
    frame.alpha.resize(transparent ? hits_.size() : 0);
    const std::vector<std::vector<glm::vec3>*> light = light_buffers(frame);
    for_pixels(hits_.size(), [&](std::size_t i) {
        for (std::size_t k = 0; k < light.size(); ++k) (*light[k])[i] = share * sums_[k][i];
        if (transparent) frame.alpha[i] = share * hits_[i];
    });
}

}  // namespace fieldwright::renderer
