// Drawing and finding the six balls.
#include "ui/axis_gizmo.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr float reach_px = 30, ball_px = 9, margin_px = 14;  // design px
constexpr const char *letters[] = {"X", "Y", "Z"}, *names[] = {"x", "y", "z"};

ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }

}  // namespace

void AxisGizmo::place(glm::vec2 centre, const ViewCamera& eye, const Theme& theme)
{
    centre_ = centre;
    radius_ = theme.px(reach_px + margin_px);
    ball_radius_ = theme.px(ball_px);
    balls_.clear();
    for (int axis = 0; axis < 3; ++axis)
        for (int sign : {1, -1}) {
            float way = static_cast<float>(sign) * theme.px(reach_px);
            glm::vec2 at = centre + way * glm::vec2(eye.right()[axis], -eye.up()[axis]);
            balls_.push_back({{axis, sign}, at, static_cast<float>(sign) * eye.backward()[axis]});
        }
    std::stable_sort(balls_.begin(), balls_.end(),
                     [](const Ball& a, const Ball& b) { return a.nearness < b.nearness; });
}

bool AxisGizmo::contains(glm::vec2 at) const { return glm::distance(at, centre_) <= radius_; }

std::optional<Side> AxisGizmo::side_at(glm::vec2 at) const
{
    for (auto ball = balls_.rbegin(); ball != balls_.rend(); ++ball)
        if (glm::distance(at, ball->at) <= 1.2f * ball_radius_) return ball->side;
    return std::nullopt;
}

void AxisGizmo::draw(ImDrawList& list, glm::vec2 mouse, bool hot, FrameContext& frame) const
{
    list.AddCircleFilled(im(centre_), radius_, colour::with_alpha(colour::window, hot ? 0.62f : 0.38f), 48);
    std::optional<Side> under_mouse = hot ? side_at(mouse) : std::nullopt;
    for (const Ball& ball : balls_) {
        draw_ball(list, ball, under_mouse == ball.side, frame.theme);
        glm::vec2 half(ball_radius_);
        std::string name = std::string("viewport/axis/") + (ball.side.sign < 0 ? "-" : "") + names[ball.side.axis];
        frame.rects.mark(name, {ball.at - half, ball.at + half});
    }
}

void AxisGizmo::draw_ball(ImDrawList& list, const Ball& ball, bool hot, const Theme& theme) const
{
    float brightness = 0.78f + 0.22f * ball.nearness;  // what points away steps back
    ImU32 base = colour::axes[ball.side.axis], ink = colour::with_alpha(hot ? colour::hot : base, brightness);
    if (ball.side.sign < 0) {
        list.AddCircleFilled(im(ball.at), 0.8f * ball_radius_, colour::with_alpha(colour::window, 0.7f), 24);
        list.AddCircle(im(ball.at), 0.8f * ball_radius_, ink, 24, theme.px(1.5f));
        return;
    }
    list.AddLine(im(centre_), im(ball.at), ink, theme.px(2));
    list.AddCircleFilled(im(ball.at), ball_radius_, colour::window, 24);
    list.AddCircleFilled(im(ball.at), ball_radius_, ink, 24);
    const char* letter = letters[ball.side.axis];
    ImFont& font = *theme.fonts.small;
    ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, letter);
    ImVec2 at(std::round(ball.at.x - 0.5f * size.x), std::round(ball.at.y - 0.5f * size.y));
    list.AddText(&font, font.FontSize, at, colour::window, letter);
}

}  // namespace fieldwright::ui
