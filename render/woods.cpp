#include "render/woods.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/noise.h"
#include "render/ramp.h"
#include "render/surroundings_mesh.h"

namespace render {
namespace {

constexpr double kMostPlaces = 600'000;  // that are looked at, a third of a second
constexpr double kLastTree = 0.8;        // longer sides, from the grid to the last tree
constexpr double kTilesAlongSide = 14;
constexpr double kShortest = 7, kTallest = 21;  // m, of full-grown trees
constexpr double kSunk = 0.4;                   // m, so that no foot hangs over a slope
constexpr int kPlacesPeriod = 1 << 20;          // places until the hash repeats: more than there are

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

// What grows where.
class Growth {
  public:
    Growth(const Surroundings& around, const TreeRules& rules, double datum)
        : around_(around), rules_(rules), datum_(datum), near_(std::min(36.0, around.side() / 12)) {}

    // The share of the closed wood's density at a place, 0 to 1.
    double share(glm::dvec2 at) const {
        const double groves = 0.62 * noise(at, 210, rules_.seed) + 0.38 * noise(at, 70, rules_.seed + 1);
        const double clumps = 0.55 + 0.45 * ramp(-0.5, 0.3, noise(at, 23, rules_.seed + 4));
        double share = clumps * ramp(-0.22, 0.12, groves) * thinned_by_distance(around_.away(at));
        if (share <= 0 || is_bare(at)) return 0;
        const Ground ground = ground_at(at);
        const double steep = glm::length(ground.slope);
        share *= below_line(at, ground);
        share *= ramp(1.0, 0.72, steep);                                            // rock
        share *= ramp(0.06, 0.22, steep + 0.07 * noise(at, 120, rules_.seed + 2));  // meadows of the valley
        // A few dare to grow where avalanches run.
        share *= 0.08 + 0.92 * ramp(0.085 * near_, 0.015 * near_, ground.gully);
        return share;
    }

    // 0 at the tree line, 1 far enough below it for full-grown trees.
    double below_line(glm::dvec2 at, const Ground& ground) const {
        // It is ragged, and higher on slopes that face the sun at noon.
        const double sunny = ground.slope.y / std::sqrt(1 + glm::dot(ground.slope, ground.slope));
        const double line =
            rules_.line_m - 45 + 25 * noise(at, 160, rules_.seed + 3) + 40 * std::min(sunny, 0.5);
        return ramp(0, 90, line - datum_ - ground.z);
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
        ground.gully = std::max(beside(near_), 0.4 * beside(2.5 * near_));
        return ground;
    }

  private:
    // No data, and the cells beside it.
    bool is_bare(glm::dvec2 at) const {
        if (around_.away(at) > 0) return false;
        const glm::dvec2 cell = at / around_.cell();
        const int x = std::min(static_cast<int>(cell.x), around_.columns() - 2),
                  y = std::min(static_cast<int>(cell.y), around_.rows() - 2);
        return around_.is_hole(x, y) || around_.is_hole(x + 1, y) || around_.is_hole(x, y + 1) ||
               around_.is_hole(x + 1, y + 1);
    }
    double thinned_by_distance(double away) const {
        const double sides = away / around_.side();
        return (1 - 0.75 * ramp(0.1, 0.6, sides)) * ramp(kLastTree, 0.6, sides);
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

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3u;
    return hash ^ (hash >> 29);
}

}  // namespace

Woods::Woods(const Surroundings& around, const TreeRules& rules, double datum,
             std::span<const Clearing> clearings) {
    if (around.empty() || rules.density <= 0) return;
    const double reach = kLastTree * around.side();
    const glm::dvec2 span = around.size() + 2 * reach;
    const double wanted = 100 / std::sqrt(rules.density);  // m between two places
    const double spacing = std::max(wanted, std::sqrt(span.x * span.y / kMostPlaces));
    const Growth growth(around, rules, datum);
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
            const double share = growth.share(at);
            if (static_cast<double>(own(x, y, 2)) >= share || is_cleared(at, clearings)) continue;
            const Ground ground = growth.ground_at(at);
            const double low = growth.below_line(at, ground), chance = own(x, y, 3);
            Tree tree;
            tree.height = static_cast<float>((kShortest + (kTallest - kShortest) * chance) *
                                             (0.45 + 0.55 * low) * (0.7 + 0.3 * share));
            tree.foot = glm::dvec3(at, ground.z - kSunk);
            const double steep = glm::length(ground.slope);
            tree.downhill = steep > 0 ? glm::vec2(-ground.slope / steep) : glm::vec2(1, 0);
            tree.chance = own(x, y, 4);
            const glm::dvec2 source = around.source(at), cell = glm::round(source / around.cell());
            const auto vertex =
                static_cast<std::int32_t>(cell.y) * around.columns() + static_cast<std::int32_t>(cell.x);
            glm::dvec2 cover(around.cover()[static_cast<std::size_t>(vertex)]);
            const bool outside = around.away(at) > 0;
            if (outside) cover += around.cover_by_height(at);
            tree.snow = static_cast<float>(std::max(cover.x, 0.0));
            tree.lower = static_cast<float>(glm::clamp(cover.y, 0.0, 1.0));
            tree.vertex = outside ? -1 : vertex;
            grown.push_back({own(x, y, 5), {x, y}, tree});
            ++count;
            if (grown.size() == 2 * kMost) keep_first();
        }
    const double squeezed = spacing / wanted;
    asked_ = static_cast<double>(count) * squeezed * squeezed;
    keep_first();
    std::ranges::sort(grown, earlier);
    for (const Grown& each : grown) trees_.push_back(each.tree);
    sort_into_tiles(around.side() / kTilesAlongSide);
    put_on_mesh(around);
    fingerprint_ = mixed(mixed(around.fingerprint(), trees_.size()), rules.seed);
    for (const Clearing& each : clearings)
        for (const double number : {each.from.x, each.from.y, each.to.x, each.to.y, each.reach})
            fingerprint_ = mixed(fingerprint_, std::hash<double>()(number));
    for (const double each : {rules.density, rules.line_m, datum})
        fingerprint_ = mixed(fingerprint_, std::hash<double>()(each));
}

void Woods::sort_into_tiles(double tile_m) {
    std::map<std::pair<int, int>, std::vector<Tree>> squares;
    for (const Tree& tree : trees_) {
        const glm::ivec2 square(glm::floor(glm::dvec2(tree.foot) / tile_m));
        squares[{square.y, square.x}].push_back(tree);
    }
    trees_.clear();
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
