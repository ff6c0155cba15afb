#include "sim/momentum/smooth_ground.h"

#include <algorithm>
#include <cmath>

#include "sim/core/tiles.h"
#include "sim/core/workers.h"
#include "sim/simd/exponential.h"
#include "sim/world/layers.h"
#include "sim/world/quanta.h"
#include "sim/world/state.h"

namespace sim::momentum {
namespace {

constexpr double kWidth = 7, kMostCells = 6;  // of σ: m, cells
constexpr double kSigmas = 3;                 // from the middle to where the weights end
constexpr double kWeightSteps = 2048;         // of 1

// Half of a Gaussian: w_1 … w_reach. They sum to less than ½.
std::vector<double> weights_of(double dx) {
    const double sigma = std::min(kWidth / dx, kMostCells);
    const auto of = [sigma](int k) {
        return double{
            sim::exp(static_cast<float>(-0.5 * k * k / (sigma * sigma)))};  // the same on every machine
    };
    const int reach = static_cast<int>(std::ceil(kSigmas * sigma));
    double sum = 1;
    for (int k = 1; k <= reach; ++k) sum += 2 * of(k);
    std::vector<double> weights;
    for (int k = 1; k <= reach; ++k) weights.push_back(std::round(of(k) / sum * kWeightSteps) / kWeightSteps);
    while (!weights.empty() && weights.back() == 0) weights.pop_back();
    return weights;
}

struct Rectangle {
    int x0, x1, y0, y1;  // vertices, x1 and y1 excluded
};

// A height of bedrock as a whole number of quanta: double's digits end at one quantum from 2³⁵ m on.
double whole(float metres) {
    constexpr double kEndsAtQuantum = 0x1.8p35;
    return (static_cast<double>(metres) + kEndsAtQuantum) - kEndsAtQuantum;
}
double whole(double metres) {
    return metres;
}

std::size_t work_for(int width, int height, std::size_t reach, const Grid& grid) {
    const auto rows =
        std::min(static_cast<std::size_t>(height) + 2 * reach, static_cast<std::size_t>(grid.ny));
    const auto columns =
        std::min(static_cast<std::size_t>(width) + 2 * reach, static_cast<std::size_t>(grid.nx));
    return rows * columns + static_cast<std::size_t>(width) * rows;
}

// Finds s of a rectangle of ground with this bedrock. `work` has work_for() values.
template <class Number>
void smooth_rectangle(Layers<Number>& layers, const Field<Number>& bedrock,
                      const std::vector<double>& weights, const Rectangle& of, double* work) {
    const int nx = layers.grid.nx, ny = layers.grid.ny, reach = static_cast<int>(weights.size());
    const Rectangle around{std::max(of.x0 - reach, 0), std::min(of.x1 + reach, nx),
                           std::max(of.y0 - reach, 0), std::min(of.y1 + reach, ny)};
    const int wide = around.x1 - around.x0, width = of.x1 - of.x0;
    double* const heights = work;
    double* const along_x = work + static_cast<std::ptrdiff_t>(wide) * (around.y1 - around.y0);
    for (int y = around.y0; y < around.y1; ++y) {
        double* h = heights + static_cast<std::ptrdiff_t>(wide) * (y - around.y0) - around.x0;
        for (int x = around.x0; x < around.x1; ++x)
            h[x] = whole(bedrock(x, y)) + static_cast<double>(layers.depth(x, y));
        double* to = along_x + static_cast<std::ptrdiff_t>(width) * (y - around.y0) - of.x0;
        std::copy(h + of.x0, h + of.x1, to + of.x0);
        for (int k = 1; k <= reach; ++k) {
            const double weight = weights[static_cast<std::size_t>(k - 1)];
            const int end = std::min(of.x1, nx - k);
            for (int x = std::max(of.x0, k); x < end; ++x)
                to[x] += weight * ((h[x + k] - h[x]) + (h[x - k] - h[x]));
        }
    }
    for (int y = of.y0; y < of.y1; ++y) {
        const auto row = [&](int at) {
            return along_x + static_cast<std::ptrdiff_t>(width) * (at - around.y0) - of.x0;
        };
        double* const sum = heights;  // no longer needed
        const double* here = row(y);
        std::copy(here + of.x0, here + of.x1, sum);
        for (int k = 1; k <= std::min({reach, y, ny - 1 - y}); ++k) {
            const double weight = weights[static_cast<std::size_t>(k - 1)];
            const double *south = row(y - k), *north = row(y + k);
            for (int x = of.x0; x < of.x1; ++x)
                sum[x - of.x0] += weight * ((north[x] - here[x]) + (south[x] - here[x]));
        }
        for (int x = of.x0; x < of.x1; ++x)
            layers.smooth_depth(x, y) =
                static_cast<Number>(sum[x - of.x0] - static_cast<double>(bedrock(x, y)));
    }
}

// Beyond the border the smoothed ground goes on as the bedrock does.
template <class Number>
void fill_halo(Layers<Number>& layers) {
    Field<Number>& s = layers.smooth_depth;
    const int nx = layers.grid.nx, ny = layers.grid.ny;
    for (int y = 0; y < ny; ++y) s(-1, y) = s(0, y), s(nx, y) = s(nx - 1, y);
    for (int x = -1; x <= nx; ++x) s(x, -1) = s(x, 0), s(x, ny) = s(x, ny - 1);
}

}  // namespace

GroundSmoother::GroundSmoother(const Grid& grid, int tile_width, int tile_height, int threads)
    : weights_(weights_of(grid.dx)),
      most_work_(
          work_for(std::min(tile_width, grid.nx), std::min(tile_height, grid.ny), weights_.size(), grid)),
      work_(most_work_ * static_cast<std::size_t>(threads)) {
    const int columns = (grid.nx + tile_width - 1) / tile_width,
              rows = (grid.ny + tile_height - 1) / tile_height;
    stale_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    tiles_.reserve(stale_.size());
}

void GroundSmoother::smooth(State& s, Workers& workers) {
    Tiles& tiles = s.tiles;
    const int reach = static_cast<int>(weights_.size());
    const int beside_x = (reach + tiles.width - 1) / tiles.width,
              beside_y = (reach + tiles.height - 1) / tiles.height;
    std::fill(stale_.begin(), stale_.end(), std::uint8_t{0});
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            if (!tiles.unsmoothed[tiles.number(column, row)]) continue;
            tiles.mark(stale_, std::max(column - beside_x, 0), std::min(column + beside_x, tiles.columns - 1),
                       std::max(row - beside_y, 0), std::min(row + beside_y, tiles.rows - 1));
        }
    tiles_.clear();
    for (std::size_t i = 0; i < stale_.size(); ++i)
        if (stale_[i]) tiles_.push_back(i), tiles.awake[i] = 1;
    std::fill(tiles.unsmoothed.begin(), tiles.unsmoothed.end(), std::uint8_t{0});

    const Field<float>& bedrock = s.things ? s.things->natural : s.bedrock;
    workers.each_member(static_cast<int>(tiles_.size()), [&](int member, int first, int last) {
        for (int i = first; i < last; ++i) {
            const int number = static_cast<int>(tiles_[static_cast<std::size_t>(i)]);
            const int x = number % tiles.columns * tiles.width, y = number / tiles.columns * tiles.height;
            smooth_rectangle(
                s, bedrock, weights_,
                {x, std::min(x + tiles.width, s.grid.nx), y, std::min(y + tiles.height, s.grid.ny)},
                work_.data() + static_cast<std::size_t>(member) * most_work_);
        }
    });
    fill_halo(s);
}

template <class Number>
void GroundSmoother::smooth_all(Layers<Number>& layers) {
    const Grid& grid = layers.grid;
    const std::vector<double> weights = weights_of(grid.dx);
    std::vector<double> work(work_for(grid.nx, grid.ny, weights.size(), grid));
    smooth_rectangle(layers, layers.bedrock, weights, {0, grid.nx, 0, grid.ny}, work.data());
    fill_halo(layers);
}

template void GroundSmoother::smooth_all(Layers<float>&);
template void GroundSmoother::smooth_all(Layers<double>&);

}  // namespace sim::momentum
