#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/view/camera.h"

// Paths of a camera between two poses that keep the grabbed point fixed in the image.
namespace game {

struct Axes {
    glm::dvec3 right, up, forward;  // unit length
};
Axes axes(const render::Camera& camera);

// A point as seen by a camera: offset right and up from the centre, as tangents, and depth, m.
struct Sight {
    glm::dvec2 at{0};
    double depth = 0;
};
Sight sight_of(glm::dvec3 point, const render::Camera& camera);

// Whether the point is in front of the camera and not too far to the side to be grabbed.
bool can_hold(glm::dvec3 point, const render::Camera& camera);

// Moves a camera so that it sees `point` at `sight`; keeps its orientation and its distance from the target.
void place(render::Camera& camera, glm::dvec3 point, Sight sight);

// The world point at `sight`.
glm::dvec3 point_at(Sight sight, const render::Camera& camera);

// What moves in a straight line along a camera path.
struct Grip {
    enum class About {
        kTarget,  // the target, in the world
        kEye,     // the eye, in the world: looking around and flying
        kPoint,   // a point, in the image; it stays fixed if both ends agree
    } about = About::kTarget;
    glm::dvec3 point{0};  // m
};

// The camera after a `share` (0 to 1) of the path. Shares compose: s, then t of the rest, is 1 − (1 − s)(1 −
// t).
render::Camera along(const render::Camera& from, const render::Camera& to, const Grip& hold, double share);

// Whether the two images would be indistinguishable.
bool look_alike(const render::Camera& a, const render::Camera& b);

}  // namespace game
