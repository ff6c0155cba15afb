#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// voellmy over bends, and under the pressure of its own layer.

namespace sim::verification {
namespace {

constexpr double kGravity = 9.81;

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

Params numbers(double friction) {
    Params params = bare_params(Model::kVoellmy, Scheme::kLocalLaxFriedrichs);
    params.friction = static_cast<float>(friction);
    params.drag = std::numeric_limits<float>::infinity();
    wall_sides(params);
    return params;
}

constexpr auto kNoCover = [](double, double) { return 0.; };

// Σ R f / Σ R over the middle row; f of x, m, and of the vertex.
double mean_of(const Layers<double>& s, const std::function<double(double x, int i)>& f) {
    double sum = 0, all = 0;
    for (int i = 0; i < s.grid.nx; ++i) {
        all += s.rolling(i, 1);
        sum += s.rolling(i, 1) * f(i * static_cast<double>(s.grid.dx), i);
    }
    return sum / all;
}

// A slope, an arc of a circle that eases it, and flat ground from x = 0 on. Level 0 is the flat.
struct Ramp {
    double angle, radius;
    double arc_begins() const { return -radius * std::sin(angle); }
    double height(double x) const {
        if (x >= 0) return 0;
        if (x >= arc_begins()) return radius - std::sqrt(radius * radius - x * x);
        return radius * (1 - std::cos(angle)) + (arc_begins() - x) * std::tan(angle);
    }
    // v²/2 along the slope at the end of the arc, with v²/2 = `before` at its beginning, Coulomb friction, and the
    // centrifugal force in it: the solution of dE/dθ = 2 μ E − r g (sin θ − μ cos θ).
    double energy_after(double before, double mu) const {
        const double a = radius * kGravity * (1 - 2 * mu * mu) / (1 + 4 * mu * mu);
        const double b = mu * (radius * kGravity + 2 * a);
        const double c = (before - a * std::cos(angle) - b * std::sin(angle)) * std::exp(-2 * mu * angle);
        return c + a;
    }
};

// A thin blob, whose own pressure hardly counts, slides down a ramp. Energies are linear in where a part of it
// starts, so that the mean over the blob is that of its centre. Compares v²/2, and what friction took on the flat.
double ramp_error(const Ramp& ramp, double mu, int squares) {
    constexpr double kLength = 800, kFlat = 250, kHalf = 25, kThick = 1e-3;
    const double begins = ramp.arc_begins() - 170;
    const auto at = [=](double x) { return x - (kLength - kFlat); };  // coordinate of the ramp
    Trial trial(column(squares, kLength), numbers(mu),
                {[&](double x, double) { return ramp.height(at(x)); }, kNoCover,
                 [&](double x, double) {
                     const double off = (at(x) - begins) / kHalf;
                     return std::fabs(off) < 1 ? kThick * (1 - off * off) * (1 - off * off) : 0;
                 }});
    const double start = mean_of(trial.layers, [&](double x, int) { return at(x); });
    const double along =
        kGravity * (std::tan(ramp.angle) - mu);  // per metre in plan: what is left of gravity
    const double exact = ramp.energy_after(along * (ramp.arc_begins() - start), mu);
    const double end = std::sqrt(2 * exact);
    // The time until the centre is some 100 m beyond the arc.
    const double slope_speed = std::sqrt(2 * along * (ramp.arc_begins() - start));
    const double slope_time = 2 * (ramp.arc_begins() - start) / std::cos(ramp.angle) / slope_speed;
    const double arc_time = ramp.radius * ramp.angle / (0.5 * (slope_speed + end));
    const double seconds = slope_time + arc_time + 100 / end;
    trial.run_in(static_cast<int>(std::ceil(seconds * squares / 5)), seconds);
    const double kept = mean_of(trial.layers, [&](double x, int i) {
        const double v = trial.layers.velocity_x(i, 1);
        return v * v / 2 + mu * kGravity * at(x);
    });
    return std::fabs(kept / exact - 1);
}

std::vector<Series> ramps(double mu, double least_order, const std::array<double, 2>& most) {
    std::vector<Series> table;
    int i = 0;
    for (const auto& [angle_deg, measure] :
         {std::pair(35., "v2/2, 35 deg"), std::pair(50., "v2/2, 50 deg")}) {
        Series series{
            "voellmy", measure, most.at(static_cast<std::size_t>(i++)), least_order, {200, 400, 800}};
        for (const int n : series.squares)
            series.errors.push_back(ramp_error({radians(angle_deg), 240}, mu, n));
        table.push_back(series);
    }
    return table;
}
std::vector<Series> free_ramp() {
    return ramps(0, 1.4, {2e-4, 3.5e-4});
}
std::vector<Series> coulomb_ramp() {
    return ramps(0.25, 1.2, {8e-4, 8.5e-4});
}

// A parabolic heap on a plane, without friction: it falls freely and spreads by its pressure, g cos⁴θ down the
// slope, R = R₀ L₀/L (1 − (x/L)²), L'' = 2 g cos⁴θ R₀ L₀/L². Compares the standard deviation, L/√5.
std::vector<Series> spread() {
    constexpr double kSide = 600, kSeconds = 8, kHeight = 1, kHalf = 40, kStart = 100;
    const double angle = radians(35);
    double l = kHalf, grows = 0;
    constexpr int kFine = 100000;
    for (int i = 0; i < kFine; ++i) {
        const double dt = kSeconds / kFine;
        grows += dt * 2 * kGravity * std::pow(std::cos(angle), 4) * kHeight * kHalf / (l * l);
        l += dt * grows;
    }
    Series series{"voellmy", "deviation", 0.0125, 1.6, {120, 240, 480}};
    for (const int n : series.squares) {
        Trial trial(column(n, kSide), numbers(0),
                    {[&](double x, double) { return -std::tan(angle) * x; }, kNoCover,
                     [&](double x, double) {
                         const double off = (x - kStart) / kHalf;
                         return std::max(0., kHeight * (1 - off * off));
                     }});
        trial.run_in(8 * n / 3, kSeconds);
        const double centre = mean_of(trial.layers, [](double x, int) { return x; });
        const double variance =
            mean_of(trial.layers, [&](double x, int) { return (x - centre) * (x - centre); });
        series.errors.push_back(std::fabs(std::sqrt(5 * variance) / l - 1));
    }
    return {series};
}

// A dam of height R₀ breaks at x = x₀. With c = √(g' R₀) and accelerated by a (Ritter 1892; Mangeney, Heinrich and
// Roche 2000), at ξ = (x − x₀ − a t²/2)/t:  R = R₀ to ξ = −c, (2 c − ξ)²/9 g' to ξ = 2 c, then 0.
std::vector<Series> dam_break(double angle_deg, double mu, double most, double least_order) {
    constexpr double kSide = 400, kSeconds = 12, kHeight = 0.5;
    const double angle = radians(angle_deg), pressure = kGravity * std::pow(std::cos(angle), 4);
    const double wave = std::sqrt(pressure * kHeight);
    const double pull = kGravity * (std::sin(angle) - mu * std::cos(angle)) * std::cos(angle);
    const double dam = kSide / 2 - pull * kSeconds * kSeconds / 4;
    Series series{"voellmy", "R, L1", most, least_order, {100, 200, 400}};
    for (const int n : series.squares) {
        Params params = numbers(mu);
        params.borders[kWest] = Border::kOpen;
        Trial trial(column(n, kSide), params,
                    {[&](double x, double) { return -std::tan(angle) * x; }, kNoCover,
                     [&](double x, double) { return x <= dam ? kHeight : 0; }});
        trial.run_in(3 * n, kSeconds);
        const double moved = dam + pull * kSeconds * kSeconds / 2;
        series.errors.push_back(relative_l1(
            trial.layers.rolling, trial.layers.grid, {moved - wave * kSeconds - 20, kSide}, {0, kSide},
            [&](double x, double) {
                const double xi = (x - moved) / kSeconds;
                return xi <= -wave ? kHeight : std::pow(std::max(0., 2 * wave - xi), 2) / (9 * pressure);
            }));
    }
    return {series};
}
std::vector<Series> ritter() {
    return dam_break(0, 0, 0.021, 0.85);
}
std::vector<Series> mangeney() {
    return dam_break(20, 0.2, 0.022, 0.85);
}

// A layer with a level surface swings in a parabolic valley, h = H (x/L)², without friction (Thacker 1981): with
// ω = √(2 g H)/L, its shores are at ± L √(D/H) + A cos(ω t). So flat that plan and slope are nearly the same.
std::vector<Series> swing() {
    constexpr double kHalf = 100, kDeep = 1, kSwing = 20, kSide = 300;
    const double omega = std::sqrt(2 * kGravity * kDeep) / kHalf, period = 2 * std::numbers::pi / omega;
    const auto layer = [=](double x, double t) {
        const double off = (x - kSide / 2 - kSwing * std::cos(omega * t)) / kHalf;
        return std::max(0., kDeep * (1 - off * off));
    };
    Series once{"voellmy", "R, 1 period", 6e-4, 1.5, {60, 120, 240}};
    Series often{"voellmy", "R, 10 periods", 9e-4, 1.7, {60, 120, 240}};
    for (const int n : once.squares) {
        Trial trial(column(n, kSide), numbers(0),
                    {[&](double x, double) {
                         const double off = (x - kSide / 2) / kHalf;
                         return kDeep * off * off;
                     },
                     kNoCover, [&](double x, double) { return layer(x, 0); }});
        const auto error = [&] {
            return relative_l1(trial.layers.rolling, trial.layers.grid, {0, kSide}, {0, kSide},
                               [&](double x, double) { return layer(x, 0); });
        };
        const int substeps = static_cast<int>(std::ceil(period * n / 12));
        trial.run_in(substeps, period);
        once.errors.push_back(error());
        trial.run_in(9 * substeps, 9 * period);
        often.errors.push_back(error());
    }
    return {once, often};
}

}  // namespace

extern const Case kFreeRamp{"slope, arc and flat, no friction", "v^2/2 = g H", free_ramp};
extern const Case kCoulombRamp{"slope, arc and flat, Coulomb friction with centrifugal force",
                               "closed form on the arc, v^2/2 falls by m g x on the flat", coulomb_ramp};
extern const Case kSpread{"heap spreading on a plane at 35 deg, no friction", "L'' = 2 g cos^4 a R0 L0/L^2",
                          spread};
extern const Case kRitter{"dam break on the flat", "Ritter 1892", ritter};
extern const Case kMangeney{"dam break on a plane, Coulomb friction", "Mangeney, Heinrich and Roche 2000",
                            mangeney};
extern const Case kSwing{"swing in a parabolic valley", "Thacker 1981", swing};

}  // namespace sim::verification
