// The viewport's eye: what a drag does to the picture.
#include "ui/view_camera.h"

#include "tests/support/scene.h"
#include "ui/scene_camera.h"

#include <gtest/gtest.h>

namespace fieldwright {
namespace {

using tests::Scene;
using ui::ViewCamera;

constexpr glm::vec2 size_px{800, 500};

void expect_near(glm::vec3 a, glm::vec3 b, float tolerance)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

void expect_near(glm::vec2 a, glm::vec2 b, float tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

ViewCamera eye_of(bool orthographic)
{
    ViewCamera eye;
    eye.pivot = {1, -2, 3};
    eye.yaw_rad = 2.1f;
    eye.pitch_rad = -0.7f;
    eye.orthographic = orthographic;
    return eye;
}

class BothProjections : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(ViewCamera, BothProjections, testing::Values(false, true),
                         [](const auto& made) { return std::string(made.param ? "orthographic" : "perspective"); });

TEST_P(BothProjections, a_ray_passes_the_point_it_is_projected_from)
{
    ViewCamera eye = eye_of(GetParam());
    for (glm::vec2 at : {glm::vec2{0, 0}, {400, 250}, {731, 88}, {799, 499}}) {
        ViewCamera::Ray ray = eye.ray(at, size_px);
        EXPECT_NEAR(glm::length(ray.direction), 1, 1e-5f);
        for (float way : {1.5f, 6.0f, 40.0f}) {
            auto back = eye.project(ray.origin + way * ray.direction, size_px);
            ASSERT_TRUE(back);
            expect_near(*back, at, 0.05f);
        }
    }
}

TEST_P(BothProjections, up_is_up_and_right_is_right)
{
    ViewCamera eye = eye_of(GetParam());
    auto centre = eye.project(eye.pivot, size_px);
    auto above = eye.project(eye.pivot + 0.1f * eye.up(), size_px);
    auto beside = eye.project(eye.pivot + 0.1f * eye.right(), size_px);
    ASSERT_TRUE(centre && above && beside);
    expect_near(*centre, 0.5f * size_px, 0.01f);
    EXPECT_LT(above->y, centre->y - 1);
    EXPECT_GT(beside->x, centre->x + 1);
    EXPECT_GT(eye.up().y, 0);
}

TEST_P(BothProjections, panning_keeps_the_pivots_plane_under_the_hand)
{
    ViewCamera eye = eye_of(GetParam());
    glm::vec3 held = eye.pivot + 0.7f * eye.right() - 0.4f * eye.up();
    auto before = eye.project(held, size_px);
    eye.pan({37, -21}, size_px.y);
    auto after = eye.project(held, size_px);
    ASSERT_TRUE(before && after);
    expect_near(*after - *before, {37, -21}, 0.01f);
}

TEST_P(BothProjections, orbiting_keeps_the_pivot_and_its_distance)
{
    ViewCamera eye = eye_of(GetParam());
    glm::vec3 before = eye.position();
    eye.orbit({0.6f, 0.3f});
    EXPECT_GT(glm::distance(eye.position(), before), 1);
    EXPECT_NEAR(glm::distance(eye.position(), eye.pivot), eye.distance, 1e-4f);
    expect_near(*eye.project(eye.pivot, size_px), 0.5f * size_px, 0.01f);
}

TEST_P(BothProjections, a_framed_box_is_inside_wide_and_tall_pictures_and_fills_a_third_of_them)
{
    for (glm::vec2 size : {glm::vec2{900, 300}, glm::vec2{300, 900}}) {
        ViewCamera eye = eye_of(GetParam());
        glm::vec3 centre{-3, 4, 12}, half{2, 0.5f, 1};
        eye.frame(centre, half, size.x / size.y);
        float extent = 0;
        for (int corner = 0; corner < 8; ++corner) {
            glm::vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            auto at = eye.project(centre + sign * half, size);
            ASSERT_TRUE(at);
            EXPECT_GE(at->x, 0);
            EXPECT_GE(at->y, 0);
            EXPECT_LE(at->x, size.x);
            EXPECT_LE(at->y, size.y);
            extent = std::max(extent, glm::distance(*at, 0.5f * size));
        }
        EXPECT_GT(2 * extent, std::min(size.x, size.y) / 3);
    }
}

TEST(ViewCamera, never_turns_over_the_poles)
{
    ViewCamera eye;
    eye.orbit({0, 100});
    EXPECT_LT(eye.pitch_rad, 1.5708f);
    EXPECT_GT(eye.up().y, 0);
    eye.orbit({0, -200});
    EXPECT_GT(eye.pitch_rad, -1.5708f);
    EXPECT_GT(eye.up().y, 0);
}

TEST(ViewCamera, a_notch_comes_a_tenth_closer_and_back)
{
    ViewCamera eye;
    eye.dolly(1);
    EXPECT_FLOAT_EQ(eye.distance, 5.4f);
    eye.dolly(-1);
    EXPECT_FLOAT_EQ(eye.distance, 6);
    eye.dolly(1e4f);
    EXPECT_GT(eye.distance, 0);
}

TEST(ViewCamera, becoming_orthographic_keeps_the_size_of_what_is_at_the_pivot)
{
    ViewCamera eye = eye_of(false);
    glm::vec3 held = eye.pivot + 1.1f * eye.right() + 0.6f * eye.up();
    auto before = eye.project(held, size_px);
    eye.toggle_orthographic();
    expect_near(*eye.project(held, size_px), *before, 0.01f);
    eye.toggle_orthographic();
    expect_near(*eye.project(held, size_px), *before, 0.01f);
}

TEST(ViewCamera, a_tall_orthographic_picture_becomes_an_eye_that_does_not_distort)
{
    ViewCamera eye;
    eye.orthographic = true;
    eye.distance = 1;
    eye.field_of_view_rad = 3.0f;
    float height = eye.height_at_pivot();
    eye.toggle_orthographic();
    EXPECT_LT(eye.field_of_view_rad, 2.1f);
    EXPECT_NEAR(eye.height_at_pivot(), height, 1e-3f * height);
}

TEST(ViewCamera, coming_closer_with_parallel_rays_does_not_cut_into_what_is_near)
{
    ViewCamera eye = eye_of(true);
    eye.rays_from = 50;
    glm::vec3 before = eye.drawn_from();
    EXPECT_NEAR(glm::distance(before, eye.pivot), 50, 1e-3f);
    eye.dolly(20);
    EXPECT_EQ(eye.drawn_from(), before);
    eye.orthographic = false;
    EXPECT_EQ(eye.drawn_from(), eye.position());
}

TEST(ViewCamera, axis_views_see_from_their_side)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {1, -1}) {
            ViewCamera eye;
            eye.look_along(axis, side);
            glm::vec3 from(0);
            from[axis] = static_cast<float>(side);
            expect_near(eye.backward(), from, 2e-3f);
            EXPECT_TRUE(eye.orthographic);
            EXPECT_TRUE(eye.looks_along(axis, side));
            EXPECT_FALSE(eye.looks_along(axis, -side));
            EXPECT_FALSE(eye.looks_along((axis + 1) % 3, side));
        }
}

TEST(ViewCamera, the_way_to_another_eye_turns_the_short_way_round)
{
    ViewCamera from, to;
    from.yaw_rad = 3.0f;
    to.yaw_rad = -3.0f;
    EXPECT_GT(std::abs(from.towards(to, 0.5f).yaw_rad), 3.1f);
    EXPECT_EQ(from.towards(to, 1), to);
    EXPECT_NEAR(from.towards(to, 0).yaw_rad, 3.0f, 1e-5f);
}

TEST(ViewCamera, sees_from_where_it_is_told_to_what_it_is_told)
{
    for (glm::vec3 target : {glm::vec3{0, 0, 0}, {4.1f, 3, 6}, {4, 3.2f, 5}, {4, -20, 6}}) {
        glm::vec3 position{4, 3, 6};
        ViewCamera eye = ViewCamera::seen_from(position, target);
        expect_near(eye.position(), position, 1e-4f);
        glm::vec3 seen = glm::normalize(target - position);
        expect_near(-eye.backward(), seen, 3e-3f);  // straight down is 0.1 degrees off
    }
    expect_near(ViewCamera::seen_from({0, 5, 0}, {0, 0, 0}).right(), {1, 0, 0}, 1e-6f);
    expect_near(ViewCamera::seen_from({1, 2, 3}, {1, 2, 3}).backward(), {0, 0, 1}, 1e-6f);
}

TEST(SceneCamera, is_the_one_wired_to_the_output)
{
    Scene scene;
    auto output = scene.show(scene.node("sphere"));
    EXPECT_FALSE(ui::scene_camera(scene.document));
    scene.node("perspective");
    auto camera = scene.node(
        "perspective", {{"position", glm::vec3(1, 2, 3)}, {"target", glm::vec3(0, 1, 0)}, {"field_of_view", 30.0f}});
    scene.wire(camera, output, "camera");
    auto found = ui::scene_camera(scene.document);
    ASSERT_TRUE(found);
    expect_near(found->eye.position(), {1, 2, 3}, 1e-5f);
    expect_near(found->eye.pivot, {0, 1, 0}, 1e-5f);
    EXPECT_NEAR(found->eye.field_of_view_rad, glm::radians(30.0f), 1e-6f);
    EXPECT_FALSE(found->driven);
    scene.wire(scene.node("vector"), camera, "position");
    EXPECT_TRUE(ui::scene_camera(scene.document)->driven);
    ASSERT_FALSE(graph::set_muted(scene.document, camera, true));
    EXPECT_FALSE(ui::scene_camera(scene.document));
}

TEST(SceneCamera, an_orthographic_one_shows_its_height)
{
    Scene scene;
    auto output = scene.show(scene.node("sphere"));
    scene.wire(scene.node("orthographic", {{"height", 7.5f}}), output, "camera");
    auto found = ui::scene_camera(scene.document);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->eye.orthographic);
    EXPECT_NEAR(found->eye.height_at_pivot(), 7.5f, 1e-4f);
    expect_near(found->eye.position(), {4, 3, 6}, 1e-5f);
    EXPECT_FALSE(found->bent);
}

TEST(SceneCamera, of_bent_rays_is_left_in_its_place_but_carries_no_handles)
{
    for (const char* type : {"equal_angle", "fisheye"}) {
        Scene scene;
        auto output = scene.show(scene.node("sphere"));
        scene.wire(scene.node(type), output, "camera");
        auto found = ui::scene_camera(scene.document);
        ASSERT_TRUE(found) << type;
        EXPECT_TRUE(found->bent) << type;
        expect_near(found->eye.position(), {4, 3, 6}, 1e-5f);
        EXPECT_LT(found->eye.field_of_view_rad, 3.0f);
    }
}

}  // namespace
}  // namespace fieldwright
