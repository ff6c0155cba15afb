#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/pages/table.h"
#include "sim/fields/front_score.h"
#include "sim/fields/texture_score.h"

namespace game {

// The paper's flows with moving fronts, as interpreted here.
struct MeasuredFlow {
    const char* name;   // for scripts
    const char* title;  // for display
    sim::fields::TestFlow flow;
};
std::span<const MeasuredFlow> flow_scenes();

// How accurately a flow's front is tracked and how its textures are advected, on a grid of `squares` along
// each side, over 16 s at 60 steps/s.
struct FlowScores {
    int scene = 0;  // of flow_scenes()
    int squares = 0;
    std::array<sim::fields::FrontScore, 3> front;      // by the sources half, paper, fit
    std::array<sim::fields::TextureScore, 4> texture;  // smooth field only; no cuts; as published; re-seeded
};

// Each scene on each grid, scene by scene. Takes minutes for
// fine grids. The same numbers for any number of threads ≥ 1.
std::vector<FlowScores> measure_flows(std::span<const int> squares, int threads);

// Limit of the root mean square error of fit, in cells; none for a grid that was never measured.
std::optional<double> fit_bound(int scene, int squares);
// The first number beyond its limit, as a sentence; none if all are within: fit_bound(); cut and re-seeded
// textures must stretch no more near the front than by the smooth field alone, hardly anywhere above 2, and
// must travel with the flow.
std::optional<std::string> first_miss(std::span<const FlowScores> numbers);

std::vector<Table> tables_of(std::span<const FlowScores> numbers);
// CSV: a header line, then a line for each scene and grid.
std::string csv_of(std::span<const FlowScores> numbers);

}  // namespace game
