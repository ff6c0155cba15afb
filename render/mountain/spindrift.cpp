#include "render/mountain/spindrift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "render/base/noise.h"
#include "render/base/ramp.h"
#include "render/mountain/surroundings_mesh.h"

namespace render {
namespace {

constexpr double kNearSides = 0.9;  // longer sides from the grid: as far away ridges are looked for
constexpr double kFinest = 10;      // m between places on a grid of smaller cells
constexpr double kAcross = 22;      // m, over which a ridge must be sharp
constexpr double kBlunt = 0.2, kSharp = 0.65;  // tangent of the bend over it
constexpr double kLee = 0.2;                   // least fall on its lee
constexpr double kBroad = 200;                 // m, around which it must be high
constexpr double kLow = 24, kHigh = 70;        // m above the mean of that
constexpr double kLittle = 0.1, kMuch = 0.5;   // m of snow before it
constexpr double kOver = 3;                    // m above the ridge, where the light is taken
constexpr float kFaintestPlume = 0.05f;

struct Found {
    SpindriftPlace place;
    glm::ivec2 cell;
};

// Strength of a ridge at a place, 0 if there is none. `along`: unit vector to where the wind blows.
double ridge_at(const Surroundings& around, glm::dvec2 at, glm::dvec2 along, double step) {
    const double across = std::max(kAcross, 1.5 * step);
    const double here = around.rough_height(at);
    const double before = around.rough_height(at - across * along);
    const double behind = around.rough_height(at + across * along);
    if (before > here || here - behind < kLee * across) return 0;
    const double bend = ramp(kBlunt, kSharp, (2 * here - before - behind) / across);
    if (bend <= 0) return 0;
    // The crest itself, not a place beside it.
    for (const double aside : {-1.0, 1.0})
        if (around.rough_height(at + aside * step * along) > here) return 0;
    constexpr std::array<glm::dvec2, 8> kRound{
        {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
    double mean = 0;
    for (const glm::dvec2& aside : kRound) mean += around.rough_height(at + kBroad * aside) / kRound.size();
    return bend * ramp(kLow, kHigh, here - mean);
}

// Snow before a ridge, from where the wind takes it, m.
double snow_before(const Surroundings& around, glm::dvec2 at) {
    const glm::dvec2 cell = around.source(at) / around.cell();
    const auto x = static_cast<std::size_t>(std::clamp(cell.x + 0.5, 0.0, around.columns() - 1.0));
    const auto y = static_cast<std::size_t>(std::clamp(cell.y + 0.5, 0.0, around.rows() - 1.0));
    return around.cover()[y * static_cast<std::size_t>(around.columns()) + x].x +
           around.cover_by_height(at).x;
}

}  // namespace

bool is_dry_snow(const Look& look) {
    constexpr float kBright = 0.6f, kMuchPowder = 0.5f;
    return look.standing.g > kBright && look.powder.strength > kMuchPowder;
}

Ridges::Ridges(const Surroundings& around, const Wind& wind) {
    const double lifts = ramp(kLeastSpeed, kGreatestSpeed, wind.speed);
    if (around.empty() || lifts <= 0) return;
    const glm::dvec2 along = glm::normalize(glm::dvec2(velocity(wind)));
    const auto scan = [&](glm::dvec2 from, glm::ivec2 count, double step, bool on_grid) {
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) {
                glm::dvec2 at = from + step * glm::dvec2(x, y);
                const double away = around.away(at);
                if ((away == 0) != on_grid || away > kNearSides * around.side()) continue;
                double strength = ridge_at(around, at, along, step);
                if (strength <= 0) continue;
                strength *= ramp(kLittle, kMuch, snow_before(around, at - step * along));
                if (strength < kFaintestPlume) continue;
                const std::uint32_t seed = on_grid ? 3 : 4;
                const glm::dvec2 aside(-along.y, along.x);
                at += step * (static_cast<double>(hash(x, y, 1 << 20, seed)) - 0.5) * aside;
                places_.push_back({glm::vec3(at, around.height(at)), static_cast<float>(std::sqrt(strength)),
                                   hash(x, y, 1 << 20, seed + 2)});
            }
    };
    const double step = std::max(around.cell(), kFinest);
    scan({0, 0}, glm::ivec2(around.size() / step) + 1, step, true);
    const auto rough = static_cast<int>(Surroundings::kRough);
    scan(around.rough_origin(), {rough, rough}, around.rough_cell(), false);
    if (places_.size() > kMost) {
        std::stable_sort(places_.begin(), places_.end(),
                         [](const auto& a, const auto& b) { return a.strength > b.strength; });
        places_.resize(kMost);
    }
    for (SpindriftPlace& place : places_) place.strength *= static_cast<float>(lifts);
}

void Ridges::light(const Surroundings& around, const glm::vec3& sun) {
    std::vector<SurroundingsVertex> over;
    over.reserve(places_.size());
    for (const SpindriftPlace& place : places_)
        over.push_back(
            {.at = place.at + glm::vec3(0, 0, kOver), .slope = {}, .source = {}, .cover = {}, .open = 1});
    std::vector<float> lit;
    sunlit(around, over, glm::dvec3(sun), lit);
    for (std::size_t i = 0; i < places_.size(); ++i) places_[i].sunlit = lit[i];
}

}  // namespace render
