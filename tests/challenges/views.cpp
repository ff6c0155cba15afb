// Each challenge starts with a view in which a person sees what is at stake and where to act, beside the panels.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "game/scene/scene.h"
#include "render/view/camera.h"
#include "sim/world/command.h"
#include "tests/challenges/shipped.h"

namespace game::test {
namespace {

using Points = std::vector<glm::dvec2>;  // m, from vertex (0, 0)

// Parts of a window of 1280×720, its smallest usual size, that panels cover when a try begins: tools, task, first steps,
// time and readings. From left to right and from top to bottom, as shares.
struct Plate {
    double left, right, top, bottom;
};
constexpr std::array kPlates{Plate{0.11, 0.89, 0, 0.13}, Plate{0.23, 0.77, 0.13, 0.245},
                             Plate{0.28, 0.72, 0.81, 0.86}, Plate{0.22, 0.78, 0.86, 1},
                             Plate{0, 0.21, 0.7, 1}};
constexpr double kAspect = 16.0 / 9;

Points outline_of(const Area& area) {
    constexpr int kSides = 64;
    Points points;
    for (int i = 0; i < kSides; ++i) {
        const double turn = 2 * std::numbers::pi * i / kSides;
        const double along = std::sin(turn), across = std::cos(turn);
        if (area.shape == Area::Shape::kEllipse) {
            points.push_back(area.from + area.to * glm::dvec2(along, across));
            continue;
        }
        // As the circle, pushed out to the sides.
        const double reach = std::max(std::abs(along), std::abs(across));
        points.push_back((area.from + area.to) / 2.0 +
                         (area.to - area.from) / 2.0 * glm::dvec2(along, across) / reach);
    }
    return points;
}

Points outline_of(const sim::Command& disc) {
    return outline_of(Area{Area::Shape::kEllipse, {disc.x, disc.y}, glm::dvec2(disc.radius)});
}

// The share of the points that no panel covers and that are in the frame.
double seen(const Scenario& scenario, const Points& points) {
    const sim::Grid& grid = scenario.grid;
    const auto height = [&](glm::dvec2 at) {
        const auto cell = [&](double metres, int most) {
            return std::clamp(static_cast<int>(std::lrint(metres / static_cast<double>(grid.dx))), 0,
                              most - 1);
        };
        const std::size_t i =
            static_cast<std::size_t>(cell(at.y, grid.ny)) * static_cast<std::size_t>(grid.nx) +
            static_cast<std::size_t>(cell(at.x, grid.nx));
        return scenario.datum + static_cast<double>(scenario.bedrock[i]) +
               static_cast<double>(scenario.depth[i]);
    };
    const render::Camera& camera = scenario.camera.value();
    const glm::dmat4 clip_from_world =
        render::projection_matrix(camera, kAspect) * render::view_matrix(camera);
    const auto count = std::ranges::count_if(points, [&](glm::dvec2 at) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(at, height(at), 1);
        if (clip.w <= 0) return false;
        const double right = (1 + clip.x / clip.w) / 2, down = (1 - clip.y / clip.w) / 2;
        if (right < 0 || right > 1 || down < 0 || down > 1) return false;
        return std::ranges::none_of(kPlates, [&](const Plate& plate) {
            return right >= plate.left && right <= plate.right && down >= plate.top && down <= plate.bottom;
        });
    });
    return static_cast<double>(count) / static_cast<double>(points.size());
}

TEST(Challenges, begin_with_a_view_of_what_is_at_stake_and_where_to_act) {
    for (const std::string& name : challenges()) {
        const Scene scene = load_scene(name, {}).value();
        const Goal& goal = *scene.scenario.goal;
        const auto expect_seen = [&](const Points& points, double least, const std::string& what) {
            EXPECT_GE(seen(scene.scenario, points), least) << name << ": " << what;
        };
        if (goal.zone) expect_seen(outline_of(*goal.zone), 0.6, "where the tools may be used");
        for (const TimedCommand& event : goal.events)
            if (event.tick > 0) expect_seen(outline_of(event.command), 0.9, "what the scene does");
        for (const sim::Command& thing : scene.scenario.standing.placed)
            if (thing.kind == sim::CommandKind::kHouse) expect_seen({{thing.x, thing.y}}, 1, "a house");
    }
}

}  // namespace
}  // namespace game::test
