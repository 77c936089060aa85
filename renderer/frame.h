// What a device draws: one frame of buffers, top-down rows, and the request for it.
#pragma once

#include "graph/program.h"
#include "renderer/slice.h"

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace fieldwright::renderer {

enum class Eye { centre, left, right };

float eye_side(Eye eye);  // -1 left, 0 centre, 1 right

// A viewport's own camera: moving it is not an edit, and links no program.
struct ViewCamera {
    glm::vec3 position{4, 3, 6}, target{0}, up{0, 1, 0};  // m; up: any direction that is not the view's
    float field_of_view_rad = 0.785398163f;               // vertical
    float orthographic_height = 0;                        // m, of what the picture shows; 0 = perspective
    bool operator==(const ViewCamera&) const = default;
};

// The same for the shading library (render/view.glsl).
struct Viewpoint {
    glm::vec3 position{0}, forward{0}, right{0}, upward{0};  // m, and three unit vectors
    float slope = 0;                                         // of rays at the upper edge, of a perspective view
    float half_height = 0;                                   // m, of an orthographic view
};

Viewpoint viewpoint_of(const ViewCamera& camera);

// Pixels of a picture; y counts from the top.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Area&) const = default;
};

// Every `step`-th pixel of a picture across and down: those whose x and y (from the top) leave these remainders.
struct Lattice {
    int step = 1, x = 0, y = 0;
    bool operator==(const Lattice&) const = default;
};

struct FrameRequest {
    int width = 640, height = 360;  // px, of the whole picture
    float time = 0;                 // s
    Eye eye = Eye::centre;
    float interaxial = 0.065f;                        // m
    float convergence = 5.0f;                         // m, along the view axis
    bool toe_in = false;                              // the eyes turn to that point, else off-axis
    std::optional<ViewCamera> camera = std::nullopt;  // else the scene's camera node
    std::optional<Slice> slice = std::nullopt;  // shows the field on a plane instead; eyes and camera do not count
    std::optional<Area> part = std::nullopt;    // of the picture, that alone is drawn: frames have its size
    Lattice lattice;                            // of the part's pixels, those alone are drawn: frames have their number
    // One of a pixel's samples (renderer/samples.h).
    glm::vec2 offset{0};  // px from the pixel's centre, y up
    glm::vec2 lens{0};    // where its ray crosses the camera's lens, in the unit disk; each pixel turns it
    bool layers = false;  // a second shader, compiled when first asked for
    bool counts = false;  // too: how often the field was evaluated; the CPU device always tells
    bool sky = true;  // where edges share pixels: it shows behind them, else nothing does and a backdrop is laid there

    bool operator==(const FrameRequest&) const = default;
};

Area drawn_area(const FrameRequest& request);  // the part of the picture, or all of it

// The pixels that a request draws: the first one in the picture, y from the top, how far the next ones are, and how many.
struct DrawnPixels {
    int x, y, step, width, height;
};
DrawnPixels drawn_pixels(const FrameRequest& request);

// What the colour is made of and how it was found, by pixel like a frame's rows. In linear Rec.709
//   colour = ambient + diffuse + specular + reflection + emission,
// each as it reaches the eye: shadowed, occluded and behind the fog (docs/layers.md).
struct Layers {
    explicit Layers(std::size_t pixels);
    glm::vec3 colour(std::size_t pixel) const;  // the sum

    std::vector<glm::vec3> ambient;         // the sky's light
    std::vector<glm::vec3> diffuse;         // the lights', scattered
    std::vector<glm::vec3> specular;        // the lights', mirrored: highlights
    std::vector<glm::vec3> reflection;      // what further rays bring, mirrored or through glass
    std::vector<glm::vec3> emission;        // the surface's own, the fog's, and the sky where nothing was hit
    std::vector<glm::vec3> albedo;          // of the material; 0 on a miss
    std::vector<glm::vec3> position;        // world space, m; 0 on a miss
    std::vector<float> shadow;              // mean visibility of the lights that cast shadows, 0 to 1; 1 on a miss
    std::vector<float> occlusion;           // 1 where nothing occludes, and on a miss
    std::vector<float> gradient_length;     // of the field at the hit, 1 of a true distance; 0 on a miss
    std::vector<float> minimum_cone_ratio;  // smallest distance / way of the eye ray: how near it passed to something
    std::vector<int> shadow_steps;          // of all shadow rays that start at the hit
};

// Sample 0 of each pixel; of a picture of several samples the colour, and the layers it is made of, are their mean. Row 0
// is the top. All rows have width * height elements.
struct Frame {
    Frame() = default;
    Frame(int width, int height, bool with_layers = false);

    int width = 0, height = 0;
    std::vector<glm::vec3> colour;          // linear Rec.709, before tone mapping
    std::vector<float> depth;               // m along the view axis; +inf where nothing was hit
    std::vector<glm::vec3> normal;          // world space; 0 on a miss
    std::vector<int> node_id, material_id;  // 0 on a miss, and where the program was lowered without ids
    std::vector<int> steps;                 // of the eye ray
    std::vector<unsigned char> exhausted;   // 1 where the step budget or limit ran out
    // Share of the pixel in which something was hit, where edges share pixels; empty: 0 on a miss, else 1.
    std::vector<float> covered;
    // Share of the pixel that is opaque; empty: all of it is. Where it is less than 1, colours are multiplied by it.
    std::vector<float> alpha;
    std::optional<Layers> layers;  // when the request asked for them
    std::int64_t evaluations = 0;  // of the field, by all rays together; 0 of a slice, and of what was not counted
};

using Progress = std::function<void(float fraction)>;

// What one who draws may hear and say on the way. The CPU device calls `part_drawn` and `cancelled` from all of its
// threads at once.
struct Watch {
    Progress progress;
    std::function<void(const Frame& frame, const Area& area)> part_drawn;  // other pixels may be in the making
    std::function<bool()> cancelled;                                       // asked between strips, and within tiles

    bool stops() const { return cancelled && cancelled(); }
};

}  // namespace fieldwright::renderer
