#include "sim/weather/work.h"

#include <algorithm>
#include <numeric>

#include "sim/world/state.h"

namespace sim::weather {
namespace {

constexpr float kAllStays = 1, kLeastStays = 0.1f;  // share of a snowfall up to 45°, and from 60° on
constexpr float kMostShare = 3;                     // what falls from above on top of that is blown away
constexpr double kHeightWithin = 100;               // m

// Snow does not stay on steep rock: what slides off lies at the lower neighbours, from high to low. Each vertex gathers
// from its neighbours in pairs, so that a mirrored or turned world is the mirrored or turned world.
void find_share(const Field<float>& ground, const Grid& grid, Field<float>& share) {
    const int nx = grid.nx, ny = grid.ny;
    std::vector<std::int32_t> order(grid.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return ground(a % nx, a / nx) > ground(b % nx, b / nx);
    });
    Field<float> per_fall(grid);  // what slides off a vertex, per metre of fall to a neighbour
    for (const std::int32_t i : order) {
        const int x = i % nx, y = i / nx;
        const float here = ground(x, y);
        const int west = std::max(x - 1, 0), east = std::min(x + 1, nx - 1);
        const int south = std::max(y - 1, 0), north = std::min(y + 1, ny - 1);
        const auto from = [&](int u, int v) { return std::max(ground(u, v) - here, 0.f) * per_fall(u, v); };
        const auto fall = [&](int u, int v) { return std::max(here - ground(u, v), 0.f); };
        const float comes = kAllStays + ((from(west, y) + from(east, y)) + (from(x, south) + from(x, north)));
        const auto tangent = [&](float rise, int cells) {
            return rise / (static_cast<float>(std::max(cells, 1)) * grid.dx);
        };
        const float along_x = tangent(ground(east, y) - ground(west, y), east - west),
                    along_y = tangent(ground(x, north) - ground(x, south), north - south);
        const float steep = along_x * along_x + along_y * along_y;  // 1 at 45°, 3 at 60°
        const float all = (fall(west, y) + fall(east, y)) + (fall(x, south) + fall(x, north));
        const float stays = all > 0 ? std::clamp(kAllStays - (kAllStays - kLeastStays) * (steep - 1) / 2,
                                                 kLeastStays, kAllStays)
                                    : kAllStays;
        share(x, y) = std::min(comes * stays, kMostShare);
        if (stays < kAllStays) per_fall(x, y) = comes * (1 - stays) / all;
    }
}

// A box mean, along x and then y. Heights in whole quanta, so that sums in double are exact in any order.
void find_mean_height(const Field<float>& ground, const Grid& grid, Field<float>& mean) {
    const int reach = std::max(1, static_cast<int>(kHeightWithin / static_cast<double>(grid.dx)));
    const auto whole = [](float metres) {
        constexpr double kEndsAtQuantum = 0x1.8p35;
        return (static_cast<double>(metres) + kEndsAtQuantum) - kEndsAtQuantum;
    };
    const auto nx = static_cast<std::size_t>(grid.nx);
    // Sums of whole columns within reach of a row, which moves north.
    std::vector<double> columns(nx), up_to(nx + 1);
    const auto add_row = [&](int y, double times) {
        if (y < 0 || y >= grid.ny) return;
        for (std::size_t x = 0; x < nx; ++x) columns[x] += times * whole(ground(static_cast<int>(x), y));
    };
    for (int y = 0; y < reach; ++y) add_row(y, 1);
    for (int y = 0; y < grid.ny; ++y) {
        add_row(y + reach, 1);
        add_row(y - reach - 1, -1);
        const int rows = std::min(y + reach, grid.ny - 1) - std::max(y - reach, 0) + 1;
        std::partial_sum(columns.begin(), columns.end(), up_to.begin() + 1);
        for (int x = 0; x < grid.nx; ++x) {
            const int first = std::max(x - reach, 0), end = std::min(x + reach, grid.nx - 1) + 1;
            mean(x, y) = static_cast<float>(
                (up_to[static_cast<std::size_t>(end)] - up_to[static_cast<std::size_t>(first)]) /
                (static_cast<double>(rows) * (end - first)));
        }
    }
}

}  // namespace

Work::Work(const State& s, int threads)
    : share(s.grid),
      mean_height(s.grid),
      gradient_x(s.grid),
      gradient_y(s.grid),
      over(s.grid),
      wind(s.grid),
      stability(s.grid),
      fallen(static_cast<std::size_t>(threads)),
      melted(static_cast<std::size_t>(threads)),
      crack(s.grid.size()) {
    find_share(s.things->natural, s.grid, share);
    find_mean_height(s.things->natural, s.grid, mean_height);
    for (Drifting* row : {&before, &now})
        for (std::vector<std::int32_t>* part : {&row->straight, &row->aside})
            part->resize(static_cast<std::size_t>(s.grid.nx) + 2);
    cracked.reserve(s.grid.size());
    piece.reserve(s.grid.size());
}

}  // namespace sim::weather
