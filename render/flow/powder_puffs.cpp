#include "render/flow/powder_puffs.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/ramp.h"

namespace render {
namespace {

constexpr float kThickness = 0.42f;  // of an opaque puff, through its middle
constexpr float kScattered = 0.15f;  // of the light, passed on from grain to grain to the depth of the cloud
constexpr float kFaintest =
    0.01f;  // opacity, from which on a puff is drawn; all lose as much, so that none appears at once
constexpr float kNearest = 4, kFar = 8;  // radii: nearer puffs are not drawn, from here on all of them is
// Mean radii of the puffs, or the puff's own if it is larger: where on its way a shadow is counted as part of the cloud.
// It ends with the last one, as in powder_light.frag.
constexpr float kShadow[] = {1, 2, POWDER_SHADOW};

// Share of its opacity with which a puff is drawn. Near the eye the cloud parts, so that the blocks of the flow stay visible. A
// puff that is hardly there would be a veil with a rim.
float parted(float distance, float radius) {
    const float share = ramp(kNearest * radius, kFar * radius, distance);
    return share * share;
}

// Of a cell of the map.
std::size_t number(int x, int y) {
    constexpr auto kSide = static_cast<std::size_t>(ShadeMap::kSide);
    return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
}

// Of what nearer puffs leave to see of one: from here to there it is drawn more and more.
constexpr float kHidden = 0.02f, kSeen = 0.06f;
constexpr float kCore = 0.65f, kCoreShare = 0.6f;  // part of the radius that hides, and of the opacity there

}  // namespace

ShadeMap::ShadeMap() : cells_(static_cast<std::size_t>(kSide) * kSide) {
    order_.reserve(sim::powder::Cloud::kMost);
    light_.reserve(sim::powder::Cloud::kMost);
}

std::span<const float> ShadeMap::cast(std::span<const sim::powder::Puff> puffs,
                                      std::span<const float> opacity, const glm::vec3& direction) {
    const glm::vec3 aside = std::abs(direction.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    const glm::vec3 across = glm::normalize(glm::cross(aside, direction)), up = glm::cross(direction, across);
    glm::vec2 low(1e30f), high(-1e30f);
    order_.clear();
    for (std::size_t i = 0; i < puffs.size(); ++i) {
        const glm::vec2 at(glm::dot(across, puffs[i].at), glm::dot(up, puffs[i].at));
        low = glm::min(low, at - radius(puffs[i]));
        high = glm::max(high, at + radius(puffs[i]));
        order_.emplace_back(-glm::dot(direction, puffs[i].at), i);
    }
    std::sort(order_.begin(), order_.end());
    const float side = std::max(high.x - low.x, high.y - low.y);
    across_ = glm::vec4(across, -low.x) / side;
    up_ = glm::vec4(up, -low.y) / side;

    cells_.assign(static_cast<std::size_t>(kSide) * kSide, glm::vec2(0));
    light_.resize(puffs.size());
    for (const auto& [behind, i] : order_) {
        const glm::vec4 at(puffs[i].at, 1);
        const glm::vec2 cell =
            static_cast<float>(kSide) * glm::vec2(glm::dot(across_, at), glm::dot(up_, at));
        light_[i] = kScattered + (1 - kScattered) * std::exp(-thickness(cell));
        add(cell, radius(puffs[i]) * kSide / side, kThickness * opacity[i], -behind);
    }
    return light_;
}

float ShadeMap::thickness(glm::vec2 at) const {
    at = glm::clamp(at - 0.5f, glm::vec2(0), glm::vec2(kSide - 1.001f));
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    const float u = at.x - static_cast<float>(x), v = at.y - static_cast<float>(y);
    const auto cell = [&](int i, int j) { return cells_[number(i, j)].x; };
    return std::lerp(std::lerp(cell(x, y), cell(x + 1, y), u),
                     std::lerp(cell(x, y + 1), cell(x + 1, y + 1), u), v);
}

void ShadeMap::add(glm::vec2 at, float reach, float thickness, float along) {
    const float wide = std::max(reach, 1.f);
    thickness *= std::min(reach * reach, 1.f);  // a puff smaller than a cell covers part of it
    const int first_x = std::max(static_cast<int>(at.x - wide), 0),
              last_x = std::min(static_cast<int>(at.x + wide), kSide - 1);
    const int first_y = std::max(static_cast<int>(at.y - wide), 0),
              last_y = std::min(static_cast<int>(at.y + wide), kSide - 1);
    for (int y = first_y; y <= last_y; ++y)
        for (int x = first_x; x <= last_x; ++x) {
            const glm::vec2 away = (glm::vec2(x, y) + 0.5f - at) / wide;
            const float more = thickness * std::max(1 - glm::dot(away, away), 0.f);
            cells_[number(x, y)] += glm::vec2(more, more * along);
        }
}

VeilMap::VeilMap() : share_(static_cast<std::size_t>(kAcross) * kUp) {}

void VeilMap::clear() {
    std::fill(share_.begin(), share_.end(), 1.f);
}

VeilMap::Cells VeilMap::cells_of(glm::vec2 low, glm::vec2 high) {
    const auto cell = [](float at, int cells) {
        return static_cast<int>((0.5f + 0.5f * std::clamp(at, -1.f, 1.f)) *
                                (static_cast<float>(cells) - 0.001f));
    };
    return {cell(low.x, kAcross), cell(low.y, kUp), cell(high.x, kAcross), cell(high.y, kUp)};
}

float VeilMap::seen(glm::vec2 middle, glm::vec2 half) const {
    const Cells cells = cells_of(middle - half, middle + half);
    float most = 0;
    for (int y = cells.bottom; y <= cells.top; ++y) {
        const auto row = share_.begin() + static_cast<std::ptrdiff_t>(y) * kAcross;
        most = std::max(most, *std::max_element(row + cells.left, row + cells.right + 1));
    }
    return most;
}

void VeilMap::lay(glm::vec2 middle, glm::vec2 half, float opacity) {
    const Cells cells = cells_of(middle - half, middle + half);
    const glm::vec2 size(kAcross, kUp);
    for (int y = cells.bottom; y <= cells.top; ++y)
        for (int x = cells.left; x <= cells.right; ++x) {
            const glm::vec2 away = ((glm::vec2(x, y) + 0.5f) / size * 2.f - 1.f - middle) / half;
            if (glm::dot(away, away) < 1)
                share_[static_cast<std::size_t>(y) * kAcross + static_cast<std::size_t>(x)] *= 1 - opacity;
        }
}

PowderPuffs::PowderPuffs() {
    opacity_.reserve(sim::powder::Cloud::kMost);
    in_view_.reserve(sim::powder::Cloud::kMost);
    drawn_.reserve(sim::powder::Cloud::kMost);
}

void PowderPuffs::find(std::span<const sim::powder::Puff> puffs, const FrameBlock& frame, float strength,
                       int width, int height, bool all) {
    drawn_.clear();
    in_view_.clear();
    opacity_.clear();
    covered_ = 0;
    box_ = {1, 1, -1, -1};
    parts_ = {};
    mixed_ = false;
    if (puffs.empty() || strength <= 0) return;
    tiles_.begin(width, height);
    float radii = 0;
    for (const sim::powder::Puff& puff : puffs) {
        opacity_.push_back(strength * opacity(puff));
        radii += radius(puff);
    }
    mean_radius_ = radii / static_cast<float>(puffs.size());
    find_in_view(puffs, frame);
    if (in_view_.empty()) return;
    light_and_sort(puffs, glm::vec3(frame.sun));
    if (!all) hide_behind_nearer();
    box_ = glm::clamp(box_, -1.f, 1.f);
    parts_ = tiles_.collect();
}

void PowderPuffs::find_in_view(std::span<const sim::powder::Puff> puffs, const FrameBlock& frame) {
    const glm::vec3 eye(frame.eye), forward(frame.ray_forward), sun(frame.sun);
    const float wide = glm::length(glm::vec3(frame.ray_right)), high = glm::length(glm::vec3(frame.ray_up));
    for (std::size_t i = 0; i < puffs.size(); ++i) {
        const sim::powder::Puff& puff = puffs[i];
        const float r = radius(puff), distance = glm::dot(puff.at - eye, forward);
        if (opacity_[i] < kFaintest) continue;
        // Includes what a ball of its size covers at a place. Returns false if that is beside the frame.
        const auto include = [&](const glm::vec3& at, float nearest) {
            const glm::vec4 clip = frame.clip_from_world * glm::vec4(at, 1);
            if (clip.w < nearest * r) return false;
            const glm::vec2 middle = glm::vec2(clip) / clip.w, half = glm::vec2(r / wide, r / high) / clip.w;
            if (middle.x + half.x < -1 || middle.x - half.x > 1 || middle.y + half.y < -1 ||
                middle.y - half.y > 1)
                return false;
            box_ = {std::min(box_.x, middle.x - half.x), std::min(box_.y, middle.y - half.y),
                    std::max(box_.z, middle.x + half.x), std::max(box_.w, middle.y + half.y)};
            tiles_.add(middle, half);
            return true;
        };
        // The shadow of a puff beside the frame may fall into it.
        for (const float radii_away : kShadow)
            include(puff.at - radii_away * std::max(r, mean_radius_) * sun, 1);
        if (opacity_[i] * parted(distance, r) < kFaintest || !include(puff.at, kNearest)) continue;
        const glm::vec4 clip = frame.clip_from_world * glm::vec4(puff.at, 1);
        in_view_.push_back(
            {-distance, i, glm::vec2(clip) / clip.w, glm::vec2(r / wide, r / high) / distance});
        mixed_ = mixed_ || puff.lower > 0;
    }
}

void PowderPuffs::light_and_sort(std::span<const sim::powder::Puff> puffs, const glm::vec3& sun) {
    const std::span<const float> from_sun = shade_.cast(puffs, opacity_, sun);
    const std::span<const float> from_sky = sky_shade_.cast(puffs, opacity_, {0, 0, 1});
    std::sort(in_view_.begin(), in_view_.end(), [](const InView& a, const InView& b) {
        return a.behind != b.behind ? a.behind < b.behind : a.puff < b.puff;
    });
    for (const InView& seen : in_view_) {
        const sim::powder::Puff& puff = puffs[seen.puff];
        const float r = radius(puff), shown = opacity_[seen.puff] * parted(-seen.behind, r);
        const auto turn = static_cast<float>(puff.seed >> 8) / 16777216.f;
        drawn_.push_back({glm::vec4(puff.at, r),
                          {shown - kFaintest, from_sun[seen.puff], from_sky[seen.puff], turn},
                          {puff.age_s, puff.age_s / puff.life_s, puff.lower, 0}});
    }
}

// Most puffs of a thick cloud are behind others, and cost the most.
void PowderPuffs::hide_behind_nearer() {
    veil_.clear();
    for (std::size_t i = drawn_.size(); i-- > 0;) {
        float& shown = drawn_[i].look.x;
        const InView& at = in_view_[i];
        shown *= ramp(kHidden, kSeen, veil_.seen(at.middle, at.half));
        if (shown <= 0) continue;
        veil_.lay(at.middle, kCore * at.half, kCoreShare * shown);
        covered_ += 0.785f * at.half.x * at.half.y;
    }
    std::erase_if(drawn_, [](const DrawnPuff& puff) { return puff.look.x <= 0; });
}

}  // namespace render
