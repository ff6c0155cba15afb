#pragma once

#include <cstdint>
#include <span>

#include "sim/core/grid.h"

namespace sim {

struct Params;

// What a vertex is to the flow. Border vertices of the grid are kGround; the halo around them is kDrain or
// kWall.
enum class Site : std::uint8_t {
    kGround,  // material lies and rolls here
    kDrain,   // what arrives has left the world: no-data and the halo of open and sink borders
    kWall,    // nothing passes: the halo of wall borders
};

// The bedrock, standing layer and rolling layer on a grid. All lengths are vertical metres.
// Number is float in a world: depth and rolling are whole multiples of kQuantum (quanta.h), so that sums and
// differences of them are exact. It is double for comparing schemes with exact solutions: then there are no
// quanta, but the stages are the same code.
template <class Number>
struct Layers {
    Grid grid;
    Field<Number> bedrock;      // b, m above datum
    Field<Number> depth;        // d ≥ 0, m, erodible depth; the standing layer's height is h = b + d
    Field<Number> rolling;      // R ≥ 0, m, rolling layer
    Field<Number> velocity_x;   // m/s, of the rolling layer; 0 where R = 0
    Field<Number> velocity_y;   // m/s
    Field<Number> first_slope;  // |∇(b + d)| of the first surface, central: natural ground holds it
    Field<Number>
        first_depth;  // m, d of the first surface, or of what was settled: what lies above it is loose
    Field<Number>
        smooth_depth;  // s, m; b + s is the smoothed ground (momentum/smooth_ground.h), unused in bcre
    Field<Site> site;
};

// Empty layers on ground where has_data says so (grid.size() values), with halo sites as the borders ask.
template <class Number>
Layers<Number> make_layers(const Grid& grid, const Params& params, std::span<const std::uint8_t> has_data);

// Carries bedrock on over the borders, as steep as inside; walls mirror it.
template <class Number>
void continue_bedrock(Layers<Number>& layers, const Params& params);

}  // namespace sim
