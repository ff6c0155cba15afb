#include "game/controls/camera_room.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "game/controls/camera_path.h"
#include "game/scene/surface.h"

namespace game {

CameraRoom::CameraRoom(const sim::View& world, const render::Surroundings& around)
    : world_(world), around_(around), cell_(world.grid.dx) {
    const glm::dvec2 size = cell_ * glm::dvec2(world.grid.nx - 1, world.grid.ny - 1);
    diagonal_ = glm::length(size);
    centre_ = {size / 2.0, surface_height(world, size / 2.0)};
}

bool CameraRoom::reaches(glm::dvec3 point) const {
    return glm::distance(point, centre_) <= 2 * farthest();
}

double CameraRoom::height_above_ground(const render::Camera& camera) const {
    const glm::dvec3 eye = render::eye(camera);
    return eye.z - ground_at(eye);
}

double CameraRoom::ground_at(glm::dvec2 at) const {
    if (around_.empty() || around_.away(at) == 0) return surface_height(world_, at);
    return world_.datum + around_.height(at);
}

bool CameraRoom::clear(const render::Camera& camera) const {
    return height_above_ground(camera) >= cell_;
}

render::Camera CameraRoom::inside(render::Camera camera) const {
    const glm::dvec3 from_centre = render::eye(camera) - centre_;
    const double reach = 2 * farthest(), away = glm::length(from_centre);
    if (away > reach) camera.target += (reach / away - 1) * from_centre;
    camera.target.z += std::max(0.0, cell_ - height_above_ground(camera));
    return camera;
}

glm::dvec3 CameraRoom::ground_in_the_middle(const render::Camera& camera) const {
    const glm::dvec3 eye = render::eye(camera), forward = axes(camera).forward;
    const auto above = [&](double depth) {
        const glm::dvec3 p = eye + depth * forward;
        return p.z - ground_at(p);
    };
    double before = 0, depth = 0;
    while (depth < 3 * farthest() && above(depth) > 0) {
        before = depth;
        depth += std::max(cell_ / 2, above(depth) / 4);
    }
    glm::dvec3 p = camera.target;
    if (above(depth) <= 0) {
        for (int i = 0; i < 40; ++i) {
            const double middle = (before + depth) / 2;
            (above(middle) > 0 ? before : depth) = middle;
        }
        p = eye + depth * forward;
    }
    const glm::dvec2 size = cell_ * glm::dvec2(world_.grid.nx - 1, world_.grid.ny - 1);
    const glm::dvec2 on_grid = glm::clamp(glm::dvec2(p), glm::dvec2(0), size);
    return {on_grid, surface_height(world_, on_grid)};
}

}  // namespace game
