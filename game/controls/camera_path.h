#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"

// How a camera gets from one pose to another so that what a hand holds stays where it is in the picture.
namespace game {

struct Axes {
    glm::dvec3 right, up, forward;  // unit length
};
Axes axes(const render::Camera& camera);

// Where a camera has a point: to the right of and above the middle, as tangents, and how deep, m.
struct Sight {
    glm::dvec2 at{0};
    double depth = 0;
};
Sight sight_of(glm::dvec3 point, const render::Camera& camera);

// Whether the point is in front and not too far aside to be held.
bool can_hold(glm::dvec3 point, const render::Camera& camera);

// Moves a camera to where it has `point` in that sight; it keeps its orientation and its distance from the
// target.
void place(render::Camera& camera, glm::dvec3 point, Sight sight);

// A world point at that sight.
glm::dvec3 point_at(Sight sight, const render::Camera& camera);

// What the way of a camera goes about.
struct Grip {
    enum class About {
        kTarget,  // the target goes straight
        kEye,     // the eye goes straight: looking around and flying
        kPoint,   // a point goes straight across the picture, and stays where it is if both ends agree on it
    } about = About::kTarget;
    glm::dvec3 point{0};  // m
};

// The camera after a `share` (0 to 1) of the way. Shares compose: s, then t of what is left, is 1 − (1 − s)(1
// − t).
render::Camera along(const render::Camera& from, const render::Camera& to, const Grip& hold, double share);

// Whether no one could tell one picture from the other.
bool look_alike(const render::Camera& a, const render::Camera& b);

}  // namespace game
