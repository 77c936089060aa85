// Which picture the window wants, and what comes back of it.
#include "app/shown_display.h"
#include "app/workbench.h"

#include <algorithm>

namespace fieldwright::app {
namespace {

constexpr double settling_s = 0.15;  // a hand this long at rest gets a picture in full

renderer::ViewCamera renderer_camera(const ui::ViewCamera& camera)
{
    return {.position = camera.drawn_from(),
            .target = camera.pivot,
            .up = camera.up(),
            .field_of_view_rad = camera.field_of_view_rad,
            .orthographic_height = camera.orthographic ? camera.height_at_pivot() : 0};
}

bool same_picture(const renderer::PictureRequest& a, const renderer::PictureRequest& b)
{
    return a.program == b.program && a.frame == b.frame && a.display == b.display && a.exposure == b.exposure;
}

}  // namespace

// Whether there was one.
bool Workbench::take_result()
{
    std::optional<renderer::RenderResult> result = render_thread_.poll();
    if (!result) return false;
    frames_owed_ = std::max(frames_owed_, 2);  // the second for what follows from the first: a statistic, a legend
    ui::PictureReading& reading = readings_.picture;
    if (auto* drawn = std::get_if<renderer::DrawnPicture>(&*result)) {
        picture_.show(drawn->picture, drawn->frame, drawn->of_slice);
        shown_generation_ = drawn->generation;
        if (awaited_generation_ && shown_generation_ >= awaited_generation_) awaited_generation_ = 0, hurried_ = true;
        reading.full = drawn->final;
        reading.samples = drawn->samples;
        reading.draw_ms = static_cast<float>(drawn->ms);
        reading.mean_steps = static_cast<float>(drawn->steps.mean);
        reading.p99_steps = drawn->steps.p99;
        reading.max_steps = drawn->steps.largest;
        reading.fighting_share = drawn->fighting_share;
        reading.evaluations = static_cast<double>(drawn->steps.evaluations);
        reading.exhausted_share = static_cast<float>(drawn->steps.exhausted);
        drawn_ = std::move(*drawn);
        write_export();
    } else if (auto* failed = std::get_if<renderer::CompileFailed>(&*result)) {
        compile_error_ = failed->log;
        refused_generation_ = failed->generation;
    } else if (auto* broken = std::get_if<renderer::Failed>(&*result)) {
        say(broken->sentence, true);
    }
    return true;
}

// Once a newer picture is drawn and nobody complained again.
void Workbench::forget_refusal()
{
    if (compile_error_.empty() || requested_->generation == refused_generation_ || render_thread_.status().busy) return;
    compile_error_.clear();
    touch();
}

// In full, and with all of its samples.
bool Workbench::picture_finished() const
{
    const ui::PictureReading& picture = readings_.picture;
    return picture.full && picture.samples >= picture.samples_wanted && shown_generation_ == asked_generation();
}

// Layers that are drawn already stay as long as the picture does: without them it would be drawn anew.
void Workbench::keep_layers(renderer::PictureRequest& request) const
{
    if (!requested_ || request.frame.layers || !requested_->frame.layers) return;
    request.frame.layers = true;
    request.frame.layers = same_picture(*requested_, request);
}

// Whether another scene is asked for, by a hand that is done.
bool Workbench::request_picture(bool hands_moving)
{
    renderer::PictureRequest request = wanted_picture();
    keep_layers(request);
    if (request.frame.width < 8 || request.frame.height < 8) return false;
    if (!requested_ || !same_picture(*requested_, request)) last_change_s_ = now_s();
    // A hand that holds still, or types, waits for the whole picture.
    request.interacting = editor_.view.playing || (hands_moving && now_s() - last_change_s_ < settling_s);
    if (requested_ && same_picture(*requested_, request) && requested_->interacting == request.interacting)
        return false;
    bool edited = !request.interacting && (!requested_ || requested_->program != request.program);
    request.generation = requested_ ? requested_->generation + 1 : 1;
    requested_ = request;
    readings_.picture.samples_wanted = renderer::wanted_samples(request);
    render_thread_.request(request);
    return edited;
}

renderer::PictureRequest Workbench::wanted_picture() const
{
    const ui::ViewState& view = editor_.view;
    renderer::PictureRequest request;
    request.program = scene_.program();
    request.frame.time = static_cast<float>(view.time_s);
    if (!view.through_camera || !scene_.has_camera()) request.frame.camera = renderer_camera(view.camera);
    const graph::PictureSettings& settings = session_.document().picture;
    request.exposure = renderer::exposure_of(settings);
    request.exposure.checkered = true;
    request.display.look = renderer::look_of(settings);
    set_display(request, view, readings_, editor_.viewport_size_px());
    if (export_) export_->prepare(request);
    return request;
}

}  // namespace fieldwright::app
