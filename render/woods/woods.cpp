#include "render/woods/woods.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/noise.h"
#include "render/base/ramp.h"
#include "render/base/tree_model.h"
#include "render/mountain/surroundings_mesh.h"
#include "sim/core/check.h"

namespace render {
namespace {

constexpr double kMostPlaces = 2'500'000;  // that are looked at, half a second
constexpr double kLastTree = 1.4;          // longer sides, from the grid to the last tree
constexpr double kTilesAlongSide = 24;
constexpr double kShortest = 9, kTallest = 23;              // m, of full-grown trees
constexpr double kLeastPine = 1.2, kMostPine = 2.6;         // m, heights of dwarf pine
constexpr double kSunk = 0.4;                               // m, so that no foot hangs over a slope
constexpr double kBushesPerHectare = 600;                   // in a closed thicket
constexpr double kLastBush = 0.25;                          // longer sides, from the grid to the last bush
constexpr double kLowestBush = 1.9, kTallestBush = 4.4;     // m
constexpr float kLowestHedge = 1.5f, kTallestHedge = 2.9f;  // m
constexpr float kLowestFruitTree = 3.6f, kTallestFruitTree = 5.6f;  // m
constexpr float kLowestHedgeTree = 7, kTallestHedgeTree = 12;       // m
constexpr float kTallerAtBrook = 0.45f;                             // share, of alder
constexpr int kPlacesPeriod = 1 << 20;  // places until the hash repeats: more than there are

// −1 to 1, by a lattice of places `wavelength` metres apart.
double noise(glm::dvec2 at, double wavelength, std::uint32_t seed) {
    const glm::vec2 p(at / wavelength + 1000.0);
    return 2 * static_cast<double>(value_noise(p.x, p.y, 4096, seed)) - 1;
}

// The shape of the ground around a place.
struct Ground {
    double z;
    glm::dvec2 slope;
    double gully;  // m, how much higher the ground is beside it, across the slope
};

// What grows at a place.
struct Site {
    double share = 0;   // of the closed wood's density, 0 to 1
    double closed = 0;  // 1 within a stand, 0 outside
    double below = 0;   // m, below the tree line here; above it less than 0
    double gully = 0;   // 1 in a hollow across the slope, 0 outside
    double bushy = 0;   // of a closed thicket's density, 0 to 1
    Ground ground;
};

// What grows where.
class Growth {
  public:
    Growth(const Surroundings& around, const TreeRules& rules, double datum)
        : around_(around), rules_(rules), datum_(datum), near_(std::min(36.0, around.side() / 12)) {}

    // Trees that one at a place stands for.
    double group(glm::dvec2 at) const {
        const double sides = around_.away(at) / around_.side();
        return std::exp2(4 * ramp(0.0, 0.5, sides));
    }

    // The ground at a place, and how far below the line it lies.
    Site bare_site(glm::dvec2 at) const {
        Site site;
        const Ground& ground = site.ground = ground_at(at);
        const double steep = glm::length(ground.slope), hollow = ground.gully / near_;
        // The line is ragged, higher on ribs and on slopes that face the sun at noon.
        const double sunny = ground.slope.y / std::sqrt(1 + steep * steep);
        const double line = rules_.line_m - 55 + 22 * noise(at, 160, rules_.seed + 3) +
                            30 * std::min(sunny, 0.5) - 350 * std::clamp(hollow, -0.1, 0.1);
        site.below = std::min(line, rules_.line_m - 4) - datum_ - ground.z;
        site.gully = ramp(0.02, 0.07, hollow);
        return site;
    }

    Site site(glm::dvec2 at) const {
        Site site;
        if (around_.away(at) > kLastTree * around_.side() || is_bare(at) || !is_wanted(at)) return site;
        if (around_.rough_height(at) + datum_ > rules_.line_m) return site;
        site = bare_site(at);
        const Ground& ground = site.ground;
        if (site.below < 0) return site;
        const double steep = glm::length(ground.slope), hollow = ground.gully / near_;
        if (!rules_.shares.empty()) {
            site.share = site.closed = wanted_share(at) * ramp(1.0, 0.9, steep) * ramp(0, 12, site.below);
            site.bushy = bushy(at, site, site.share, steep);
            return site;
        }
        const double level = ramp(0.07, 0.17, steep + 0.05 * noise(at, 120, rules_.seed + 2));
        const double rock = ramp(0.78, 0.98, steep), gully = site.gully;
        // Stands: the farther below the line, the more ground they cover.
        const double groves = 0.50 * noise(at, 230, rules_.seed) + 0.30 * noise(at, 88, rules_.seed + 1) +
                              0.20 * noise(at, 34, rules_.seed + 5);
        const double wanted = glm::mix(0.42, -0.24, ramp(0, 190, site.below)) + 0.7 * gully + 0.9 * rock +
                              0.7 * (1 - level) - 0.22 * ramp(0.0, 0.06, -hollow);
        site.closed = ramp(-0.035, 0.045, groves - wanted);
        // Single trees around them; a few dare to grow where avalanches run and where these come to rest.
        const double near_stand = ramp(-0.28, 0.0, groves - wanted);
        const double clumps = ramp(-0.1, 0.5, noise(at, 23, rules_.seed + 4));
        const double run_out = gully * ramp(0.62, 0.45, steep);
        const double single =
            (1 - rock) * level * (0.012 + (0.03 + 0.14 * clumps) * near_stand * (1 - gully) + 0.07 * run_out);
        site.share =
            glm::mix(single, 0.72 + 0.28 * ramp(-0.6, 0.2, noise(at, 23, rules_.seed + 4)), site.closed);
        site.share *= ramp(0, 12, site.below);
        site.bushy = bushy(at, site, near_stand * level * (1 - rock), steep);
        return site;
    }

    // Higher up trees are smaller, and within a stand they are taller than at its edge.
    Tree tree(glm::dvec2 at, const Site& site, double chance) const {
        Tree tree;
        tree.kind = kind(site, chance);
        const double size = tree.kind == TreeKind::kPine
                                ? 1
                                : (0.42 + 0.58 * ramp(0, 130, site.below)) * (0.72 + 0.28 * site.closed);
        tree.height = static_cast<float>(tree.kind == TreeKind::kPine
                                             ? glm::mix(kLeastPine, kMostPine, chance)
                                             : size * glm::mix(kShortest, kTallest, std::sqrt(chance)));
        tree.closed = static_cast<float>(site.closed);
        const double steep = glm::length(site.ground.slope);
        tree.downhill = steep > 0 ? glm::vec2(-site.ground.slope / steep) : glm::vec2(1, 0);
        if (rules_.mixed) tree.kind = kind_in_mixed_wood(at, site, tree.kind, chance);
        return tree;
    }

    Tree bush(const Site& site, double chance) const {
        Tree tree;
        tree.kind = TreeKind::kBush;
        tree.height = static_cast<float>(glm::mix(kLowestBush, kTallestBush, chance * chance));
        tree.closed = static_cast<float>(site.closed);
        const double steep = glm::length(site.ground.slope);
        tree.downhill = steep > 0 ? glm::vec2(-site.ground.slope / steep) : glm::vec2(1, 0);
        return tree;
    }

    // By height below the tree line, slope and aspect: from below beech, beech with spruce, spruce with larch, larch with dwarf pine.
    // Birches come first where nothing else grows yet: at edges, in gullies and where these end. A patch has mostly one kind.
    TreeKind kind_in_mixed_wood(glm::dvec2 at, const Site& site, TreeKind winter, double chance) const {
        if (winter == TreeKind::kPine) return winter;
        const auto random = [&](double factor) { return chance * factor - std::floor(chance * factor); };
        const double steep = glm::length(site.ground.slope), patch = noise(at, 75, rules_.seed + 6),
                     wide_patch = noise(at, 210, rules_.seed + 7);
        const double open = 1 - site.closed;
        const double pioneer = ramp(40, 150, site.below) *
                               std::min(0.06 + 0.50 * open + 0.35 * site.gully, 0.75) *
                               ramp(-0.7, 0.5, patch + 0.3);
        if (random(127) < pioneer) return TreeKind::kBirch;
        const double low =
            site.below + 130 * patch + 90 * wide_patch + 160 * site.gully - 220 * ramp(0.5, 0.95, steep);
        if (random(211) < 0.93 * ramp(170, 520, low)) return TreeKind::kBeech;
        // Larches want light: near the line, at edges and on sunny slopes.
        const double sunny = site.ground.slope.y / std::sqrt(1 + steep * steep);
        const double larch = glm::mix(0.08, 0.62, ramp(260, 30, site.below - 60 * wide_patch)) +
                             0.25 * open * ramp(420, 200, site.below) + 0.25 * std::clamp(sunny, -0.4, 0.4);
        return random(331) < larch ? TreeKind::kLarch : TreeKind::kSpruce;
    }

  private:
    // Thickets follow the edges of stands and gullies; under a closed wood there are few, and on rock none.
    double bushy(glm::dvec2 at, const Site& site, double near_stand, double steep) const {
        if (!rules_.mixed) return 0;
        const double clumps =
            ramp(0.34, 0.62, noise(at, 31, rules_.seed + 8) + 0.40 * noise(at, 11, rules_.seed + 9));
        const double edge = near_stand * (1 - site.closed) + 0.10 * site.closed;
        return clumps * std::min(edge + 0.8 * site.gully, 1.0) * ramp(0.90, 0.70, steep) *
               ramp(0, 25, site.below);
    }

    // Dwarf pine and larches grow near the line.
    static TreeKind kind(const Site& site, double chance) {
        const double other =
            chance * 61 - std::floor(chance * 61);  // as random as `chance`, and independent of it
        if (site.closed < 0.5 && other < 0.75 * ramp(70, 10, site.below)) return TreeKind::kPine;
        return other > 1 - 0.09 * ramp(200, 60, site.below) ? TreeKind::kLarch : TreeKind::kSpruce;
    }

    // Within the polygon, if there is one: a ray to the east leaves it an odd number of times. If there are
    // shares, only the grid has them.
    bool is_wanted(glm::dvec2 at) const {
        if (!rules_.shares.empty() && around_.away(at) > 0) return false;
        if (rules_.polygon.empty()) return true;
        bool inside = false;
        glm::dvec2 from = rules_.polygon.back();
        for (const glm::dvec2 to : rules_.polygon) {
            if ((from.y > at.y) != (to.y > at.y) &&
                at.x < from.x + (at.y - from.y) / (to.y - from.y) * (to.x - from.x))
                inside = !inside;
            from = to;
        }
        return inside;
    }

    double wanted_share(glm::dvec2 at) const {
        const glm::dvec2 p = at / around_.cell();
        const int x = std::min(static_cast<int>(p.x), around_.columns() - 2),
                  y = std::min(static_cast<int>(p.y), around_.rows() - 2);
        const auto share = [&](int i, int j) {
            return rules_.shares[static_cast<std::size_t>(j) * static_cast<std::size_t>(around_.columns()) +
                                 static_cast<std::size_t>(i)] /
                   255.0;
        };
        return glm::mix(glm::mix(share(x, y), share(x + 1, y), p.x - x),
                        glm::mix(share(x, y + 1), share(x + 1, y + 1), p.x - x), p.y - y);
    }

    Ground ground_at(glm::dvec2 at) const {
        const double step = std::max(1.5 * around_.cell(), 10.0);
        const auto z = [&](double x, double y) { return around_.rough_height(at + glm::dvec2(x, y)); };
        Ground ground;
        ground.z = z(0, 0);
        ground.slope = glm::dvec2(z(step, 0) - z(-step, 0), z(0, step) - z(0, -step)) / (2 * step);
        const double steep = std::max(glm::length(ground.slope), 1e-6);
        const glm::dvec2 across = glm::dvec2(-ground.slope.y, ground.slope.x) / steep;
        const auto beside = [&](double reach) {
            return 0.5 * (z(reach * across.x, reach * across.y) + z(-reach * across.x, -reach * across.y)) -
                   ground.z;
        };
        const double close = beside(near_), wide = 0.4 * beside(2.5 * near_);
        ground.gully = std::max(close, wide);
        return ground;
    }

    // No data, and the cells beside it.
    bool is_bare(glm::dvec2 at) const {
        if (around_.away(at) > 0) return false;
        const glm::dvec2 cell = at / around_.cell();
        const int x = std::min(static_cast<int>(cell.x), around_.columns() - 2),
                  y = std::min(static_cast<int>(cell.y), around_.rows() - 2);
        return around_.is_hole(x, y) || around_.is_hole(x + 1, y) || around_.is_hole(x, y + 1) ||
               around_.is_hole(x + 1, y + 1);
    }

    const Surroundings& around_;
    const TreeRules& rules_;
    double datum_, near_;
};

bool is_cleared(glm::dvec2 at, std::span<const Clearing> clearings) {
    return std::ranges::any_of(clearings, [&](const Clearing& each) {
        const glm::dvec2 along = each.to - each.from;
        const double length2 = glm::dot(along, along);
        const double t = length2 > 0 ? std::clamp(glm::dot(at - each.from, along) / length2, 0.0, 1.0) : 0.0;
        return glm::distance(at, each.from + t * along) < each.reach;
    });
}

// Where the ground is left to plants, by the land of a mixed wood.
class FreeGround {
  public:
    FreeGround(const Surroundings& around, const Land& land) : around_(around), land_(land) {}

    double to_brook(glm::dvec2 at) const { return land_.to_brook(around_.source(at)); }  // m, as Land
    // `closed`: how closed the wood is around it. A field is free only at its edges, and where it is woodland.
    bool is_free(glm::dvec2 at, double closed) const {
        if (land_.empty()) return true;
        if (to_brook(at) < kFromWater) return false;
        const int use = land_.use(around_.source(at));
        return use == 0 || (use < LAND_GARDEN && (closed > 0.5 || is_edge(at, use)));
    }
    // The nearest free place, in rings around a place; the place itself if none is near.
    glm::dvec2 nearest(glm::dvec2 at, double closed, float turn) const {
        if (is_free(at, closed)) return at;
        const bool outside = around_.away(at) > 0;
        for (int ring = 1; ring <= kRings; ++ring)
            for (int i = 0; i < kDirections; ++i) {
                const float share = turn + static_cast<float>(i) / kDirections;
                const glm::dvec2 beside =
                    at + ring * kRing * glm::dvec2(direction_of(share - std::floor(share)));
                if (is_free(beside, closed) && (around_.away(beside) > 0) == outside) return beside;
            }
        return at;
    }

  private:
    static constexpr double kFromWater = 1, kEdge = 2.5, kRing = 1.5;  // m

    bool is_edge(glm::dvec2 at, int use) const {
        const auto differs = [&](double x, double y) {
            return land_.use(around_.source(at + glm::dvec2(x, y))) != use;
        };
        return differs(kEdge, 0) || differs(-kEdge, 0) || differs(0, kEdge) || differs(0, -kEdge);
    }
    static constexpr int kDirections = 12, kRings = 12;

    const Surroundings& around_;
    const Land& land_;
};

// The height of triangle abc at a place within it.
std::optional<float> height_in(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, glm::vec2 at) {
    const glm::vec2 ab = glm::vec2(b - a), ac = glm::vec2(c - a), ap = at - glm::vec2(a);
    const float area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0) return std::nullopt;
    const float v = (ap.x * ac.y - ap.y * ac.x) / area, w = (ab.x * ap.y - ab.y * ap.x) / area;
    if (v < 0 || w < 0 || v + w > 1) return std::nullopt;
    return a.z + v * (b.z - a.z) + w * (c.z - a.z);
}

// A tree, and a random number: of too many trees those with the least are kept.
struct Grown {
    float order;
    glm::ivec2 place;
    Tree tree;
};
bool earlier(const Grown& a, const Grown& b) {
    return std::tuple(a.order, a.place.y, a.place.x) < std::tuple(b.order, b.place.y, b.place.x);
}

// Its foot, and the cover of tick 0 there.
void put_on_ground(const Surroundings& around, glm::dvec2 at, const Site& site, Tree& tree) {
    tree.foot = glm::dvec3(at, site.ground.z - kSunk);
    const glm::dvec2 source = around.source(at), cell = glm::round(source / around.cell());
    const auto vertex =
        static_cast<std::int32_t>(cell.y) * around.columns() + static_cast<std::int32_t>(cell.x);
    glm::dvec2 cover(around.cover()[static_cast<std::size_t>(vertex)]);
    const bool outside = around.away(at) > 0;
    if (outside) cover += around.cover_by_height(at);
    tree.snow = static_cast<float>(std::max(cover.x, 0.0));
    tree.lower = static_cast<float>(glm::clamp(cover.y, 0.0, 1.0));
    tree.vertex = outside ? -1 : vertex;
}

// Moves a tree out of what is not left to plants. It counts where it grew.
void move_to_free_ground(const Surroundings& around, const FreeGround& free, Tree& tree) {
    const glm::dvec2 grew(tree.foot),
        stands = free.nearest(grew, static_cast<double>(tree.closed), tree.chance);
    if (stands != grew) tree.foot = glm::dvec3(stands, around.rough_height(stands) - kSunk);
}

// How close to a thicket of alder and willow a bank is, 0 to 1.
double thicket_at_brook(glm::dvec2 at, double to_brook, std::uint32_t seed) {
    return 0.7 * ramp(6.5, 2, to_brook) * ramp(-0.25, 0.3, noise(at, 27, seed + 10));
}

// Bushes of a mixed wood, one place in each square of a finer lattice.
std::vector<Tree> bushes_of(const Surroundings& around, const Growth& growth, const FreeGround& free,
                            std::uint32_t seed, std::span<const Clearing> clearings) {
    const double reach = kLastBush * around.side();
    const glm::dvec2 span = around.size() + 2 * reach;
    const double spacing =
        std::max(100 / std::sqrt(kBushesPerHectare), std::sqrt(span.x * span.y / kMostPlaces));
    const auto own = [&](int x, int y, std::uint32_t kind) {
        return hash(x, y, kPlacesPeriod, 16 * seed + kind);
    };
    std::vector<Grown> grown;
    const auto first = glm::ivec2(glm::floor(-reach / spacing)),
               last = glm::ivec2((around.size() + reach) / spacing);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const glm::dvec2 at = spacing * (glm::dvec2(x, y) + glm::dvec2(own(x, y, 8), own(x, y, 9)));
            if (around.away(at) > reach) continue;
            const Site site = growth.site(at);
            const double bank =
                site.below > 0 ? thicket_at_brook(at, free.to_brook(at), seed) * ramp(0, 25, site.below) : 0;
            if (static_cast<double>(own(x, y, 10)) >= std::max(site.bushy, bank)) continue;
            if (!free.is_free(at, site.closed) || is_cleared(at, clearings)) continue;
            Tree tree = growth.bush(site, own(x, y, 11));
            tree.height *= 1 + kTallerAtBrook * static_cast<float>(bank);
            tree.group = 1;
            tree.chance = own(x, y, 12);
            put_on_ground(around, at, site, tree);
            tree.snow_near = snow_near(around, at);
            grown.push_back({own(x, y, 13), {x, y}, tree});
        }
    std::ranges::sort(grown, earlier);
    grown.resize(std::min(grown.size(), Woods::kMostBushes));
    std::vector<Tree> bushes;
    bushes.reserve(grown.size());
    for (const Grown& each : grown) bushes.push_back(each.tree);
    return bushes;
}

// Hedges and orchards of a land, by random: those low as bushes, or the others.
std::vector<Tree> planted_of(const Surroundings& around, const Growth& growth, const Land& land, bool low,
                             std::span<const Clearing> clearings) {
    std::vector<Grown> grown;
    for (const PlantedTree& each : land.planted) {
        if ((each.as == PlantedTree::As::kHedge) != low || is_cleared(each.at, clearings)) continue;
        const Site site = growth.bare_site(each.at);
        if (site.below < 30) continue;
        const glm::ivec2 place(glm::round(4.0 * each.at));
        const auto own = [&](std::uint32_t kind) {
            return hash(place.x, place.y, kPlacesPeriod, 400 + kind);
        };
        Tree tree = growth.bush(site, own(0));
        tree.origin = TreeOrigin::kPlanted;
        tree.group = 1;
        tree.chance = own(1);
        if (low)
            tree.height = glm::mix(kLowestHedge, kTallestHedge, own(2));
        else if (each.as == PlantedTree::As::kFruitTree)
            tree.kind = TreeKind::kBeech, tree.height = glm::mix(kLowestFruitTree, kTallestFruitTree, own(2));
        else
            tree.kind = own(3) < 0.3f ? TreeKind::kBirch : TreeKind::kBeech,
            tree.height = glm::mix(kLowestHedgeTree, kTallestHedgeTree, own(2));
        put_on_ground(around, each.at, site, tree);
        tree.snow_near = snow_near(around, each.at);
        grown.push_back({own(4), place, tree});
    }
    std::ranges::sort(grown, earlier);
    std::vector<Tree> trees;
    trees.reserve(grown.size());
    for (const Grown& each : grown) trees.push_back(each.tree);
    return trees;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3u;
    return hash ^ (hash >> 29);
}

}  // namespace

float snow_near(const Surroundings& around, glm::dvec2 at) {
    constexpr double kNear = 25;  // m
    const int reach = std::clamp(static_cast<int>(kNear / around.cell()), 1, 4);
    const glm::ivec2 vertex(glm::round(around.source(at) / around.cell())),
        last(around.columns() - 1, around.rows() - 1), from = glm::max(vertex - reach, 0),
                                                       to = glm::min(vertex + reach, last);
    const auto columns = static_cast<std::size_t>(around.columns()), first = static_cast<std::size_t>(from.x),
               across = static_cast<std::size_t>(to.x) + 1 - first;
    float most = 0;
    for (int y = from.y; y <= to.y; ++y)
        for (const glm::vec2& cover :
             around.cover().subspan(static_cast<std::size_t>(y) * columns + first, across))
            most = std::max(most, cover.x);
    if (around.away(at) > 0) most += static_cast<float>(around.cover_by_height(at).x);
    return std::max(most, 0.f);
}

bool is_of_forest(const Tree& tree) {
    return tree.vertex >= 0 && tree.kind != TreeKind::kBush && tree.origin == TreeOrigin::kWild;
}

float radius_of(TreeKind kind) {
    switch (kind) {
        case TreeKind::kPine:
            return kCushionRadius;
        case TreeKind::kBeech:
            return kBeechRadius;
        case TreeKind::kBirch:
            return kBirchRadius;
        case TreeKind::kBush:
            return kBushRadius;
        default:
            return kConiferRadius;
    }
}

Woods::Woods(const Surroundings& around, const TreeRules& rules, double datum,
             std::span<const Clearing> clearings, const Land& land)
    : planted_{.line_m = rules.line_m, .seed = rules.seed, .mixed = rules.mixed}, datum_(datum) {
    if (rules.mixed) fingerprint_ = mixed(1, rules.seed);
    if (around.empty() || rules.density <= 0) return;
    CHECK(rules.shares.empty() || rules.shares.size() == around.cover().size());
    const double reach = kLastTree * around.side();
    const glm::dvec2 span = around.size() + 2 * reach;
    const double wanted = 100 / std::sqrt(rules.density);  // m between two places
    const double spacing = std::max(wanted, std::sqrt(span.x * span.y / kMostPlaces));
    const Growth growth(around, rules, datum);
    const FreeGround free(around, land);
    const auto own = [&](int x, int y, std::uint32_t kind) {
        return hash(x, y, kPlacesPeriod, 16 * rules.seed + kind);
    };

    // One place in each square of a lattice, by chance.
    std::vector<Grown> grown;
    std::size_t count = 0;
    const auto keep_first = [&] {
        if (grown.size() <= kMost) return;
        std::ranges::nth_element(grown, grown.begin() + kMost, earlier);
        grown.resize(kMost);
    };
    const auto first = glm::ivec2(glm::floor(-reach / spacing)),
               last = glm::ivec2((around.size() + reach) / spacing);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const glm::dvec2 at = spacing * (glm::dvec2(x, y) + glm::dvec2(own(x, y, 0), own(x, y, 1)));
            const double group = growth.group(at), keep = own(x, y, 2) * group;
            if (keep >= 1) continue;
            const Site site = growth.site(at);
            if (keep >= site.share || is_cleared(at, clearings)) continue;
            Tree tree = growth.tree(at, site, own(x, y, 3));
            tree.group = static_cast<float>(group);
            tree.chance = own(x, y, 4);
            put_on_ground(around, at, site, tree);
            grown.push_back({own(x, y, 5), {x, y}, tree});
            ++count;
            if (grown.size() == 2 * kMost) keep_first();
        }
    const double squeezed = spacing / wanted;
    asked_ = static_cast<double>(count) * squeezed * squeezed;
    keep_first();
    std::ranges::sort(grown, earlier);
    // Those that are left out stand with those that are kept, as far as they are drawn together.
    const float together =
        grown.empty() ? 1.f : static_cast<float>(std::max(asked_ / static_cast<double>(grown.size()), 1.0));
    std::vector<Tree> trees;
    for (const Grown& each : grown) {
        trees.push_back(each.tree);
        trees.back().group = std::min(trees.back().group * together, kMostTogether);
        trees.back().snow_near = snow_near(around, glm::dvec2(each.tree.foot));
        move_to_free_ground(around, free, trees.back());
    }
    const double tile_m = around.side() / kTilesAlongSide;
    sort_into_tiles(tile_m, trees);
    // Bushes have tiles of their own, because fewer of them are seen from afar.
    if (rules.mixed) {
        sort_into_tiles(tile_m, bushes_of(around, growth, free, rules.seed, clearings));
        for (const bool low : {true, false})
            sort_into_tiles(tile_m, planted_of(around, growth, land, low, clearings));
    }
    put_on_mesh(around);
    fingerprint_ = mixed(mixed(around.fingerprint(), trees_.size()), rules.seed);
    if (rules.mixed) fingerprint_ = mixed(mixed(fingerprint_, 1), land.fingerprint);
    for (const Clearing& each : clearings)
        for (const double number : {each.from.x, each.from.y, each.to.x, each.to.y, each.reach})
            fingerprint_ = mixed(fingerprint_, std::hash<double>()(number));
    for (const double each : {rules.density, rules.line_m, datum})
        fingerprint_ = mixed(fingerprint_, std::hash<double>()(each));
    for (const glm::dvec2 corner : rules.polygon)
        fingerprint_ =
            mixed(mixed(fingerprint_, std::hash<double>()(corner.x)), std::hash<double>()(corner.y));
    for (const std::uint8_t share : rules.shares) fingerprint_ = mixed(fingerprint_, share);
}

TreeKind Woods::kind_of_planted(const Surroundings& around, glm::dvec2 at, double closed,
                                double chance) const {
    if (!planted_.mixed || around.empty()) return chance < 0.06 ? TreeKind::kLarch : TreeKind::kSpruce;
    const Growth growth(around, planted_, datum_);
    Site site = growth.bare_site(at);
    site.closed = closed;
    return growth.kind_in_mixed_wood(at, site, TreeKind::kSpruce, chance);
}

void Woods::let_act() {
    act_ = true;
    fingerprint_ = mixed(fingerprint_, 1);
}

std::vector<sim::Stems> forest_of(const Woods& woods, const sim::Grid& grid) {
    std::vector<std::uint32_t> count(grid.size());
    std::vector<double> height(grid.size());
    for (const Tree& tree : woods.trees()) {
        if (!is_of_forest(tree)) continue;
        ++count[static_cast<std::size_t>(tree.vertex)];
        height[static_cast<std::size_t>(tree.vertex)] += static_cast<double>(tree.height);
    }
    constexpr double kHectare = 1e4;  // m²
    std::vector<sim::Stems> forest(grid.size());
    for (std::size_t i = 0; i < forest.size(); ++i) {
        if (count[i] == 0) continue;
        const double stems = count[i] * kHectare / grid.cell_area(), mean = height[i] / count[i];
        constexpr double kDiameterOfHeight = 30.0 / 22;  // cm/m
        forest[i].standing =
            static_cast<std::uint16_t>(std::clamp(std::rint(stems), 1.0, double{sim::kMostStems}));
        forest[i].height_m = static_cast<std::uint8_t>(
            std::clamp(std::rint(mean), double{sim::kLeastTreeM}, double{sim::kMostTreeM}));
        forest[i].diameter_cm = static_cast<std::uint8_t>(std::clamp(
            std::rint(kDiameterOfHeight * mean), double{sim::kLeastStemCm}, double{sim::kMostStemCm}));
    }
    return forest;
}

void Woods::sort_into_tiles(double tile_m, std::span<const Tree> trees) {
    std::map<std::pair<int, int>, std::vector<Tree>> squares;
    for (const Tree& tree : trees) {
        const glm::ivec2 square(glm::floor(glm::dvec2(tree.foot) / tile_m));
        squares[{square.y, square.x}].push_back(tree);
    }
    for (const auto& [square, inside] : squares) {
        TreeTile tile{static_cast<std::uint32_t>(trees_.size()), static_cast<std::uint32_t>(inside.size())};
        tile.lowest = glm::vec3(1e30f), tile.highest = glm::vec3(-1e30f);
        for (const Tree& tree : inside) {
            tile.lowest = glm::min(tile.lowest, tree.foot);
            tile.highest = glm::max(tile.highest, tree.foot + glm::vec3(0, 0, tree.height));
        }
        trees_.insert(trees_.end(), inside.begin(), inside.end());
        tiles_.push_back(tile);
    }
}

// Outside the grid the ground is drawn with triangles that are farther apart the farther away they are.
void Woods::put_on_mesh(const Surroundings& around) {
    const SurroundingsMesh mesh = surroundings_mesh(around);
    for (TreeTile& tile : tiles_) {
        const std::span<Tree> trees = std::span(trees_).subspan(tile.first, tile.count);
        if (std::ranges::all_of(trees, [](const Tree& tree) { return tree.vertex >= 0; })) continue;
        for (const SurroundingsPatch& patch : mesh.patches) {
            if (patch.highest.x < tile.lowest.x || patch.lowest.x > tile.highest.x ||
                patch.highest.y < tile.lowest.y || patch.lowest.y > tile.highest.y)
                continue;
            for (std::uint32_t i = patch.first; i < patch.first + patch.count; i += 3) {
                const auto corner = [&](std::uint32_t k) { return mesh.vertices[mesh.indices[i + k]].at; };
                const glm::vec3 a = corner(0), b = corner(1), c = corner(2);
                const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
                if (high.x < tile.lowest.x || low.x > tile.highest.x || high.y < tile.lowest.y ||
                    low.y > tile.highest.y)
                    continue;
                for (Tree& tree : trees)
                    if (tree.vertex < 0)
                        if (const auto z = height_in(a, b, c, glm::vec2(tree.foot)))
                            tree.foot.z = *z - static_cast<float>(kSunk);
            }
        }
        for (const Tree& tree : trees) {
            tile.lowest.z = std::min(tile.lowest.z, tree.foot.z);
            tile.highest.z = std::max(tile.highest.z, tree.foot.z + tree.height);
        }
    }
}

}  // namespace render
