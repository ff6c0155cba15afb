#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "sim/world/state.h"

namespace render {

// Where an eye looks. World metres as in camera.h.
struct Ray {
    glm::dvec3 from;
    glm::dvec3 along;  // unit length
};

// Through a point of the picture: x and y from −1 (left, bottom) to 1.
Ray ray_through(const Camera& camera, double aspect, glm::dvec2 point);

// Where a ray first meets the surface that is drawn, on the very triangles of ground_mesh.h, from above;
// nothing where it misses. z is the height above the terrain's zero.
std::optional<glm::dvec3> pick(const sim::View& world, const Ray& ray);

}  // namespace render
