#include "terrains/pixel_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terrains {

PixelBlocks::PixelBlocks(const RasterPlace& place, int columns, int rows, int side, PlaneFit& fit)
    : place_(place), fit_(fit), rows_(rows), side_(side) {
    for (int column = 0; column < columns - 1; column += side) columns_.push_back(column);
    columns_.push_back(columns - 1);
    known_.resize(columns_.size() - 1);
    unknown_.resize(known_.size());
    place_.places(columns_, 0, first_.x, first_.y);
}

void PixelBlocks::add_row(int row, const std::vector<double>& heights) {
    for (std::size_t column = 0; column < heights.size(); ++column) {
        const std::size_t block = std::min(column / static_cast<std::size_t>(side_), known_.size() - 1);
        const bool unknown = std::isnan(heights[column]);
        Lump& lump = (unknown ? unknown_ : known_)[block];
        ++lump.count;
        lump.column += static_cast<double>(column);
        lump.row += row;
        lump.height += unknown ? 0 : heights[column];
    }
    const bool last_of_blocks = (row + 1) % side_ == 0 || row + 1 == rows_;
    if (!last_of_blocks) return;
    last_row_ = std::min(row + 1, rows_ - 1);
    place_.places(columns_, last_row_, last_.x, last_.y);
    add_blocks();
    std::swap(first_, last_);
    first_row_ = last_row_;
    std::fill(known_.begin(), known_.end(), Lump{});
    std::fill(unknown_.begin(), unknown_.end(), Lump{});
}

// Interpolates linearly between the corners of the block, as RasterPlace::positions() does between its knots.
PixelBlocks::Point PixelBlocks::place_of(const Lump& lump, std::size_t block) const {
    const auto share = [](double at, double first, double last) {
        return last > first ? (at - first) / (last - first) : 0;
    };
    const double s = share(lump.column / lump.count, columns_[block], columns_[block + 1]);
    const double t = share(lump.row / lump.count, first_row_, last_row_);
    const auto blend = [&](const std::vector<double>& first, const std::vector<double>& last) {
        return (1 - t) * ((1 - s) * first[block] + s * first[block + 1]) +
               t * ((1 - s) * last[block] + s * last[block + 1]);
    };
    return {blend(first_.x, last_.x) - place_.min_x, blend(first_.y, last_.y) - place_.min_y};
}

void PixelBlocks::add_blocks() {
    for (std::size_t block = 0; block < known_.size(); ++block) {
        const Lump &known = known_[block], &unknown = unknown_[block];
        if (known.count > 0)
            if (const Point at = place_of(known, block); std::isfinite(at.x + at.y))
                fit_.add(at.x, at.y, known.height / known.count, known.count);
        if (unknown.count > 0)
            if (const Point at = place_of(unknown, block); std::isfinite(at.x + at.y))
                fit_.add_void(at.x, at.y, unknown.count);
    }
}

}  // namespace terrains
