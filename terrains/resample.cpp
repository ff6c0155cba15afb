#include "terrains/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "sim/core/check.h"

namespace terrains {

tl::expected<sim::Grid, std::string> grid_over(double width, double height, const GridChoice& choice) {
    const int squares = choice.squares;
    if (squares < kFewestSquares || squares > kMostSquares)
        return tl::unexpected(fmt::format("a grid has {} to {} squares along its longer side, not {}",
                                          kFewestSquares, kMostSquares, squares));
    const double longer = std::max(width, height), shorter = std::min(width, height);
    const double exact = longer / squares;
    auto dx = static_cast<float>(exact);
    if (static_cast<double>(dx) > exact) dx = std::nextafter(dx, 0.f);
    // The 1e-6 gives a square raster equally many squares both ways.
    const int across = std::min(squares, static_cast<int>(std::floor(shorter / exact + 1e-6)));
    if (across < 2)
        return tl::unexpected(
            fmt::format("it is {:.6g} m by {:.6g} m: with {} squares along the longer side fewer "
                        "than 2 fit across",
                        width, height, squares));
    const int along_x = width >= height ? squares : across, along_y = width >= height ? across : squares;
    const sim::Grid grid{along_x + 1, along_y + 1, dx};
    if (choice.allowed)
        if (auto allowed = choice.allowed(grid); !allowed) return tl::unexpected(allowed.error());
    return grid;
}

PlaneFit::PlaneFit(const sim::Grid& grid, double reach_x, double reach_y, double point_area)
    : grid_(grid),
      reach_x_(reach_x),
      reach_y_(reach_y),
      full_weight_(reach_x * reach_y / point_area),
      sums_(grid.size()) {
    CHECK(reach_x > 0 && reach_y > 0 && point_area > 0);
}

template <class Visit>
void PlaneFit::for_vertices_near(double x, double y, Visit visit) {
    const double dx = grid_.dx;
    const int first_x = std::max(0, static_cast<int>(std::ceil(std::max(-1.0, (x - reach_x_) / dx))));
    const int first_y = std::max(0, static_cast<int>(std::ceil(std::max(-1.0, (y - reach_y_) / dx))));
    const int last_x = static_cast<int>(std::floor(std::min<double>(grid_.nx - 1, (x + reach_x_) / dx)));
    const int last_y = static_cast<int>(std::floor(std::min<double>(grid_.ny - 1, (y + reach_y_) / dx)));
    for (int j = first_y; j <= last_y; ++j)
        for (int i = first_x; i <= last_x; ++i) {
            const double u = (x - i * dx) / reach_x_, v = (y - j * dx) / reach_y_;
            const double weight = (1 - std::abs(u)) * (1 - std::abs(v));
            if (weight > 0) visit(sums_[static_cast<std::size_t>(j) * grid_.nx + i], u, v, weight);
        }
}

void PlaneFit::add(double x, double y, double height, double count) {
    for_vertices_near(x, y, [height, count](Sums& s, double u, double v, double tent) {
        const double weight = tent * count;
        s.all += weight;
        s.w += weight;
        s.x += weight * u;
        s.y += weight * v;
        s.xx += weight * u * u;
        s.xy += weight * u * v;
        s.yy += weight * v * v;
        s.z += weight * height;
        s.xz += weight * u * height;
        s.yz += weight * v * height;
    });
}

void PlaneFit::add_void(double x, double y, double count) {
    for_vertices_near(x, y, [count](Sums& s, double, double, double tent) { s.all += tent * count; });
}

// height = mean − slope · (offset of the points' centre). If the centre is the vertex itself, as on every
// regular raster away from its borders, the slope does not matter. If it matters but the points do not
// determine it, the vertex is unknown.
bool PlaneFit::solve(const Sums& s, double& height) {
    constexpr double kNoSpread = 1e-9;  // of the reach, squared: below it all points share one x or one y
    constexpr double kCentred = 1e-5;   // of the reach
    const double x = s.x / s.w, y = s.y / s.w, z = s.z / s.w;
    const double xx = s.xx / s.w - x * x, yy = s.yy / s.w - y * y, xy = s.xy / s.w - x * y;
    const double xz = s.xz / s.w - x * z, yz = s.yz / s.w - y * z;
    double slope_x = 0, slope_y = 0;
    const double determinant = xx * yy - xy * xy;
    if (xx > kNoSpread && yy > kNoSpread && determinant > 1e-6 * xx * yy) {
        slope_x = (xz * yy - yz * xy) / determinant;
        slope_y = (yz * xx - xz * xy) / determinant;
    } else if (xx > kNoSpread && std::abs(y) < kCentred && yy <= kNoSpread) {
        slope_x = xz / xx;
    } else if (yy > kNoSpread && std::abs(x) < kCentred && xx <= kNoSpread) {
        slope_y = yz / yy;
    } else if (std::abs(x) > kCentred || std::abs(y) > kCentred) {
        return false;
    }
    height = z - slope_x * x - slope_y * y;
    return true;
}

PlaneFit::Fitted PlaneFit::finish() const {
    constexpr double kKnownShare = 0.5;
    constexpr double kInsideShare = 0.2;  // a corner of the raster has a quarter of the full weight
    Fitted fitted{std::vector<float>(grid_.size()), std::vector<std::uint8_t>(grid_.size())};
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const Sums& s = sums_[i];
        double height = 0;
        if (s.w < kKnownShare * s.all || s.all < kInsideShare * full_weight_ || s.w <= 0) continue;
        if (!solve(s, height)) continue;
        fitted.surface[i] = static_cast<float>(height);
        fitted.has_data[i] = 1;
    }
    return fitted;
}

namespace {

constexpr std::array<std::pair<int, int>, 8> kAround{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

// The fill value of one vertex from its known neighbours; `straight_on` also extrapolates the slope where two
// known vertices follow each other.
double carried_on(const sim::Grid& grid, const std::vector<std::uint8_t>& known,
                  const std::vector<float>& surface, int x, int y, bool straight_on) {
    double nearby = 0, beyond = 0;
    int near_count = 0, beyond_count = 0;
    for (const auto& step : kAround) {
        const int step_x = step.first, step_y = step.second;
        const auto at = [&](int steps) {
            return static_cast<std::size_t>(y + steps * step_y) * grid.nx + (x + steps * step_x);
        };
        if (!grid.contains(x + step_x, y + step_y) || known[at(1)] == 0) continue;
        nearby += surface[at(1)];
        ++near_count;
        if (!straight_on || !grid.contains(x + 2 * step_x, y + 2 * step_y) || known[at(2)] == 0) continue;
        beyond += 2.0 * surface[at(1)] - surface[at(2)];
        ++beyond_count;
    }
    return beyond_count > 0 ? beyond / beyond_count : nearby / near_count;
}

// Unknown vertices with a known neighbour.
std::vector<std::size_t> next_ring(const sim::Grid& grid, const std::vector<std::uint8_t>& known,
                                   const std::vector<std::size_t>& last_ring) {
    std::vector<std::size_t> ring;
    for (const std::size_t i : last_ring)
        for (const auto& [step_x, step_y] : kAround) {
            const int x = static_cast<int>(i % grid.nx) + step_x, y = static_cast<int>(i / grid.nx) + step_y;
            const auto at = static_cast<std::size_t>(y) * grid.nx + x;
            if (grid.contains(x, y) && known[at] == 0) ring.push_back(at);
        }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    return ring;
}

}  // namespace

void fill_voids(const sim::Grid& grid, const std::vector<std::uint8_t>& has_data,
                std::vector<float>& surface) {
    CHECK(has_data.size() == grid.size() && surface.size() == grid.size());
    std::vector<std::uint8_t> known = has_data;
    std::vector<std::size_t> ring;
    for (std::size_t i = 0; i < known.size(); ++i)
        if (known[i] != 0) ring.push_back(i);
    CHECK(!ring.empty());
    bool straight_on = true;
    for (ring = next_ring(grid, known, ring); !ring.empty(); ring = next_ring(grid, known, ring)) {
        // A ring reads only earlier ones, so the order within it does not matter.
        for (const std::size_t i : ring)
            surface[i] = static_cast<float>(carried_on(grid, known, surface, static_cast<int>(i % grid.nx),
                                                       static_cast<int>(i / grid.nx), straight_on));
        for (const std::size_t i : ring) known[i] = 1;
        straight_on = false;
    }
}

}  // namespace terrains
