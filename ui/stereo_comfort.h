// How strong the depth of a stereo picture is on the screen before which somebody sits, and how to keep it comfortable.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

struct Eyes {
    float interaxial = 0.065f, convergence = 5;  // m
};

// How wide the picture is in the scene.
struct SeenWidth {
    float per_metre = 0;  // of depth
    float parallel = 0;   // m, of a picture without perspective, which is equally wide everywhere; else 0
};

// Of the picture in the viewport; nothing when only the program knows its camera.
std::optional<SeenWidth> seen_width(const FrameContext& frame);

// What the right eye sees right of the left eye's place for it, as a share of the picture's width: positive behind the
// screen, negative in front of it. depth: m along the view axis.
float parallax_share(const Eyes& eyes, const SeenWidth& width, float depth);

// The same for somebody before a screen.
struct Parallax {
    float share = 0;
    float mm = 0;       // on the screen
    float degrees = 0;  // as an angle at the eye
};
Parallax parallax_on(const StereoView& screen, float share);

enum class Comfort { good, strong, painful };
// More than 2 % of the width is strong, more than 4 % painful; so is more behind the screen than eyes are apart.
Comfort comfort_of(const Parallax& parallax);

// Eyes that show the range with one percent in front of the screen and one behind it, no farther apart than a thirtieth
// of the way to the nearest thing, and so that no eye has to turn outwards.
Eyes comfortable_eyes(const DepthRange& range, const SeenWidth& width, const StereoView& screen);
void set_comfortable_eyes(FrameContext& frame);  // or refuses with the reason

}  // namespace fieldwright::ui
