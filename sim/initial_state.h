#pragma once

#include <cstdint>
#include <optional>
#include <span>

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
    std::uint64_t seed = 0;

    // A second material under the other: how much of `depth`, from bedrock up, is it alone.
    struct Lower {
        Params params;                 // model, scheme, law, borders, tick and Courant number are the world's
        std::span<const float> depth;  // m, 0 to what `depth` is there
    };
    std::optional<Lower> lower = std::nullopt;
};
State make_state(const InitialState& world, const Params& params);

// Once bedrock and depth are set: carries the bedrock on over the borders and remembers the first slope.
template <class Number>
void enclose(Layers<Number>& layers, const Params& params);

}  // namespace sim
