// What a device draws: one frame of buffers, top-down rows, and the request for it.
#pragma once

#include "graph/program.h"

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace fieldwright::renderer {

enum class Eye { centre, left, right };

float eye_side(Eye eye);                          // -1 left, 0 centre, 1 right
int shadow_count(const graph::Program& program);  // lights that cast shadows; they come first

// A viewport's own camera: moving it is not an edit, and links no program.
struct ViewCamera {
    glm::vec3 position{4, 3, 6}, target{0}, up{0, 1, 0};  // m; up: any direction that is not the view's
    float field_of_view_rad = 0.785398163f;               // vertical
    float orthographic_height = 0;                        // m, of what the picture shows; 0 = perspective
    bool operator==(const ViewCamera&) const = default;
};

struct FrameRequest {
    int width = 640, height = 360;  // px
    float time = 0;                 // s
    Eye eye = Eye::centre;
    float interaxial = 0.065f;                        // m
    float convergence = 5.0f;                         // m, along the view axis
    std::optional<ViewCamera> camera = std::nullopt;  // else the scene's camera node

    bool operator==(const FrameRequest&) const = default;
};

// Pixels of a picture; y counts from the top.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
};

// Sample 0 of each pixel. Row 0 is the top. All rows have width * height elements.
struct Frame {
    Frame() = default;
    Frame(int width, int height);

    int width = 0, height = 0;
    std::vector<glm::vec3> colour;          // linear Rec.709, before tone mapping
    std::vector<float> depth;               // m along the view axis; +inf where nothing was hit
    std::vector<glm::vec3> normal;          // world space; 0 on a miss
    std::vector<int> node_id, material_id;  // 0 on a miss, and where the program was lowered without ids
    std::vector<int> steps;                 // of the eye ray
    std::vector<unsigned char> exhausted;   // 1 where the step budget or limit ran out
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
