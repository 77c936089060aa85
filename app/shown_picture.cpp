// Pictures to textures, pixels to nodes.
#include "app/shown_picture.h"

#include <cmath>
#include <cstdint>

namespace fieldwright::app {

void ShownPicture::show(std::shared_ptr<const renderer::Picture> picture, std::shared_ptr<const renderer::Frame> frame)
{
    if (!texture_) texture_.emplace();
    picture_ = std::move(picture);
    frame_ = std::move(frame);
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
    int frame_x = x * frame_->width / size_.x, frame_y = y * frame_->height / size_.y;
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

}  // namespace fieldwright::app
