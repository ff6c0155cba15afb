#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "render/camera.h"
#include "render/look.h"
#include "sim/fields/flow_stage.h"
#include "sim/initial_state.h"
#include "sim/world/params.h"
#include "sim/world/state.h"
#include "terrains/georeference.h"
#include "terrains/terrain.h"

namespace game {

// All that a world begins with, whether a scene, a terrain file or a recording said so.
struct Scenario {
    std::string scene;     // name of the scene or of the terrain file
    std::string title;     // for people
    std::string material;  // name of its preset
    sim::Params params;

    std::string terrain;  // name of the ground
    std::string licence;  // of the ground's source; may be empty
    sim::Grid grid;
    double datum = 0;                     // m, height of bedrock = 0
    std::vector<float> bedrock;           // m above datum, grid.size() values, row-major, row 0 the south
    std::vector<float> depth;             // m, erodible
    std::vector<float> rolling;           // m, a release that begins at rest
    std::vector<std::uint8_t> has_data;   // 0 where material leaves the world
    terrains::Georeference georeference;  // where the grid stands on Earth, if anywhere
    std::uint64_t seed = 0;

    // The material under the other, in a world of two (sim/world/mixture.h).
    struct Lower {
        std::string material;  // name of its preset
        sim::Params params;
        std::vector<float> depth;  // m, how much of `depth` it is alone, from bedrock up
    };
    std::optional<Lower> lower;

    // A scene that shows how the fronts of a flow are met: level ground, on which nothing else happens.
    struct Flow {
        sim::fields::TestFlow flow;
        sim::fields::FlowNumbers numbers;
    };
    std::optional<Flow> flow;

    render::Look look;
    render::Light light;
    std::optional<render::Camera> camera;  // none: the overview
};

// A command and the tick at whose start it is given.
struct TimedCommand {
    std::int64_t tick = 0;
    sim::Command command;
};

// Of commands in order of their ticks, those from a tick on, and those given at its start.
std::span<const TimedCommand> commands_from(std::span<const TimedCommand> commands, std::int64_t tick);
std::span<const TimedCommand> commands_at(std::span<const TimedCommand> commands, std::int64_t tick);

// What is wrong with the numbers that these commands, in order of their ticks, set one after the other: "at
// tick 6: start_slope is below stop_slope". Nothing if all is well.
std::optional<std::string> fault_of_commands(sim::Params params, std::span<const TimedCommand> commands);

// The ground of `terrain` as a start's: bedrock under its cover, above a whole-metre datum near its lowest
// point.
void set_ground(Scenario& scenario, const terrains::Terrain& terrain);

// For sim; valid as long as the start is.
sim::InitialState initial_state_of(const Scenario& scenario);

// XXH3 of grid, datum, bedrock, depth, rolling, has_data and the lower material's depth: which ground a
// recording is of.
std::uint64_t ground_hash(const Scenario& scenario);

}  // namespace game
