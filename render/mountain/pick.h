#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/mountain/surroundings.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace render {

// A line of sight. World metres as in camera.h.
struct Ray {
    glm::dvec3 from;
    glm::dvec3 along;  // unit length
};

// Ray through a point of the image: x and y from −1 (left, bottom) to 1.
Ray ray_through(const Camera& camera, double aspect, glm::dvec2 point);

// Where a ray first meets the drawn surface from above, on the triangles of ground_mesh.h. Empty if it
// misses. z is the height above the terrain's zero. A building that is a part of the bedrock is met as its block, so that
// what points at its walls or its roof finds it.
std::optional<glm::dvec3> pick(const sim::View& world, const Ray& ray);

// Whether ground between a place and the eye hides it. One that lies on the ground may be met a fiftieth of the way early.
bool is_hidden(const sim::View& world, glm::dvec3 place, glm::dvec3 eye);
// The same, or a mountain around that ground.
bool is_hidden(const sim::View& world, const Surroundings& around, glm::dvec3 place, glm::dvec3 eye);

}  // namespace render
