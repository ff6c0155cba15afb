#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "terrains/massif/exact.h"

namespace terrains::massif {

using Values = std::vector<double>;  // one per vertex of a level

// The ground at one spacing.
struct Level {
    explicit Level(int squares_, double length)
        : squares(squares_), side(squares_ + 1), dx(length / squares_), size(std::size_t(side) * side) {}

    int squares, side;
    double dx;
    std::size_t size;
    Values height, talus;              // m
    Values beds;                       // height of the lowest bed above its dip, m
    Values uplift, weakness;           // relative
    Values sound;                      // 0: broken rock; 1: rock that stands as steep as hard beds
    Values base;                       // height of a vertex that erosion leaves as it is; kNotBase elsewhere
    Values drainage;                   // m²
    std::vector<int> order, receiver;  // from low to high; the neighbour that takes the flow
    Values filled, distance;           // height without hollows; distance to the receiver, m
};
inline constexpr double kNotBase = -1e9;

// Fills hollows from the base upwards (priority flood, Barnes et al. 2014) and lists vertices from low to high.
void flood(Level& g);
// Finds receivers by steepest descent, blurred by chance so that channels do not follow the grid, and drainage.
void route(Level& g, const Noise& chance);
// Gradient of heights at a vertex: a tangent.
double slope(const Level& g, const Values& height, std::size_t a);
// Mean over a square of `reach` vertices each way.
Values blurred(const Level& g, const Values& values, int reach);

// Bilinear and bicubic value at a position in squares; beyond the border that at the border.
double sampled(const Values& values, int side, double x, double y);
double smoothly_sampled(const Values& values, int side, double x, double y);

}  // namespace terrains::massif
