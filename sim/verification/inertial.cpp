#include <algorithm>
#include <cmath>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// Manufactured solutions of bcre-inertial: chosen answers, and the source terms that make them solutions.
// h(x, y) is constant in time; R, u and v are waves. A frame along the border is held at the answer.
//
//     q_h = Γ      q_R = ∂R/∂t + ∇·(R v) − Γ      q_v = ∂v/∂t + (v·∇)v − (v_eq − v)/τ + v max(Γ, 0)/R
//
// Two-dimensional, with every term active: advected momentum, a terminal velocity that follows ∇z and R, and
// erosion, whose material starts at rest, or deposition below its speed gate.

namespace sim::verification {
namespace {

constexpr double kSide = 1.6, kSeconds = 0.25, kDeep = 2;

// A value and its derivatives.
struct Smooth {
    double value, x, y, t;
};

// middle + swing · sin(a x + b y − c t)
Smooth wave(double middle, double swing, double a, double b, double c, double x, double y, double t) {
    const double phase = a * x + b * y - c * t;
    const double bend = swing * std::cos(phase);
    return {middle + swing * std::sin(phase), a * bend, b * bend, -c * bend};
}

Params numbers(bool erodes) {
    Params params = bare_params(Model::kBcreInertial, Scheme::kLocalLaxFriedrichs);
    params.exchange_rate = 2;
    params.speed_per_slope = 1;
    params.max_speed = 10;
    params.relaxation_time = 0.25f;
    params.half_speed_depth = 0.125f;
    params.deposit_speed = 1.5f;
    params.erosion_depth = 0.0625f;
    params.stop_slope_thick = erodes ? 0.25f : 1.25f;
    params.stop_slope = erodes ? 0.375f : 1.5f;
    params.stop_fold_depth = 0.25f;
    params.erosion_slope = erodes ? 0.5f : 2.f;
    return params;
}

struct Answer {
    const Params& params;
    double x, y, t;

    // h falls along both axes everywhere.
    static double standing(double at_x, double at_y) {
        return -0.75 * at_x - 0.5 * at_y + 0.02 * std::sin(4 * at_x) * std::cos(3 * at_y);
    }
    double standing_x() const { return -0.75 + 0.08 * std::cos(4 * x) * std::cos(3 * y); }
    double standing_y() const { return -0.5 - 0.06 * std::sin(4 * x) * std::sin(3 * y); }

    Smooth rolling() const { return wave(0.2, 0.05, 5, 4, 3, x, y, t); }
    Smooth u() const { return wave(0.6, 0.1, 4, -3, 2, x, y, t); }
    Smooth v() const { return wave(0.4, 0.08, -3, 5, 3, x, y, t); }

    double exchange() const {
        const double slope = std::hypot(standing_x(), standing_y()), r = rolling().value;
        const double stop = params.stop_slope_thick + (params.stop_slope - params.stop_slope_thick) *
                                                          std::exp(-r / params.stop_fold_depth);
        const double above = std::max(0., r - params.erosion_depth);
        const double gate = std::max(0., 1 - std::hypot(u().value, v().value) / params.deposit_speed);
        return params.exchange_rate * (above * above / r * std::max(0., slope - params.erosion_slope) -
                                       r * gate * std::max(0., stop - slope));
    }
    double rolling_source() const {
        const Smooth r = rolling(), a = u(), b = v();
        return r.t + (r.x * a.value + r.value * a.x) + (r.y * b.value + r.value * b.y) - exchange();
    }
    double velocity_source(const Smooth& of, double slope_of_standing, double slope_of_rolling) const {
        const double r = rolling().value;
        const double terminal = -params.speed_per_slope * (slope_of_standing + slope_of_rolling) * r /
                                (r + params.half_speed_depth);
        return of.t + u().value * of.x + v().value * of.y - (terminal - of.value) / params.relaxation_time +
               of.value * std::max(0., exchange()) / r;
    }
    double u_source() const { return velocity_source(u(), standing_x(), rolling().x); }
    double v_source() const { return velocity_source(v(), standing_y(), rolling().y); }
};

bool in_frame(double x, double y) {
    constexpr double kWide = 0.2;
    return x < kWide || y < kWide || x > kSide - kWide || y > kSide - kWide;
}

void set_to_answer(Layers<double>& layers, int x, int y, const Answer& answer) {
    layers.depth(x, y) = kDeep;
    layers.rolling(x, y) = answer.rolling().value;
    layers.velocity_x(x, y) = answer.u().value;
    layers.velocity_y(x, y) = answer.v().value;
}

template <class Visit>
void each_vertex(const Grid& grid, Visit&& visit) {
    const double dx = grid.dx;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) visit(x, y, x * dx, y * dx);
}

Layers<double> at_end(const Params& params, int n) {
    const Grid grid{n + 1, n + 1, static_cast<float>(kSide / n)};
    Trial trial(grid, params,
                {[](double x, double y) { return Answer::standing(x, y) - kDeep; },
                 [](double, double) { return kDeep; },
                 [&](double x, double y) {
                     return Answer{params, x, y, 0}.rolling().value;
                 }});
    Layers<double>& s = trial.layers;
    each_vertex(grid, [&](int x, int y, double at_x, double at_y) {
        set_to_answer(s, x, y, {params, at_x, at_y, 0});
    });
    trial.run(kSeconds, [&](double t, double dt) {
        each_vertex(grid, [&](int x, int y, double at_x, double at_y) {
            if (in_frame(at_x, at_y)) return set_to_answer(s, x, y, {params, at_x, at_y, t + dt / 2});
            const Answer answer{params, at_x, at_y, t};
            s.depth(x, y) += dt * answer.exchange();
            s.rolling(x, y) += dt * answer.rolling_source();
            s.velocity_x(x, y) += dt * answer.u_source();
            s.velocity_y(x, y) += dt * answer.v_source();
        });
    });
    return s;
}

std::vector<Series> compare(bool erodes, double most_depth, double most_speed) {
    const Params params = numbers(erodes);
    const Window middle{0.6, 1.2};
    Series depth{"bcre-inertial", "R, L1", most_depth, 1.8, {40, 80, 160}};
    Series speed{"bcre-inertial", "u, L1", most_speed, 1.8, {40, 80, 160}};
    for (const int n : depth.squares) {
        const Layers<double> s = at_end(params, n);
        const auto exact = [&](double x, double y) { return Answer{params, x, y, kSeconds}; };
        depth.errors.push_back(relative_l1(s.rolling, s.grid, middle, middle,
                                           [&](double x, double y) { return exact(x, y).rolling().value; }));
        speed.errors.push_back(relative_l1(s.velocity_x, s.grid, middle, middle,
                                           [&](double x, double y) { return exact(x, y).u().value; }));
    }
    return {depth, speed};
}

std::vector<Series> eroding() {
    return compare(true, 5.5e-5, 4.7e-5);
}
std::vector<Series> depositing() {
    return compare(false, 4.8e-5, 5.4e-5);
}

}  // namespace

extern const Case kEroding{"manufactured, with momentum, eroding", "h stays, R, u and v are waves", eroding};
extern const Case kDepositing{"manufactured, with momentum, depositing", "h stays, R, u and v are waves",
                              depositing};

}  // namespace sim::verification
