#include "render/woods/trees_in_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/base/ramp.h"
#include "render/base/tree_model.h"

namespace render {
namespace {

constexpr float kWiderInStand = 0.2f;  // by this share, so that a stand is closed
// Far away some trees are left out, and others are drawn larger, so that they cover as much: so many of a
// tile that the mean one is as wide as this share of the frame's height, because a small frame has few trees
// anyhow.
constexpr float kWideOfHeight = 0.0145f, kLeastWide = 5.5f, kMostWide = 10.5f;  // pixels
constexpr float kMeanWidth = 5;                                                 // m
// One that stands for few is a larger tree, one that stands for more a group of them side by side, which is
// not as wide because it has no flanks to its foot.
constexpr float kGroup = 8, kWidthOfGroup = 0.75f;
constexpr float kTaller = 0.4f;  // power of how many it stands for by which one is taller
constexpr float kBushGone = 5,
                kBushWhole = 20;  // pixels of height: below the first none is drawn, from the second on all
constexpr float kLongestShadow = 36;  // m
constexpr float kShadowPixels =
    7;  // height below which a tree casts none, or four times that within a stand, and a bush
constexpr float kShallow = 0.15f,
                kDeep = 0.6f;  // m: a flow bends a tree from the first on, and from the second breaks it
constexpr float kSlow = 1.5f, kFast = 4.5f;  // m/s, the same
constexpr float kCrushed = 0.65f;            // width of a lying tree, of a standing one's
constexpr float kLaid = 1.5f;                // rad, of a tree that lies
constexpr float kLean = 0.05f,
                kMostLean = 0.22f;  // tangents: of most trees at most, and of one that stands out
constexpr float kLeaning = 0.06f;   // share of those
constexpr float kBare = 0.02f,
                kSnowy =
                    0.3f;  // m of snow near a tree: from the first on it carries some, from the second all
constexpr float kShedInSun = 0.5f;  // share of its snow that a tree on a south slope has lost

// Whether a ball around a place, `from` the eye, is beside the image or behind the eye.
bool is_beside(glm::vec3 from, const FrameBlock& frame, float radius) {
    const float deep = glm::dot(from, glm::vec3(frame.ray_forward));
    const glm::vec3 middle = glm::vec3(frame.ray_middle - frame.ray_forward);
    const auto outside = [&](const glm::vec4& ray) {
        const float half = glm::length(glm::vec3(ray));  // of the image at a distance of 1
        const float farthest = std::abs(glm::dot(middle, glm::vec3(ray))) / half + half;
        return std::abs(glm::dot(from - deep * middle, glm::vec3(ray))) / half >
               deep * half + radius * std::sqrt(1 + farthest * farthest);
    };
    return deep < -radius || outside(frame.ray_right) || outside(frame.ray_up);
}

// Interpolates between vertices; outside the grid that is what its border has.
template <class Value>
float between_vertices(const sim::Grid& grid, glm::vec2 at, const Value& z) {
    const glm::vec2 cell = glm::clamp(at / grid.dx, glm::vec2(0), glm::vec2(grid.nx - 1, grid.ny - 1));
    const int x = std::min(static_cast<int>(cell.x), grid.nx - 2),
              y = std::min(static_cast<int>(cell.y), grid.ny - 2);
    const float u = cell.x - static_cast<float>(x), v = cell.y - static_cast<float>(y);
    return std::lerp(std::lerp(z(x, y), z(x + 1, y), u), std::lerp(z(x, y + 1), z(x + 1, y + 1), u), v);
}

// Height of the surface now.
float surface(const sim::View& world, glm::vec2 at) {
    return between_vertices(world.grid, at, [&](int i, int j) {
        return world.bedrock(i, j) + world.depth(i, j) + world.rolling(i, j);
    });
}

// Height of what was sculpted, m; outside the grid that at its border.
float earth_at(const sim::View& world, glm::vec2 at) {
    return between_vertices(world.grid, at, [&](int i, int j) { return world.things->earth(i, j); });
}

// A number of the tree's own, 0 to 1, independent of the others.
float own(const Tree& tree, float factor) {
    const float x = tree.chance * factor;
    return x - std::floor(x);
}

// The wood parts before the eye, which would see nothing within a crown: a tree shrinks as the eye comes near.
float parted(const Tree& tree, const glm::vec3& eye) {
    constexpr float kGone = 0.25f, kWhole = 0.5f;  // distance from its axis, of its height
    if (eye.z > tree.foot.z + 1.2f * tree.height) return 1;
    return ramp(kGone * tree.height, kWhole * tree.height,
                glm::distance(glm::vec2(tree.foot), glm::vec2(eye)));
}

// The way its stem points. Few trees are plumb.
glm::vec3 upright(const Tree& tree) {
    const float most = own(tree, 83.3f) < kLeaning ? kMostLean : kLean;
    const glm::vec2 way(own(tree, 23.9f) - 0.5f, own(tree, 61.7f) - 0.5f);
    return glm::normalize(glm::vec3(most * std::sqrt(2.f) * way, 1));
}

// Bends a tree as far as the flow has reached its stem, and lays it into the deposit.
void lay(const Tree& tree, const sim::View& world, float lying, DrawnTree& drawn) {
    const float aside = 1.1f * (own(tree, 37.3f) - 0.5f), angle = kLaid * lying;
    const glm::vec2 along =
        glm::vec2(tree.downhill.x - aside * tree.downhill.y, tree.downhill.y + aside * tree.downhill.x) /
        std::sqrt(1 + aside * aside);
    const glm::vec2 root(tree.foot), top = root + tree.height * along;
    const float radius = kCrushed * std::min(radius_of(tree.kind), kConiferRadius) * tree.height;
    // Some lie on the deposit, and some look out of it with one end.
    const float root_z =
        std::lerp(tree.foot.z, surface(world, root) + radius * (0.5f - 1.2f * own(tree, 71.9f)), lying);
    const float top_z = surface(world, top) + radius * (0.9f - 1.5f * own(tree, 53.7f));
    const glm::vec3 flat = glm::normalize(glm::vec3(along * tree.height, top_z - root_z));
    drawn.foot.z = root_z;
    drawn.axis = glm::vec4(glm::normalize(std::cos(angle) * glm::vec3(drawn.axis) + std::sin(angle) * flat),
                           tree.chance);
    drawn.look.w *= std::lerp(1.f, kCrushed, lying);
    drawn.shadow.w *= 1 - lying;
}

}  // namespace

float snow_kept(const Tree& tree) {
    return ramp(kBare, kSnowy, tree.snow_near) * (1 - kShedInSun * std::max(-tree.downhill.y, 0.f));
}

float lying(const Tree& tree, const FlowSoFar& flow) {
    if (tree.fate != TreeFate::kOfFlow) return tree.fate == TreeFate::kLies ? 1.f : 0.f;
    if (tree.vertex < 0 || flow.depth.empty()) return 0;
    const auto vertex = static_cast<std::size_t>(tree.vertex);
    const float strength = 0.7f + 0.6f * own(tree, 19.1f);
    return ramp(kShallow * strength, kDeep * strength, flow.depth[vertex]) *
           ramp(kSlow, kFast, flow.speed[vertex]);
}

// Its picture faces the eye: seen from above it reaches beside the tree by a share of its height.
Rectangle TreesInView::seen(const DrawnTree& tree, const OnScreen& screen) {
    const glm::vec3 foot(tree.foot), top = foot + 1.02f * tree.foot.w * glm::vec3(tree.axis);
    const float beside = 1.5f * tree.look.w + 0.3f * tree.foot.w;
    const Rectangle crown = screen.box(glm::min(foot, top) - beside, glm::max(foot, top) + beside);
    if (tree.shadow.w <= 0) return crown;
    const glm::vec3 tip(tree.shadow);
    return around_both(crown,
                       screen.box(glm::min(foot, tip) - beside - 1.f, glm::max(foot, tip) + beside + 1.f));
}

void TreesInView::reserve(std::size_t trees) {
    upright_.reserve(trees);
    drawn_.reserve(trees);
    moved_.reserve(trees);
}

void TreesInView::find(const LitTrees& of, const FrameBlock& frame, const OnScreen& screen) {
    upright_.clear();
    const glm::vec3 eye(frame.eye);
    const float pixel = frame.material.y * frame.material.z;  // m at a distance of 1 m
    const float frame_height = 2 * frame.ray_up.w / pixel;
    const float wide_pixels = std::clamp(kWideOfHeight * frame_height, kLeastWide, kMostWide);
    const auto share_at = [&](float distance, float group) {
        return std::clamp(kMeanWidth * group / (distance * pixel) / wide_pixels, group / Woods::kMostTogether,
                          1.f);
    };
    const auto together_at = [&](float distance) {
        return std::max(wide_pixels * distance * pixel / kMeanWidth, 1.f);
    };
    for (const TreeTile& tile : of.tiles) {
        // With branches and shadows beside it.
        if (tile.count == 0 ||
            screen.box(tile.lowest - kLongestShadow, tile.highest + kLongestShadow).empty())
            continue;
        const float first = of.trees[tile.first].chance;  // of few trees of a tile not always one is left
        for (std::uint32_t k = 0; k < tile.count; ++k) {
            const std::uint32_t i = tile.first + k;
            const Tree& tree = of.trees[i];
            const float distance = std::max(glm::distance(tree.foot, eye), 1.f);
            // One that is left out shrinks first.
            const bool bush = tree.kind == TreeKind::kBush;
            const float share = bush ? ramp(kBushGone, kBushWhole, tree.height / (distance * pixel))
                                     : share_at(distance, tree.group);
            const float rank = (static_cast<float>(k) + first) / static_cast<float>(tile.count);
            if (rank >= share) continue;
            const float kept =
                (share < 1 ? std::min((share - rank) / (0.15f * share), 1.f) : 1.f) * parted(tree, eye);
            if (kept <= 0) continue;
            if (is_beside(tree.foot - eye, frame, kLongestShadow + tree.height)) continue;

            // Near the eye it is one tree, even if it stands for more.
            const float together = bush ? 1.f : std::min(tree.group / share, together_at(distance)),
                        taller = std::pow(std::min(together, kGroup), kTaller);
            const float height = tree.height * kept * taller, high = height / (distance * pixel);
            const bool group = together > kGroup;
            const float wide = radius_of(tree.kind) * tree.height * kept * together / taller *
                               (1 + kWiderInStand * tree.closed);
            const float half = std::max(group ? kWidthOfGroup * wide : wide, 0.6f * kept * distance * pixel);
            const float shadow =
                of.lights[i].sunlit * ramp(1, 2, high / (kShadowPixels * (bush ? 4 : 1 + 3 * tree.closed)));
            upright_.push_back({{{tree.foot, height},
                                 {upright(tree), tree.chance},
                                 {of.lights[i].sunlit, 0, tree.lower, half},
                                 {of.lights[i].tip, shadow},
                                 {static_cast<float>(tree.kind), group ? std::round(together) : 1,
                                  tree.closed, snow_kept(tree)}},
                                i,
                                distance});
        }
    }
    // What they hide is not shaded.
    std::sort(upright_.begin(), upright_.end(), [](const Upright& a, const Upright& b) {
        return std::pair(a.distance, a.tree) < std::pair(b.distance, b.tree);
    });
    const auto shades = [](const Upright& tree) { return tree.drawn.shadow.w > 0; };
    with_shadow_ = static_cast<std::size_t>(std::find_if(upright_.rbegin(), upright_.rend(), shades).base() -
                                            upright_.begin());
    drawn_.clear();
    for (const Upright& tree : upright_) drawn_.push_back(tree.drawn);
}

void TreesInView::find_again(const LitTrees& of, std::span<const ChangedTile> changed,
                             const FrameBlock& frame, const OnScreen& screen) {
    drawn_before_.swap(drawn_);
    gone_.clear();
    grown_.clear();
    settled_.assign(of.trees.size(), nullptr);
    for (std::size_t i = 0; i < upright_.size(); ++i) settled_[upright_[i].tree] = &drawn_before_[i];
    for (const ChangedTile& each : changed) {
        for (std::uint32_t i = each.first_before; i < each.first_before + each.count_before; ++i)
            if (settled_[i]) gone_.push_back(*settled_[i]);
        std::fill_n(settled_.begin() + each.first_before, each.count_before, nullptr);
        std::fill_n(settled_.begin() + of.tiles[each.tile].first, of.tiles[each.tile].count, nullptr);
    }
    find(of, frame, screen);
    for (std::size_t i = 0; i < upright_.size(); ++i) {
        if (const DrawnTree* before = settled_[upright_[i].tree])
            drawn_[i] = *before;
        else
            grown_.push_back(i);
    }
}

void TreesInView::settle(std::span<const Tree> trees, const sim::View& world, const FlowSoFar& flow,
                         bool carried_off) {
    moved_.clear();
    for (std::size_t i = 0; i < upright_.size(); ++i) {
        const Tree& tree = trees[upright_[i].tree];
        if (tree.vertex < 0) continue;
        DrawnTree now = upright_[i].drawn;
        now.foot.z -=
            std::max(tree.snow - world.depth(tree.vertex % world.grid.nx, tree.vertex / world.grid.nx), 0.f);
        if (world.things) {
            now.foot.z += earth_at(world, glm::vec2(tree.foot));
            now.shadow.z += earth_at(world, glm::vec2(now.shadow));
        }
        if (const float laid = lying(tree, flow); laid > 0) lay(tree, world, laid, now);
        if (carried_off && tree.fate == TreeFate::kLies) now.look.w = now.shadow.w = 0;
        if (now == drawn_[i]) continue;
        moved_.push_back({i, drawn_[i]});
        drawn_[i] = now;
    }
}

}  // namespace render
