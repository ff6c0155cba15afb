#include <algorithm>
#include <cmath>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// Heaps in equilibrium with rain: what rains on a heap flows to the nearest edge of the table and off it,
// over a slope that is the stop slope everywhere. Steady answers (Hadeler and Kuttler 1999; Cannarsa and
// Cardaliaguet 2004): h = s · distance to the edge, and R from ∇·(R v) = f along the rays to it.

namespace sim::verification {
namespace {

constexpr double kStop = 0.5, kSpeed = 1, kRain = 0.1;  // 1, m/s, m/s of depth

Params table_params() {
    Params params = bare_params(Model::kBcre, Scheme::kLocalLaxFriedrichs);
    params.rolling_speed = static_cast<float>(kSpeed);
    params.stop_slope = static_cast<float>(kStop);
    params.exchange_rate = 100;              // so that thin layers near the top settle soon too
    params.start_slope = params.stop_slope;  // otherwise rain would stand on the very top
    params.borders.fill(Border::kSink);
    return params;
}

// Rains until nothing changes any more. The heap begins at nine tenths of its final height.
void rain(Trial& trial, double seconds) {
    trial.run(seconds, [&](double, double dt) {
        for (int y = 0; y < trial.layers.grid.ny; ++y)
            for (int x = 0; x < trial.layers.grid.nx; ++x)
                if (trial.layers.site(x, y) == Site::kGround) trial.layers.rolling(x, y) += kRain * dt;
    });
}

// Exact layers on one table.
struct Heap {
    Grid grid;
    Params params;
    Function has_data, standing, rolling;
};

std::vector<Series> compare(const std::vector<int>& squares, Series standing, Series rolling, double seconds,
                            const std::function<Heap(int)>& heap_of) {
    for (Series* series : {&standing, &rolling}) {
        series->scheme = to_string(Scheme::kLocalLaxFriedrichs);
        series->squares = squares;
    }
    for (const int n : squares) {
        const Heap heap = heap_of(n);
        const double side = heap.grid.dx * (n + 2);
        Trial trial(heap.grid, heap.params,
                    {[](double, double) { return 0; },
                     [&](double x, double y) { return 0.9 * std::max(0., heap.standing(x, y)); },
                     [](double, double) { return 0; }, heap.has_data});
        rain(trial, seconds);
        const auto on_table = [&](const Function& f) {
            return [&](double x, double y) { return heap.has_data(x, y) != 0 ? f(x, y) : 0; };
        };
        standing.errors.push_back(
            relative_l1(trial.layers.depth, heap.grid, {0, side}, {0, side}, on_table(heap.standing)));
        rolling.errors.push_back(
            relative_l1(trial.layers.rolling, heap.grid, {0, side}, {0, side}, on_table(heap.rolling)));
    }
    return {standing, rolling};
}

double everywhere(double, double) {
    return 1;
}

// Between two edges, one unit apart. The edges are the halo's vertices.
std::vector<Series> strip() {
    return compare({64, 128, 256}, {"", "h, L1", 1e-12, 0}, {"", "R, L1", 7.7e-3, 0.9}, 30, [](int n) {
        Heap heap{{n - 1, 3, 1.f / static_cast<float>(n)}, table_params(), everywhere, {}, {}};
        wall_sides(heap.params);
        const double dx = heap.grid.dx;
        heap.standing = [=](double x, double) { return kStop * std::min(x + dx, 1 - (x + dx)); };
        heap.rolling = [=](double x, double) { return kRain / kSpeed * std::fabs(x + dx - 0.5); };
        return heap;
    });
}

std::vector<Series> square() {
    return compare({20, 40, 80}, {"", "h, L1", 1.1e-3, 1.5}, {"", "R, L1", 4e-2, 0.9}, 20, [](int n) {
        Heap heap{{n - 1, n - 1, 1.f / static_cast<float>(n)}, table_params(), everywhere, {}, {}};
        const double dx = heap.grid.dx;
        const auto off = [=](double x,
                             double y) {  // from the middle: the greater and the lesser of |x|, |y|
            return std::minmax({std::fabs(x + dx - 0.5), std::fabs(y + dx - 0.5)});
        };
        heap.standing = [=](double x, double y) { return kStop * (0.5 - off(x, y).second); };
        heap.rolling = [=](double x, double y) {
            return kRain / kSpeed * (off(x, y).second - off(x, y).first);
        };
        return heap;
    });
}

// Compares h only: R, which is f r/2 except in the middle, did not converge with any scheme tried, because
// the rim is made of squares.
std::vector<Series> disk() {
    auto both = compare({20, 40, 80}, {"", "h, L1", 2.3e-2, 0.75}, {}, 20, [](int n) {
        Heap heap{{n + 1, n + 1, 1.f / static_cast<float>(n)}, table_params(), {}, {}, {}};
        const auto rim = [](double x, double y) { return 0.5 - std::hypot(x - 0.5, y - 0.5); };
        heap.has_data = [=](double x, double y) { return rim(x, y) > 0 ? 1 : 0; };
        heap.standing = [=](double x, double y) { return kStop * rim(x, y); };
        heap.rolling = everywhere;
        return heap;
    });
    return {both[0]};
}

}  // namespace

extern const Case kStrip{"table under rain", "h = s dist, R = f |x - 1/2| / v", strip};
extern const Case kSquare{"square table under rain", "h = s dist, R = f (max - min of |x|, |y|) / v", square};
extern const Case kDisk{"disk under rain", "h = s (a - r)", disk};

}  // namespace sim::verification
