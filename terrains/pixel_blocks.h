#pragma once

#include <vector>

#include "terrains/raster_place.h"
#include "terrains/resample.h"

namespace terrains {

// Adds a raster to a fit by blocks of side × side pixels. Each block becomes one point with the mean position
// and height of its known pixels, and one point of its unknown ones. A raster much finer than the grid then
// costs little more than reading it. Every plane is still reproduced exactly. Include from sources only.
class PixelBlocks {
  public:
    // `place` and `fit` must outlive this.
    PixelBlocks(const RasterPlace& place, int columns, int rows, int side, PlaneFit& fit);

    // Adds one row of heights, m, NaN if unknown. Rows come in order, from 0 to the last.
    void add_row(int row, const std::vector<double>& heights);

  private:
    // Sums over some pixels; columns and rows are relative to the first pixel's centre.
    struct Lump {
        double count = 0, column = 0, row = 0, height = 0;
    };
    struct Point {
        double x, y;
    };
    // Positions on the plane, in one row, at each of columns_.
    struct Knots {
        std::vector<double> x, y;
    };
    Point place_of(const Lump& lump, std::size_t block) const;
    void add_blocks();

    const RasterPlace& place_;
    PlaneFit& fit_;
    int rows_, side_;
    std::vector<double> columns_;          // block b lies between columns_[b] and columns_[b + 1]
    double first_row_ = 0, last_row_ = 0;  // of the blocks being summed
    Knots first_, last_;                   // positions in these rows
    std::vector<Lump> known_, unknown_;    // one per block
};

}  // namespace terrains
