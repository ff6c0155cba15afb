#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/controls/camera_control.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

// Worlds, hands and measures for the tests of the camera.
namespace game::test {

inline constexpr double kAspect = 16.0 / 9, kCell = 10, kSide = 600;  // m
inline constexpr double kFrame = 1.0 / 60;                            // s

// A valley of 60 × 60 squares with knolls, 1000 m above the terrain's zero.
sim::State valley();
// As large, at 0 m.
sim::State level();

render::Camera over(glm::dvec2 target, double height, double azimuth, double elevation, double distance);

glm::dvec2 in_picture(const render::Camera& camera, glm::dvec3 point);
// The ground that a place of the picture shows; nothing within 3 km.
std::optional<glm::dvec3> ground_at(const render::Camera& camera, const sim::View& world, glm::dvec2 place);
// m, of the eye above the surface.
double clearance(const render::Camera& camera, const sim::View& world);
bool finite(const render::Camera& camera);

// Many cameras over the valley, each with a place well inside the picture that shows ground.
struct CameraCase {
    render::Camera camera;
    glm::dvec2 place;
};
std::vector<CameraCase> cases();

// A control over a world, with the frames that hands need.
struct Hands {
    sim::State state;
    render::Surroundings around;  // none
    CameraControl control;

    Hands(sim::State world, const render::Camera& home);
    const render::Camera& camera() const { return control.camera(); }
    std::optional<glm::dvec3> ground(glm::dvec2 place) const;
    void frame(const CameraWish& wish = {}, double seconds = kFrame);
    // Frames until it is still, which 1.7 s must do for; calls `each` after every one.
    void settle(const std::function<void()>& each = {});
    // In equal parts; calls `each` after every frame.
    void drag(CameraWish::Drag kind, glm::dvec2 from, glm::dvec2 to, int frames,
              const std::function<void()>& each = {});
    void wheel(glm::dvec2 place, double steps);
};

}  // namespace game::test
