#include "render/frame/what_changed.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "sim/core/check.h"

namespace render {
namespace {

// Change of the standing layer, m, below which ground may look untouched: three steps of `layers`, and some room.
constexpr float kUntouched = 0.016f;
// Where untouched, one of two materials is drawn as from so many sides of the grid away, as in ground.glsl.
constexpr double kFarthest = 0.035;
// m: room for rounding between a height and a ceiling; height of what people build and of its shadow's way.
constexpr float kRoom = 0.1f, kHighest = 40;
// As in marks.glsl: half the width of a ring's line, of its dot and of an outline's line, pixels; the smallest sine of
// the angle at which ground is seen that is used.
constexpr double kLineWidth = 2.7, kDotWidth = 4.5, kOutlineWidth = 4.2, kFlattestView = 0.06;

// A bound of the length of a pixel on ground at a distance, m, that is seen at an angle with this sine.
double pixel_on_ground(float distance, double sine, const FrameBlock& frame) {
    constexpr double kDiagonal = 1.5;
    return kDiagonal * static_cast<double>(distance * frame.material.y * frame.material.z) * (1 + 1 / sine);
}

// A NaN has the bits of itself, and −0 not those of 0.
bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// Of a place in rows of so many columns.
std::size_t numbered(int column, int row, int columns) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
}

int groups_along(int vertices) {
    return (vertices + GROUP_SQUARE - 1) / GROUP_SQUARE;
}

}  // namespace

void WhatChanged::compare(const sim::View& world, std::span<const std::uint8_t> mixture,
                          std::span<const float> undisturbed, std::optional<float> walls_to,
                          const RedrawRules& rules, bool everything, const ChangedGround& ground,
                          std::span<const glm::ivec2> water) {
    rules_ = rules;
    everything |= grid_ != world.grid || mixture_.size() != mixture.size();
    if (grid_ != world.grid) resize(world);
    everything_ = everything;
    undisturbed_ = undisturbed;
    walls_to_ = walls_to;
    far_reach_ =
        mixture.empty() ? 0 : 2 + static_cast<int>(std::ceil(kFarthest * std::max(grid_.nx, grid_.ny)));
    moved_.clear();
    std::fill(near_.begin(), near_.end(), std::uint8_t{0});
    std::fill(squares_.begin(), squares_.end(), std::uint8_t{0});
    std::fill(group_.begin(), group_.end(), static_cast<std::uint8_t>(everything));
    left_ = bottom_ = std::numeric_limits<int>::max();
    right_ = top_ = -1;
    first_row_ = grid_.ny, last_row_ = -1;

    for (int y = 0; y < grid_.ny; ++y) compare_row(world, y, everything);
    compare_mixture(mixture);
    if (!everything) {
        compare_ground(world, ground);
        for (const glm::ivec2 v : water) change(v.x, v.y);
    }
    collect_groups();
    if (everything) {
        height_before_ = height_;
        for (int y = 0; y < grid_.ny; ++y)
            for (int x = 0; x < grid_.nx; ++x)
                walled_[index(x, y)] = x == 0 || y == 0 || x == grid_.nx - 1 || y == grid_.ny - 1 ||
                                       world.site(x, y) == sim::Site::kDrain;
    }
}

void WhatChanged::resize(const sim::View& world) {
    grid_ = world.grid;
    for (std::vector<float>& field : field_) field.assign(grid_.size(), 0);
    for (std::vector<float>* heights : {&height_, &height_before_}) heights->assign(grid_.size(), 0);
    for (std::vector<std::uint8_t>* each : {&near_, &squares_, &walled_}) each->assign(grid_.size(), 0);
    moved_.reserve(grid_.size());
    group_.assign(
        static_cast<std::size_t>(groups_along(grid_.nx)) * static_cast<std::size_t>(groups_along(grid_.ny)),
        0);
    groups_.reserve(group_.size());
}

void WhatChanged::compare_row(const sim::View& world, int y, bool everything) {
    const std::array<const float*, kFields> now{world.depth.row(y), world.rolling.row(y),
                                                world.velocity_x.row(y), world.velocity_y.row(y)};
    const auto start = index(0, y);
    const std::size_t bytes = sizeof(float) * static_cast<std::size_t>(grid_.nx);
    bool same = !everything;
    for (std::size_t k = 0; k < kFields && same; ++k)
        same = std::memcmp(now[k], &field_[k][start], bytes) == 0;
    if (same) return;
    first_row_ = std::min(first_row_, y);
    last_row_ = y;
    const float* bedrock = world.bedrock.row(y);
    for (int x = 0; x < grid_.nx; ++x) {
        const std::size_t v = start + static_cast<std::size_t>(x);
        bool differs = everything;
        for (std::size_t k = 0; k < kFields; ++k) differs |= !same_bits(now[k][x], field_[k][v]);
        if (!differs) continue;
        const bool was_untouched = far_reach_ > 0 && is_untouched_near(x, y);
        for (std::size_t k = 0; k < kFields; ++k) field_[k][v] = now[k][x];
        const float height = bedrock[x] + now[0][x] + now[1][x];
        if (everything || !same_bits(height, height_[v])) moved_.emplace_back(x, y);
        height_[v] = height;
        if (everything) continue;
        change(x, y);
        if (far_reach_ > 0 && (was_untouched || is_untouched_near(x, y))) open_around(x, y, far_reach_);
    }
}

// Bedrock under a vertex rose or sank, and others around it see more or less of the sky.
void WhatChanged::compare_ground(const sim::View& world, const ChangedGround& ground) {
    if (ground.vertices.empty()) return;
    glm::ivec2 low = ground.vertices.front(), high = low;
    for (const glm::ivec2 v : ground.vertices) {
        const auto i = index(v.x, v.y);
        height_[i] = world.bedrock(v.x, v.y) + world.depth(v.x, v.y) + world.rolling(v.x, v.y);
        moved_.push_back(v);
        change(v.x, v.y);
        low = glm::min(low, v), high = glm::max(high, v);
    }
    low = glm::max(low - ground.reach, glm::ivec2(0));
    high = glm::min(high + ground.reach, glm::ivec2(grid_.nx, grid_.ny) - 1);
    open_squares(low.x - rules_.reach, high.x + rules_.reach - 1, low.y - rules_.reach,
                 high.y + rules_.reach - 1);
    const int across = groups_along(grid_.nx);
    for (int y = low.y / GROUP_SQUARE; y <= high.y / GROUP_SQUARE; ++y)
        for (int x = low.x / GROUP_SQUARE; x <= high.x / GROUP_SQUARE; ++x)
            group_[numbered(x, y, across)] = 1;
}

void WhatChanged::compare_mixture(std::span<const std::uint8_t> mixture) {
    if (mixture.size() != mixture_.size() || everything_) {
        mixture_.assign(mixture.begin(), mixture.end());
        return;
    }
    const std::size_t row = 2 * static_cast<std::size_t>(grid_.nx);
    for (std::size_t begin = 0; begin < mixture.size(); begin += row) {
        if (std::memcmp(&mixture[begin], &mixture_[begin], row) == 0) continue;
        const int y = static_cast<int>(begin / row);
        first_row_ = std::min(first_row_, y);
        last_row_ = std::max(last_row_, y);
        for (int x = 0; x < grid_.nx; ++x) {
            const std::size_t i = begin + 2 * static_cast<std::size_t>(x);
            if (mixture[i] == mixture_[i] && mixture[i + 1] == mixture_[i + 1]) continue;
            mixture_[i] = mixture[i], mixture_[i + 1] = mixture[i + 1];
            change(x, y);
            if (is_untouched_near(x, y)) open_around(x, y, far_reach_);
        }
    }
}

bool WhatChanged::is_untouched(int x, int y, float depth) const {
    return undisturbed_.empty() || std::abs(depth - undisturbed_[index(x, y)]) < kUntouched;
}

bool WhatChanged::is_untouched_near(int x, int y) const {
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, grid_.ny - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, grid_.nx - 1); ++i)
            if (is_untouched(i, j, field_[0][index(i, j)])) return true;
    return false;
}

// A vertex has other layers than before: so have the slopes beside it, and all squares within reach look different.
void WhatChanged::change(int x, int y) {
    near_[index(x, y)] = 1;
    open_around(x, y, rules_.reach);
    const int across = groups_along(grid_.nx);
    for (int j = std::max(y - 1, 0) / GROUP_SQUARE; j <= std::min(y + 1, grid_.ny - 1) / GROUP_SQUARE; ++j)
        for (int i = std::max(x - 1, 0) / GROUP_SQUARE; i <= std::min(x + 1, grid_.nx - 1) / GROUP_SQUARE;
             ++i)
            group_[numbered(i, j, across)] = 1;
}

// Inclusive; a square has the number of its lower left vertex.
void WhatChanged::open_squares(int x0, int x1, int y0, int y1) {
    x0 = std::max(x0, 0), y0 = std::max(y0, 0);
    x1 = std::min(x1, grid_.nx - 2), y1 = std::min(y1, grid_.ny - 2);
    if (x0 > x1 || y0 > y1) return;
    for (int y = y0; y <= y1; ++y) std::fill_n(&squares_[index(x0, y)], x1 - x0 + 1, std::uint8_t{1});
    left_ = std::min(left_, x0), right_ = std::max(right_, x1);
    bottom_ = std::min(bottom_, y0), top_ = std::max(top_, y1);
}

void WhatChanged::collect_groups() {
    groups_.clear();
    const int across = groups_along(grid_.nx);
    for (std::size_t i = 0; i < group_.size(); ++i)
        if (group_[i] != 0) {
            const int group = static_cast<int>(i);
            groups_.push_back(group % across | group / across << 16);
        }
}

// The triangles of a flow end at its vertices.
void WhatChanged::add_flow(std::span<const int> vertices, std::span<const std::uint8_t> shown,
                           std::span<const std::uint8_t> shown_before) {
    if (everything_) return;
    for (const int v : vertices) {
        const int x = v % grid_.nx, y = v / grid_.nx;
        for (int j = std::max(y - 1, 0); j <= std::min(y, grid_.ny - 2); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x, grid_.nx - 2); ++i) {
                const std::size_t square = numbered(i, j, grid_.nx - 1);
                if ((shown[square] | shown_before[square]) != 0) open_squares(i, i, j, j);
            }
    }
}

// A ceiling is read between rays and between rows. Only where it meets what stands there does a shadow end.
void WhatChanged::add_shadows(const SunSweep& sweep, const FrameBlock& frame) {
    if (everything_ || !rules_.sun) return;
    const bool turned = frame.sweep.w > 0.5f, backwards = frame.haze.z > 0.5f;
    const int rays = sweep.rays(), rows = sweep.rows(), columns = turned ? grid_.ny : grid_.nx;
    const double shear = static_cast<double>(frame.sweep.x), wide = 0.5 + std::abs(shear);
    const int beside = walls_to_ ? 3 : 0;  // squares: a wall is lit as a place before it is
    for (int step = sweep.first_changed(); step <= sweep.last_changed(); ++step)
        for (int ray = 0; ray < rays; ++ray) {
            const auto at = [&](int s, int r) {
                return static_cast<std::size_t>(s) * static_cast<std::size_t>(rays) +
                       static_cast<std::size_t>(r);
            };
            const float now = sweep.ceilings()[at(step, ray)], before = sweep.before()[at(step, ray)];
            if (same_bits(now, before)) continue;
            const double column = static_cast<double>(frame.sweep.y) + 0.5 * ray + shear * step;
            const int c0 = std::max(static_cast<int>(std::floor(column - wide)), 0),
                      c1 = std::min(static_cast<int>(std::ceil(column + wide)), columns - 1);
            if (c0 > c1) continue;
            const int row = backwards ? rows - 1 - step : step;
            const int r0 = std::max(row - 1, 0), r1 = std::min(row + 1, rows - 1);
            const glm::ivec2 first = turned ? glm::ivec2(r0, c0) : glm::ivec2(c0, r0),
                             last = turned ? glm::ivec2(r1, c1) : glm::ivec2(c1, r1);
            float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
            for (int s = std::max(step - 1, 0); s <= std::min(step + 1, rows - 1); ++s)
                for (int r = std::max(ray - 1, 0); r <= std::min(ray + 1, rays - 1); ++r)
                    for (const float ceiling : {sweep.ceilings()[at(s, r)], sweep.before()[at(s, r)]})
                        least = std::min(least, ceiling), most = std::max(most, ceiling);
            const glm::vec2 ground = heights_between(first, last);
            const float lowest = walls_to_.value_or(ground.x) - kRoom,
                        shade = least - 0.5f * frame.sweep.z - kRoom;  // below it there was none and is none
            if (most < lowest || ground.y + kHighest < shade) continue;
            for (int y = first.y; y <= last.y; ++y)
                std::fill_n(&near_[index(first.x, y)], last.x - first.x + 1, std::uint8_t{1});
            if (ground.y < shade) continue;
            open_squares(first.x - beside, last.x - 1 + beside, first.y - beside, last.y - 1 + beside);
        }
}

// A ring is as wide as so many pixels, which on the ground are the longer, the farther off and the flatter it is seen.
void WhatChanged::add_ring(const std::optional<Ring>& before, const std::optional<Ring>& now,
                           const FrameBlock& frame) {
    if (everything_ || before == now) return;
    constexpr int kSide = 2;  // squares
    const double dx = static_cast<double>(grid_.dx);
    for (int y = 0; y + 1 < grid_.ny; y += kSide)
        for (int x = 0; x + 1 < grid_.nx; x += kSide) {
            const glm::ivec2 first(x, y), last = glm::min(first + kSide, glm::ivec2(grid_.nx, grid_.ny) - 1);
            const glm::vec3 corner(grid_.dx * glm::vec2(first), height_[index(x, y)]);
            const double longest = pixel_on_ground(
                glm::distance(corner, glm::vec3(frame.eye)) + 4 * kSide * grid_.dx, kFlattestView, frame);
            double pixel = -1;  // not known yet
            for (const std::optional<Ring>& ring : {before, now}) {
                if (!ring) continue;
                const glm::dvec2 nearest =
                    glm::clamp(ring->centre, dx * glm::dvec2(first), dx * glm::dvec2(last));
                const double away = glm::distance(nearest, ring->centre);
                const auto is_beside = [&](double of) {
                    return away > std::max(ring->radius + kLineWidth * of, kDotWidth * of);
                };
                if (is_beside(longest)) continue;  // even if it is seen at the flattest angle
                if (away > ring->radius && pixel < 0) pixel = longest_pixel(first, last, frame);
                if (away > ring->radius && is_beside(pixel)) continue;
                open_squares(first.x, last.x - 1, first.y, last.y - 1);
            }
        }
}

// Around the rectangle its line is as wide as so many pixels.
void WhatChanged::add_outline(const std::optional<Outline>& before, const std::optional<Outline>& now,
                              const FrameBlock& frame) {
    if (everything_ || before == now) return;
    const auto dx = static_cast<double>(grid_.dx);
    for (int y = 0; y + 1 < grid_.ny; ++y)
        for (int x = 0; x + 1 < grid_.nx; ++x) {
            const glm::dvec2 middle = dx * (glm::dvec2(x, y) + 0.5);
            const glm::vec3 corner(grid_.dx * glm::vec2(x, y), height_[index(x, y)]);
            const float distance = glm::distance(corner, glm::vec3(frame.eye)) + 4 * grid_.dx;
            const double longest = pixel_on_ground(distance, kFlattestView, frame);
            for (const std::optional<Outline>& outline : {before, now}) {
                if (!outline) continue;
                const glm::dvec2 along = outline->to - outline->from, away = middle - outline->from;
                const double t =
                    std::clamp(glm::dot(away, along) / std::max(glm::dot(along, along), 1e-9), 0.0, 1.0);
                const double beside = glm::distance(away, t * along) - outline->width / 2 - dx;
                if (beside > kOutlineWidth * longest) continue;  // even if it is seen at the flattest angle
                if (beside > 0 && beside > kOutlineWidth * longest_pixel({x, y}, {x + 1, y + 1}, frame))
                    continue;
                open_squares(x, x, y, y);
            }
        }
}

// A line follows from the four by four vertices of the spline alone.
void WhatChanged::add_extent(std::span<const glm::ivec2> vertices) {
    constexpr int kSpline = 2;  // vertices to each side
    if (everything_) return;
    for (const glm::ivec2 v : vertices) open_around(v.x, v.y, kSpline);
}

// The longest that a pixel can be on the ground between two vertices, m.
double WhatChanged::longest_pixel(glm::ivec2 first, glm::ivec2 last, const FrameBlock& frame) const {
    const glm::vec3 eye(frame.eye);
    const float dx = grid_.dx;
    float farthest = 0, flattest = 1;
    bool known = true;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const glm::vec3 ray = glm::vec3(dx * glm::vec2(x, y), height_[index(x, y)]) - eye;
            const float distance = glm::length(ray);
            farthest = std::max(farthest, distance);
            // Beside a hole or the border slopes are other ones, and near the eye rays differ much.
            if (walled_[index(x, y)] != 0 ||
                distance < 8 * dx * static_cast<float>(last.x - first.x + last.y - first.y)) {
                known = false;
                continue;
            }
            const auto height = [&](int i, int j) { return height_[index(i, j)]; };
            const glm::vec3 normal(height(x - 1, y) - height(x + 1, y), height(x, y - 1) - height(x, y + 1),
                                   2 * dx);
            flattest = std::min(flattest, -glm::dot(normal, ray) / (glm::length(normal) * distance));
        }
    constexpr float kOfSlopesBetween = 0.7f;
    const double sine = known ? std::max<double>(kOfSlopesBetween * flattest, kFlattestView) : kFlattestView;
    return pixel_on_ground(farthest, sine, frame);
}

bool WhatChanged::is_near(glm::vec2 low, glm::vec2 high) const {
    const int x0 = std::max(static_cast<int>(std::floor(low.x / grid_.dx)) - 1, 0),
              x1 = std::min(static_cast<int>(std::ceil(high.x / grid_.dx)) + 1, grid_.nx - 1);
    const int y0 = std::max(static_cast<int>(std::floor(low.y / grid_.dx)) - 1, 0),
              y1 = std::min(static_cast<int>(std::ceil(high.y / grid_.dx)) + 1, grid_.ny - 1);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            if (near_[index(x, y)] != 0) return true;
    return false;
}

glm::vec2 WhatChanged::heights_in(glm::vec2 low, glm::vec2 high) const {
    const glm::vec2 last(grid_.nx - 1, grid_.ny - 1);
    const glm::ivec2 first(glm::clamp(glm::floor(low / grid_.dx), glm::vec2(0), last));
    return heights_between(first, glm::ivec2(glm::clamp(glm::ceil(high / grid_.dx), glm::vec2(0), last)));
}

glm::vec2 WhatChanged::heights_between(glm::ivec2 first, glm::ivec2 last) const {
    const std::vector<float>& before = rules_.old_heights ? height_before_ : height_;
    glm::vec2 range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const auto v = index(x, y);
            range.x = std::min({range.x, height_[v], before[v]});
            range.y = std::max({range.y, height_[v], before[v]});
        }
    return range;
}

void WhatChanged::mark(const OnScreen& screen, ScreenTiles& tiles) const {
    const int side = rules_.block;
    for (int y0 = bottom_ / side * side; y0 <= top_; y0 += side)
        for (int x0 = left_ / side * side; x0 <= right_; x0 += side) {
            const int x1 = std::min(x0 + side, grid_.nx - 1), y1 = std::min(y0 + side, grid_.ny - 1);
            bool any = false, wall = false;
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) any |= squares_[index(x, y)] != 0;
            if (!any) continue;
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x) wall |= walled_[index(x, y)] != 0;
            const glm::vec2 heights = heights_between({x0, y0}, {x1, y1});
            const float low = wall && walls_to_ ? *walls_to_ : heights.x;
            const float dx = grid_.dx;
            tiles.mark(screen.box({dx * static_cast<float>(x0), dx * static_cast<float>(y0), low},
                                  {dx * static_cast<float>(x1), dx * static_cast<float>(y1), heights.y}));
        }
}

void WhatChanged::finish() {
    for (const glm::ivec2 v : moved_) {
        const auto i = index(v.x, v.y);
        height_before_[i] = height_[i];
    }
}

}  // namespace render
