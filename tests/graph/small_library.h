// A library of a few small node types, one per kind of socket and parameter, for tests of documents and files.
#pragma once

#include "graph/library.h"

#include <map>
#include <memory>
#include <string>

namespace fieldwright::graph {

inline std::shared_ptr<const Library> small_library()
{
    static const std::map<std::string, std::string> texts = {
        {"render/types.glsl", R"(// Types: what nodes pass around.

struct Box {
    vec3 centre;
    vec3 half_size;
};

struct Material {
    vec3 albedo;
};

struct Ray {
    vec3 origin;
};

struct Camera {
    Ray ray;
};

struct Sky {
    vec3 radiance;
};

Box make_box(vec3 centre, vec3 half_size)
{
    Box box;
    box.centre = centre;
    box.half_size = half_size;
    return box;
}
)"},
        {"nodes/primitive/sphere.glsl", R"(// Sphere: all points at one distance.
// field: exact
float sphere_distance(
    vec3 p,
    float radius)   // 1.0 [0.01, 10] m  Distance from the centre to the surface.
{
    return length(p) - radius;
}

Box sphere_bounds(float radius) { return make_box(vec3(0.0f), vec3(radius)); }
)"},
        {"nodes/shape2d/circle.glsl", R"(// Circle: a disc.
// field: exact
float circle_distance(
    vec2 p,
    float radius)   // 1.0 [0.01, 10] m  Distance from the centre to the edge.
{
    return length(p) - radius;
}

Box circle_bounds(float radius) { return make_box(vec3(0.0f), vec3(radius)); }
)"},
        {"nodes/shape2d/star.glsl", R"(// Star: one parameter of every kind that has a value.
// field: bound
float star_distance(
    vec2 p,
    List points,   // [(0, 0), (1, 0), (0, 1)] [-100, 100] m  Corners.
    int corners,   // 5 [3, 100]  How many.
    bool filled,   // true  Whether the inside counts.
    int style,   // round {sharp, round}  The kind of corner.
    vec2 size,   // (1, 1) [0, 10] m  Width and height.
    vec3 offset,   // (0, 0, 0) [-10, 10] m  Where it is.
    vec3 turn,   // (0, 0, 0) [-360, 360] deg  Rotation.
    float lean,   // 30 [-90, 90] deg  Shear.
    vec3 tint)   // #ffffff [0, 1]  Colour.
{
    return length(p);
}

Box star_bounds(vec2 size) { return make_box(vec3(0.0f), vec3(size.x)); }
)"},
        {"nodes/convert/extrude.glsl", R"(// Extrude: a 2D field made solid.
// field: exact
vec2 extrude_point(vec3 p)
{
    return vec2(p.x, p.y);
}

float extrude_distance(
    vec3 p,
    float d,
    float height)   // 1.0 [0.01, 10] m  Half the thickness.
{
    return max(d, abs(p.z) - height);
}

Box extrude_bounds(float height, Box child) { return child; }
)"},
        {"nodes/combine/union.glsl", R"(// Union: what is in either.
// field: exact; bound
// combiner: hard associative
float union_distance(float a, float b)
{
    return min(a, b);
}

float union_blend(float a, float b)
{
    return a < b ? 0.0f : 1.0f;
}

Box union_bounds(Box box_a, Box box_b) { return box_a; }
)"},
        {"nodes/modify/paint.glsl", R"(// Paint: gives a field a material.
// field: exact
float paint_distance(
    float d,
    Material material)   // The material.
{
    return d;
}

Box paint_bounds(Box child) { return child; }
)"},
        {"nodes/value/number.glsl", R"(// Number: one number.
float number_value(
    float number)   // 0.0 [-1000000, 1000000]  The number.
{
    return number;
}
)"},
        {"nodes/value/arrow.glsl", R"(// Arrow: three numbers.
vec3 arrow_value(
    vec3 to)   // (0, 1, 0) [-10, 10]  Its end.
{
    return to;
}
)"},
        {"nodes/value/words.glsl", R"(// Words: what is written, and what is computed.
// text motto: "Ag: two words"  What it says.
// number a: 1.0 [-10, 10] [0, 1] m  A number of the formula.
float words_value(
    float result,   // formula "a  * x"  What it computes.
    float scale)   // 2.0 [0, 10]  How much of it.
{
    return result * scale;
}
)"},
        {"nodes/material/matte.glsl", R"(// Matte: one colour.
Material matte_material(
    vec3 colour)   // #808080 [0, 1]  What it looks like.
{
    Material material;
    material.albedo = colour;
    return material;
}
)"},
        {"nodes/output/output.glsl", R"(// Output: what is drawn.
// field: exact
float output_distance(vec3 p, float d, Camera camera, Sky sky)
{
    return d;
}

Box output_bounds(Box child) { return child; }
)"},
    };
    static const std::shared_ptr<const Library> library = Library::from_texts(texts, {});
    return library;
}

}  // namespace fieldwright::graph
