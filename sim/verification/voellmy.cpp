#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// voellmy on planes, far from borders: a uniform layer is a sliding block with drag.

namespace sim::verification {
namespace {

constexpr std::array kAnglesDeg{20., 35., 50.};

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

Params numbers(double friction, double drag = std::numeric_limits<double>::infinity()) {
    Params params = bare_params(Model::kVoellmy, Scheme::kLocalLaxFriedrichs);
    params.friction = static_cast<float>(friction);
    params.drag = static_cast<float>(drag);
    return params;
}

struct Vector {
    double x, y;
};

// The plan velocity of the middle vertex on a plane that falls toward `azimuth`, after `substeps` sub-steps. Too
// few of them for any influence of the borders.
Vector middle_after(const Params& params, double angle, double azimuth, double rolling, double speed,
                    double seconds, int substeps) {
    constexpr int kSquares = 160, kMiddle = kSquares / 2;
    const double tangent = std::tan(angle), x = std::cos(azimuth), y = std::sin(azimuth);
    Trial trial({kSquares + 1, kSquares + 1, 5}, params,
                {[=](double at_x, double at_y) { return -tangent * (at_x * x + at_y * y); },
                 [](double, double) { return 1; }, [=](double, double) { return rolling; }});
    trial.layers.velocity_x.fill(speed * x);
    trial.layers.velocity_y.fill(speed * y);
    trial.run_in(substeps, seconds);
    return {trial.layers.velocity_x(kMiddle, kMiddle), trial.layers.velocity_y(kMiddle, kMiddle)};
}

// The greatest relative error over slopes and orientations, of a block that starts from rest.
std::vector<Series> sliding(double friction, std::string_view measure) {
    Series series{"voellmy", measure, 1e-12, 0, {160}, {0}};
    for (const double angle_deg : kAnglesDeg)
        for (const double azimuth_deg : {0., 30., 45.}) {
            constexpr double kSeconds = 1;
            const double angle = radians(angle_deg), azimuth = radians(azimuth_deg);
            const float mu = static_cast<float>(friction);
            const double speed = kGravity * (std::sin(angle) - static_cast<double>(mu) * std::cos(angle)) *
                                 std::cos(angle) * kSeconds;
            const Vector v = middle_after(numbers(friction), angle, azimuth, 1, 0, kSeconds, 16);
            series.errors[0] = std::max(
                series.errors[0],
                std::hypot(v.x - speed * std::cos(azimuth), v.y - speed * std::sin(azimuth)) / speed);
        }
    return {series};
}
std::vector<Series> free_slab() {
    return sliding(0, "v at 1 s");
}
std::vector<Series> coulomb_slab() {
    return sliding(0.25, "v at 1 s");
}

// On the flat: v falls by μ g t to exactly 0. It stops after v²/2 μ g, here the sum of what each sub-step moves.
std::vector<Series> stopping() {
    constexpr double kSpeed = 4, kFriction = 0.25;
    const Params params = numbers(kFriction);
    Series speed{"voellmy", "v at 1 s", 1e-12, 0, {160}};
    speed.errors.push_back(
        std::fabs(middle_after(params, 0, 0, 1, kSpeed, 1, 16).x / (kSpeed - kFriction * kGravity) - 1));
    Series rest{"voellmy", "v at 2 s", 0, 0, {160}};
    rest.errors.push_back(std::fabs(middle_after(params, 0, 0, 1, kSpeed, 2, 16).x));
    Series distance{"voellmy", "way to rest", 0.02, 0.95, {8, 16, 32}};  // sub-steps per second
    for (const int n : distance.squares) {
        double way = 0;
        for (int i = 1; i <= 2 * n && i <= 64; ++i)
            way += middle_after(params, 0, 0, 1, kSpeed, static_cast<double>(i) / n, i).x / n;
        distance.errors.push_back(std::fabs(way / (kSpeed * kSpeed / (2 * kFriction * kGravity)) - 1));
    }
    return {speed, rest, distance};
}

// Along the slope: v = v∞ tanh(t/τ), v∞ = √(ξ h (sin θ − μ cos θ)), τ = ξ h/(g v∞), h normal to the slope.
std::vector<Series> terminal() {
    constexpr double kFriction = 0.25, kDrag = 500, kRolling = 1;
    const Params params = numbers(kFriction, kDrag);
    Series stays{"voellmy", "v at terminal", 1e-12, 0, {160}, {0}};
    for (const double angle_deg : kAnglesDeg) {
        const double angle = radians(angle_deg), normal = kRolling * std::cos(angle);
        const double end = std::sqrt(kDrag * normal * (std::sin(angle) - kFriction * std::cos(angle)));
        const double plan = end * std::cos(angle);
        const Vector v = middle_after(params, angle, radians(30), kRolling, plan, 1, 16);
        stays.errors[0] = std::max(stays.errors[0], std::fabs(std::hypot(v.x, v.y) / plan - 1));
    }
    Series gathers{"voellmy", "v at 2 s", 1e-4, 1.9, {4, 8, 16}};  // sub-steps per second
    const double angle = radians(35), normal = kRolling * std::cos(angle);
    const double end = std::sqrt(kDrag * normal * (std::sin(angle) - kFriction * std::cos(angle)));
    const double exact = end * std::tanh(2 * kGravity * end / (kDrag * normal)) * std::cos(angle);
    for (const int n : gathers.squares)
        gathers.errors.push_back(
            std::fabs(middle_after(params, angle, 0, kRolling, 0, 2, 2 * n).x / exact - 1));
    return {stays, gathers};
}

// v∞ = √(ξ h^(1 + p) (sin θ − μ cos θ)) along the slope, of layers of other thicknesses.
std::vector<Series> terminal_by_thickness() {
    constexpr double kFriction = 0.25, kDrag = 1208, kExponent = 0.375;
    Params params = numbers(kFriction, kDrag);
    params.drag_exponent = static_cast<float>(kExponent);
    Series stays{"voellmy", "v at terminal", 1e-12, 0, {160}, {0}};
    for (const double rolling : {0.25, 1., 4.})
        for (const double angle_deg : kAnglesDeg) {
            const double angle = radians(angle_deg), normal = rolling * std::cos(angle);
            const double end = std::sqrt(kDrag * std::pow(normal, 1 + kExponent) *
                                         (std::sin(angle) - kFriction * std::cos(angle)));
            const double plan = end * std::cos(angle);
            const Vector v = middle_after(params, angle, radians(30), rolling, plan, 1, 16);
            stays.errors[0] = std::max(stays.errors[0], std::fabs(std::hypot(v.x, v.y) / plan - 1));
        }
    return {stays};
}

// Along the slope: dv/dt = g (sin θ − μ cos θ (1 + f N h/(f N h + v²))), N h = g cos θ h, integrated finely.
std::vector<Series> fluidized() {
    constexpr double kFriction = 0.25, kRolling = 1, kSeconds = 2;
    const float f = 0.222f;
    Params params = numbers(kFriction);
    params.fluidization = f;
    const double angle = radians(35),
                 pressed = static_cast<double>(f) * kGravity * kRolling * std::cos(angle) * std::cos(angle);
    const auto gains = [&](double v) {
        return kGravity * (std::sin(angle) - kFriction * std::cos(angle) * (1 + pressed / (pressed + v * v)));
    };
    double exact = 0;
    constexpr int kFine = 100000;
    for (int i = 0; i < kFine; ++i) {
        const double dt = kSeconds / kFine;
        exact += dt * gains(exact + dt / 2 * gains(exact));
    }
    Series series{"voellmy", "v at 2 s", 4e-3, 0.95, {32, 64, 128}};  // sub-steps
    for (const int n : series.squares)
        series.errors.push_back(std::fabs(
            middle_after(params, angle, 0, kRolling, 0, kSeconds, n).x / (exact * std::cos(angle)) - 1));
    return {series};
}

// v = g (sin θ − cos θ (μ + (1 − μ)(1 − e^(−x))/x)) t along the slope, x = h cos θ/h_c; what is thin does not move.
std::vector<Series> cohesive() {
    constexpr double kFriction = 0.25, kSeconds = 1;
    const float depth = 0.05f;
    Params params = numbers(kFriction);
    params.cohesion_depth = depth;
    const auto pull = [&](double angle, double rolling) {
        const double x = rolling * std::cos(angle) * std::cos(angle) / static_cast<double>(depth);
        const double friction = kFriction + (1 - kFriction) * -std::expm1(-x) / x;
        return kGravity * (std::sin(angle) - friction * std::cos(angle)) * std::cos(angle);
    };
    Series speed{"voellmy", "v at 1 s", 1e-12, 0, {160}, {0}},
        rest{"voellmy", "v of a film", 0, 0, {160}, {0}};
    for (const double angle_deg : kAnglesDeg) {
        const double angle = radians(angle_deg), exact = pull(angle, 1) * kSeconds;
        const Vector v = middle_after(params, angle, radians(30), 1, 0, kSeconds, 16);
        speed.errors[0] = std::max(speed.errors[0], std::fabs(std::hypot(v.x, v.y) / exact - 1));
    }
    // The film that just holds on 20 degrees.
    double holds = 0, goes = 1;
    for (int i = 0; i < 60; ++i)
        (pull(radians(20), (holds + goes) / 2) < 0 ? holds : goes) = (holds + goes) / 2;
    rest.errors[0] = std::fabs(middle_after(params, radians(20), 0, 0.99 * holds, 0, kSeconds, 16).x);
    Series moves{"voellmy", "v of a thicker film", 1e-12, 0, {160}};
    moves.errors.push_back(std::fabs(middle_after(params, radians(20), 0, 1.01 * holds, 0, kSeconds, 16).x /
                                         (pull(radians(20), 1.01 * holds) * kSeconds) -
                                     1));
    return {speed, rest, moves};
}

}  // namespace

extern const Case kFreeSlab{"slab on a plane, no friction, 20, 35, 50 deg, at 0, 30, 45 deg to the grid",
                            "v = g sin a cos a t in plan", free_slab};
extern const Case kCoulombSlab{"slab on a plane, Coulomb friction, same planes",
                               "v = g (sin a - m cos a) cos a t in plan", coulomb_slab};
extern const Case kStopping{"layer on the flat, Coulomb friction", "v = v0 - m g t, stops after v0^2/2 m g",
                            stopping};
extern const Case kVoellmyTerminal{"terminal speed with drag", "v = sqrt(xi h (sin a - m cos a)) tanh(t/tau)",
                                   terminal};
extern const Case kThickDrag{"terminal speed with drag that falls with thickness, xi h^(3/8)",
                             "v = sqrt(xi h^(11/8) (sin a - m cos a))", terminal_by_thickness};
extern const Case kFluidized{"slab on a plane of 35 deg whose friction falls with its speed",
                             "dv/dt = g (sin a - m cos a (1 + f N h/(f N h + v^2)))", fluidized};
extern const Case kCohesive{"slab on a plane with cohesion, 20, 35, 50 deg, and a film that holds",
                            "v = g (sin a - cos a (m + (1 - m)(1 - exp(-x))/x)) t", cohesive};

}  // namespace sim::verification
