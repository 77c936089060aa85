// Frames and pictures of the render thread as files.
#include "app/picture_export.h"

#include "ui/picture_formats.h"

namespace fieldwright::app {
namespace {

using renderer::Frame;
using renderer::PictureFormat;

PictureFormat format_of(const std::filesystem::path& path)
{
    std::optional<PictureFormat> format = renderer::picture_format(path);
    if (!format) throw graph::Failure(2, ui::picture_name_error(path.filename().string()));
    return *format;
}

// With the share of hits as alpha; accumulated frames have it already.
Frame with_holes(const Frame& drawn, const renderer::Exposure& exposure)
{
    Frame frame = drawn;
    bool has_holes = exposure.backdrop == graph::Backdrop::transparent && !exposure.checkered;
    if (!has_holes || !frame.alpha.empty()) return frame;
    renderer::Accumulator one;
    one.add(drawn, exposure);
    one.resolve(frame, exposure);
    return frame;
}

}  // namespace

PictureExport::PictureExport(std::filesystem::path path)
    : path_(path.replace_filename(ui::complete_picture_name(path.filename().string()))), format_(format_of(path_))
{
}

bool PictureExport::of_light() const { return format_ == PictureFormat::hdr || format_ == PictureFormat::exr; }

std::string PictureExport::refusal(const renderer::Display& display) const
{
    if (of_light() && display.view != renderer::View::beauty)
        return "HDR and EXR hold the light itself: show the view Beauty, or save what is shown as PNG or JPEG";
    if (format_ == PictureFormat::hdr && display.stereo != renderer::Stereo::off)
        return "HDR holds one eye: turn stereo off, or save both as PNG, JPEG or EXR";
    return {};
}

bool PictureExport::keeps_holes(const renderer::PictureRequest& request) const
{
    bool has_alpha = of_light() || (format_ == PictureFormat::png && !is_stereo(request));
    return has_alpha && request.exposure.backdrop == graph::Backdrop::transparent;
}

void PictureExport::prepare(renderer::PictureRequest& request) const
{
    if (format_ == PictureFormat::exr) request.frame.layers = true;
    if (keeps_holes(request)) request.exposure.checkered = false;
}

bool PictureExport::suits(const renderer::PictureRequest& request) const
{
    bool has_layers = format_ != PictureFormat::exr || request.frame.layers;
    return has_layers && !(keeps_holes(request) && request.exposure.checkered);
}

void PictureExport::write(const renderer::DrawnPicture& drawn, const renderer::PictureRequest& request) const
{
    Frame left = with_holes(*drawn.frame, request.exposure);
    Frame right = drawn.right_frame ? with_holes(*drawn.right_frame, request.exposure) : Frame();
    renderer::FileNotes notes{.width = left.width, .height = left.height, .samples = drawn.samples};
    notes.part = {0, 0, left.width, left.height};
    const Frame* eyes[] = {&left, &right};
    switch (format_) {
        case PictureFormat::png:
            if (!left.alpha.empty())
                return write_picture(
                    path_, renderer::picture(left, left, request.display, request.program->march.step_limit), notes);
            [[fallthrough]];
        case PictureFormat::jpeg: return write_picture(path_, *drawn.picture, notes);
        case PictureFormat::hdr: return write_hdr(path_, left);
        case PictureFormat::exr:
            return write_exr(path_, std::span<const Frame* const>(eyes, drawn.right_frame ? 2 : 1), notes);
    }
}

}  // namespace fieldwright::app
