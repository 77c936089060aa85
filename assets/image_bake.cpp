// Pixels to insideness, insideness to an outline, the outline to distances.
#include "assets/image_bake.h"

#include "assets/image_outline.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::assets {
namespace {

constexpr float finest = 0.125f;  // of a pixel: of a small picture more samples would show nothing new

constexpr float spare = 1.5f;  // pixels a sample

// How much a pixel is of the part, and from where on it is inside.
struct Measure {
    explicit Measure(const graph::ImageRequest& request)
        : of_brightness(request.part == "dark" || request.part == "bright"),
          inverted(request.part == "dark" || request.part == "transparent")
    {
        float level = 0.01f * static_cast<float>(request.level);
        threshold = inverted ? 1 - level : level;
    }

    // What is transparent shows neither ink nor light.
    float operator()(const float* rgba) const
    {
        float brightness = 0.2126f * rgba[0] + 0.7152f * rgba[1] + 0.0722f * rgba[2];
        float amount = std::clamp(of_brightness ? brightness : rgba[3], 0.0f, 1.0f);
        if (inverted) amount = 1 - amount;
        return of_brightness ? amount * rgba[3] : amount;
    }

    bool of_brightness, inverted;
    float threshold;
};

// From below, with a ring of outside.
NumberGrid insideness(const Pixels& pixels, const Measure& measure)
{
    NumberGrid grid{pixels.width + 2, pixels.height + 2, {}};
    grid.numbers.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 0.0f);
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            auto from = static_cast<std::size_t>(pixels.height - 1 - y) * static_cast<std::size_t>(pixels.width) +
                        static_cast<std::size_t>(x);
            auto to = static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(grid.columns) +
                      static_cast<std::size_t>(x + 1);
            grid.numbers[to] = measure(&pixels.rgba[4 * from]);
        }
    return grid;
}

// Each number the mean of nine; the ring around stays outside. An edge one pixel wide becomes a slope on which
// interpolation finds it exactly where it is straight.
NumberGrid averaged(const NumberGrid& grid)
{
    NumberGrid result = grid;
    for (int y = 1; y + 1 < grid.rows; ++y)
        for (int x = 1; x + 1 < grid.columns; ++x) {
            float sum = 0;
            for (int i = 0; i < 9; ++i) sum += grid.at(x - 1 + i % 3, y - 1 + i / 3);
            result.at(x, y) = sum / 9;
        }
    return result;
}

// Where the samples lie: square, around the middle of the outline's grid, at least as wide as that. In its cells.
struct Sampling {
    Sampling(const NumberGrid& grid, int detail)
        : spacing(
              std::max(finest, static_cast<float>(std::max(grid.columns, grid.rows) - 1) / static_cast<float>(detail))),
          columns(count(grid.columns)),
          rows(count(grid.rows)),
          low(0.5f * (glm::vec2(grid.columns - 1, grid.rows - 1) - spacing * glm::vec2(columns - 1, rows - 1)))
    {
    }
    int count(int of_grid) const
    {
        return 1 + static_cast<int>(std::ceil(static_cast<float>(of_grid - 1) / spacing - 1e-3f));
    }

    float spacing;
    int columns, rows;
    glm::vec2 low;  // of the first sample
};

// Signed distances, in their spacing.
NumberGrid sampled(const ImageOutline& outline, const NumberGrid& grid, const Sampling& sampling)
{
    NumberGrid samples{sampling.columns, sampling.rows, {}};
    float farthest = static_cast<float>(grid.columns + grid.rows);
    for (int y = 0; y < samples.rows; ++y) {
        float bound = farthest;
        for (int x = 0; x < samples.columns; ++x) {
            glm::vec2 point = sampling.low + sampling.spacing * glm::vec2(x, y);
            // The neighbour's distance, and the way from it.
            bound = outline.distance(point, bound + 1.001f * sampling.spacing);
            samples.numbers.push_back((outline.inside(point) ? -bound : bound) / sampling.spacing);
        }
    }
    return samples;
}

// Away from the line, which stays where it is, the tips of the distance's cones are rounded: bilinear interpolation is
// steep there. What slope is left is measured afterwards.
NumberGrid rounded_far_away(const NumberGrid& samples)
{
    constexpr float far_away = 1.5f;  // beyond all cells that the line passes
    constexpr float weights[3] = {0.25f, 0.5f, 0.25f};
    NumberGrid result = samples;
    for (int y = 1; y + 1 < samples.rows; ++y)
        for (int x = 1; x + 1 < samples.columns; ++x) {
            if (std::abs(samples.at(x, y)) < far_away) continue;
            float sum = 0;
            for (int i = 0; i < 9; ++i)
                sum += weights[i % 3] * weights[i / 3] * samples.at(x - 1 + i % 3, y - 1 + i / 3);
            result.at(x, y) = sum;
        }
    return result;
}

// Of bilinear interpolation: at a corner of a cell its gradient is the slopes of two sides.
float lipschitz(const NumberGrid& samples)
{
    float steepest = 1;
    for (int y = 0; y + 1 < samples.rows; ++y)
        for (int x = 0; x + 1 < samples.columns; ++x) {
            float a = samples.at(x, y), b = samples.at(x + 1, y), c = samples.at(x + 1, y + 1),
                  d = samples.at(x, y + 1);
            float across = std::max(std::abs(b - a), std::abs(c - d)), up = std::max(std::abs(d - a), std::abs(c - b));
            steepest = std::max(steepest, across * across + up * up);
        }
    return 1.00001f * std::sqrt(steepest);
}

graph::PointList packed(const NumberGrid& samples, const Sampling& sampling, const ImageOutline& outline, int height)
{
    glm::vec2 low = (outline.low() - sampling.low) / sampling.spacing;
    glm::vec2 high = (outline.high() - sampling.low) / sampling.spacing;
    glm::vec2 centre = 0.5f * (low + high), half = 0.5f * (high - low) + 1.0f;  // where it is between samples, too
    graph::PointList list = {
        glm::vec4(samples.columns, samples.rows, lipschitz(samples), sampling.spacing / static_cast<float>(height)),
        glm::vec4(centre.x, centre.y, half.x, half.y)};
    list.resize(2 + (samples.numbers.size() + 3) / 4, glm::vec4(0));
    for (std::size_t i = 0; i < samples.numbers.size(); ++i)
        list[2 + i / 4][static_cast<int>(i % 4)] = samples.numbers[i];
    return list;
}

}  // namespace

graph::BakedImage baked(const Pixels& pixels, const graph::ImageRequest& request, const std::string& subject)
{
    Measure measure(request);
    NumberGrid grid = insideness(pixels, measure);
    Sampling sampling(grid, request.detail);
    // Pixels much finer than the samples give their detail for a smoother edge.
    ImageOutline outline(sampling.spacing >= spare ? averaged(grid) : grid, measure.threshold);
    if (outline.empty())
        return {{}, subject + " has nothing " + request.part + " at this level; change the part or the level"};
    NumberGrid samples = rounded_far_away(sampled(outline, grid, sampling));
    return {packed(samples, sampling, outline, pixels.height), {}};
}

}  // namespace fieldwright::assets
