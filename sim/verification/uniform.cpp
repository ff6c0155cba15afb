#include <algorithm>
#include <cmath>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// A uniform layer on a plane, far from borders: the equations become ordinary differential equations.

namespace sim::verification {
namespace {

constexpr int kSquares = 320;  // so that no influence of the borders reaches the middle in 160 sub-steps
constexpr double kSide = 1;

// The state of the middle vertex after `seconds`, on a plane with slope `tangent` along x under uniform
// layers.
struct Middle {
    double depth, rolling, velocity;
};

Middle after(Params params, double tangent, double depth, double rolling, double velocity, double seconds,
             int substeps) {
    wall_sides(params);
    Trial trial(column(kSquares, kSide), params,
                {[=](double x, double) { return -tangent * x; }, [=](double, double) { return depth; },
                 [=](double, double) { return rolling; }});
    trial.layers.velocity_x.fill(velocity);
    trial.run_in(substeps, seconds);
    constexpr int kAt = kSquares / 2;
    return {trial.layers.depth(kAt, 1), trial.layers.rolling(kAt, 1), trial.layers.velocity_x(kAt, 1)};
}

constexpr double kTangent = 0.75, kStop = 0.5;

Params growing(Scheme scheme) {
    Params params = bare_params(Model::kBcre, scheme);
    params.rolling_speed = 0.0625f;
    params.stop_slope = static_cast<float>(kStop);
    params.exchange_rate = 4;
    return params;
}

// γ p = 1/s: R grows as e^t until the ground is used up.
std::vector<Series> growth() {
    constexpr double kLayer = 1e-3, kGround = 2e-3;
    std::vector<Series> table;
    for (const Scheme scheme : {Scheme::kLaxFriedrichs, Scheme::kLocalLaxFriedrichs}) {
        Series grows{to_string(scheme), "R at 1 s", 1e-13, 0, {kSquares}};
        Series ends{to_string(scheme), "R at 2 s", 1e-13, 0, {kSquares}};
        const auto rolling = [&](double t) {
            return after(growing(scheme), kTangent, kGround, kLayer, 0, t, static_cast<int>(64 * t)).rolling;
        };
        grows.errors.push_back(std::fabs(rolling(1) / (kLayer * std::exp(1.)) - 1));
        ends.errors.push_back(std::fabs(rolling(2) / (kLayer + kGround) - 1));
        table.push_back(grows);
        table.push_back(ends);
    }
    Series second{to_string(Scheme::kMuscl), "R at 1 s", 6e-5, 1.9, {16, 32, 64}};  // sub-steps per second
    for (const int n : second.squares)
        second.errors.push_back(std::fabs(
            after(growing(Scheme::kMuscl), kTangent, 1, kLayer, 0, 1, n).rolling / (kLayer * std::exp(1.)) -
            1));
    table.push_back(second);
    return table;
}

// The known defect of lax-friedrichs, as large as theory says: a layer at rest spreads by dx²/4 Δt along each
// axis, which is half a cell squared per sub-step. The local scheme does not move it.
std::vector<Series> resting_layer() {
    std::vector<Series> table;
    for (const Scheme scheme : {Scheme::kLaxFriedrichs, Scheme::kLocalLaxFriedrichs, Scheme::kMuscl}) {
        Params params = bare_params(Model::kBcre, scheme);
        params.exchange_rate = 0;
        params.rolling_speed = 0;
        params.start_slope = 0;  // otherwise it would stand and freeze
        constexpr int kMiddle = 20, kSteps = 16;
        const Grid grid{2 * kMiddle + 1, 2 * kMiddle + 1, 1};
        Trial trial(grid, params,
                    {[](double, double) { return 0; }, [](double, double) { return 0; },
                     [&](double x, double y) { return std::hypot(x - kMiddle, y - kMiddle) < 0.5 ? 1 : 0; }});
        trial.run_in(kSteps, kSteps);
        double variance = 0;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x)
                variance += trial.layers.rolling(x, y) * (x - kMiddle) * (x - kMiddle);
        const double expected = scheme == Scheme::kLaxFriedrichs ? kSteps / 2. : 0.;
        table.push_back(
            {to_string(scheme), "spread, cells2", 1e-6, 0, {2 * kMiddle}, {std::fabs(variance - expected)}});
    }
    return table;
}

}  // namespace

extern const Case kGrowth{"uniform growth, saturation", "R = R0 exp(g p t), ends at R0 + d0", growth};
extern const Case kRestingLayer{"spread of a layer at rest",
                                "lax-friedrichs dx2/4dt along each axis, the others none", resting_layer};

}  // namespace sim::verification
