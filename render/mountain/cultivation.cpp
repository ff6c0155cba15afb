#include "render/mountain/cultivation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/noise.h"
#include "render/base/ramp.h"

namespace render {
namespace {

constexpr int kUseLattice = 4096;        // cells until noise repeats
constexpr double kParcel = 58;           // m, between the middles of parcels, on average
constexpr double kBent = 7;              // m, by which edges of parcels are bent
constexpr double kFromBrook = 4;         // m, from its water to the first furrow
constexpr double kBush = 2.3;            // m, from bush to bush in a hedge
constexpr double kHedged = 0.6;          // share of borders with a hedge
constexpr double kVerge = 3.8;           // m, from the edge of a road
constexpr double kPathWidth = 1.7;       // m
constexpr double kPathGrade = 0.17;      // slope along a path uphill
constexpr double kPathStep = 4;          // m
constexpr double kLongestPath = 420;     // m, uphill
constexpr double kSteepestGround = 0.8;  // slope at which a path ends
constexpr double kBetweenPaths = 170;    // m, between houses that one leads uphill from
constexpr double kFarthestRoad = 70;     // m, from a house that has a path to it

float random(int x, int y, std::uint32_t kind) {
    return hash(x, y, kUseLattice, 300 + kind);
}

// −1 to 1.
double noise(glm::dvec2 at, double wavelength, std::uint32_t kind) {
    const glm::vec2 p(at / wavelength + 1000.0);
    return 2 * static_cast<double>(value_noise(p.x, p.y, kUseLattice, 300 + kind)) - 1;
}

glm::dvec2 left_of(glm::dvec2 along) {
    return {-along.y, along.x};
}

glm::dvec2 slope_at(const Surroundings& around, glm::dvec2 at, double reach) {
    const auto z = [&](double x, double y) { return around.rough_height(at + glm::dvec2(x, y)); };
    return glm::dvec2(z(reach, 0) - z(-reach, 0), z(0, reach) - z(0, -reach)) / (2 * reach);
}

// The nearest point of a line.
glm::dvec2 nearest_on(glm::dvec2 from, glm::dvec2 to, glm::dvec2 at) {
    const glm::dvec2 along = to - from;
    const double length2 = glm::dot(along, along);
    return from + (length2 > 0 ? std::clamp(glm::dot(at - from, along) / length2, 0.0, 1.0) : 0.0) * along;
}

// A parcel of land: a box around its middle, in strips.
struct Parcel {
    glm::ivec2 number;  // on the lattice
    glm::dvec2 middle;  // m
    glm::dvec2 along;   // unit vector, along the contour
    glm::dvec2 half;    // m, along it and across
    int strips;         // side by side, across
    bool is_tilled;
};

// The place of a texel within the parcel that it belongs to.
struct Holding {
    const Parcel* parcel = nullptr;
    int strip = 0;
    bool operator==(const Holding&) const = default;
};

class Parcels {
  public:
    Parcels(const Surroundings& around, const TexelGrid& grid, const std::vector<float>& tilled)
        : around_(around), last_(glm::ivec2(around.size() / kParcel) + kReach) {
        parcels_.reserve(columns() * static_cast<std::size_t>(last_.y + kReach + 1));
        for (int y = -kReach; y <= last_.y; ++y)
            for (int x = -kReach; x <= last_.x; ++x) parcels_.push_back(parcel(x, y, grid, tilled));
    }

    // The nearest parcel by its own measure, in which it is a box.
    Holding at(glm::dvec2 place) const {
        const glm::dvec2 bent = place + kBent * glm::dvec2(noise(place, 61, 1), noise(place, 61, 2));
        const glm::ivec2 cell(glm::floor(bent / kParcel));
        Holding nearest;
        double least = 1e30;
        for (int y = std::max(cell.y - kReach, -kReach); y <= std::min(cell.y + kReach, last_.y); ++y)
            for (int x = std::max(cell.x - kReach, -kReach); x <= std::min(cell.x + kReach, last_.x); ++x) {
                const Parcel& each = numbered(x, y);
                const glm::dvec2 from = bent - each.middle;
                const glm::dvec2 share =
                    glm::dvec2(glm::dot(from, each.along), glm::dot(from, left_of(each.along))) / each.half;
                const glm::dvec2 squares = share * share;
                const double away = glm::dot(squares, squares);
                if (away >= least) continue;
                least = away;
                nearest = {&each, std::clamp(static_cast<int>(std::floor(0.5 * (share.y + 1) * each.strips)),
                                             0, each.strips - 1)};
            }
        return nearest;
    }

  private:
    static constexpr int kReach = 2;  // parcels from a place, among which its own is

    std::size_t columns() const { return static_cast<std::size_t>(last_.x) + kReach + 1; }
    const Parcel& numbered(int x, int y) const {
        return parcels_[static_cast<std::size_t>(y + kReach) * columns() +
                        static_cast<std::size_t>(x + kReach)];
    }
    Parcel parcel(int x, int y, const TexelGrid& grid, const std::vector<float>& tilled) const {
        const auto own = [&](std::uint32_t kind) { return static_cast<double>(random(x, y, kind)); };
        Parcel parcel{};
        parcel.number = {x, y};
        parcel.middle = kParcel * (glm::dvec2(x, y) + 0.5 + 0.66 * (glm::dvec2(own(10), own(11)) - 0.5));
        const glm::dvec2 slope = slope_at(around_, parcel.middle, 35);
        const double steep = glm::length(slope);
        // On level ground neighbours agree by a noise that is broader than they are.
        const glm::dvec2 level(direction_of(0.5f + 0.5f * static_cast<float>(noise(parcel.middle, 320, 3))));
        const glm::dvec2 contour = steep > 1e-6 ? left_of(slope / steep) : level;
        const glm::dvec2 wanted =
            glm::mix(glm::dot(contour, level) < 0 ? -level : level, contour, ramp(0.015, 0.05, steep)) +
            0.3 * (own(12) - 0.5) * left_of(contour);
        parcel.along = glm::normalize(wanted);
        const double size = kParcel * glm::mix(0.42, 0.68, own(13)),
                     longer = std::sqrt(glm::mix(1.1, 2.6, own(14)));
        parcel.half = {size * longer, size / longer};
        parcel.strips = own(15) < 0.5 ? 1 : 2 + static_cast<int>(3 * own(16));
        const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::round(parcel.middle / grid.spacing)),
                                            glm::ivec2(0), glm::ivec2(grid.columns, grid.rows) - 1);
        parcel.is_tilled = tilled[grid.at(texel.x, texel.y)] > 0.4f && own(17) > 0.1;
        return parcel;
    }

    const Surroundings& around_;
    glm::ivec2 last_;
    std::vector<Parcel> parcels_;
};

// What a field looks like: its direction, one of LAND_DIRECTIONS of half a turn, and its crop.
std::uint8_t field_of(const Holding& holding) {
    const Parcel& parcel = *holding.parcel;
    constexpr double kHalfTurn = 3.14159265358979323846;
    const double turn = std::atan2(parcel.along.y, parcel.along.x) / kHalfTurn;  // −1 to 1
    const int direction =
        static_cast<int>(std::lround((turn - std::floor(turn)) * LAND_DIRECTIONS)) % LAND_DIRECTIONS;
    const int crop = static_cast<int>(random(parcel.number.x * 8 + holding.strip, parcel.number.y, 20) *
                                      static_cast<float>(LAND_CROPS));
    return static_cast<std::uint8_t>(LAND_FIELD + LAND_DIRECTIONS * crop + direction);
}

class Cultivator {
  public:
    Cultivator(const Surroundings& around, const Settlement& settlement, const TexelGrid& grid,
               const std::vector<float>& tilled, const std::vector<float>& to_brook)
        : around_(around), settlement_(settlement), grid_(grid), to_brook_(to_brook) {
        cultivation_.uses.assign(tilled.size(), 0);
        lay_out_fields(tilled);
        for (const Settlement::House& house : settlement.houses) lay_out_garden(house);
        for (const Settlement::Road& road : settlement.roads)
            paint(road.from, road.to, road.width / 2 + kVerge, LAND_VERGE);
        for (const Settlement::House& house : settlement.houses) lead_to_road(house);
        lead_uphill();
        std::erase_if(cultivation_.planted, [&](const PlantedTree& each) { return !is_plantable(each.at); });
    }
    Cultivation result() && { return std::move(cultivation_); }

  private:
    glm::dvec2 place(int x, int y) const { return grid_.spacing * glm::dvec2(x, y); }
    bool contains(glm::dvec2 at) const {
        return at.x >= 0 && at.y >= 0 && at.x <= around_.size().x && at.y <= around_.size().y;
    }
    std::size_t texel(glm::dvec2 at) const {
        const glm::ivec2 i = glm::clamp(glm::ivec2(glm::round(at / grid_.spacing)), glm::ivec2(0),
                                        glm::ivec2(grid_.columns, grid_.rows) - 1);
        return grid_.at(i.x, i.y);
    }
    // Neither outside the grid, in a brook, on a path or in a garden bed.
    bool is_plantable(glm::dvec2 at) const {
        return contains(at) && to_brook_[texel(at)] > 2 && cultivation_.uses[texel(at)] < LAND_GARDEN;
    }

    void lay_out_fields(const std::vector<float>& tilled) {
        const Parcels parcels(around_, grid_, tilled);
        std::vector<Holding> south(static_cast<std::size_t>(grid_.columns)), row(south.size());
        for (int y = 0; y < grid_.rows; ++y) {
            for (int x = 0; x < grid_.columns; ++x) {
                const glm::dvec2 at = place(x, y);
                const std::size_t i = grid_.at(x, y);
                Holding& here = row[static_cast<std::size_t>(x)];
                here = {};
                if (tilled[i] > 0.3f && to_brook_[i] > kFromBrook &&
                    static_cast<double>(tilled[i]) + 0.15 * noise(at, 34, 4) > 0.5)
                    here = parcels.at(at);
                if (here.parcel && !here.parcel->is_tilled) here = {};
                if (here.parcel) cultivation_.uses[i] = field_of(here);
                if (y > 0) plant_between(here, south[static_cast<std::size_t>(x)], at);
                if (x > 0) plant_between(here, row[static_cast<std::size_t>(x) - 1], at);
            }
            south.swap(row);
        }
    }

    // Hedges stand between parcels, and toward open ground, not between strips.
    void plant_between(const Holding& a, const Holding& b, glm::dvec2 at) {
        if (a.parcel == b.parcel) return;
        const auto number = [](const Parcel* parcel) { return parcel ? parcel->number : glm::ivec2(-1000); };
        const glm::ivec2 sum = number(a.parcel) + number(b.parcel),
                         first = glm::max(number(a.parcel), number(b.parcel));
        if (static_cast<double>(random(sum.x * 64 + first.x, sum.y * 64 + first.y, 30)) > kHedged) return;
        if (noise(at, 17, 5) < -0.55) return;  // a gap
        const glm::ivec2 spot(glm::floor(at / kBush));
        if (!planted_.insert({spot.y, spot.x}).second) return;
        const auto own = [&](std::uint32_t kind) {
            return static_cast<double>(random(spot.x, spot.y, kind));
        };
        const glm::dvec2 aside = 0.8 * (glm::dvec2(own(31), own(32)) - 0.5);
        cultivation_.planted.push_back(
            {at + aside, own(33) < 0.06 ? PlantedTree::As::kHedgeTree : PlantedTree::As::kHedge});
    }

    // A kitchen garden behind a house, and fruit trees on one side of it.
    void lay_out_garden(const Settlement::House& house) {
        const glm::ivec2 number(house.at);
        const auto own = [&](std::uint32_t kind) {
            return static_cast<double>(random(number.x, number.y, kind));
        };
        const glm::dvec2 across = left_of(house.front) * (own(40) < 0.5 ? 1.0 : -1.0);
        const glm::dvec2 bed =
            house.at - (house.length / 2 + 5.5) * house.front + 2 * (own(41) - 0.5) * across;
        if (own(42) < 0.8 && is_open(bed, 3)) {
            const glm::dvec2 end = (2.5 + 1.5 * own(43)) * across;
            paint(bed - end, bed + end, 2.4, LAND_GARDEN);
        }
        if (own(44) > 0.75) return;
        constexpr double kRow = 6.5;  // m, from tree to tree
        const int trees = 2 + static_cast<int>(2.99 * own(45));
        for (int row = 0; row < 2; ++row)
            for (int i = 0; i < trees; ++i) {
                const glm::dvec2 jitter(random(number.x + i, number.y + row, 46),
                                        random(number.x + i, number.y + row, 47));
                const glm::dvec2 at = house.at + (house.width / 2 + 8 + kRow * row) * across +
                                      kRow * (i - 0.5 * (trees - 1)) * house.front + 2.5 * (jitter - 0.5);
                if (is_open(at, 3)) cultivation_.planted.push_back({at, PlantedTree::As::kFruitTree});
            }
    }

    // Whether neither house nor road is within a distance.
    bool is_open(glm::dvec2 at, double distance) const {
        return std::ranges::none_of(
                   settlement_.houses,
                   [&](const Settlement::House& house) {
                       const glm::dvec2 from = at - house.at;
                       return std::abs(glm::dot(from, house.front)) < house.length / 2 + distance &&
                              std::abs(glm::dot(from, left_of(house.front))) < house.width / 2 + distance;
                   }) &&
               std::ranges::none_of(settlement_.roads, [&](const Settlement::Road& road) {
                   return glm::distance(at, nearest_on(road.from, road.to, at)) < road.width / 2 + distance;
               });
    }

    // Trodden ground before the door, and a path to the nearest road.
    void lead_to_road(const Settlement::House& house) {
        const glm::dvec2 door = house.at + (house.length / 2 + 1) * house.front,
                         before = door + 2.5 * house.front;
        paint(door, before, 2.2, LAND_PATH);
        std::optional<glm::dvec2> nearest;
        for (const Settlement::Road& road : settlement_.roads) {
            const glm::dvec2 at = nearest_on(road.from, road.to, before);
            if (!nearest || glm::distance(at, before) < glm::distance(*nearest, before)) nearest = at;
        }
        if (nearest && glm::distance(*nearest, before) < kFarthestRoad) {
            const glm::dvec2 aside = 0.12 * left_of(*nearest - before);
            const glm::dvec2 bend =
                glm::mix(before, *nearest, 0.5) +
                (random(static_cast<int>(house.at.x), static_cast<int>(house.at.y), 50) < 0.5f ? aside
                                                                                               : -aside);
            paint(before, bend, kPathWidth / 2, LAND_PATH);
            paint(bend, *nearest, kPathWidth / 2, LAND_PATH);
        }
    }

    // From the highest house, and from others that are far enough from those before.
    void lead_uphill() {
        std::vector<Settlement::House> houses = settlement_.houses;
        std::ranges::stable_sort(houses, std::greater(), [&](const Settlement::House& house) {
            return around_.rough_height(house.at);
        });
        std::vector<glm::dvec2> begun;
        for (const Settlement::House& house : houses) {
            if (std::ranges::any_of(
                    begun, [&](glm::dvec2 at) { return glm::distance(at, house.at) < kBetweenPaths; }))
                continue;
            begun.push_back(house.at);
            lead_uphill(house);
        }
    }
    void lead_uphill(const Settlement::House& house) {
        const glm::dvec2 rise = slope_at(around_, house.at, 18);
        const double steepness = std::max(glm::length(rise), 1e-6);
        glm::dvec2 at = house.at + (0.5 * std::max(house.length, house.width) + 2) * rise / steepness,
                   along(0);
        double side = 1, straight = 0;  // m since the last bend
        const auto longest = static_cast<int>(kLongestPath / kPathStep);
        for (int i = 0; i < longest; ++i) {
            const glm::dvec2 slope = slope_at(around_, at, 18);
            const double steep = std::max(glm::length(slope), 1e-6);
            if (steep > kSteepestGround) return;
            const glm::dvec2 uphill = slope / steep;
            const double up = std::min(kPathGrade / steep, 1.0);
            if (straight > 70 + 50 * noise(at, 90, 6) && up < 0.7) side = -side, straight = 0;
            const glm::dvec2 wanted = up * uphill + side * std::sqrt(1 - up * up) * left_of(uphill);
            along = glm::normalize(glm::mix(wanted, along, i > 0 ? 0.55 : 0.0) +
                                   0.15 * noise(at, 40, 7) * left_of(wanted));
            const glm::dvec2 next = at + kPathStep * along;
            if (!contains(next)) return;
            if (is_open(next, 0.5)) paint(at, next, kPathWidth / 2, LAND_PATH);
            at = next, straight += kPathStep;
        }
    }

    // Everything within a distance of a line that is no water.
    void paint(glm::dvec2 from, glm::dvec2 to, double half, std::uint8_t use) {
        const double reach = std::max(half, 0.6 * std::max(grid_.spacing.x, grid_.spacing.y));
        const glm::ivec2 first = glm::max(glm::ivec2((glm::min(from, to) - reach) / grid_.spacing), 0),
                         last = glm::min(glm::ivec2((glm::max(from, to) + reach) / grid_.spacing) + 1,
                                         glm::ivec2(grid_.columns, grid_.rows) - 1);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const glm::dvec2 at = place(x, y);
                if (glm::distance(at, nearest_on(from, to, at)) < reach && to_brook_[grid_.at(x, y)] > 0)
                    cultivation_.uses[grid_.at(x, y)] = use;
            }
    }

    const Surroundings& around_;
    const Settlement& settlement_;
    const TexelGrid& grid_;
    const std::vector<float>& to_brook_;
    std::set<std::pair<int, int>> planted_;  // spots of hedges
    Cultivation cultivation_;
};

}  // namespace

Cultivation cultivate(const Surroundings& around, const Settlement& settlement, const TexelGrid& grid,
                      const std::vector<float>& tilled, const std::vector<float>& to_brook) {
    return Cultivator(around, settlement, grid, tilled, to_brook).result();
}

}  // namespace render
