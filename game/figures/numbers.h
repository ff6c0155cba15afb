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

// The paper's flows whose fronts move, by our readings.
struct MeasuredFlow {
    const char* name;   // for a script
    const char* title;  // for people
    sim::fields::TestFlow flow;
};
std::span<const MeasuredFlow> flow_scenes();

// How well a flow's front is met and how its textures fare, on a grid of `squares` along each side, over 16 s
// at 60 steps/s.
struct FlowScores {
    int scene = 0;  // of flow_scenes()
    int squares = 0;
    std::array<sim::fields::FrontScore, 3> front;  // by the sources half, paper, fit
    std::array<sim::fields::TextureScore, 4>
        texture;  // the smooth field alone; no cuts; to the letter; re-seeded
};

// Each scene on each grid, scene after scene. Takes minutes where squares are many. However many threads, ≥
// 1: the same numbers.
std::vector<FlowScores> measure_flows(std::span<const int> squares, int threads);

// The most that fit's root mean square may be, in cells; none for a grid that nobody has measured.
std::optional<double> fit_bound(int scene, int squares);
// The first number beyond its bound, as a sentence; none if all hold: fit_bound(); textures that are cut and
// re-seeded are to be no more drawn out near the front than by the smooth field alone, hardly anywhere above
// 2, and to travel with the flow.
std::optional<std::string> first_miss(std::span<const FlowScores> numbers);

std::vector<Table> tables_of(std::span<const FlowScores> numbers);
// A line for each scene and grid, after a line of names.
std::string csv_of(std::span<const FlowScores> numbers);

}  // namespace game
