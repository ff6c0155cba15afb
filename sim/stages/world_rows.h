#pragma once

#include <array>

#include "sim/simd/rows.h"
#include "sim/world/params.h"

namespace sim {

// What the stages of every model read beside their fields: values that all vertices share, and the bedrock.
template <class Constants, class Scalar>
struct WorldRows {
    int nx, ny;
    std::array<Border, 4> borders;  // by Side
    Constants c;
    Rows<Scalar> bedrock;

    bool is_ground(int y) const { return y >= 0 && y < ny; }
    bool is_wall(Side side) const { return borders[side] == Border::kWall; }
};

}  // namespace sim
