// The two machines that draw a program: the same text on both.
#pragma once

#include "renderer/frame.h"

#include <memory>
#include <string>

namespace fieldwright::renderer {

// All cores, 256 probes at a time. Throws graph::Failure{1} when a node is not compiled into this program.
Frame render_on_cpu(const graph::Program& program, const FrameRequest& request, const Progress& progress = {});
// Whether the program and the shading library are those that the CPU's kernels were compiled from.
bool runs_on_cpu(const graph::Program& program);
// Draws over the frame, which has the size of the request's part, tile by tile; false when the watch cancelled it.
bool draw_on_cpu(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch);

// The driver reset the GPU: the device is of no more use, a new one may be.
struct ContextLost : graph::Failure {
    using Failure::Failure;
};

// OpenGL on EGL surfaceless, no window. Owns its context; use from the thread that made it.
class GpuDevice {
public:
    GpuDevice();  // throws graph::Failure{4} when there is no usable GL 3.3
    ~GpuDevice();
    GpuDevice(GpuDevice&&) noexcept;

    std::string renderer_name() const;  // GL_RENDERER
    bool software() const;              // llvmpipe, softpipe, swrast
    // Compiles when the text changed (else only uploads values), draws in strips of <= 15 ms. Failure{6} on GLSL errors.
    Frame render(const graph::Program& program, const FrameRequest& request, const Progress& progress = {});
    // Draws over the frame, which has the size of the request's part, from the top; false when the watch cancelled it.
    bool draw(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch);
    // The shader that would draw the program, and whether it is linked: of the last few texts, so that undo is at once.
    std::string shader_text(const graph::Program& program, const FrameRequest& request) const;
    bool linked(const std::string& text) const;
    // Links it and draws one pixel, since drivers finish compiling at the first draw. Blocks; Failure{6} on GLSL errors.
    void link(const std::string& text, bool layers = false);
    // Distances of the distance entry at points, by the same text (tests and `eval --device gpu`).
    std::vector<float> distances(const graph::Program& program, float time, const std::vector<glm::vec3>& points);
    // Number of program links so far.
    int links() const;
    // Compiles a complete fragment shader and draws one pixel; seconds until that pixel is there. Failure{6} on errors.
    double ready_seconds(const std::string& fragment_shader);

private:
    bool draw_slice(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch);

    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fieldwright::renderer
