// The viewport's picture as a file: what the format needs it to be drawn with, and writing it.
#pragma once

#include "renderer/picture_file.h"
#include "renderer/render_thread.h"

#include <filesystem>
#include <string>

namespace fieldwright::app {

class PictureExport {
public:
    // A name without an end becomes one of PNG. graph::Failure{2} when its end is no format's.
    explicit PictureExport(std::filesystem::path path);

    const std::filesystem::path& path() const { return path_; }
    // Why such a picture is not for the format, as a sentence; empty when it is.
    std::string refusal(const renderer::Display& display) const;
    // Asks for what the format holds beside what is shown: layers, and real holes instead of a checkerboard.
    void prepare(renderer::PictureRequest& request) const;
    bool suits(const renderer::PictureRequest& request) const;
    // `drawn` is the finished picture of a request that suits. graph::Failure{5}
    void write(const renderer::DrawnPicture& drawn, const renderer::PictureRequest& request) const;

private:
    bool of_light() const;
    bool keeps_holes(const renderer::PictureRequest& request) const;

    std::filesystem::path path_;
    renderer::PictureFormat format_;
};

}  // namespace fieldwright::app
