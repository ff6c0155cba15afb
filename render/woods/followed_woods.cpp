#include "render/woods/followed_woods.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/base/noise.h"
#include "render/base/ramp.h"
#include "render/base/same_inside.h"

namespace render {
namespace {

constexpr int kBlocksAlongSide = 24;
constexpr int kNumberPeriod = 1 << 20;
constexpr float kSunkFoot = 0.4f;                    // m, so that no foot hangs over a slope
constexpr float kClosedFrom = 120, kClosedAt = 420;  // stems per hectare
constexpr double kSquareMetresOfHectare = 1e4;

int stems_of(const sim::Stems& stems) {
    return stems.standing + stems.lying;
}

// A random number of a vertex, or of one of its trees; 0 to 1.
float chance_of(std::size_t vertex, int number, std::uint32_t seed) {
    return hash(static_cast<int>(vertex % kNumberPeriod), number, kNumberPeriod, 77 + seed);
}

// A whole number near `count`, the same for a vertex, and as large on average.
int whole(double count, std::size_t vertex) {
    return static_cast<int>(std::floor(count + static_cast<double>(chance_of(vertex, 0, 9))));
}

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

float fraction(float x) {
    return x - std::floor(x);
}

}  // namespace

FollowedWoods::Change FollowedWoods::follow(const Woods* woods, const Surroundings* around,
                                            const sim::View& world, std::span<const float> first_depth,
                                            const glm::vec3& sun, bool new_ground) {
    changed_tiles_.clear();
    const std::uint64_t woods_now = woods ? woods->fingerprint() : 0,
                        around_now = around ? around->fingerprint() : 0;
    const bool same =
        woods_now == woods_known_ && around_now == around_known_ && grid_ == world.grid && !new_ground;
    const bool lit = sun == sun_;
    woods_ = woods, woods_known_ = woods_now, around_known_ = around_now, grid_ = world.grid, sun_ = sun;
    const auto is_wooded = [&] {
        const sim::Field<sim::Stems>& forest = world.things->forest;
        for (int y = 0; y < grid_.ny; ++y)
            for (int x = 0; x < grid_.nx; ++x)
                if (stems_of(forest(x, y)) > 0) return true;
        return false;
    };
    const auto is_built_up = [&] { return woods && !woods->empty() && !world.things->list.empty(); };
    const bool acts = woods && woods->act();
    if (!world.things || (!(same && follows_) && !acts && !is_built_up() && !is_wooded())) {
        const bool stays = same && !follows_;
        follows_ = false;
        if (!stays || !lit) light_woods(around);
        return stays ? Change::kNone : Change::kAll;
    }
    const World of{woods, around, world, first_depth};
    const bool begins = !same || !follows_;
    follows_ = true;
    if (begins) begin(of);
    const bool built = compare_footprints(*world.things), changed = compare(of) || built;
    bool all = begins;
    if (changed || begins) {
        all = thin() || all;
        renew_stale(of);
        if (trees_.size() > 3 * room_ + Woods::kMost / 8) {  // most of it is left behind by tiles that grew
            for (Plot& plot : plots_) plot = {};
            trees_.clear(), lights_.clear(), room_ = 0;
            renew_stale(of);
            all = true;
        }
    }
    if (!lit)
        for (const TreeTile& tile : tiles_)
            for (std::uint32_t i = tile.first; i < tile.first + tile.count; ++i)
                lights_[i] = light_of(trees_[i], around, sun);
    return all ? Change::kAll : changed ? Change::kSome : Change::kNone;
}

LitTrees FollowedWoods::trees() const {
    if (follows_) return {trees_, tiles_, lights_};
    if (woods_) return {woods_->trees(), woods_->tiles(), lights_};
    return {};
}

void FollowedWoods::light_woods(const Surroundings* around) {
    lights_.clear();
    if (woods_ && around) light_trees(*woods_, *around, sun_, lights_);
}

void FollowedWoods::begin(const World& world) {
    forest_ = sim::Field<sim::Stems>(grid_);
    forest_of_own_.assign(grid_.size(), {});
    first_own_.assign(grid_.size() + 1, 0);
    own_.clear();
    own_plots_ = world.woods ? world.woods->tiles().size() : 0;
    block_ = (std::max(grid_.nx, grid_.ny) + kBlocksAlongSide - 1) / kBlocksAlongSide;
    blocks_along_x_ = (grid_.nx + block_ - 1) / block_;
    const int blocks_along_y = (grid_.ny + block_ - 1) / block_;
    plots_.assign(
        own_plots_ + static_cast<std::size_t>(blocks_along_x_) * static_cast<std::size_t>(blocks_along_y),
        {});
    tiles_.assign(plots_.size(), {});
    trees_.clear(), lights_.clear();
    footprints_.clear();
    beyond_ = 0, share_ = 1, room_ = 0;
    if (world.woods && world.woods->act()) find_own(*world.woods);
}

void FollowedWoods::find_own(const Woods& woods) {
    forest_of_own_ = forest_of(woods, grid_);
    for (const Tree& tree : woods.trees())
        if (is_of_forest(tree)) ++first_own_[static_cast<std::size_t>(tree.vertex) + 1];
    for (std::size_t i = 1; i < first_own_.size(); ++i) first_own_[i] += first_own_[i - 1];
    own_.resize(first_own_.back());
    std::vector<std::uint32_t> next(first_own_.begin(), first_own_.end() - 1);
    for (std::uint32_t plot = 0; plot < woods.tiles().size(); ++plot) {
        const TreeTile& tile = woods.tiles()[plot];
        for (std::uint32_t i = tile.first; i < tile.first + tile.count; ++i)
            if (const Tree& tree = woods.trees()[i]; is_of_forest(tree))
                own_[next[static_cast<std::size_t>(tree.vertex)]++] = {i, plot};
    }
}

// Finds where the forest is another one, and returns whether it is anywhere.
bool FollowedWoods::compare(const World& world) {
    const sim::Field<sim::Stems>& now = world.view.things->forest;
    bool any = false;
    for (int y = 0; y < grid_.ny; ++y) {
        if (same_row(forest_, now, y)) continue;
        for (int x = 0; x < grid_.nx; ++x)
            if (forest_(x, y) != now(x, y)) {
                const std::size_t vertex = vertex_at(x, y);
                beyond_ -= beyond_own(vertex);
                forest_(x, y) = now(x, y);
                beyond_ += beyond_own(vertex);
                mark_stale(vertex);
                any = true;
            }
    }
    return any;
}

bool FollowedWoods::Footprint::covers(glm::dvec2 place) const {
    const glm::dvec2 from = place - at;
    return std::abs(glm::dot(from, along)) < half.x && std::abs(cross(along, from)) < half.y;
}

// May return true though it lies beside the corners.
bool FollowedWoods::Footprint::meets(glm::dvec2 low, glm::dvec2 high) const {
    const double reach = half.x + half.y;
    return at.x + reach > low.x && at.x - reach < high.x && at.y + reach > low.y && at.y - reach < high.y;
}

void FollowedWoods::list_footprints(const sim::Things& things) {
    constexpr double kAround = 2.5, kBesideRoad = 1.5;  // m
    footprints_now_.clear();
    for (const sim::Thing& thing : things.list) {
        const glm::dvec2 from(thing.x, thing.y), to(thing.to_x, thing.to_y);
        if (thing.kind == sim::ThingKind::kNet || (thing.kind == sim::ThingKind::kRoad && from == to))
            continue;
        if (thing.kind == sim::ThingKind::kRoad)
            footprints_now_.push_back({0.5 * (from + to), glm::normalize(to - from),
                                       0.5 * glm::dvec2(glm::distance(from, to), thing.width) + kBesideRoad});
        else
            footprints_now_.push_back({from,
                                       {thing.front_x, thing.front_y},
                                       0.5 * glm::dvec2(thing.length, thing.width) + kAround});
    }
}

// Returns whether something was built or removed.
bool FollowedWoods::compare_footprints(const sim::Things& things) {
    list_footprints(things);
    if (footprints_now_ == footprints_) return false;
    const auto mark_those_not_in = [&](const std::vector<Footprint>& some,
                                       const std::vector<Footprint>& other) {
        for (std::size_t i = 0; i < some.size(); ++i)
            if (i >= other.size() || some[i] != other[i]) mark_around(some[i]);
    };
    mark_those_not_in(footprints_, footprints_now_);
    mark_those_not_in(footprints_now_, footprints_);
    footprints_.swap(footprints_now_);
    return true;
}

// Trees of a block of vertices stand up to half a cell outside it.
void FollowedWoods::mark_around(const Footprint& footprint) {
    const auto dx = static_cast<double>(grid_.dx);
    for (std::size_t plot = 0; plot < plots_.size(); ++plot) {
        if (plot < own_plots_) {
            const TreeTile& woods = woods_->tiles()[plot];
            if (footprint.meets(glm::dvec2(woods.lowest), glm::dvec2(woods.highest)))
                plots_[plot].is_stale = true;
            continue;
        }
        const auto block = static_cast<int>(plot - own_plots_);
        const glm::dvec2 low = dx * block_ * glm::dvec2(block % blocks_along_x_, block / blocks_along_x_);
        if (footprint.meets(low - dx, low + dx * (block_ + 1))) plots_[plot].is_stale = true;
    }
}

void FollowedWoods::find_near(glm::dvec2 low, glm::dvec2 high) {
    near_.clear();
    for (const Footprint& each : footprints_)
        if (each.meets(low, high)) near_.push_back(each);
}

bool FollowedWoods::is_built_on(const Tree& tree) const {
    return std::ranges::any_of(near_,
                               [&](const Footprint& each) { return each.covers(glm::dvec2(tree.foot)); });
}

void FollowedWoods::mark_stale(std::size_t vertex) {
    const auto columns = static_cast<std::size_t>(grid_.nx);
    plots_[plot_at(static_cast<int>(vertex % columns), static_cast<int>(vertex / columns))].is_stale = true;
    for (std::uint32_t i = first_own_[vertex]; i < first_own_[vertex + 1]; ++i)
        plots_[own_[i].plot].is_stale = true;
}

// Shows a half, a quarter … of the trees beyond the woods' own, if they are too many.
bool FollowedWoods::thin() {
    double share = 1;
    while (beyond_ * share > static_cast<double>(Woods::kMost)) share /= 2;
    if (share == share_) return false;
    share_ = share;
    for (std::size_t plot = own_plots_; plot < plots_.size(); ++plot) plots_[plot].is_stale = true;
    return true;
}

void FollowedWoods::renew_stale(const World& world) {
    for (std::size_t plot = 0; plot < plots_.size(); ++plot) {
        if (!plots_[plot].is_stale) continue;
        plots_[plot].is_stale = false;
        grown_.clear();
        if (plot < own_plots_)
            grow_own(plot, *world.woods);
        else
            grow_others(plot, world);
        settle(plot, world.around);
    }
}

void FollowedWoods::grow_own(std::size_t plot, const Woods& woods) {
    const TreeTile& tile = woods.tiles()[plot];
    find_near(glm::dvec2(tile.lowest), glm::dvec2(tile.highest));
    for (std::uint32_t i = tile.first; i < tile.first + tile.count; ++i) {
        Tree tree = woods.trees()[i];
        if (is_built_on(tree)) continue;
        const auto order = static_cast<float>(i - tile.first);
        if (!is_of_forest(tree) || own_.empty()) {
            grown_.push_back({order, tree});
            continue;
        }
        const auto vertex = static_cast<std::size_t>(tree.vertex);
        const Own* first = &own_[first_own_[vertex]];
        const auto number = static_cast<int>(
            std::find_if(first, first + count_own(vertex), [&](const Own& own) { return own.tree == i; }) -
            first);
        if (number >= shown_own(vertex)) continue;
        const sim::Stems& stems = at(vertex);
        if (stems.height_m != forest_of_own_[vertex].height_m)
            tree.height *= static_cast<float>(stems.height_m) / forest_of_own_[vertex].height_m;
        tree.fate = number < lying_of(vertex) ? TreeFate::kLies : TreeFate::kStands;
        grown_.push_back({order, tree});
    }
}

void FollowedWoods::grow_others(std::size_t plot, const World& world) {
    const auto block = static_cast<int>(plot - own_plots_);
    const int x0 = block % blocks_along_x_ * block_, y0 = block / blocks_along_x_ * block_;
    const auto dx = static_cast<double>(grid_.dx);
    find_near(dx * (glm::dvec2(x0, y0) - 1.0), dx * (glm::dvec2(x0, y0) + (block_ + 1.0)));
    for (int y = y0; y < std::min(y0 + block_, grid_.ny); ++y)
        for (int x = x0; x < std::min(x0 + block_, grid_.nx); ++x) {
            const std::size_t vertex = vertex_at(x, y);
            if (world.view.site(x, y) == sim::Site::kDrain) continue;
            const int others = shown_others(vertex), lying = lying_of(vertex) - shown_own(vertex);
            for (int i = 0; i < others; ++i) {
                Tree tree = other(x, y, i, world);
                if (is_built_on(tree)) continue;
                tree.fate = i < lying ? TreeFate::kLies : TreeFate::kStands;
                grown_.push_back({chance_of(vertex, i, 5), tree});
            }
        }
    std::ranges::stable_sort(grown_, {}, &Ordered::order);
}

// The places of a vertex's trees are as even as those of an additive sequence (Roberts 2018).
Tree FollowedWoods::other(int x, int y, int number, const World& world) const {
    constexpr float kStepX = 0.7548777f, kStepY = 0.5698403f;
    const std::size_t vertex = vertex_at(x, y);
    const auto share = static_cast<float>(number);
    const glm::vec2 jitter(fraction(chance_of(vertex, 0, 1) + kStepX * share) - 0.5f,
                           fraction(chance_of(vertex, 0, 2) + kStepY * share) - 0.5f);
    const glm::vec2 last(grid_.nx - 1, grid_.ny - 1);
    const glm::vec2 cell =
        last - glm::abs(last - glm::abs(glm::vec2(x, y) + jitter));  // mirrored at the border
    const int i = std::min(static_cast<int>(cell.x), grid_.nx - 2),
              j = std::min(static_cast<int>(cell.y), grid_.ny - 2);
    const sim::Field<float>& natural = world.view.things->natural;
    const auto z = [&](int at_x, int at_y) {
        const float first = world.first_depth.empty() ? 0 : world.first_depth[vertex_at(at_x, at_y)];
        return natural(at_x, at_y) + first;
    };
    const float u = cell.x - static_cast<float>(i), v = cell.y - static_cast<float>(j);
    const float west = z(i, j), east = z(i + 1, j), north = z(i, j + 1), across = z(i + 1, j + 1);
    const sim::Stems& stems = forest_(x, y);
    Tree tree{};
    tree.foot = glm::vec3(grid_.dx * cell,
                          std::lerp(std::lerp(west, east, u), std::lerp(north, across, u), v) - kSunkFoot);
    tree.chance = chance_of(vertex, number, 3);
    tree.height =
        static_cast<float>(stems.height_m) * (0.6f + 0.55f * std::sqrt(chance_of(vertex, number, 4)));
    const glm::vec2 fall(west - east + north - across, west + east - north - across);
    tree.downhill = glm::length(fall) > 0 ? glm::normalize(glm::vec2(fall.x, fall.y)) : glm::vec2(1, 0);
    tree.vertex = static_cast<std::int32_t>(vertex);
    tree.snow = tree.snow_near = world.first_depth.empty() ? 0 : world.first_depth[vertex];
    if (world.around && !world.around->empty()) {
        tree.snow = std::max(world.around->cover()[vertex].x, 0.f);
        tree.snow_near = snow_near(*world.around, glm::dvec2(tree.foot));
        tree.lower = world.around->cover()[vertex].y;
    }
    tree.closed = ramp(kClosedFrom, kClosedAt, static_cast<float>(stems_of(stems)));
    tree.group = 1;
    const float kind = chance_of(vertex, number, 6);
    tree.kind = kind < 0.06f ? TreeKind::kLarch : TreeKind::kSpruce;
    if (world.woods && world.around)
        tree.kind = world.woods->kind_of_planted(*world.around, glm::dvec2(tree.foot),
                                                 static_cast<double>(tree.closed), static_cast<double>(kind));
    return tree;
}

// Puts the trees of a plot into their place among all, and lights those that were not there before.
void FollowedWoods::settle(std::size_t plot, const Surroundings* around) {
    TreeTile& tile = tiles_[plot];
    changed_tiles_.push_back({static_cast<std::uint32_t>(plot), tile.first, tile.count});
    if (grown_.size() > plots_[plot].room) {
        room_ -= plots_[plot].room;
        plots_[plot].room = static_cast<std::uint32_t>(grown_.size() + grown_.size() / 2);
        room_ += plots_[plot].room;
        tile.first = static_cast<std::uint32_t>(trees_.size());
        trees_.resize(trees_.size() + plots_[plot].room);
        lights_.resize(trees_.size());
    }
    tile.count = static_cast<std::uint32_t>(grown_.size());
    tile.lowest = glm::vec3(1e30f), tile.highest = glm::vec3(-1e30f);
    for (std::uint32_t k = 0; k < tile.count; ++k) {
        const Tree& tree = grown_[k].tree;
        trees_[tile.first + k] = tree;
        lights_[tile.first + k] = light_of(tree, around, sun_);
        tile.lowest = glm::min(tile.lowest, tree.foot);
        tile.highest = glm::max(tile.highest, tree.foot + glm::vec3(0, 0, tree.height));
    }
}

double FollowedWoods::beyond_own(std::size_t vertex) const {
    const sim::Stems& stems = at(vertex);
    return std::max(stems_of(stems) - stems_of(forest_of_own_[vertex]), 0) * grid_.cell_area() /
           kSquareMetresOfHectare;
}

int FollowedWoods::shown_own(std::size_t vertex) const {
    const int all = stems_of(forest_of_own_[vertex]);
    if (all == 0) return 0;
    const sim::Stems& stems = at(vertex);
    const auto own = static_cast<int>(count_own(vertex));
    const int now = stems_of(stems);
    return now >= all ? own
           : now == 0 ? 0
                      : std::min(whole(static_cast<double>(own) * now / all, vertex), own);
}

int FollowedWoods::shown_others(std::size_t vertex) const {
    return whole(beyond_own(vertex) * share_, vertex);
}

// Of the trees of a vertex that are shown.
int FollowedWoods::lying_of(std::size_t vertex) const {
    const sim::Stems& stems = at(vertex);
    if (stems.lying == 0) return 0;
    const int shown = shown_own(vertex) + shown_others(vertex);
    return std::min(whole(static_cast<double>(shown) * stems.lying / stems_of(stems), vertex), shown);
}

}  // namespace render
