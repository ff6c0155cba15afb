#include "sim/weather/hour.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/workers.h"
#include "sim/weather/cast.h"
#include "sim/weather/sky.h"
#include "sim/weather/slab.h"
#include "sim/weather/work.h"
#include "sim/world/edit_layers.h"
#include "sim/world/quanta.h"
#include "sim/world/state.h"

namespace sim::weather {
namespace {

constexpr float kLapse = 0.0065f;                                          // K/m
constexpr float kMoreWithHeight = 4e-4f, kLeastOf = 0.5f, kMostOf = 2.5f;  // of precipitation: 1/m; factors
constexpr float kBuries = 0.3f;       // mm/h of snow that cover a surface
constexpr float kHoursUntilOld = 12;  // without snow
constexpr float kOld = 1000, kBare = 680, kHoar = 250, kSunned = 1100, kBlown = 1200, kFrozen = 1350;  // Pa
constexpr float kHoarGrows = 24, kSunHeals = 0.08f;                                // Pa/h; share of an hour
constexpr float kSunny = 250, kDim = 100;                                          // W/m² on the surface
constexpr float kMeltPerDegree = 1.8f / 24, kMeltBySun = 0.0008f, kMeltFrom = -2;  // mm/h K, mm m²/h K W, °C
constexpr float kFreezes = 0.12f;                                                  // mm/h K
constexpr float kHolds = 0.1f, kHoldsWithin = 0.3f;              // of the slab's mass; m of d at least
constexpr float kCrust = 900, kCohesion = 700, kPerLoad = 1.2f;  // Pa, Pa, 1
constexpr float kBondHours = 40, kBondHoursPersistent = 200;

// The wind of the hour near the ground: faster up slopes and on crests, slow in the wake of a ridge.
void find_wind(const State& s, const Sky& sky, Work& work, Workers& workers) {
    constexpr double kWakeSlope = 0.165;                // 1 : 6
    constexpr float kFullWake = 15, kWakeSlows = 0.9f;  // m; share
    cast(s, sky.wind_to, kWakeSlope, work.over);
    const auto east = static_cast<float>(sky.wind_to.x), north = static_cast<float>(sky.wind_to.y);
    workers.each_band(s.grid.ny, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < s.grid.nx; ++x) {
                const float climbs = work.gradient_x(x, y) * east + work.gradient_y(x, y) * north;
                const float slope = std::clamp(climbs * 0.625f, -0.5f, 0.5f);
                const float crest =
                    std::clamp((s.bedrock(x, y) - work.mean_height(x, y)) * 0.04f, -0.5f, 0.5f);
                const float wake = std::min(work.over(x, y) / kFullWake, 1.f);
                work.wind(x, y) = (1 + 0.58f * slope + 0.42f * crest) * (1 - kWakeSlows * wake);
            }
    });
}

// What the hour is for every vertex.
struct Hour {
    const Sky& sky;
    const Burial burial;
    const Dither<float> dither;
    const float metres_per_mm;  // of d
    const float above;          // m, of b = d = 0 above the calendar's reference
    const bool shines, blows;
};

// Rows first … last-1. Vertices need no neighbours.
class Passing {
  public:
    Passing(State& s, const Hour& hour, const Work& work) : s_(s), w_(*s.weather), hour_(hour), work_(work) {}

    void pass(int x, int y) {
        float& d = s_.depth(x, y);
        const float height = hour_.above + s_.bedrock(x, y) + d;
        const float air = hour_.sky.temperature - kLapse * height;
        const float along_x = work_.gradient_x(x, y), along_y = work_.gradient_y(x, y);
        const float steep = along_x * along_x + along_y * along_y;
        const float water =
            hour_.sky.precipitation * std::clamp(1 + kMoreWithHeight * height, kLeastOf, kMostOf);
        const float solid = std::clamp((2 - air) * 0.5f, 0.f, 1.f);
        const float snow = water * solid * work_.share(x, y), rain = water * (1 - solid);
        const float sun = sun_at(x, y, along_x, along_y, steep);
        age_surface(x, y, snow, air, sun, height, steep);
        if (d == 0 && snow == 0) return;
        const float rained = d > 0 ? rain : 0;
        const float gained =
            std::min(in_quanta((snow + rained) * hour_.metres_per_mm, hour_.dither), room_in(d));
        change_depth(d, w_.undisturbed(x, y), gained);
        fallen += static_cast<std::int64_t>(gained / kQuantum);
        if (d == 0) return;
        wet(x, y, rained, air, sun);
        bond(x, y, steep);
    }

    std::int64_t fallen = 0, melted = 0;  // quanta

  private:
    float sun_at(int x, int y, float along_x, float along_y, float steep) const {
        if (!hour_.shines || work_.over(x, y) >= 1) return 0;
        const auto east = static_cast<float>(hour_.sky.sun.x), north = static_cast<float>(hour_.sky.sun.y);
        const float facing = (hour_.sky.sun_up - (along_x * east + along_y * north)) / std::sqrt(1 + steep);
        return hour_.sky.beam() * std::max(facing, 0.f);
    }

    void age_surface(int x, int y, float snow, float air, float sun, float height, float steep) {
        float& surface = w_.surface(x, y);
        const float d = s_.depth(x, y);
        if (snow > kBuries) {
            hour_.burial(w_, d, steep, x, y);
        } else if (d == 0) {
            surface = kBare;
        } else if (surface < 0) {
            surface -= 1;
            if (surface <= -kHoursUntilOld) surface = kOld;
        } else {
            if (hour_.sky.is_clear_night() && air < -1) surface = std::max(surface - kHoarGrows, kHoar);
            if (sun > kSunny) surface += (kSunned - surface) * kSunHeals;
            if (hour_.blows && wind_near_ground(hour_.sky.wind, work_.wind(x, y), height) > kDriftFrom)
                surface = std::max(surface, kBlown);
        }
    }

    // Melt and rain wet the slab; what it cannot hold runs off.
    void wet(int x, int y, float rain, float air, float sun) {
        float &d = s_.depth(x, y), &base = w_.base(x, y);
        const float density = hour_.burial.density, before = w_.water(x, y) + rain;
        float water = before;
        if (air > kMeltFrom) water += (kMeltPerDegree + kMeltBySun * sun) * (air - kMeltFrom);
        if (air < 0 && sun < kDim) water = std::max(water + kFreezes * air, 0.f);
        const float slab = std::max(d - base, 0.f);
        const float holds = kHolds * density * std::max(slab, std::min(d, kHoldsWithin));
        if (water > holds) {
            const float runs =
                std::min(std::floor((water - holds) * hour_.metres_per_mm / kQuantum) * kQuantum, d);
            change_depth(d, w_.undisturbed(x, y), -runs);
            melted += static_cast<std::int64_t>(runs / kQuantum);
            base = std::min(base, d);
            water = d > 0 ? water - runs * density : 0;
        }
        if (before > 2 && water < 1) {  // frozen again
            w_.surface(x, y) = kFrozen;
            w_.strength(x, y) = std::max(std::abs(w_.strength(x, y)), kCrust);
        }
        w_.water(x, y) = water;
    }

    // An interface bonds under its load, toward a strength that grows with it.
    void bond(int x, int y, float steep) {
        float& strength = w_.strength(x, y);
        const float slab = std::max(s_.depth(x, y) - w_.base(x, y), 0.f);
        const float load = hour_.burial.density * static_cast<float>(kGravity) * slab / (1 + steep);
        const float goal = kCohesion + kPerLoad * load, now = std::abs(strength);
        if (now >= goal) return;
        const bool persistent = strength < 0;
        const float grown = now + (goal - now) / (persistent ? kBondHoursPersistent : kBondHours);
        strength = persistent ? -grown : grown;
    }

    State& s_;
    Weather& w_;
    const Hour& hour_;
    const Work& work_;
};

}  // namespace

void find_gradient(const State& s, Work& work, int first, int last) {
    constexpr float kOver = 12;  // m, half
    const Grid& grid = s.grid;
    const int reach = std::max(1, static_cast<int>(std::lround(kOver / grid.dx)));
    for (int y = first; y < last; ++y) {
        const int south = std::max(y - reach, 0), north = std::min(y + reach, grid.ny - 1);
        const float height = static_cast<float>(std::max(north - south, 1)) * grid.dx;
        for (int x = 0; x < grid.nx; ++x) {
            const int west = std::max(x - reach, 0), east = std::min(x + reach, grid.nx - 1);
            const float width = static_cast<float>(std::max(east - west, 1)) * grid.dx;
            const auto rise = [&](int x0, int y0, int x1, int y1) {
                return (s.bedrock(x1, y1) - s.bedrock(x0, y0)) + (s.depth(x1, y1) - s.depth(x0, y0));
            };
            work.gradient_x(x, y) = rise(west, y, east, y) / width;
            work.gradient_y(x, y) = rise(x, south, x, north) / height;
        }
    }
}

void pass_hour(State& s, Work& work, Workers& workers) {
    Weather& w = *s.weather;
    const Sky sky = sky_of(w);
    workers.each_band(s.grid.ny, [&](int first, int last) { find_gradient(s, work, first, last); });
    const bool blows = sky.wind * 1.5f > kDriftFrom;  // the most that a crest adds
    if (blows) find_wind(s, sky, work, workers);
    const double level = std::sqrt(sky.sun.x * sky.sun.x + sky.sun.y * sky.sun.y);
    const bool shines = sky.shines();
    if (shines && level > 0.01)
        cast(s, {-sky.sun.x / level, -sky.sun.y / level}, static_cast<double>(sky.sun_up) / level, work.over);
    else if (shines)
        work.over.fill(0);  // the sun is overhead

    const float density = s.params.density;
    const Hour hour{sky,
                    Burial(s, sky.event),
                    Dither<float>(dither_of(w.hours)),
                    1 / density,
                    static_cast<float>(s.datum - w.calendar.reference),
                    shines,
                    blows};
    std::fill(work.fallen.begin(), work.fallen.end(), 0);
    std::fill(work.melted.begin(), work.melted.end(), 0);
    workers.each_member(s.grid.ny, [&](int member, int first, int last) {
        Passing passing(s, hour, work);
        for (int y = first; y < last; ++y)
            for (int x = 0; x < s.grid.nx; ++x)
                if (s.site(x, y) == Site::kGround) passing.pass(x, y);
        work.fallen[static_cast<std::size_t>(member)] += passing.fallen;
        work.melted[static_cast<std::size_t>(member)] += passing.melted;
    });
    s.ledger.fallen += std::accumulate(work.fallen.begin(), work.fallen.end(), std::int64_t{0});
    s.ledger.melted += std::accumulate(work.melted.begin(), work.melted.end(), std::int64_t{0});
    if (blows) drift(s, sky, work);
    w.anchored = false;
    ++w.hours;
}

}  // namespace sim::weather
