// Pictures to textures, pixels to nodes.
#include "app/shown_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace fieldwright::app {

void ShownPicture::show(std::shared_ptr<const renderer::Picture> picture, std::shared_ptr<const renderer::Frame> frame,
                        bool of_slice)
{
    if (!texture_) texture_.emplace();
    picture_ = std::move(picture);
    frame_ = std::move(frame);
    of_rays_ = of_slice ? nullptr : frame_;
    depth_range_known_ = false;
    size_ = {picture_->width, picture_->height};
    glBindTexture(GL_TEXTURE_2D, texture_->name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (texture_size_ != size_) {
        texture_size_ = size_;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, size_.x, size_.y, 0, GL_RGB, GL_UNSIGNED_BYTE, picture_->rgb.data());
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
        for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        return;
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.x, size_.y, GL_RGB, GL_UNSIGNED_BYTE, picture_->rgb.data());
}

ImTextureID ShownPicture::texture() const
{
    if (!texture_ || size_.x == 0) return nullptr;
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture_->name()));
}

std::optional<std::size_t> ShownPicture::pixel(int x, int y) const
{
    if (!frame_ || x < 0 || y < 0 || x >= size_.x || y >= size_.y) return std::nullopt;
    // Two eyes beside each other make the picture twice as wide as the frame is, below each other twice as high.
    int across = size_.x * frame_->height > 3 * size_.y * frame_->width / 2 ? 2 : 1;
    int down = size_.y * frame_->width > 3 * size_.x * frame_->height / 2 ? 2 : 1;
    int frame_x = across * x * frame_->width / size_.x % frame_->width;
    int frame_y = down * y * frame_->height / size_.y % frame_->height;
    return static_cast<std::size_t>(frame_y) * static_cast<std::size_t>(frame_->width) +
           static_cast<std::size_t>(frame_x);
}

graph::NodeId ShownPicture::node_at(int x, int y) const
{
    auto at = pixel(x, y);
    return {at ? frame_->node_id[*at] : 0};
}

std::optional<float> ShownPicture::depth_at(int x, int y) const
{
    auto at = pixel(x, y);
    if (!at || !std::isfinite(frame_->depth[*at])) return std::nullopt;
    return frame_->depth[*at];
}

// Without the last hundredth on either side: a blade of grass before the lens is not what is looked at.
std::optional<ui::DepthRange> ShownPicture::depth_range() const
{
    if (std::exchange(depth_range_known_, true)) return depth_range_;
    depth_range_.reset();
    if (!of_rays_) return depth_range_;
    std::vector<float> depths;
    std::copy_if(of_rays_->depth.begin(), of_rays_->depth.end(), std::back_inserter(depths),
                 [](float depth) { return std::isfinite(depth); });
    if (depths.empty()) return depth_range_;
    auto at = [&](std::size_t index) {
        auto nth = depths.begin() + static_cast<std::ptrdiff_t>(index);
        std::nth_element(depths.begin(), nth, depths.end());
        return *nth;
    };
    std::size_t left_out = depths.size() / 100;
    return depth_range_ = ui::DepthRange{at(left_out), at(depths.size() - 1 - left_out)};
}

}  // namespace fieldwright::app
