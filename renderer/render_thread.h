// Draws the newest request of a window on threads of its own: coarse at once, then finer, then with more samples, then
// idle.
//
// Two threads of low priority: one draws on all cores, one owns a GL context of its own, compiles and draws.
// On software GL a changed value is a new text, so there the CPU shows pictures while values change.
#pragma once

#include "renderer/picture.h"
#include "renderer/samples.h"

#include <cstdint>
#include <memory>
#include <variant>

namespace fieldwright::renderer {

enum class Device { automatic, gpu, cpu };

struct PictureRequest {
    std::shared_ptr<const graph::Program> program;
    FrameRequest frame;  // its eye counts only without stereo
    Display display;
    Exposure exposure;  // further samples are added once the picture of the first ones is there
    // A hand moves something: coarse pictures only, and no links on software GL. When it rests, ask again without.
    bool interacting = false;
    std::uint64_t generation = 0;  // the window's; comes back with the results
};

// Both eyes are drawn.
inline bool is_stereo(const PictureRequest& request) { return request.display.stereo != Stereo::off; }
// Of a pixel, in the end: only beauty has more than one, and nothing has while a hand moves something.
int wanted_samples(const PictureRequest& request);

struct StepStatistics {
    double mean = 0;
    int p99 = 0;  // 99 of 100 rays take at most so many
    int largest = 0;
    std::int64_t evaluations = 0;  // of the field, by all rays; 0 of a slice, and of what was not counted
    double exhausted = 0;          // share of pixels that ran out of steps
};

struct DrawnPicture {
    // Where parts of a finer picture are still missing, the coarser one shows, scaled up.
    std::shared_ptr<const Picture> picture;
    // Buffers of the last complete drawing, left eye or only one: as large as the picture or smaller.
    std::shared_ptr<const Frame> frame, right_frame;  // right_frame: of stereo, else null
    int divisor = 1;     // of the request's size: width and height are divided by it in `frame`
    bool final = false;  // complete and of the request's size: only further samples follow
    int samples = 1;     // of a pixel, in the picture and in its frames' colours
    std::uint64_t generation = 0;
    double ms = 0;                // drawing it took
    Device device = Device::cpu;  // that drew it, or is drawing over the one that did
    bool of_slice = false;        // its frame holds distances, not depths
    StepStatistics steps;
    std::optional<double> fighting_share;  // of pixels over whose colour the eyes fight; nothing unless both are mixed
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
    bool busy = false;       // something is drawn or compiled
    bool compiling = false;  // a shader
    std::string gpu;         // GL_RENDERER; empty when there is none (yet)
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
