#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "game/base/outcome.h"
#include "game/recording/reader.h"
#include "game/scene/memory.h"
#include "game/scene/scenario.h"

namespace game {

// The physics variants for measuring recordings; a name has no spaces.
struct BenchPhysics {
    std::string_view name;
    sim::Model model;
    sim::Scheme scheme;  // of bcre
};
inline constexpr std::array<BenchPhysics, 3> kBenchPhysics{
    {{"bcre-inertial", sim::Model::kBcreInertial, sim::Scheme::kLocalLaxFriedrichs},
     {"lax-friedrichs", sim::Model::kBcre, sim::Scheme::kLaxFriedrichs},
     {"local-lax-friedrichs", sim::Model::kBcre, sim::Scheme::kLocalLaxFriedrichs}}};
std::optional<BenchPhysics> bench_physics_named(std::string_view name);
std::string bench_physics_names();  // separated by commas

// Whether `scenario` uses this physics already.
bool is_own(const Scenario& scenario, const BenchPhysics& physics);
// Changes the physics of the scenario: only the scheme, or the parameters that its materials have for the
// other model. Tick and borders stay. Errors: a material has no such parameters.
Outcome<Scenario> in_physics(Scenario scenario, const BenchPhysics& physics);

int squares_of(const Scenario& scenario);  // along the longer side
// Moves the scenario to another grid over the same rectangle, 8 to 4096 squares along the longer side.
// Bedrock and layers are averaged on a coarser grid and interpolated on a finer one. Errors: fewer than two
// squares would fit across, or `memory` does not allow the grid.
Outcome<Scenario> on_grid(Scenario scenario, int squares, const Memory& memory = {});

// The scenario of a recording in this physics on that grid. Errors: as above, or its commands set parameters
// that are inconsistent there.
Outcome<Scenario> scenario_of(const Recording& recording, int squares, const BenchPhysics& physics,
                              const Memory& memory);
// Whether the recorded states are of that scenario.
bool has_states_of(const Recording& recording, int squares, const BenchPhysics& physics);

}  // namespace game
