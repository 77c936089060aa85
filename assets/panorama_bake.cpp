// The pixels themselves, and the light that a matt surface gathers in every direction.
#include "assets/panorama_bake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fieldwright::assets {
namespace {

constexpr int wide_columns = 32, wide_rows = 16;      // what a matt surface sees has no detail
constexpr int source_columns = 64, source_rows = 32;  // of what it is gathered from
constexpr float brightest = 1e6f;                     // beyond, numbers of a file mean nothing that a picture shows

// Colours of an equirectangular map, row by row from the top.
struct Map {
    int columns, rows;
    std::vector<glm::vec3> colours;

    Map(int map_columns, int map_rows)
        : columns(map_columns),
          rows(map_rows),
          colours(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
    {
    }
    glm::vec3& at(int x, int y)
    {
        return colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
    const glm::vec3& at(int x, int y) const { return const_cast<Map*>(this)->at(x, y); }
    double polar_angle(int y) const { return std::numbers::pi * (y + 0.5) / rows; }
    glm::vec3 direction(int x, int y) const
    {
        double down = polar_angle(y), around = 2 * std::numbers::pi * (x + 0.5) / columns;
        return {std::sin(down) * std::sin(around), std::cos(down), -std::sin(down) * std::cos(around)};
    }
};

// At least two rows and columns, as what lies between them is interpolated.
Map map_of(const Pixels& pixels)
{
    Map map(std::max(pixels.width, 2), std::max(pixels.height, 2));
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x) {
            int from_x = std::min(x, pixels.width - 1), from_y = std::min(y, pixels.height - 1);
            const float* rgba =
                &pixels.rgba[4 * (static_cast<std::size_t>(from_y) * static_cast<std::size_t>(pixels.width) +
                                  static_cast<std::size_t>(from_x))];
            map.at(x, y) = glm::clamp(glm::vec3(rgba[0], rgba[1], rgba[2]), 0.0f, brightest) * rgba[3];
        }
    return map;
}

// Means over the cells of a coarser map.
Map reduced(const Map& map, int columns, int rows)
{
    Map result(std::min(columns, map.columns), std::min(rows, map.rows));
    std::vector<float> counts(result.colours.size());
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x) {
            int to_x = x * result.columns / map.columns, to_y = y * result.rows / map.rows;
            result.at(to_x, to_y) += map.at(x, y);
            counts[static_cast<std::size_t>(to_y * result.columns + to_x)] += 1;
        }
    for (std::size_t i = 0; i < counts.size(); ++i) result.colours[i] /= counts[i];
    return result;
}

std::vector<glm::vec3> directions(const Map& map)
{
    std::vector<glm::vec3> result;
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x) result.push_back(map.direction(x, y));
    return result;
}

// Mean of the radiance around a normal, weighted by the cosine and the solid angle. `ways`: the directions of the map.
glm::vec3 gathered(const Map& map, const std::vector<glm::vec3>& ways, const glm::vec3& normal)
{
    glm::dvec3 sum(0);
    double weights = 0;
    auto way = ways.begin();
    for (int y = 0; y < map.rows; ++y) {
        double area = std::sin(map.polar_angle(y));
        for (int x = 0; x < map.columns; ++x) {
            double weight = std::max(0.0f, glm::dot(normal, *way++)) * area;
            sum += weight * glm::dvec3(map.at(x, y));
            weights += weight;
        }
    }
    return sum / std::max(weights, 1e-9);
}

Map wide(const Map& sharp)
{
    Map source = reduced(sharp, source_columns, source_rows), result(wide_columns, wide_rows);
    std::vector<glm::vec3> ways = directions(source);
    for (int y = 0; y < result.rows; ++y)
        for (int x = 0; x < result.columns; ++x) result.at(x, y) = gathered(source, ways, result.direction(x, y));
    return result;
}

void append(graph::PointList& list, const Map& map)
{
    for (const glm::vec3& colour : map.colours) list.emplace_back(colour, 0.0f);
}

}  // namespace

graph::BakedImage panorama(const Pixels& pixels)
{
    Map sharp = map_of(pixels), matt = wide(sharp);
    graph::BakedImage image;
    image.list.reserve(1 + sharp.colours.size() + matt.colours.size());
    image.list.emplace_back(sharp.columns, sharp.rows, matt.columns, matt.rows);
    append(image.list, sharp);
    append(image.list, matt);
    return image;
}

}  // namespace fieldwright::assets
