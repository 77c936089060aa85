// Samples, eyes and files of one picture after the other.
#include "app/picture_maker.h"

#include "app/contact_sheet.h"
#include "app/frame_numbers.h"
#include "graph/scene_file.h"

#include <utility>

namespace fieldwright::app {
namespace {

using renderer::Area;
using renderer::Eye;
using renderer::Frame;
using renderer::PictureFormat;

// The device that `--device` means for this program; none = the CPU. `auto` must not depend on timing.
std::optional<renderer::GpuDevice> choose_gpu(const std::string& device, const graph::Program& program)
{
    bool by_cpu = renderer::runs_on_cpu(program);
    if (device == "cpu" && !by_cpu && !program.gpu_only)
        throw graph::Failure(
            1,
            "the shading of --shaders (render/*.glsl) is not the one compiled into this program, so only "
            "a GPU can draw with it; use --device gpu, or build the program with these shaders");
    if (device == "cpu") return std::nullopt;
    if (device == "gpu" || !by_cpu) return renderer::GpuDevice();
    try {
        renderer::GpuDevice gpu;
        if (!gpu.software()) return gpu;
    } catch (const graph::Failure& failure) {
        if (failure.exit_code != 4) throw;  // no GL: the CPU draws
    }
    return std::nullopt;
}

}  // namespace

PictureMaker::PictureMaker(const RenderArguments& arguments, const graph::Document& document,
                           const graph::Program& program, std::size_t picture_count)
    : arguments_(arguments),
      document_(document),
      program_(program),
      gpu_(choose_gpu(arguments.device, program)),
      exposure_(renderer::exposure_of(document.picture)),
      display_(display_of(arguments.display)),
      line_(!arguments.quiet)
{
    std::tie(request_.width, request_.height) = parsed_size(arguments.size);
    display_.look = renderer::look_of(document.picture);
    if (!arguments.tile.empty()) request_.part = tile_from_text(arguments.tile, request_.width, request_.height);
    set_request(request_, arguments.display);
    Area part = drawn_area(request_);
    display_.origin = {part.x, part.y};
    request_.layers = request_.layers || arguments.sheet || arguments.format() == PictureFormat::exr;
    exposure_.grid = arguments.grid;
    request_.sky = renderer::shows_sky(exposure_);
    bool of_samples = kind_of(display_.view).mean || arguments.sheet;
    samples_ = of_samples ? renderer::sample_count(exposure_) : 1;
    if (arguments.keep_scene) scene_ = graph::write_scene(document, *program.library);
    double eyes = arguments.has_stereo() ? 2 : 1, of_picture = samples_ + (arguments.grid > 0 ? 1 : 0);
    drawings_in_all_ = std::max(1.0, static_cast<double>(picture_count) * eyes * of_picture);
}

void PictureMaker::make(const std::filesystem::path& path, float time)
{
    if (!arguments_.has_stereo()) return write(path, eye(Eye::centre, time), nullptr);
    Frame left = eye(Eye::left, time), right = eye(Eye::right, time);
    write(path, left, &right);
}

void PictureMaker::finish(const std::string& what) { line_.finish(what + " on " + device_name()); }

Frame PictureMaker::draw(const renderer::FrameRequest& picture, const renderer::Exposure& exposure, int sample)
{
    const Area area = drawn_area(picture);
    Frame frame(area.width, area.height, picture.layers);
    double pixels = std::max(1.0, static_cast<double>(area.width) * area.height);
    draw_sample(frame, picture, exposure, sample, [&](Frame& to, const renderer::FrameRequest& request) {
        double part = static_cast<double>(to.width) * to.height / pixels;
        auto progress = [&](float share) {
            line_.show(static_cast<float>((drawings_ + share * part) / drawings_in_all_));
        };
        bool drawn = gpu_ ? gpu_->draw(to, program_, request, {.progress = progress})
                          : draw_on_cpu(to, program_, request, {.progress = progress});
        drawings_ += part;
        return drawn;
    });
    lay_backdrop(frame, {0, 0, frame.width, frame.height}, exposure_, area);
    return frame;
}

// The middle sample with the light of all of them.
Frame PictureMaker::eye(Eye which, float time)
{
    renderer::FrameRequest picture = request_;
    picture.eye = which;
    picture.time = time;
    Frame first = draw(picture, {}, 0);
    renderer::Accumulator sums;
    bool on_grid = exposure_.grid > 0 && samples_ > 1;
    if (!on_grid) sums.add(first, exposure_);
    while (sums.count() < samples_) sums.add(draw(picture, exposure_, sums.count()), exposure_);
    sums.resolve(first, exposure_);
    return first;
}

void PictureMaker::write(const std::filesystem::path& path, const Frame& left, const Frame* right) const
{
    int step_limit = program_.march.step_limit;
    if (arguments_.format() == PictureFormat::hdr) return write_hdr(path, left);
    if (arguments_.format() == PictureFormat::exr) {
        const Frame* eyes[] = {&left, right};
        if (right && display_.swap_eyes) std::swap(eyes[0], eyes[1]);
        return write_exr(path, std::span<const Frame* const>(eyes, right ? 2 : 1), notes());
    }
    renderer::Picture drawn = arguments_.sheet ? contact_sheet(left, step_limit, display_)
                                               : picture(left, right ? *right : left, display_, step_limit);
    write_picture(path, enlarged(drawn, arguments_.enlarge), notes());
}

renderer::FileNotes PictureMaker::notes() const
{
    renderer::FileNotes notes;
    notes.width = request_.width;
    notes.height = request_.height;
    notes.part = drawn_area(request_);
    notes.samples = samples_;
    if (!arguments_.frames.empty()) notes.frames_per_second = document_.animation.frames_per_second;
    notes.scene = scene_;
    return notes;
}

}  // namespace fieldwright::app
