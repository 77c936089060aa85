// The viewport's newest picture: a texture of the window's context, and the buffers that picking reads.
#pragma once

#include "renderer/frame.h"
#include "renderer/gl_handles.h"
#include "renderer/picture.h"
#include "ui/readings.h"

#include <memory>
#include <optional>

namespace fieldwright::app {

class ShownPicture {
public:
    // Uploads it. `frame` holds its ids and depths; it may be smaller than the picture, or null.
    // A picture larger than the frame's shape shows it again beside or below itself, for another eye.
    void show(std::shared_ptr<const renderer::Picture> picture, std::shared_ptr<const renderer::Frame> frame,
              bool of_slice = false);
    // The newest frame; null while there is none, and when it shows a slice.
    const std::shared_ptr<const renderer::Frame>& of_rays() const { return of_rays_; }
    const std::shared_ptr<const renderer::Picture>& picture() const { return picture_; }  // null while there is none

    ImTextureID texture() const;  // null while there is none
    glm::ivec2 size() const { return size_; }
    // At a pixel of the picture, top-left origin.
    graph::NodeId node_at(int x, int y) const;
    std::optional<float> depth_at(int x, int y) const;  // m along the view axis; nothing on a miss
    std::optional<ui::DepthRange> depth_range() const;  // of what is seen

private:
    std::optional<std::size_t> pixel(int x, int y) const;

    std::optional<renderer::Texture> texture_;  // made at the first picture, when the window's context is current
    glm::ivec2 size_{0, 0}, texture_size_{0, 0};
    std::shared_ptr<const renderer::Picture> picture_;
    std::shared_ptr<const renderer::Frame> frame_, of_rays_;
    mutable std::optional<ui::DepthRange> depth_range_;  // of `frame_`
    mutable bool depth_range_known_ = false;
};

}  // namespace fieldwright::app
