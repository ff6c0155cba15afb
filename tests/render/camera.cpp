#include "render/view/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace render {
namespace {

Camera tilted() {
    Camera camera;
    camera.target = {120, -40, 1800};
    camera.azimuth_deg = 250;
    camera.elevation_deg = 25;
    camera.distance_m = 700;
    return camera;
}

glm::dvec3 project(const Camera& camera, double aspect, glm::dvec3 point) {
    const glm::dvec4 clip = projection_matrix(camera, aspect) * view_matrix(camera) * glm::dvec4(point, 1);
    return glm::dvec3(clip) / clip.w;
}

TEST(Camera, stands_at_its_azimuth_elevation_and_distance) {
    Camera camera;
    camera.target = {10, 20, 30};
    camera.azimuth_deg = 90;
    camera.elevation_deg = 30;
    camera.distance_m = 100;
    const glm::dvec3 at = eye(camera);
    EXPECT_NEAR(at.x, 10 + 100 * std::sqrt(3.0) / 2, 1e-9);
    EXPECT_NEAR(at.y, 20, 1e-9);
    EXPECT_NEAR(at.z, 80, 1e-9);
}

TEST(Camera, shows_its_target_in_the_middle) {
    const glm::dvec3 seen = project(tilted(), 1.6, tilted().target);
    EXPECT_NEAR(seen.x, 0, 1e-9);
    EXPECT_NEAR(seen.y, 0, 1e-9);
}

TEST(Camera, has_its_field_of_view_from_top_to_bottom_and_the_aspect_from_side_to_side) {
    Camera south;
    south.target = {0, 0, 0};
    south.azimuth_deg = 180;
    south.elevation_deg = 0;
    south.distance_m = 50;
    south.field_of_view_deg = 60;
    const double half = 50 * std::tan(3.14159265358979 / 6);
    EXPECT_NEAR(project(south, 2, {0, 0, half}).y, 1, 1e-9);
    EXPECT_NEAR(project(south, 2, {2 * half, 0, 0}).x, 1, 1e-9);
}

TEST(Camera, reverses_depth_from_one_at_the_near_plane_toward_zero_far_away) {
    const glm::dvec3 forward = glm::normalize(tilted().target - eye(tilted()));
    EXPECT_NEAR(project(tilted(), 1, eye(tilted()) + kNear * forward).z, 1, 1e-9);
    EXPECT_NEAR(project(tilted(), 1, eye(tilted()) + 1e6 * forward).z, kNear / 1e6, 1e-12);
}

}  // namespace
}  // namespace render
