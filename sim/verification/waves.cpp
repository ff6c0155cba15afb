#include <cmath>
#include <numbers>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// Waves with a closed form, along x, v = 1 m/s by law C, p = |h_x| − s. Each gives the initial layers, and R
// at any later time. Derived from ∂h/∂t = −γ R p, ∂R/∂t + v ∂R/∂x = γ R p.

namespace sim::verification {
namespace {

constexpr double kSeconds = 0.3;

// A smooth bump: 1 in the middle, 0 for |u| ≥ 1, with three continuous derivatives.
double bump(double u) {
    if (std::fabs(u) >= 1) return 0;
    const double c = std::cos(u * std::numbers::pi / 2);
    return c * c * c * c;
}

Params wave_params(Scheme scheme, float stop_slope, float rate) {
    Params params = bare_params(Model::kBcre, scheme);
    params.rolling_speed = 1;
    params.stop_slope = stop_slope;
    params.exchange_rate = rate;
    return params;
}

// A film too thin for its deposit to change the plane: R = R₀(x − vt) e^{−γ (s − tan a) t}.
std::vector<Series> decay() {
    constexpr double kTangent = 0.25, kFilm = 1e-9, kSide = 1;
    constexpr std::array<Bounds, 3> kBounds{{{4e-2, 0.9}, {1.6e-2, 0.9}, {6e-4, 1.8}}};
    return of_each_scheme({100, 200, 400}, kBounds, [&](Scheme scheme, int n) {
        Params params = wave_params(scheme, 0.5f, 3);
        wall_sides(params);
        const auto shape = [](double x) { return kFilm * bump((x - 0.4) / 0.4); };
        Trial trial(column(n, kSide), params,
                    {[](double x, double) { return -kTangent * x - 1; }, [](double, double) { return 1; },
                     [&](double x, double) { return shape(x); }});
        constexpr double kTime = 0.2;
        trial.run(kTime);
        const double left = std::exp(-3 * (0.5 - kTangent) * kTime);
        return relative_l1(trial.layers.rolling, trial.layers.grid, {0, kSide}, {0, kSide},
                           [&](double x, double) { return left * shape(x - kTime); });
    });
}

// R = R₀(x + γ R t), h = −s x − R − (v/γ) ln R: erosion and deposition move the wave uphill while the
// material flows down. R at a place is found by fixed-point iteration, which converges until the wave breaks
// at t = 1/(γ max R₀′).
struct SimpleWave {
    double slope = 1, rate = 5, middle = 1.3, width = 0.4, film = 0.1, rise = 0.03;

    double begin(double x) const { return film + rise * bump((x - middle) / width); }
    double rolling(double x, double t) const {
        double r = begin(x);
        for (int i = 0; i < 200; ++i) r = begin(x + rate * r * t);
        return r;
    }
    double standing(double x) const { return -slope * x - begin(x) - std::log(begin(x)) / rate; }
};

constexpr double kDeep = 2;  // m of erodible ground, which no wave here uses up

std::vector<Series> simple_wave() {
    constexpr std::array<Bounds, 3> kBounds{{{3.8e-3, 0.9}, {2.8e-3, 0.9}, {5e-5, 1.9}}};
    constexpr double kSide = 2.4;
    const SimpleWave wave;
    return of_each_scheme({200, 400, 800}, kBounds, [&](Scheme scheme, int n) {
        Params params = wave_params(scheme, 1, 5);
        wall_sides(params);
        Trial trial(column(n, kSide), params,
                    {[&](double x, double) { return wave.standing(x) - kDeep; },
                     [](double, double) { return kDeep; }, [&](double x, double) { return wave.begin(x); }});
        trial.run(kSeconds);
        return relative_l1(trial.layers.rolling, trial.layers.grid, {0.85, 1.7}, {0, kSide},
                           [&](double x, double) { return wave.rolling(x, kSeconds); });
    });
}

// The same at 45° to the grid.
std::vector<Series> oblique_wave() {
    constexpr std::array<Bounds, 3> kBounds{{{7.5e-3, 0.9}, {4.7e-3, 0.9}, {1.5e-4, 1.8}}};
    constexpr double kSide = 1.7;
    const SimpleWave wave;
    const auto along = [](double x, double y) { return (x + y) / std::numbers::sqrt2; };
    return of_each_scheme({60, 120, 240}, kBounds, [&](Scheme scheme, int n) {
        const Params params = wave_params(scheme, 1, 5);
        Trial trial({n + 1, n + 1, static_cast<float>(kSide / n)}, params,
                    {[&](double x, double y) { return wave.standing(along(x, y)) - kDeep; },
                     [](double, double) { return kDeep; },
                     [&](double x, double y) { return wave.begin(along(x, y)); }});
        trial.run(kSeconds);
        return relative_l1(trial.layers.rolling, trial.layers.grid, {0.6, 1.15}, {0.6, 1.15},
                           [&](double x, double y) { return wave.rolling(along(x, y), kSeconds); });
    });
}

// A front that deposits while it moves over a bare plane too gentle for it, with constant shape and speed c <
// v: h = −x tan a + ((v − c)/c) R and c ln R + γ R = const − γ K ξ/(v − c), with ξ = x − ct, K = c (s − tan
// a).
std::vector<Series> deposit_front() {
    constexpr double kC = 0.5, kTangent = 0.25, kRate = 4, kS = 0.5, kSide = 3.2;
    constexpr std::array<Bounds, 3> kBounds{{{5.5e-4, 0.95}, {9.5e-5, 0.95}, {3.1e-7, 1.9}}};
    const auto rolling = [](double xi) {
        constexpr double kFilm = 0.1;  // R where ξ = 0
        const double right =
            kC * std::log(kFilm) + kRate * kFilm - kRate * kC * (kS - kTangent) * xi / (1 - kC);
        double log_r = std::log(kFilm);
        for (int i = 0; i < 100; ++i)
            log_r -= (kC * log_r + kRate * std::exp(log_r) - right) / (kC + kRate * std::exp(log_r));
        return std::exp(log_r);
    };
    return of_each_scheme({200, 400, 800}, kBounds, [&](Scheme scheme, int n) {
        Params params = wave_params(scheme, static_cast<float>(kS), static_cast<float>(kRate));
        wall_sides(params);
        constexpr double kMiddle = 1.6;
        Trial trial(
            column(n, kSide), params,
            {[&](double x, double) { return -kTangent * x + (1 - kC) / kC * rolling(x - kMiddle) - kDeep; },
             [](double, double) { return kDeep; }, [&](double x, double) { return rolling(x - kMiddle); }});
        trial.run(kSeconds);
        return relative_l1(trial.layers.rolling, trial.layers.grid, {1.3, 2.2}, {0, kSide},
                           [&](double x, double) { return rolling(x - kMiddle - kC * kSeconds); });
    });
}

// A thick flow of which only R_c exchanges, v_u = γ R_c: p(x, t) = p₀(x + v_u t), and with p₀ = G′ R = R₀ +
// v_u/(v + v_u) [G(x + v_u t) − G(x − vt)].
std::vector<Series> thick_pulse() {
    constexpr double kUphill = 0.5, kFlow = 1, kSide = 2.4;
    constexpr std::array<Bounds, 3> kBounds{{{1.25e-3, 0.85}, {7e-4, 0.85}, {1.9e-5, 1.8}}};
    const auto bulge = [](double x) { return 0.1 * bump((x - 1.3) / 0.3); };
    return of_each_scheme({200, 400, 800}, kBounds, [&](Scheme scheme, int n) {
        Params params = wave_params(scheme, 1, 2);
        params.exchange_depth = 0.25f;
        wall_sides(params);
        Trial trial(column(n, kSide), params,
                    {[&](double x, double) { return -x - bulge(x) - kDeep; },
                     [](double, double) { return kDeep; }, [](double, double) { return kFlow; }});
        trial.run(kSeconds);
        return relative_l1(
            trial.layers.rolling, trial.layers.grid, {0.85, 1.7}, {0, kSide}, [&](double x, double) {
                return kFlow +
                       kUphill / (1 + kUphill) * (bulge(x + kUphill * kSeconds) - bulge(x - kSeconds));
            });
    });
}

}  // namespace

extern const Case kDecay{"decay on a frozen plane", "R = R0(x - vt) exp(-g (s - tan a) t)", decay};
extern const Case kSimpleWave{"uphill simple wave", "R = R0(x + g R t)", simple_wave};
extern const Case kObliqueWave{"the same at 45 degrees", "R = R0(x + g R t)", oblique_wave};
extern const Case kDepositFront{"travelling deposit front", "c ln R + g R = const - g K (x - ct)/(v - c)",
                                deposit_front};
extern const Case kThickPulse{"thick-flow pulse", "p = p0(x + vu t)", thick_pulse};

}  // namespace sim::verification
