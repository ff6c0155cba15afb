#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "game/files/toml_table.h"
#include "game/scene/scenario.h"

namespace game {

// What a scene file places on its mountain: [[dam]], [[house]], [[net]], [[road]], [[lift]], [[forest]] and [earth].

// What the tables say before the ground is known. The tables stay, so that a fault on the ground names its line.
struct ThingsTables {
    struct Placed {
        TomlTable table;
        std::vector<sim::Command> commands;
        std::vector<glm::dvec2> points = {};  // that must lie on the grid
    };
    struct Forest {
        TomlTable table;
        std::vector<glm::dvec2> polygon;
        sim::Stems stems;
    };
    std::vector<Placed> placed = {};
    std::vector<Forest> forests = {};
    std::optional<TomlTable> earth;
    double earth_budget = -1;  // m³; −1: no limit

    bool empty() const { return placed.empty() && forests.empty() && earth_budget < 0; }
};

// Reads the tables. Faults go to the tables' fault.
ThingsTables read_things(TomlTable& root);

// Sets what stands on a scenario's ground; `woods_act`: its trees too. Faults go to the tables' fault: something beside
// the grid, on no-data or on something else, or a forest that covers no vertex.
void stand(ThingsTables things, bool woods_act, Scenario& scenario);

}  // namespace game
