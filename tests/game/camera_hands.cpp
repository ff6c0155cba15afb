#include "tests/game/camera_hands.h"

#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "game/scene/surface.h"
#include "tests/support/worlds.h"

namespace game::test {

sim::State valley() {
    support::Ground ground({61, 61, static_cast<float>(kCell)});
    ground.set(ground.bedrock, [](double x, double y) {
        return 0.3 * std::abs(x - 300) + 0.1 * y + 15 * std::sin(x / 60) * std::cos(y / 45);
    });
    ground.set(ground.depth, [](double, double) { return 2; });
    sim::State state = sim::make_state(ground.world(), {});
    state.datum = 1000;
    return state;
}

sim::State level() {
    return sim::make_state(support::plane(60, static_cast<float>(kCell), 0).world(), {});
}

render::Camera over(glm::dvec2 target, double height, double azimuth, double elevation, double distance) {
    render::Camera camera;
    camera.target = {target, height};
    camera.azimuth_deg = azimuth;
    camera.elevation_deg = elevation;
    camera.distance_m = distance;
    return camera;
}

glm::dvec2 in_picture(const render::Camera& camera, glm::dvec3 point) {
    const glm::dvec4 clip =
        render::projection_matrix(camera, kAspect) * render::view_matrix(camera) * glm::dvec4(point, 1);
    EXPECT_GT(clip.w, 0);
    return glm::dvec2(clip) / clip.w;
}

std::optional<glm::dvec3> ground_at(const render::Camera& camera, const sim::View& world, glm::dvec2 place) {
    const double focal = std::tan(camera.field_of_view_deg * 3.14159265358979323846 / 360);
    const glm::dmat4 view = render::view_matrix(camera);
    const glm::dvec3 along = glm::normalize(
        glm::dvec3(glm::transpose(view) * glm::dvec4(place.x * focal * kAspect, place.y * focal, -1, 0)));
    for (double way = 0; way < 3000; way += 0.5) {
        const glm::dvec3 p = render::eye(camera) + way * along;
        if (p.x < 0 || p.y < 0 || p.x > kSide || p.y > kSide || p.z > surface_height(world, p)) continue;
        return p;
    }
    return std::nullopt;
}

double clearance(const render::Camera& camera, const sim::View& world) {
    const glm::dvec3 eye = render::eye(camera);
    return eye.z - surface_height(world, eye);
}

bool finite(const render::Camera& c) {
    return std::isfinite(c.target.x + c.target.y + c.target.z + c.azimuth_deg + c.elevation_deg) &&
           std::isfinite(c.distance_m) && c.distance_m > 0;
}

std::vector<CameraCase> cases() {
    std::mt19937 random(7);
    const auto between = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
    };
    const sim::State world = valley();
    std::vector<CameraCase> made;
    while (made.size() < 60) {
        const render::Camera camera = over({between(200, 400), between(200, 400)}, between(1030, 1060),
                                           between(0, 360), between(20, 80), std::exp(between(4.6, 7)));
        const glm::dvec2 place(between(-0.8, 0.8), between(-0.8, 0.8));
        if (clearance(camera, sim::view(world)) > 40 && ground_at(camera, sim::view(world), place))
            made.push_back({camera, place});
    }
    return made;
}

Hands::Hands(sim::State world, const render::Camera& home)
    : state(std::move(world)), control(home, sim::view(state), around) {}

std::optional<glm::dvec3> Hands::ground(glm::dvec2 place) const {
    return ground_at(camera(), sim::view(state), place);
}

void Hands::frame(const CameraWish& wish, double seconds) {
    control.move(wish, sim::view(state), around, kAspect, seconds);
}

void Hands::settle(const std::function<void()>& each) {
    for (int i = 0; i < 100 && !control.still(); ++i) {
        frame();
        if (each) each();
    }
    EXPECT_TRUE(control.still());
}

void Hands::drag(CameraWish::Drag kind, glm::dvec2 from, glm::dvec2 to, int frames,
                 const std::function<void()>& each) {
    CameraWish wish;
    wish.drag = kind;
    wish.pivot = ground(from);
    for (int i = 0; i < frames; ++i) {
        wish.from = glm::mix(from, to, static_cast<double>(i) / frames);
        wish.to = glm::mix(from, to, (i + 1.0) / frames);
        frame(wish);
        if (each) each();
    }
}

void Hands::wheel(glm::dvec2 place, double steps) {
    CameraWish wish;
    wish.zoom_steps = steps;
    wish.pivot = ground(place);
    frame(wish);
}

}  // namespace game::test
