#include <cmath>
#include <numbers>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// A manufactured solution: a chosen answer, and the source terms that make it a solution. h(x, y) is constant
// in time; R(x, y, t) is a wave. A frame along the border is held at the answer, inflow included.
//
//     q_h = Γ      q_R = ∂R/∂t + ∇·(R v) − Γ      Γ = γ R (|∇h| − s)      v = −μ ∇h  (law HK)
//
// Two-dimensional, with every term of the equations active.

namespace sim::verification {
namespace {

constexpr double kSide = 1.6, kSeconds = 0.25, kMobility = 1, kRate = 2, kStop = 0.5, kDeep = 2;

struct Answer {
    double t = 0;

    // h falls along both axes everywhere.
    static double standing(double x, double y) {
        return -0.75 * x - 0.5 * y + 0.02 * std::sin(4 * x) * std::cos(3 * y);
    }
    static double standing_x(double x, double y) { return -0.75 + 0.08 * std::cos(4 * x) * std::cos(3 * y); }
    static double standing_y(double x, double y) { return -0.5 - 0.06 * std::sin(4 * x) * std::sin(3 * y); }
    static double laplacian(double x, double y) { return -25 * 0.02 * std::sin(4 * x) * std::cos(3 * y); }

    double phase(double x, double y) const { return 5 * x + 4 * y - 3 * t; }
    double rolling(double x, double y) const { return 0.1 + 0.03 * std::sin(phase(x, y)); }

    double exchange(double x, double y) const {
        return kRate * rolling(x, y) * (std::hypot(standing_x(x, y), standing_y(x, y)) - kStop);
    }
    double rolling_source(double x, double y) const {
        const double slope = 0.03 * std::cos(phase(x, y));  // of R along its phase
        const double divergence = -kMobility * (5 * slope * standing_x(x, y) + 4 * slope * standing_y(x, y) +
                                                rolling(x, y) * laplacian(x, y));
        return -3 * slope + divergence - exchange(x, y);
    }
};

bool in_frame(double x, double y) {
    constexpr double kWide = 0.2;
    return x < kWide || y < kWide || x > kSide - kWide || y > kSide - kWide;
}

std::vector<Series> manufactured() {
    constexpr std::array<Bounds, 3> kBounds{{{2.2e-2, 0.9}, {5.4e-3, 0.9}, {4.4e-4, 1.75}}};
    return of_each_scheme({40, 80, 160}, kBounds, [&](Scheme scheme, int n) {
        Params params = bare_params(Model::kBcre, scheme);
        params.law = Law::kSlope;
        params.speed_per_slope = static_cast<float>(kMobility);
        params.exchange_rate = static_cast<float>(kRate);
        params.stop_slope = static_cast<float>(kStop);
        const Grid grid{n + 1, n + 1, static_cast<float>(kSide / n)};
        const double dx = grid.dx;
        Trial trial(grid, params,
                    {[](double x, double y) { return Answer::standing(x, y) - kDeep; },
                     [](double, double) { return kDeep; },
                     [](double x, double y) { return Answer{0}.rolling(x, y); }});
        trial.run(kSeconds, [&](double t, double dt) {
            const Answer answer{t}, after{t + dt / 2};
            for (int y = 0; y < grid.ny; ++y)
                for (int x = 0; x < grid.nx; ++x) {
                    const double at_x = x * dx, at_y = y * dx;
                    double &d = trial.layers.depth(x, y), &r = trial.layers.rolling(x, y);
                    if (in_frame(at_x, at_y)) {
                        d = kDeep;
                        r = after.rolling(at_x, at_y);
                    } else {
                        d += dt * answer.exchange(at_x, at_y);
                        r += dt * answer.rolling_source(at_x, at_y);
                    }
                }
        });
        const Answer end{kSeconds};
        return relative_l1(trial.layers.rolling, grid, {0.6, 1.2}, {0.6, 1.2},
                           [&](double x, double y) { return end.rolling(x, y); });
    });
}

}  // namespace

extern const Case kManufactured{"manufactured, two-dimensional", "h stays, R = 0.1 + 0.03 sin(5x + 4y - 3t)",
                                manufactured};

}  // namespace sim::verification
