#include "game/controls/camera_path.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace game {
namespace {

constexpr double kFarthestAside = 10;  // tangent; images end at about 3

double log_mix(double a, double b, double share) {
    return std::exp(glm::mix(std::log(a), std::log(b), share));
}

}  // namespace

Axes axes(const render::Camera& camera) {
    const double azimuth = glm::radians(camera.azimuth_deg), elevation = glm::radians(camera.elevation_deg);
    const glm::dvec3 right(-std::cos(azimuth), std::sin(azimuth), 0);
    const glm::dvec3 forward(-std::sin(azimuth) * std::cos(elevation),
                             -std::cos(azimuth) * std::cos(elevation), -std::sin(elevation));
    return {right, glm::cross(right, forward), forward};
}

Sight sight_of(glm::dvec3 point, const render::Camera& camera) {
    const Axes a = axes(camera);
    const glm::dvec3 from_eye = point - render::eye(camera);
    const double depth = glm::dot(from_eye, a.forward);
    return {glm::dvec2(glm::dot(from_eye, a.right), glm::dot(from_eye, a.up)) / depth, depth};
}

bool can_hold(glm::dvec3 point, const render::Camera& camera) {
    const Sight sight = sight_of(point, camera);
    return sight.depth > 0 && glm::length(sight.at) < kFarthestAside;
}

void place(render::Camera& camera, glm::dvec3 point, Sight sight) {
    const Axes a = axes(camera);
    const glm::dvec3 eye = point - sight.depth * (a.forward + sight.at.x * a.right + sight.at.y * a.up);
    camera.target = eye + camera.distance_m * a.forward;
}

glm::dvec3 point_at(Sight sight, const render::Camera& camera) {
    const Axes a = axes(camera);
    return render::eye(camera) + sight.depth * (a.forward + sight.at.x * a.right + sight.at.y * a.up);
}

render::Camera along(const render::Camera& from, const render::Camera& to, const Grip& hold, double share) {
    render::Camera camera = from;
    camera.azimuth_deg = glm::mix(from.azimuth_deg, to.azimuth_deg, share);
    camera.elevation_deg = glm::mix(from.elevation_deg, to.elevation_deg, share);
    camera.distance_m = log_mix(from.distance_m, to.distance_m, share);
    if (hold.about == Grip::About::kEye) {
        const glm::dvec3 eye = glm::mix(render::eye(from), render::eye(to), share);
        camera.target = eye + camera.distance_m * axes(camera).forward;
    } else if (hold.about == Grip::About::kPoint && can_hold(hold.point, from) && can_hold(hold.point, to)) {
        const Sight a = sight_of(hold.point, from), b = sight_of(hold.point, to);
        place(camera, hold.point, {glm::mix(a.at, b.at, share), log_mix(a.depth, b.depth, share)});
    } else {
        camera.target = glm::mix(from.target, to.target, share);
    }
    return camera;
}

bool look_alike(const render::Camera& a, const render::Camera& b) {
    constexpr double kDegrees = 1e-4, kOfDistance = 1e-6;
    return std::abs(a.azimuth_deg - b.azimuth_deg) < kDegrees &&
           std::abs(a.elevation_deg - b.elevation_deg) < kDegrees &&
           std::abs(a.distance_m - b.distance_m) < kOfDistance * b.distance_m &&
           glm::distance(render::eye(a), render::eye(b)) < kOfDistance * b.distance_m;
}

}  // namespace game
