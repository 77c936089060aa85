// Draws the newest request of a window on threads of its own: coarse at once, then finer, then idle.
//
// Two threads of low priority: one draws on all cores, one owns a GL context of its own, compiles and draws.
// On software GL a changed value is a new text, so there the CPU shows pictures while values change.
#pragma once

#include "renderer/picture.h"

#include <cstdint>
#include <memory>
#include <variant>

namespace fieldwright::renderer {

enum class Device { automatic, gpu, cpu };

struct PictureRequest {
    std::shared_ptr<const graph::Program> program;
    FrameRequest frame;  // its eye counts only without stereo
    View view = View::beauty;
    Stereo stereo = Stereo::off;
    // A hand moves something: coarse pictures only, and no links on software GL. When it rests, ask again without.
    bool interacting = false;
    std::uint64_t generation = 0;  // the window's; comes back with the results
};

struct StepStatistics {
    double mean = 0;
    int largest = 0;
    double exhausted = 0;  // share of pixels that ran out of steps
};

struct DrawnPicture {
    // Where parts of a finer picture are still missing, the coarser one shows, scaled up.
    std::shared_ptr<const Picture> picture;
    // Buffers of the last complete drawing, left eye or only one: as large as the picture or smaller.
    std::shared_ptr<const Frame> frame, right_frame;  // right_frame: of stereo, else null
    int divisor = 1;     // of the request's size: width and height are divided by it in `frame`
    bool final = false;  // complete and of the request's size: nothing follows
    std::uint64_t generation = 0;
    double ms = 0;            // drawing it took
    const char* device = "";  // "cpu", "gpu"
    StepStatistics steps;
};

// The driver refuses the shader; pictures of the CPU go on. Once per request.
struct CompileFailed {
    std::string log;
    std::uint64_t generation = 0;
};
// The GPU was reset. A new device follows, after two losses in two minutes none.
struct Lost {
    bool gives_up = false;
};
struct Failed {
    std::string sentence;
    std::uint64_t generation = 0;
};
using RenderResult = std::variant<DrawnPicture, CompileFailed, Lost, Failed>;

struct RenderStatus {
    bool busy = false;        // something is drawn or compiled
    bool compiling = false;   // a shader
    const char* device = "";  // which drew last: "cpu", "gpu"
    std::string gpu;          // GL_RENDERER; empty when there is none (yet)
    bool gpu_is_software = false;
    std::string no_gpu;                                 // why there is none
    int links = 0;                                      // programs linked so far
    double cpu_ns_per_pixel = 0, gpu_ns_per_pixel = 0;  // as measured last; 0 = not yet
};

struct RenderOptions {
    Device device = Device::automatic;
    std::function<void()> on_ready;  // called from the threads when there is something to poll
};

class RenderThread {
public:
    explicit RenderThread(RenderOptions options = {});
    ~RenderThread();  // stops what is drawn; waits for a compile in progress
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    void request(PictureRequest request);  // the newest wins; returns at once
    std::optional<RenderResult> poll();    // what is new since the last poll: reports first, then the newest picture
    // Returns when there is a report or a picture of that generation to poll, or the time is over.
    void wait(std::uint64_t generation, double seconds);
    void set_window_drawing(bool drawing);  // finer pictures pause meanwhile where both want the same cores
    RenderStatus status() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fieldwright::renderer
