#include "render/view/camera.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace render {

glm::dvec3 eye(const Camera& camera) {
    const double azimuth = glm::radians(camera.azimuth_deg), elevation = glm::radians(camera.elevation_deg);
    const glm::dvec3 from_target(std::sin(azimuth) * std::cos(elevation),
                                 std::cos(azimuth) * std::cos(elevation), std::sin(elevation));
    return camera.target + camera.distance_m * from_target;
}

glm::dmat4 view_matrix(const Camera& camera) {
    return glm::lookAt(eye(camera), camera.target, glm::dvec3(0, 0, 1));
}

glm::dmat4 projection_matrix(const Camera& camera, double aspect) {
    const double focal = 1 / std::tan(glm::radians(camera.field_of_view_deg) / 2);
    glm::dmat4 m(0.0);
    m[0][0] = focal / aspect;
    m[1][1] = focal;
    m[2][3] = -1;
    m[3][2] = kNear;  // reversed depth is precise at any distance, so this near plane suits every scene
    return m;
}

}  // namespace render
