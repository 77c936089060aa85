// Pictures and frames as files. A file appears whole or not at all; the same pixels are the same bytes.
#pragma once

#include "renderer/picture.h"

namespace fieldwright::renderer {

enum class PictureFormat { png, jpeg, hdr, exr };

// By the end of the name, in capitals or not: .png, .jpg, .jpeg, .hdr, .exr; nothing for others.
std::optional<PictureFormat> picture_format(const std::filesystem::path& path);

// What a file says beside its pixels, as far as its format has room.
struct FileNotes {
    int width = 0, height = 0;    // px, of the whole picture
    Area part;                    // of it, that is in the file
    int samples = 1;              // of a pixel
    float frames_per_second = 0;  // 0: of no animation
    std::string scene;            // as JSON; empty: not kept
};

// PNG (its text "fieldwright:graph" keeps the scene) or JPEG, of 8 bits. Failure{5}.
void write_picture(const std::filesystem::path& path, const Picture& picture, const FileNotes& notes);

// Radiance: the colours in linear light, before tone mapping. Failure{5}.
void write_hdr(const std::filesystem::path& path, const Frame& frame);

// OpenEXR, a layer for every buffer: R G B A (half), Z (depth along the view axis in metres, inf on a miss), N.X ...
// (world space), id.Y, material.Y, steps.Y (float); with the frame's layers P.X, albedo.R, ambient.R and the like. Colours are linear Rec.709 before tone mapping. Two frames are the
// parts `left` and `right`. The data window is the notes' part. Failure{5}.
void write_exr(const std::filesystem::path& path, std::span<const Frame* const> eyes, const FileNotes& notes);

}  // namespace fieldwright::renderer
