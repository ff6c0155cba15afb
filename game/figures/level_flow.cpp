#include "game/figures/level_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "sim/front/gradient.h"
#include "sim/front/remesh_reference.h"
#include "sim/initial_state.h"

namespace game {
namespace {

constexpr double kStepsPerSecond = 60;

sim::front::Rule rule_of(float cell, bool cut) {
    return cut ? sim::front::gradient_rule(kJump, cell) : sim::front::uncut_rule();
}

sim::State level(const sim::Grid& grid) {
    const std::vector<float> nothing(grid.size(), 0.f);
    const std::vector<std::uint8_t> has_data(grid.size(), 1);
    return sim::make_state({grid, 0, nothing, nothing, nothing, has_data}, sim::Params{});
}

// Greatest over least singular value of the gradient of a sheet's coordinates on a piece of the cut mesh.
double stretch_of(const sim::front::CutTriangle& piece, const sim::front::TextureLayers& layers, int sheet) {
    std::array<glm::dvec2, 3> at, coordinates;
    for (int k = 0; k < 3; ++k) {
        at[k] = glm::dvec2(piece[k].position);
        coordinates[k] = at[k] + glm::dvec2(layers.offset(piece[k], sheet));
    }
    const glm::dmat2 g = glm::dmat2(coordinates[1] - coordinates[0], coordinates[2] - coordinates[0]) *
                         glm::inverse(glm::dmat2(at[1] - at[0], at[2] - at[0]));
    const auto [greatest, least] = sim::front::singular_values(g);
    return greatest / std::max(std::abs(least), 0.5e-4);
}

// The mean of all sheets, weighted by visibility.
double stretch_of(const sim::front::CutTriangle& piece, const sim::front::TextureLayers& layers) {
    double stretch = 0;
    for (int sheet = 0; sheet < sim::front::TextureLayers::kSheets; ++sheet) {
        float weight = 0;
        for (const auto& corner : piece) weight += layers.weight(corner.side, sheet) / 3;
        if (weight > 0) stretch += static_cast<double>(weight) * stretch_of(piece, layers, sheet);
    }
    return stretch;
}

double area_of(const sim::front::CutTriangle& piece) {
    const glm::dvec2 u(piece[1].position - piece[0].position), v(piece[2].position - piece[0].position);
    return std::abs(u.x * v.y - u.y * v.x) / 2;
}

}  // namespace

LevelFlow::LevelFlow(int squares, bool cut)
    : grid_{squares + 1, squares + 1, 1.f / static_cast<float>(squares)},
      mesh_(sim::front::mesh_of(grid_)),
      view_(mesh_, rule_of(grid_.dx, cut), sim::front::PointSource::kFit, {}),
      ground_(level(grid_)) {}

void LevelFlow::advance(const sim::fields::TestFlow& flow, double seconds, sim::Workers& workers) {
    std::vector<glm::vec2> velocity(mesh_.position.size());
    const auto steps = std::lround(seconds * kStepsPerSecond);
    for (int step = 1; step <= steps; ++step) {
        for (std::size_t v = 0; v < velocity.size(); ++v)
            velocity[v] = flow.velocity(glm::dvec2(mesh_.position[v]), step / kStepsPerSecond);
        view_.advance({velocity, {}}, 1 / kStepsPerSecond, workers);
    }
}

double LevelFlow::drawn_out() const {
    constexpr double kDrawnOut = 2, kNoArea = 1e-6;  // of a cell
    double all = 0, drawn_out = 0;
    for (int t = 0; t < static_cast<int>(mesh_.triangle.size()); ++t)
        for (const auto& piece : sim::front::cut_triangle(view_.tracker(), t)) {
            const double area = area_of(piece);
            if (area < kNoArea * grid_.dx * grid_.dx) continue;
            all += area;
            if (stretch_of(piece, view_.layers()) > kDrawnOut) drawn_out += area;
        }
    return drawn_out / all;
}

}  // namespace game
