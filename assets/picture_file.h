// Picture files from anywhere as pixels: read by a worker, only in five formats, told by content.
#pragma once

#include "assets/worker.h"
#include "assets/worker_jobs.h"

#include <memory>
#include <vector>

namespace fieldwright::assets {

// What numbers the pixels are: as shown on a screen (sRGB curve, 0 to 1), or proportional to light (unbounded).
enum class PixelScale { shown, light };

struct Pixels {
    int width = 0, height = 0;
    std::vector<float> rgba;  // top-down; colour not multiplied by alpha; grey files repeat their grey
};

struct PictureQuestion {
    PixelScale scale = PixelScale::shown;
    int long_side = 0;  // larger pictures are averaged down to it, px; 0 = as large as they are
    bool operator==(const PictureQuestion&) const = default;
};

inline constexpr std::int64_t picture_bytes_limit = std::int64_t(256) << 20;  // of a file
inline constexpr int picture_side_limit = 16384;                              // px
inline constexpr std::int64_t picture_area_limit = std::int64_t(64) << 20;    // px
inline constexpr int pixels_side_limit = 4096;                                // px, of what comes back whole

// "png", "jpeg", "hdr", "openexr" or "tiff" by the first bytes; empty when it is none of them.
std::string_view picture_format(std::string_view bytes);

// The file's bytes. graph::Failure{3}: it is missing, no ordinary file, or too large; the reason follows the path.
std::string picture_bytes(const std::filesystem::path& path);

// A picture, or one sentence that begins with `subject`.
struct PictureAnswer {
    Ending ending = Ending::answered;
    Pixels pixels;
    std::string sentence;
    explicit operator bool() const { return ending == Ending::answered; }
};
PictureAnswer read_picture(const Worker& worker, const std::string& bytes, const std::string& subject,
                           const PictureQuestion& question, const std::stop_token& stop = {});

// The worker's job behind it.
inline constexpr std::string_view picture_job = "picture";
std::string decode_picture(const std::string& input);

}  // namespace fieldwright::assets
