#include <cmath>
#include <limits>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// Exchange of bcre-inertial under a uniform layer on a plane, far from borders: ordinary differential equations.

namespace sim::verification {
namespace {

constexpr int kSquares = 160;
constexpr float kCell = 5;  // m, so that nothing of the borders reaches the middle

struct Middle {
    double rolling, velocity;
};

// The middle vertex after `seconds`, on a plane that falls along x by `slope`.
Middle after(Params params, double slope, double rolling, double velocity, double seconds, int substeps) {
    wall_sides(params);
    Trial trial(column(kSquares, kSquares * double{kCell}), params,
                {[=](double x, double) { return -slope * x; }, [](double, double) { return 10; },
                 [=](double, double) { return rolling; }});
    trial.layers.velocity_x.fill(velocity);
    trial.run_in(substeps, seconds);
    return {trial.layers.rolling(kSquares / 2, 1), trial.layers.velocity_x(kSquares / 2, 1)};
}

// Neither starts nor rests, erodes nor deposits; hardly any drag.
Params sliding(double friction) {
    Params params = bare_params(Model::kBcreInertial, Scheme::kLocalLaxFriedrichs);
    params.friction = params.friction_thin = static_cast<float>(friction);
    params.drag = std::numeric_limits<float>::infinity();
    params.erosion_rate = params.deposit_rate = 0;
    params.erosion_slope = params.loose_slope = 1e6f;
    params.erosion_depth = 0;
    return params;
}

// R grows by k (S − s_ero) per metre of way, and what is eroded joins at rest. Without friction
// (R v)² = 2 a (R³ − R₀³)/(3 k (S − s_ero)), a = g sin θ cos θ.
std::vector<Series> entraining() {
    constexpr double kSlope = 0.75, kRate = 0.125, kBeyond = 0.25, kThick = 0.5, kSeconds = 4;
    Params params = sliding(0);
    params.erosion_rate = static_cast<float>(kRate);
    params.erosion_slope = static_cast<float>(kSlope - kBeyond);
    const double pull = kGravity * kSlope / (1 + kSlope * kSlope);
    Series speed{"bcre-inertial", "v of R at 4 s", 6e-3, 0.9, {60, 120, 240}};  // sub-steps
    for (const int substeps : speed.squares) {
        const Middle end = after(params, kSlope, kThick, 0, kSeconds, substeps);
        const double cubes = std::pow(end.rolling, 3) - std::pow(kThick, 3);
        const double momentum = std::sqrt(2 * pull * cubes / (3 * kRate * kBeyond));
        speed.errors.push_back(std::fabs(end.velocity * end.rolling / momentum - 1));
    }
    return {speed};
}

// Slower than v_dep on a slope below its friction: v = v₀ − a t, a = g cos²θ (μ cos²θ⁻¹ …) from the block on a
// plane, and R = R₀ e^{−γ (μ − S)(t − (v₀ t − a t²/2)/v_dep)}. The rest keeps its speed.
std::vector<Series> depositing() {
    constexpr double kSlope = 0.25, kFriction = 0.375, kRate = 2, kSpeed = 3, kGate = 4, kThick = 0.5,
                     kSeconds = 1;
    Params params = sliding(kFriction);
    params.deposit_rate = static_cast<float>(kRate);
    params.deposit_speed = static_cast<float>(kGate);
    const double angle = std::atan(kSlope);
    const double slows = kGravity * (kFriction * std::cos(angle) - std::sin(angle)) * std::cos(angle);
    const double gate = kSeconds - (kSpeed * kSeconds - slows * kSeconds * kSeconds / 2) / kGate;
    const double left = kThick * std::exp(-kRate * (kFriction - kSlope) * gate);
    Series layer{"bcre-inertial", "R at 1 s", 2e-3, 0.9, {15, 30, 60}};  // sub-steps
    Series speed{"bcre-inertial", "v at 1 s", 1e-9, 0, {kSquares}};
    Middle end{};
    for (const int substeps : layer.squares) {
        end = after(params, kSlope, kThick, kSpeed, kSeconds, substeps);
        layer.errors.push_back(std::fabs(end.rolling / left - 1));
    }
    speed.errors.push_back(std::fabs(end.velocity / (kSpeed - slows * kSeconds) - 1));
    return {layer, speed};
}

// A film holds if h ≤ h_fold ln((μ_thin − μ)/(tan θ − μ)): 1 % below it rests exactly, 1 % above it moves.
std::vector<Series> film() {
    constexpr double kSlope = 0.5, kFriction = 0.25, kThin = 1, kFold = 0.125;
    Params params = sliding(kFriction);
    params.friction_thin = static_cast<float>(kThin);
    params.friction_fold_depth = static_cast<float>(kFold);
    const double holds = kFold * std::log((kThin - kFriction) / (kSlope - kFriction)) * std::hypot(1, kSlope);
    const double below = after(params, kSlope, 0.99 * holds, 0, 1, 16).velocity;
    const double above = after(params, kSlope, 1.01 * holds, 0, 1, 16).velocity;
    return {{"bcre-inertial", "v of a film", 0, 0, {kSquares}, {below + (above > 0 ? 0. : 1.)}}};
}

}  // namespace

extern const Case kEntraining{"entrainment on a plane", "(R v)2 = 2 a (R3 - R03)/(3 k (S - s))", entraining};
extern const Case kDepositing{"deposition on a plane", "R = R0 exp(-g (mu - S)(t - x/vdep)), v stays",
                              depositing};
extern const Case kFilm{"a film that holds", "hfold ln((mu_thin - mu)/(tan a - mu))", film};

}  // namespace sim::verification
