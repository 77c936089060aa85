// Parallax and its limits.
#include "ui/stereo_comfort.h"

#include "ui/scene_camera.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float eyes_apart_mm = 63;
constexpr float budget = 0.01f;  // of the width, on either side of the screen
constexpr float nearest_by_interaxial = 30;
constexpr float strong = 0.02f, painful = 0.04f;

float width_at(const SeenWidth& width, float depth)
{
    return width.parallel > 0 ? width.parallel : width.per_metre * depth;
}

}  // namespace

std::optional<SeenWidth> seen_width(const FrameContext& frame)
{
    ViewCamera eye = frame.view.camera;
    std::optional<SceneCamera> camera = scene_camera(frame.draft.document);
    if (frame.view.through_camera && (camera || frame.readings.has_camera)) {
        if (!camera || camera->driven) return std::nullopt;
        eye = camera->eye;
    }
    const PictureReading& picture = frame.readings.picture;
    if (picture.height == 0) return std::nullopt;
    const StereoChoice* mode = find_choice(frame.readings.stereo_modes, frame.view.stereo);
    float aspect = static_cast<float>(picture.width) / static_cast<float>(picture.height);
    if (mode) aspect *= static_cast<float>(mode->down) / static_cast<float>(mode->across);
    if (eye.orthographic) return SeenWidth{.parallel = aspect * eye.height_at_pivot()};
    return SeenWidth{.per_metre = 2 * std::tan(0.5f * eye.field_of_view_rad) * aspect};
}

float parallax_share(const Eyes& eyes, const SeenWidth& width, float depth)
{
    float behind = depth - eyes.convergence;
    if (width.parallel > 0) return eyes.interaxial * behind / (eyes.convergence * width.parallel);
    return eyes.interaxial * behind / (depth * width_at(width, eyes.convergence));
}

Parallax parallax_on(const StereoView& screen, float share)
{
    float metres = share * screen.screen_width;
    return {share, 1000 * metres, glm::degrees(std::atan(metres / screen.viewing_distance))};
}

Comfort comfort_of(const Parallax& parallax)
{
    float size = std::abs(parallax.share);
    if (size > painful || parallax.mm > eyes_apart_mm) return Comfort::painful;
    return size > strong ? Comfort::strong : Comfort::good;
}

// Parallax is linear in 1/depth, or in depth without perspective: the screen goes to the middle of that.
Eyes comfortable_eyes(const DepthRange& range, const SeenWidth& width, const StereoView& screen)
{
    float near = std::max(range.near, 0.01f), far = std::max(range.far, 1.001f * near);
    Eyes eyes{1, width.parallel > 0 ? 0.5f * (near + far) : 2 * near * far / (near + far)};
    float behind = parallax_share(eyes, width, far);  // of eyes one metre apart
    float most_behind = std::min(budget, 0.001f * eyes_apart_mm / screen.screen_width);
    eyes.interaxial = std::min(most_behind / behind, near / nearest_by_interaxial);
    return eyes;
}

void set_comfortable_eyes(FrameContext& frame)
{
    std::optional<DepthRange> range = frame.readings.depth_range ? frame.readings.depth_range() : std::nullopt;
    std::optional<SeenWidth> width = seen_width(frame);
    if (!range || !width) {
        frame.draft.refusal = !width ? "the camera is moved by wires; set the eyes by hand, or leave the camera"
                                     : "the picture shows nothing but sky; turn to something first";
        return;
    }
    Eyes eyes = comfortable_eyes(*range, *width, frame.view.eyes);
    // To a tenth of a millimetre and a centimetre, as a hand would.
    frame.view.interaxial = std::max(std::round(eyes.interaxial * 1e4f) / 1e4f, 1e-4f);
    frame.view.convergence = std::max(std::round(eyes.convergence * 100) / 100, 0.01f);
}

}  // namespace fieldwright::ui
