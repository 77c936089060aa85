// From buffers to a picture: views, stereo, sRGB, files.
#pragma once

#include "renderer/colour_map.h"
#include "renderer/look.h"
#include "renderer/stereo.h"
#include "renderer/view.h"

#include <filesystem>
#include <string_view>

namespace fieldwright::renderer {

// What a picture shows of its frames, and how.
struct Display {
    View view = View::beauty;
    Look look;             // of beauty
    glm::ivec2 origin{0};  // px, of the frames in the whole picture of which they are a part
    Stereo stereo = Stereo::off;
    StereoSpace stereo_space = StereoSpace::linear;
    bool swap_eyes = false;
    float split = 0;       // of an anaglyph: this share of its width, from the left, is the naive one
    bool rivalry = false;  // of an anaglyph: stripes where the eyes fight
    ColourMap colour_map = ColourMap::viridis;
    int full_scale = 0;  // steps at the colour map's end; 0 = the step limit
    bool operator==(const Display&) const = default;
};
// The number at the end of the display's colour map: of steps, or of what its view has on its scale.
float scale_end(const Display& display, int step_limit);

// 8-bit sRGB, top-down, 3 bytes a pixel.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
    std::vector<unsigned char> alpha = {};  // one byte a pixel, not multiplied into the colours; empty: all opaque
};
Picture blank_picture(glm::ivec2 size_px);
// Every pixel as a square of so many.
Picture enlarged(const Picture& picture, int times);

// Frames as 8-bit pixels. Threads share it.
class PictureEncoder {
public:
    PictureEncoder(const Display& display, int step_limit);
    // Of the picture of frames of a size: eyes beside or below each other make it larger.
    glm::ivec2 size_px(glm::ivec2 frame_size_px) const;
    // Encodes an area of the frames. The picture is of that size; only stereo reads `right`.
    void encode(Picture& picture, const Area& area, const Frame& left, const Frame& right) const;

private:
    struct Scratch;
    struct Run;
    void encode_run(const Run& run, Scratch& scratch) const;
    void show(Rows& shown, const Frame& frame, std::size_t first, int count, Scratch& scratch) const;
    void show_beauty(Rows& shown, const Frame& frame, std::size_t first, int count, Scratch& scratch) const;
    void show_heat(Rows& shown, const Frame& frame, const ViewSource& source, std::size_t first, int count) const;
    void add_glow(Rows& shown, const Frame& frame, std::size_t first, int count) const;
    void mix(const EyeMix& mix, unsigned char* rgb, int count, Scratch& scratch) const;
    void mark_fights(const Run& run, Stereo stereo, const Rows& left) const;
    int divider(const Frame& frame) const;  // px from the left

    Display display_;
    float step_scale_, heat_scale_;  // steps, and what is shown of them or others, at the end of the scale
    RowFunction show_;
    LookFunction look_;
};

// The display's own size; `right` is read by stereo only.
Picture picture(const Frame& left, const Frame& right, const Display& display, int step_limit);
Picture picture(const Frame& frame, View view, int step_limit, const Look& look = {});
// Share of the pixels over whose colour the eyes fight, by a sample of them.
double fighting_share(const Frame& frame, Stereo stereo, StereoSpace space);

// PNG through OpenImageIO; temporary file + rename; same pixels, same bytes. Failure{5}.
void write_png(const std::filesystem::path& path, const Picture& picture);
Picture read_png(const std::filesystem::path& path);  // Failure{3}

}  // namespace fieldwright::renderer
