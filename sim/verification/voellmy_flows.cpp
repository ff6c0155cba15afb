#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sim/verification/case_list.h"
#include "sim/verification/trial.h"

// voellmy over bends, and under the pressure of its own layer.

namespace sim::verification {
namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

Params numbers(double friction, float levelling = 0) {
    Params params = bare_params(Model::kVoellmy, Scheme::kLocalLaxFriedrichs);
    params.levelling = levelling;
    params.friction = static_cast<float>(friction);
    params.drag = std::numeric_limits<float>::infinity();
    wall_sides(params);
    return params;
}

// A case without levelling (transport.h), and with it.
using OfLevelling = std::vector<Series> (*)(float levelling);
std::vector<Series> both(OfLevelling run) {
    std::vector<Series> all = run(0);
    for (Series& levelled : run(1)) {
        levelled.scheme = "levelled";
        all.push_back(std::move(levelled));
    }
    return all;
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
std::vector<Series> dam_break(double angle_deg, double mu, double most, double least_order, float levelling) {
    constexpr double kSide = 400, kSeconds = 12, kHeight = 0.5;
    const double angle = radians(angle_deg), pressure = kGravity * std::pow(std::cos(angle), 4);
    const double wave = std::sqrt(pressure * kHeight);
    const double pull = kGravity * (std::sin(angle) - mu * std::cos(angle)) * std::cos(angle);
    const double dam = kSide / 2 - pull * kSeconds * kSeconds / 4;
    Series series{"voellmy", "R, L1", most, least_order, {100, 200, 400}};
    for (const int n : series.squares) {
        Params params = numbers(mu, levelling);
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
    return both([](float levelling) { return dam_break(0, 0, 0.021, 0.85, levelling); });
}
std::vector<Series> mangeney() {
    return both([](float levelling) { return dam_break(20, 0.2, 0.022, 0.85, levelling); });
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
    Series often{"voellmy", "R, 10 periods", 6e-4, 1.7, {60, 120, 240}};
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

// The whole of a layer: its mass, the mean of where it is and how it moves, and its energy, kinetic along the
// slope and potential. All over density and area of a cell.
struct Whole {
    double mass = 0, x = 0, y = 0, u = 0, v = 0, kinetic = 0, potential = 0;
    double energy() const { return kinetic + potential; }
};
Whole whole(const Layers<double>& s) {
    const double dx = s.grid.dx;
    Whole all;
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const double r = s.rolling(x, y), u = s.velocity_x(x, y), v = s.velocity_y(x, y);
            const double rises = ((s.bedrock(x + 1, y) - s.bedrock(x - 1, y)) * u +
                                  (s.bedrock(x, y + 1) - s.bedrock(x, y - 1)) * v) /
                                 (2 * dx);
            all.mass += r;
            all.x += r * x * dx, all.y += r * y * dx;
            all.u += r * u, all.v += r * v;
            all.kinetic += r * (u * u + v * v + rises * rises) / 2;
            all.potential += r * kGravity * (s.bedrock(x, y) + r / 2);
        }
    for (double* mean : {&all.x, &all.y, &all.u, &all.v}) *mean /= all.mass;
    return all;
}

// The same in a paraboloid (Thacker 1981): a layer with a plane surface, whose centre moves on an ellipse with
// axes at 30 deg to the grid and the period of the valley. Slopes stay below .003, so that plan and slope are the
// same to 1e-5. Period and energy are those of the centre: what is left of the energy above rest.
std::vector<Series> bowl_of(float levelling) {
    constexpr double kHalf = 100, kDeep = 0.1, kLong = 20, kShort = 10, kSide = 300;
    constexpr int kPeriods = 10;
    const double omega = std::sqrt(2 * kGravity * kDeep) / kHalf, period = 2 * std::numbers::pi / omega;
    const double cos = std::cos(radians(30)), sin = std::sin(radians(30));
    const auto height = [=](double x, double y) { return kDeep * (x * x + y * y) / (kHalf * kHalf); };
    const auto layer = [=](double x, double y) {
        return std::max(0., kDeep - height(x - kSide / 2 - kLong * cos, y - kSide / 2 - kLong * sin));
    };
    // With levelling a bank does not push the thin shore, which costs energy.
    const bool levels = levelling > 0;
    Series form{"voellmy", "R, 10 periods", levels ? 1.2e-2 : 6e-3, 1.7, {40, 80, 160}};
    Series beat{"voellmy", "period", levels ? 2e-4 : 1e-4, 2, form.squares};
    Series energy{"voellmy", "energy, 10 per.", levels ? 4.2e-2 : 2.2e-3, levels ? 1.9 : 2.6, form.squares};
    for (const int n : form.squares) {
        Trial trial(
            {n + 1, n + 1, static_cast<float>(kSide / n)}, numbers(0, levelling),
            {[&](double x, double y) { return height(x - kSide / 2, y - kSide / 2); }, kNoCover, layer});
        const int substeps =
            static_cast<int>(std::ceil(period * std::sqrt(kGravity * kDeep) * 2 * n / kSide));
        const double late = omega * period / substeps / 2;  // the state's velocity is half a sub-step late
        const double u = kLong * omega * std::sin(late), v = kShort * omega * std::cos(late);
        trial.layers.velocity_x.fill(u * cos - v * sin);
        trial.layers.velocity_y.fill(u * sin + v * cos);
        const double before = whole(trial.layers).energy();
        trial.run_in(kPeriods * substeps, kPeriods * period);
        const Whole after = whole(trial.layers);
        const double along = (after.x - kSide / 2) * cos + (after.y - kSide / 2) * sin;
        const double phase = std::atan2(-(after.u * cos + after.v * sin), omega * along) + late;
        const double above = after.mass * omega * omega * (kLong * kLong + kShort * kShort) / 2;
        form.errors.push_back(
            relative_l1(trial.layers.rolling, trial.layers.grid, {0, kSide}, {0, kSide}, layer));
        beat.errors.push_back(std::fabs(phase) / (2 * std::numbers::pi * kPeriods));
        energy.errors.push_back(std::fabs(after.energy() - before) / above);
    }
    return {form, beat, energy};
}
std::vector<Series> bowl() {
    return both(bowl_of);
}

// A ring of a layer that circles in a paraboloid at one speed v, without friction. Its surface rises outward as
// in a bend of a channel. With k = v²/(g r), the centripetal acceleration v²/r less what the ground's curvature
// gives, v² h'/r · h'/(1 + h'²), is that of the surface, g z'/(1 + h' z'):
//
//     z' = k/(1 + h' (h' − k))          h' = s r/r₀:  z = z₀ + s r₀/(1 − s²) ln( (r/r₀)/√(1 − s² + s² r²/r₀²) )
//
// The crest of the ring is at r₀, where k = h' = s, and z' is v²/(g r).
std::vector<Series> circular_bend() {
    constexpr double kRadius = 100, kSlope = 0.3, kThick = 5, kSide = 360;
    const double speed = std::sqrt(kGravity * kSlope * kRadius),
                 seconds = 2 * std::numbers::pi * kRadius / speed;
    const auto height = [=](double r) { return kSlope / 2 * r * r / kRadius; };
    const auto layer = [=](double r) {
        const double to = r / kRadius, rest = 1 - kSlope * kSlope;
        const double rises =
            kSlope * kRadius / rest * std::log(to / std::sqrt(rest + kSlope * kSlope * to * to));
        return std::max(0., kThick + rises - (height(r) - height(kRadius)));
    };
    const auto of_radius = [](const auto& f) {
        return [f](double x, double y) { return f(std::hypot(x - kSide / 2, y - kSide / 2)); };
    };
    Series form{"voellmy", "R, 1 turn", 1.6e-2, 1.2, {60, 120, 240}};
    Series keeps{"voellmy", "v, 1 turn", 2.5e-3, 1.6, form.squares};
    Series rise{"voellmy", "dz/dr, 1 turn", 4.5e-3, 0, form.squares};
    Series energy{"voellmy", "energy, 1 turn", 3e-3, 0.9, form.squares};
    for (const int n : form.squares) {
        Trial trial({n + 1, n + 1, static_cast<float>(kSide / n)}, numbers(0),
                    {of_radius(height), kNoCover, of_radius(layer)});
        Layers<double>& s = trial.layers;
        const int substeps = static_cast<int>(std::ceil(seconds * speed * n / kSide / 0.4));
        const double dx = s.grid.dx;
        const auto each = [&](const auto& visit) {
            for (int y = 1; y < n; ++y)
                for (int x = 1; x < n; ++x) {
                    const double to_x = x * dx - kSide / 2, to_y = y * dx - kSide / 2;
                    if (const double r = std::hypot(to_x, to_y); layer(r) > 0)
                        visit(x, y, to_x / r, to_y / r, r);
                }
        };
        each([&](int x, int y, double out_x, double out_y, double r) {
            const double late = speed * seconds / substeps / 2 / r;
            s.velocity_x(x, y) = speed * (std::sin(late) * out_x - std::cos(late) * out_y);
            s.velocity_y(x, y) = speed * (std::sin(late) * out_y + std::cos(late) * out_x);
        });
        const double before = whole(s).energy();
        trial.run_in(substeps, seconds);
        energy.errors.push_back(std::fabs(whole(s).energy() / before - 1));
        double mass = 0, off = 0, rises = 0, exact = 0;
        each([&](int x, int y, double out_x, double out_y, double r) {
            if (layer(r) < kThick / 2) return;  // far from both shores
            const auto z = [&](int i, int j) { return s.bedrock(i, j) + s.rolling(i, j); };
            const double k = speed * speed / (kGravity * r), h = kSlope * r / kRadius;
            mass += 1;
            off += std::fabs(out_x * s.velocity_y(x, y) - out_y * s.velocity_x(x, y) - speed);
            rises += (out_x * (z(x + 1, y) - z(x - 1, y)) + out_y * (z(x, y + 1) - z(x, y - 1))) / (2 * dx);
            exact += k / (1 + h * (h - k));
        });
        form.errors.push_back(relative_l1(s.rolling, s.grid, {0, kSide}, {0, kSide}, of_radius(layer)));
        keeps.errors.push_back(off / mass / speed);
        rise.errors.push_back(std::fabs(rises / exact - 1));
    }
    return {form, keeps, rise, energy};
}

// A parabolic heap slides down a plane with Coulomb friction (Savage and Hutter 1989): its centre as a block, its
// half length by L'' = 2 g cos⁴θ R₀ L₀/L² (fourth-order Runge-Kutta). Friction is the same in all of it as long as
// all of it slides down. So flat that z_x in G does not count.
std::vector<Series> sliding_heap() {
    constexpr double kSide = 600, kSeconds = 25, kHeight = 0.5, kHalf = 80, kStart = 150, kFriction = 0.35;
    const double angle = radians(25);
    const double pull = kGravity * (std::sin(angle) - kFriction * std::cos(angle)) * std::cos(angle);
    const double push = 2 * kGravity * std::pow(std::cos(angle), 4) * kHeight * kHalf;
    const auto half_length = [=](double seconds) {
        constexpr int kFine = 1000;
        const double dt = seconds / kFine;
        double l = kHalf, grows = 0;
        const auto gains = [=](double at) { return push / (at * at); };
        for (int i = 0; i < kFine; ++i) {
            const double a = gains(l), b = gains(l + dt / 2 * grows);
            const double c = gains(l + dt / 2 * (grows + dt / 2 * a));
            const double d = gains(l + dt * (grows + dt / 2 * b));
            l += dt * (grows + dt / 6 * (a + b + c));
            grows += dt / 6 * (a + 2 * b + 2 * c + d);
        }
        return l;
    };
    const auto heap = [=](double x, double centre, double half) {
        const double off = (x - centre) / half;
        return std::max(0., kHeight * kHalf / half * (1 - off * off));
    };
    const std::vector<int> squares{120, 240, 480};
    std::vector<Series> table{{"voellmy", "length, 12.5 s", 1.1e-3, 1.75, squares},
                              {"voellmy", "length, 25 s", 2.6e-3, 1.75, squares},
                              {"voellmy", "way, 12.5 s", 1.1e-3, 0.95, squares},
                              {"voellmy", "way, 25 s", 5.5e-4, 0.95, squares},
                              {"voellmy", "R, 25 s", 5.5e-3, 1.2, squares}};
    for (const int n : squares) {
        Trial trial(column(n, kSide), numbers(kFriction),
                    {[&](double x, double) { return -std::tan(angle) * x; }, kNoCover,
                     [&](double x, double) { return heap(x, kStart, kHalf); }});
        const auto centre = [&] { return mean_of(trial.layers, [](double x, int) { return x; }); };
        const double start = centre();
        for (const int half : {0, 1}) {
            trial.run_in(2 * n, kSeconds / 2);
            const double seconds = kSeconds / 2 * (half + 1), at = centre(), l = half_length(seconds);
            const double variance = mean_of(trial.layers, [&](double x, int) { return (x - at) * (x - at); });
            const double way = pull * seconds * seconds / 2;
            table[static_cast<std::size_t>(half)].errors.push_back(
                std::fabs(std::sqrt(5 * variance) / l - 1));
            table[static_cast<std::size_t>(half) + 2].errors.push_back(std::fabs((at - start) / way - 1));
            if (half)
                table[4].errors.push_back(
                    relative_l1(trial.layers.rolling, trial.layers.grid, {0, kSide}, {0, kSide},
                                [&](double x, double) { return heap(x, kStart + way, l); }));
        }
    }
    return table;
}

// A layer flows from rest on smooth ground between walls, without friction. Its energy is kept where the pressure's
// denominator does not count: for a thin layer on steep ground, and for any layer on gentle ground. Errors are
// relative to the kinetic energy at the end.
struct SmoothGround {
    double height, rolling, swells, seconds, fastest;  // m, m, share of R, s, m/s

    static constexpr double kSide = 4800;
    // Harmonics whose gradient through the walls is 0; walls are half a cell beyond the first and last vertex.
    Function on(double dx, double (*of)(double x, double y), double times, double plus) const {
        return [=](double x, double y) {
            constexpr double kWave = std::numbers::pi / kSide;
            return times * of(kWave * (x + dx / 2), kWave * (y + dx / 2)) + plus;
        };
    }
    struct Gained {
        double energy, as_stored;
    };
    Gained after(int cells, float levelling) const {
        Params params = numbers(0, levelling);
        params.borders.fill(Border::kWall);
        const double dx = kSide / cells;
        const auto hills = [](double x, double y) {
            return std::cos(x) + 0.7 * std::cos(2 * y) * std::cos(x) + 0.5 * std::cos(y);
        };
        const auto swell = [](double x, double y) { return std::cos(x) * std::cos(y); };
        Trial trial({cells, cells, static_cast<float>(dx)}, params,
                    {on(dx, hills, height, 0), kNoCover, on(dx, swell, swells * rolling, rolling)});
        const int substeps = static_cast<int>(std::ceil(seconds * fastest / dx));
        const double dt = seconds / substeps;
        // The state's velocity is half a sub-step late: at its time, kinetic energy is the mean of now and next.
        const Whole begun = whole(trial.layers);
        trial.run_in(1, dt);
        const double first = begun.potential + (begun.kinetic + whole(trial.layers).kinetic) / 2;
        trial.run_in(substeps - 1, seconds - dt);
        const Whole ended = whole(trial.layers);
        trial.run_in(1, dt);
        const double kinetic = (ended.kinetic + whole(trial.layers).kinetic) / 2;
        return {(ended.potential + kinetic - first) / kinetic, (ended.energy() - begun.energy()) / kinetic};
    }
};
std::vector<Series> smooth_energy_of(float levelling) {
    const SmoothGround steep{400, 0.04, 0.3, 11, 180}, gentle{2, 40, 0.1, 90, 90};
    Series thin{"voellmy", "steep, thin", levelling > 0 ? 1.3e-3 : 2.7e-4, 1.8, {40, 80, 160}};
    Series stored{"voellmy", "steep, stored", 1.7e-2, 0.95, thin.squares};
    Series thick{"voellmy", "gentle, thick", 2.2e-4, 1.75, thin.squares};
    for (const int n : thin.squares) {
        const auto gained = steep.after(n, levelling);
        thin.errors.push_back(std::fabs(gained.energy));
        stored.errors.push_back(std::fabs(gained.as_stored));
        thick.errors.push_back(std::fabs(gentle.after(n, levelling).energy));
    }
    return {thin, stored, thick};
}
std::vector<Series> smooth_energy() {
    return both(smooth_energy_of);
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
extern const Case kBowl{"swing in a paraboloid, along an ellipse", "Thacker 1981", bowl};
extern const Case kCircularBend{"ring that circles in a paraboloid, no friction",
                                "dz/dr = k/(1 + h' (h' - k)), k = v^2/g r", circular_bend};
extern const Case kSlidingHeap{"heap sliding down a plane at 25 deg, Coulomb friction",
                               "Savage and Hutter 1989", sliding_heap};
extern const Case kSmoothEnergy{"energy on smooth ground between walls, no friction", "kept", smooth_energy};

}  // namespace sim::verification
