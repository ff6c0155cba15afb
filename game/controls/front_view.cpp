#include "game/controls/front_view.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "game/scene/surface.h"

namespace game {

render::Camera view_from_front(const sim::View& world, glm::dvec2 top, glm::dvec2 toe) {
    constexpr double kLook = 0.5;                        // of the way up, what is looked at
    constexpr double kBeyond = 0.08, kLeastBeyond = 30;  // of the slide's length, m; from the toe to the eye
    constexpr double kAbove = 0.02, kLeastAbove = 2;     // the same, above the ground
    const double length = glm::distance(top, toe);
    const glm::dvec2 down = length > 0 ? (toe - top) / length : glm::dvec2(0, -1);
    const glm::dvec2 stand = toe + down * std::max(kBeyond * length, kLeastBeyond),
                     aim = glm::mix(toe, top, kLook);
    const glm::dvec3 eye(stand, surface_height(world, stand) + std::max(kAbove * length, kLeastAbove)),
        target(aim, surface_height(world, aim)), away = eye - target;
    render::Camera camera;
    camera.target = target;
    camera.distance_m = glm::length(away);
    camera.azimuth_deg = glm::degrees(std::atan2(away.x, away.y));
    camera.elevation_deg = glm::degrees(std::asin(away.z / camera.distance_m));
    camera.field_of_view_deg = 55;
    return camera;
}

}  // namespace game
