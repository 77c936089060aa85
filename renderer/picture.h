// From buffers to a picture: views, stereo, sRGB, files.
#pragma once

#include "renderer/frame.h"
#include "renderer/rows.h"

#include <filesystem>
#include <string_view>

namespace fieldwright::renderer {

enum class View { beauty, steps, normal, depth, id };
enum class Stereo { off, naive, dubois };

std::optional<View> view_from_name(std::string_view name);
std::optional<Stereo> stereo_from_name(std::string_view name);
const std::vector<std::string>& view_names();
const std::vector<std::string>& stereo_names();

// 8-bit sRGB, top-down, 3 bytes a pixel.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
};

// Frames as 8-bit pixels: one view of one eye, or an anaglyph of two. Threads share it.
class PictureEncoder {
public:
    PictureEncoder(View view, int step_limit, Stereo stereo = Stereo::off);
    // The picture and the frames are of one size. Only anaglyphs read `right`.
    void encode(Picture& picture, const Area& area, const Frame& left, const Frame& right) const;

private:
    struct Scratch;
    void show(Rows& shown, const Frame& frame, std::size_t first, int count, Scratch& scratch) const;
    void show_steps(Rows& shown, const Frame& frame, std::size_t first, int count) const;
    void fill_step_colours(int step_limit);

    View view_;
    Stereo stereo_;
    RowFunction show_, combine_;
    std::vector<glm::vec3> step_colours_;  // by number of steps, then the one of pixels that ran out of them
};

Picture picture(const Frame& frame, View view, int step_limit);
Picture anaglyph(const Frame& left, const Frame& right, View view, int step_limit, Stereo stereo);

// PNG through OpenImageIO; temporary file + rename; same pixels, same bytes. Failure{5}.
void write_png(const std::filesystem::path& path, const Picture& picture);
Picture read_png(const std::filesystem::path& path);  // Failure{3}

}  // namespace fieldwright::renderer
