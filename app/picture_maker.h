// Draws the pictures that `render` writes: all samples of both eyes, on one device.
#pragma once

#include "app/progress_line.h"
#include "app/render_arguments.h"
#include "renderer/devices.h"
#include "renderer/samples.h"

namespace fieldwright::app {

class PictureMaker {
public:
    // Failure{1, 4} when the device cannot draw the program.
    PictureMaker(const RenderArguments& arguments, const graph::Document& document, const graph::Program& program,
                 std::size_t picture_count);

    // Draws the moment and writes it. Failure{1, 5, 6}.
    void make(const std::filesystem::path& path, float time);
    void finish(const std::string& what);  // says so on stderr

    std::string device_name() const { return gpu_ ? gpu_->renderer_name() : "the CPU"; }
    int samples() const { return samples_; }

private:
    renderer::Frame draw(const renderer::FrameRequest& picture, const renderer::Exposure& exposure, int sample);
    renderer::Frame eye(renderer::Eye eye, float time);
    void write(const std::filesystem::path& path, const renderer::Frame& left, const renderer::Frame* right) const;
    renderer::FileNotes notes() const;

    const RenderArguments& arguments_;
    const graph::Document& document_;
    const graph::Program& program_;
    std::optional<renderer::GpuDevice> gpu_;
    renderer::FrameRequest request_;
    renderer::Exposure exposure_;
    renderer::Display display_;
    std::string scene_;  // JSON, when it is kept
    int samples_ = 1;
    ProgressLine line_;
    double drawings_ = 0, drawings_in_all_ = 1;
};

}  // namespace fieldwright::app
