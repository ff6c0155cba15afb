#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/scene/camera_key.h"
#include "game/scene/goal.h"
#include "game/scene/timed_command.h"
#include "render/buildings/structures.h"
#include "render/view/camera.h"
#include "render/view/look.h"
#include "render/view/wind.h"
#include "render/woods/woods.h"
#include "sim/fields/flow_stage.h"
#include "sim/initial_state.h"
#include "sim/world/params.h"
#include "sim/world/state.h"
#include "terrains/georeference.h"
#include "terrains/terrain.h"

namespace game {

// Everything that a world starts with, from a scene, a terrain file or a recording.
struct Scenario {
    std::string scene;     // name of the scene or of the terrain file
    std::string title;     // for display
    std::string material;  // name of its preset
    sim::Params params;
    std::optional<double> density;  // kg/m³, of the flowing material; for impact pressure and things

    std::string terrain;  // name of the ground
    std::string licence;  // licence of the ground's source; may be empty
    sim::Grid grid;
    double datum = 0;                     // m, height at which bedrock is 0
    std::vector<float> bedrock;           // m above datum, grid.size() values, row-major, row 0 the south
    std::vector<float> depth;             // m, erodible
    std::vector<float> rolling;           // m, a release that starts at rest
    std::vector<std::uint8_t> has_data;   // 0 where material leaves the world
    terrains::Georeference georeference;  // where the grid is on Earth, if known

    // The lower material of a world with two materials (sim/world/mixture.h).
    struct Lower {
        std::string material;  // name of its preset
        sim::Params params;
        std::vector<float> depth;       // m, the part of `depth` that is this material, from bedrock up
        std::optional<double> density;  // kg/m³
        // Where the materials are mixed already, m of this one: in the standing layer above its depth, and in the
        // rolling layer; none, or grid.size() values.
        std::vector<float> settled, rolling;
    };
    std::optional<Lower> lower;

    // A flow scene, which shows how a flow's fronts are tracked: level ground and nothing else.
    struct Flow {
        sim::fields::TestFlow flow;
        sim::fields::FlowNumbers numbers;
    };
    std::optional<Flow> flow;

    // What stands at tick 0 and acts on a flow (sim/world/things.h).
    struct Standing {
        std::vector<sim::Stems> forest;    // none, or grid.size() values
        std::vector<sim::Command> placed;  // of things, done one after another before tick 0
        double earth_budget = -1;          // m³; −1: no limit
        std::vector<float> earth =
            {};  // m that bedrock is raised by, whole quanta; none, or grid.size() values
        std::vector<float> water =
            {};  // share of the standing layer that is saturated, whole quanta; none, or grid.size() values
        bool empty() const {
            return forest.empty() && placed.empty() && earth_budget < 0 && earth.empty() && water.empty();
        }
        bool operator==(const Standing&) const = default;
    };
    Standing standing;
    std::optional<sim::Calendar> weather;  // without fault_of()
    std::optional<Goal> goal;              // of a challenge

    render::Look look;
    render::Light light;
    std::optional<render::Camera> camera;  // none: the overview
    std::vector<CameraKey> camera_path;    // of a film; none, or 2 and more by time
    bool model = false;                    // drawn as a block cut from its mountains
    render::TreeRules trees;               // for the eye alone, unless woods_act()
    render::Wind wind;                     // for the eye alone

    // Whether its trees on the grid are those of the forest at tick 0.
    bool woods_act() const { return trees.density > 0 && !standing.forest.empty() && !model; }
};

inline constexpr double kLeastDensity = 1, kGreatestDensity = 3000;  // kg/m³

// Of commands sorted by tick: those before a tick, those from it on, and those that apply at its start.
std::span<const TimedCommand> commands_before(std::span<const TimedCommand> commands, std::int64_t tick);
std::span<const TimedCommand> commands_from(std::span<const TimedCommand> commands, std::int64_t tick);
std::span<const TimedCommand> commands_at(std::span<const TimedCommand> commands, std::int64_t tick);

// Checks the parameters that these commands, sorted by tick, set one after another. Returns the fault, such
// as "at tick 6: start_slope is below stop_slope", or nothing.
std::optional<std::string> fault_of_commands(sim::Params params, std::span<const TimedCommand> commands);

// Sets the scenario's ground from `terrain`: bedrock under
// its cover, above a whole-metre datum near its lowest point.
void set_ground(Scenario& scenario, const terrains::Terrain& terrain);

// Old cover is drawn only where a world starts without any standing layer: without it, real winter terrain would
// look like summer. Elsewhere what is bare is meant to be.
void leave_old_cover_on_bare_ground(Scenario& scenario);

// Whether a world began without any material and nothing lies or moves in it yet, so that nothing can be released or
// dug. Old snow may be drawn there nevertheless.
bool is_bare(const Scenario& scenario, const sim::State& state);

// A view for sim; valid as long as the scenario is.
sim::InitialState initial_state_of(const Scenario& scenario);

// XXH3 of grid, datum, bedrock, depth, rolling, has_data and the
// lower material's depth. Identifies the ground of a recording.
std::uint64_t ground_hash(const Scenario& scenario);

}  // namespace game
