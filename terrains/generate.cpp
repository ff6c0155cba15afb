#include "terrains/generate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "terrains/massif/exact.h"
#include "terrains/resample.h"

namespace terrains {
namespace {

constexpr double kPi = std::numbers::pi;

// 2⁻¹⁰ m: float32 holds such multiples exactly up to 16 km.
double rounded(double metres) {
    return std::nearbyint(metres * 1024) / 1024;
}

double tangent(double degrees) {
    return std::tan(degrees * kPi / 180);
}

using massif::eased;

// Samples height(x, downhill) and cover(x, downhill), in metres, on a square of `length`.
template <class Height, class Cover>
tl::expected<Terrain, std::string> sample(const char* name, double length, const GridChoice& choice,
                                          Height height, Cover cover) {
    const auto grid = grid_over(length, length, choice);
    const int squares = choice.squares;
    if (!grid) return tl::unexpected(grid.error());
    Terrain terrain;
    terrain.name = name;
    terrain.licence = "MIT, made by Couloir";
    terrain.grid = *grid;
    terrain.surface.resize(grid->size());
    terrain.cover.resize(grid->size());
    terrain.has_data.assign(grid->size(), 1);
    for (int j = 0; j < grid->ny; ++j)
        for (int i = 0; i < grid->nx; ++i) {
            // Computed from squares, not from dx, so that a vertex shared by two grids is at the
            // bit-identical point.
            const double x = length * i / squares, downhill = length * (squares - j) / squares;
            const auto at = static_cast<std::size_t>(j) * grid->nx + i;
            terrain.surface[at] = static_cast<float>(rounded(height(x, downhill)));
            terrain.cover[at] = static_cast<float>(rounded(cover(x, downhill)));
        }
    return terrain;
}

// Ribs and crags: five octaves of a folded pattern, each rotated against the last, so that no crest follows
// the grid. About 0 to 1, mostly near a half; u, v in metres.
double crags(double u, double v) {
    double sum = 0, amplitude = 0.5, frequency = 2 * kPi / 620;
    for (int k = 0; k < 5; ++k, amplitude *= 0.46, frequency *= 1.97) {
        const double turn = 0.4 + 1.1 * k, c = std::cos(turn), s = std::sin(turn);
        const double a = frequency * (c * u + s * v), b = frequency * (c * v - s * u);
        const double first = std::sin(a + 1.7 * k + 0.9 * std::sin(0.53 * b + k));
        const double second = std::sin(b + 2.3 * k + 0.9 * std::sin(0.47 * a + 2 * k));
        sum += amplitude * (1 - std::abs(first + second) / 2);
    }
    return sum;
}

// Profile across a row of gullies, phase 0 on each axis: −1 in the gully, 1 on the rib. Ribs are sharp. Gully
// floors are concave rather than flat, so that they collect the flow.
double gully_profile(double phase) {
    const double s = std::sin(phase / 2), c = std::cos(phase / 2);
    return 0.4 * (2 * std::sqrt(s * s + 0.01) - 1) + 0.6 * (1 - 2 * std::sqrt(c * c + 0.01));
}

class Valley {
  public:
    explicit Valley(const AlpineValley& recipe) : r_(recipe) {}

    double height(double x, double downhill) const {
        const double foot = 1480 + 90 * std::sin(x / 420);
        const double floor = r_.floor_height - r_.floor_fall * (x - 0.5 * kLength);
        return floor + main_side(x, downhill, foot) + opposite_side(x, downhill, foot) + fans(x, downhill) +
               0.12 * r_.ruggedness * (crags(x, downhill) - 0.5);
    }

    double snow(double x, double downhill) const {
        constexpr double kReach = 5;  // m each way: the slope of the mountain, not of the grid
        const double gx = (height(x + kReach, downhill) - height(x - kReach, downhill)) / (2 * kReach);
        const double gy = (height(x, downhill + kReach) - height(x, downhill - kReach)) / (2 * kReach);
        const double slope = std::atan(std::hypot(gx, gy)) * 180 / kPi;
        const double above = (height(x, downhill) - r_.snow_line) / r_.snow_full;
        return r_.snow * std::clamp(above, 0.0, 1.0) * std::clamp((r_.bare - slope) / 10, 0.0, 1.0);
    }

    static constexpr double kLength = 2000;  // m

  private:
    // Axis of the main gully. It starts under the heap and winds slightly to the east.
    static double main_gully(double downhill) {
        return 960 + 45 * (std::sin(downhill / 260) - std::sin(330.0 / 260)) + 0.07 * (downhill - 330);
    }

    // Deviation of the gullies from parallel lines, m; 0 at the heap.
    static double stray(double x, double downhill) {
        const auto wind = [](double u, double v) {
            return 60 * std::sin(v / 310 + u / 270 + 0.6) + 24 * std::sin(v / 118 - u / 190);
        };
        return wind(x, downhill) - wind(960, 330);
    }

    double main_side(double x, double downhill, double foot) const {
        const double ridge =
            140 + 50 * std::sin(x / 300 + 0.8) + 22 * std::sin(x / 83) + 9 * std::sin(x / 37 + 4);
        const double t = std::clamp((foot - downhill) / (foot - ridge), 0.0, 1.3);
        const double up = t <= 1 ? t : 2 - t;  // falls beyond the ridge
        // A saddle above the heap, so that a bowl opens below it, between summits of different heights.
        const double skyline = 0.35 - 0.4 * std::cos((x - 975) / 215) - 0.3 * std::cos((x - 975) / 121) +
                               0.14 * std::sin((x - 960) / 61) + 0.1 * std::cos((x - 960) / 29);
        const double across = x - main_gully(downhill) - stray(x, downhill);
        const double gully = gully_profile(2 * kPi * across / r_.gully_spacing);
        const double flutes =
            gully_profile(2 * kPi * (across - 0.35 * (downhill - 330)) / (0.27 * r_.gully_spacing));
        const double rib = (gully + 1) / 2;  // gully floors are smooth, ribs are rough
        const double inside = eased(0.02, 0.35, t) * (1 - 0.5 * eased(0.75, 1, up));
        const double deep = 1 + 0.35 * std::cos(2 * kPi * (x - 960) / 1270);
        return r_.rise * std::pow(up, 1.42) + r_.summits * skyline * up * up * up +
               r_.gully_depth * inside * (deep * gully + 0.22 * rib * flutes) +
               r_.ruggedness * (crags(x + 1240, downhill + 1400) - 0.5) * std::pow(std::min(t, 1.0), 0.8) *
                   (0.2 + 0.7 * rib);
    }

    double opposite_side(double x, double downhill, double foot) const {
        const double u = std::clamp((downhill - foot - 60) / 520, 0.0, 2.0);
        const double skyline = 1 + u * (0.24 * std::sin(x / 240 + 2.2) + 0.13 * std::sin(x / 97));
        const double across = x + 0.35 * downhill + 40 * std::sin(downhill / 120 + x / 210);
        const double gully = gully_profile(2 * kPi * across / (0.7 * r_.gully_spacing));
        return r_.opposite_rise * skyline * std::pow(u, 1.4) +
               0.75 * r_.gully_depth * gully * eased(0.1, 0.6, u) +
               0.85 * r_.ruggedness * (crags(x + 700, downhill - 300) - 0.5) * eased(0, 0.8, u);
    }

    // Debris at the foot of the main gully and its two neighbours.
    double fans(double x, double downhill) const {
        constexpr double kRadius = 110;  // m
        double sum = 0;
        for (const int side : {-1, 0, 1}) {
            const double at_x = main_gully(1440) + side * r_.gully_spacing,
                         at_y = 1440 + 90 * std::sin(at_x / 420);
            const double away = std::hypot(x - at_x, downhill - at_y) / kRadius;
            sum += (side == 0 ? 1.0 : 0.6) * std::exp(-away * away);
        }
        return r_.fan_height * sum;
    }

    const AlpineValley& r_;
};

}  // namespace

tl::expected<Terrain, std::string> generate_soil_slope(const SoilSlope& recipe, const GridChoice& choice) {
    if (auto right = check_numbers(recipe, kSoilSlopeNumbers); !right) return tl::unexpected(right.error());
    const double steep = tangent(recipe.steep), flat = tangent(recipe.flat), middle = 0.5 * recipe.length;
    // Contours are displaced about x = middle, where the heap stands and the fall line is unchanged.
    const auto swung = [&](double x, double downhill) {
        return downhill + recipe.sway * std::sin((x - middle) / 26) * std::cos((x - middle) / 61 + 0.5);
    };
    const auto height = [&](double x, double downhill) {
        const double y = swung(x, downhill), w = recipe.break_width, away = x - middle;
        // The integral of a slope that changes from steep to flat as tanh((y − break_at) / w).
        const double fall =
            flat * y + (steep - flat) / 2 * (y - w * std::log(std::cosh((y - recipe.break_at) / w)));
        const double uneven =
            std::sin(0.31 * x + 1.3 * std::sin(0.11 * downhill)) * std::sin(0.23 * downhill + 0.7);
        return -fall + recipe.relief * uneven +
               recipe.hollow * away * away * std::exp(-std::pow(downhill / 70, 2));
    };
    const auto soil = [&](double x, double downhill) {
        const double beyond = swung(x, downhill) - recipe.break_at - 6;
        return recipe.soil / 2 * (1 - std::tanh(beyond / 6)) + recipe.soil_at_foot;
    };
    return sample("slope-of-soil", recipe.length, choice, height, soil);
}

tl::expected<Terrain, std::string> generate_alpine_valley(const AlpineValley& recipe,
                                                          const GridChoice& choice) {
    if (auto right = check_numbers(recipe, kAlpineValleyNumbers); !right)
        return tl::unexpected(right.error());
    const Valley valley(recipe);
    return sample(
        "alpine-valley", Valley::kLength, choice, [&](double x, double y) { return valley.height(x, y); },
        [&](double x, double y) { return valley.snow(x, y); });
}

}  // namespace terrains
