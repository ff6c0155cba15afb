#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace render {

// A camera that looks at a point of the terrain. World metres: x east, y north, z up, height above the
// terrain's zero.
struct Camera {
    glm::dvec3 target{0, 0, 0};     // m
    double azimuth_deg = 200;       // of the camera as seen from the target: 0 north, 90 east
    double elevation_deg = 35;      // above the horizon, −89.9 to 89.9
    double distance_m = 1000;       // > 0
    double field_of_view_deg = 35;  // vertical, 5 to 120
    bool operator==(const Camera&) const = default;
};

inline constexpr double kNear = 0.1;  // m, near plane

glm::dvec3 eye(const Camera& camera);
glm::dmat4 view_matrix(const Camera& camera);
// Reversed depth, infinite far plane; `aspect` is width / height.
glm::dmat4 projection_matrix(const Camera& camera, double aspect);

}  // namespace render
