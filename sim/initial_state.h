#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/world/command.h"
#include "sim/world/params.h"
#include "sim/world/state.h"

namespace sim {

// What a world begins with: grid.size() values each, row-major, without a halo.
struct InitialState {
    Grid grid;
    double datum = 0;                        // m, see State
    std::span<const float> bedrock;          // m above datum
    std::span<const float> depth;            // m, 0 ≤ depth ≤ kDeepest / 2; rounded to whole quanta
    std::span<const float> rolling;          // m, the same; begins at rest
    std::span<const std::uint8_t> has_data;  // 0 where material leaves the world

    // A second material under the other: how much of `depth`, from bedrock up, is it alone.
    struct Lower {
        Params params;                 // model, scheme, law, borders, tick and Courant number are the world's
        std::span<const float> depth;  // m, 0 to what `depth` is there
        // Where the materials are mixed already, m of this one, in whole quanta: in the standing layer above its
        // `depth`, and in the rolling layer. None: 0.
        std::span<const float> settled = {}, rolling = {};
    };
    std::optional<Lower> lower = std::nullopt;

    // kg/m³, of both materials; 0: unknown.
    float density = 0, lower_density = 0;

    // What stands there at tick 0; commands that place things. They must be without fault_of_things().
    struct Standing {
        std::span<const Stems> forest;    // none, or grid.size() values
        std::span<const Command> placed;  // sculpt, house, lift, net, road …, one after another
        double earth_budget = -1;         // m³; −1: no limit
        std::span<const float> earth =
            {};  // m that bedrock is raised by, whole quanta; none, or grid.size() values
        std::span<const float> water = {};  // m of Things, whole quanta; none, or grid.size() values
        bool empty() const {
            return forest.empty() && placed.empty() && earth_budget < 0 && earth.empty() && water.empty();
        }
    };
    Standing standing = {};

    std::optional<Calendar> weather = std::nullopt;  // must be without fault_of()
};
State make_state(const InitialState& world, const Params& params);

// Once bedrock and depth are set: carries the bedrock on over the borders and remembers the first slope.
template <class Number>
void enclose(Layers<Number>& layers, const Params& params);

}  // namespace sim
