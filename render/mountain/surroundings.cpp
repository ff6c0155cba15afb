#include "render/mountain/surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/base/noise.h"
#include "render/base/ramp.h"
#include "sim/core/check.h"
#include "sim/world/mixture.h"

namespace render {
namespace {

constexpr int kPeriod = 4096;             // cells until noise repeats: farther than the surroundings reach
constexpr std::size_t kSmoothings = 200;  // of filled holes
constexpr std::size_t kMostSmoothed = 50'000'000;  // vertices times smoothings, half a second
constexpr double kCrags = 0.20;                    // height of crags in a hole, of the relief
constexpr int kHeightSteps = 24;                   // of mean covers

// −1 to 1.
double noise(glm::dvec2 at, std::uint32_t seed) {
    const glm::vec2 p(at + 1000.0);  // away from 0, where the lattice is mirrored by rounding toward it
    return 2 * static_cast<double>(value_noise(p.x, p.y, kPeriod, seed)) - 1;
}

// Sharp crests and round valleys, 0 to 1, about 0.45 in the mean. Octaves shorter than five `spacing`s fade
// into their mean, because the mesh could show them only as needles.
double ridges(glm::dvec2 at, double wavelength, double spacing, std::uint32_t seed) {
    constexpr double kMean = 0.42;
    double sum = 0, weight = 0.55;
    for (std::uint32_t octave = 0; octave < 4; ++octave, weight *= 0.45, wavelength *= 0.47) {
        const double crest = 1 - std::abs(noise(at / wavelength + 17.0 * octave, seed + octave));
        sum += weight * glm::mix(kMean, crest * crest, ramp(2, 5, wavelength / spacing));
    }
    return sum;
}

// Ridges, gullies and crags about −1 to 1, in octaves from `wavelength` down to three `spacing`s. A finer octave is
// rough on the crests of the broader ones and smooth in their hollows. `rim` is the distance from ground that
// is known, where they must vanish: fine ones begin nearer to it than broad ones.
double crags(glm::dvec2 at, double wavelength, double spacing, double rim, std::uint32_t seed) {
    constexpr double kMean = 0.6;
    double sum = 0, weight = 1, rough = 1;
    glm::dvec2 p = at / wavelength + 1000.0;
    for (std::uint32_t octave = 0; wavelength > 3 * spacing; ++octave) {
        const glm::vec2 q(p);
        const double n = 1.4 * static_cast<double>(gradient_noise(q.x, q.y, kPeriod, seed + octave));
        const double crest = (1 - std::abs(n)) * (1 - std::abs(n));
        sum += weight * rough * (crest - kMean) * ramp(0, 0.6, rim / wavelength) *
               ramp(3, 6, wavelength / spacing);
        rough = std::clamp(0.25 + 1.1 * crest, 0.0, 1.0);
        // The next octave is turned, so that no lattice shows, and bent, so that its ribs run down these crests.
        p = 2.1 * glm::dvec2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y) + 0.35 * n;
        wavelength /= 2.1;
        weight *= 0.48;
    }
    return sum;
}

// The standing layer of a vertex: its depth, m, and the share of the lower material at its surface, which
// is bare where less than a skin lies on it.
glm::vec2 cover_of(float depth, float lower_depth) {
    const float skin = std::min(sim::kSkin, depth), above = depth - std::min(lower_depth, depth);
    return {depth, skin > 0 ? std::max(skin - above, 0.f) / skin : 0.f};
}

// Mirrors a coordinate at 0 and `length` until it lies between them.
double folded(double x, double length) {
    const double there = std::fmod(std::abs(x), 2 * length);
    return there > length ? 2 * length - there : there;
}

}  // namespace

Surroundings::Surroundings(const sim::Grid& grid, std::span<const float> bedrock,
                           std::span<const float> depth, std::span<const std::uint8_t> has_data,
                           std::span<const float> lower_depth)
    : nx_(grid.nx),
      ny_(grid.ny),
      cell_(grid.dx),
      surface_(grid.size()),
      cover_(grid.size()),
      hole_(grid.size()),
      from_rim_(grid.size()) {
    CHECK(bedrock.size() == grid.size() && depth.size() == grid.size() && has_data.size() == grid.size());
    CHECK(lower_depth.empty() || lower_depth.size() == grid.size());
    size_ = cell_ * glm::dvec2(nx_ - 1, ny_ - 1);
    side_ = std::max(size_.x, size_.y);
    bool any = false;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        hole_[i] = has_data[i] == 0;
        if (hole_[i]) continue;
        cover_[i] = cover_of(depth[i], lower_depth.empty() ? 0 : lower_depth[i]);
        surface_[i] = bedrock[i] + depth[i];
        const double z = surface_[i];
        lowest_ = any ? std::min(lowest_, z) : z;
        highest_ = any ? std::max(highest_, z) : z;
        any = true;
    }
    if (!any) {
        *this = Surroundings();
        return;
    }
    relief_ = highest_ - lowest_;
    fill_holes();
    smooth_ = surface_;
    make_crags();
    find_mean_covers();
    make_rough();
    mark(std::as_bytes(std::span(surface_)));
    mark(std::as_bytes(std::span(cover_)));
    mark(std::as_bytes(std::span(hole_)));
    mark(std::as_bytes(std::span(&size_, 1)));
}

// FNV-1a, by whole words: it need not be the same elsewhere.
void Surroundings::mark(std::span<const std::byte> bytes) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); i += sizeof word) {
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        fingerprint_ = (fingerprint_ ^ word) * 0x100000001b3u;
        fingerprint_ ^= fingerprint_ >> 29;
    }
}

// Heights and covers spread inward from the rim of a hole; then heights are smoothed.
void Surroundings::fill_holes() {
    const auto for_neighbours = [&](std::size_t i, auto&& visit) {
        const int x = static_cast<int>(i % static_cast<std::size_t>(nx_)),
                  y = static_cast<int>(i / static_cast<std::size_t>(nx_));
        if (x > 0) visit(index(x - 1, y));
        if (x + 1 < nx_) visit(index(x + 1, y));
        if (y > 0) visit(index(x, y - 1));
        if (y + 1 < ny_) visit(index(x, y + 1));
    };
    std::vector<std::uint8_t> unknown = hole_;
    std::vector<std::size_t> filled;
    std::vector<std::uint16_t> steps(hole_.size());  // to the rim, by neighbours
    const auto spread_from = [&](std::size_t i) {
        for_neighbours(i, [&](std::size_t beside) {
            if (!unknown[beside]) return;
            unknown[beside] = 0;
            surface_[beside] = surface_[i];
            cover_[beside] = cover_[i];
            steps[beside] = static_cast<std::uint16_t>(steps[i] + 1);
            filled.push_back(beside);
        });
    };
    for (std::size_t i = 0; i < hole_.size(); ++i)
        if (!hole_[i]) spread_from(i);
    for (std::size_t next = 0; next < filled.size(); ++next) spread_from(filled[next]);
    if (filled.empty()) return;
    const std::size_t passes = std::clamp(kMostSmoothed / filled.size(), std::size_t{10}, kSmoothings);
    for (std::size_t pass = 0; pass < passes; ++pass)
        for (const std::size_t i : filled) {
            float sum = 0, count = 0;
            for_neighbours(i, [&](std::size_t beside) { sum += surface_[beside], ++count; });
            surface_[i] = sum / count;
        }
    missing_ = std::min(1.0, 2.0 * static_cast<double>(filled.size()) / static_cast<double>(hole_.size()));
    for (const std::size_t i : filled) from_rim_[i] = static_cast<float>(0.8 * cell_ * steps[i]);
}

// What is missing where no ground is known is mountains like those beside it.
void Surroundings::make_crags() {
    for (int y = 0; y < ny_; ++y)
        for (int x = 0; x < nx_; ++x)
            if (hole_[index(x, y)])
                surface_[index(x, y)] += static_cast<float>(crags_at(cell_ * glm::dvec2(x, y), cell_));
}

double Surroundings::crags_at(glm::dvec2 at, double spacing) const {
    if (missing_ == 0) return 0;
    const double out = away(at), rim = on_grid(from_rim_, at) + out;
    const double high =
        std::clamp((on_grid(smooth_, source(at)) - lowest_) / std::max(relief_, 1e-6), 0.0, 1.0);
    const double share = glm::mix(1.0, missing_, ramp(0, 0.1, out / side_));  // mirrored ground has its own
    return kCrags * share * relief_ * (0.4 + 0.6 * high) * crags(at, 0.26 * side_, spacing, rim, 20);
}

void Surroundings::find_mean_covers() {
    std::vector<glm::dvec3> sums(kHeightSteps + 1);
    for (std::size_t i = 0; i < surface_.size(); ++i) {
        if (hole_[i]) continue;
        const double step = relief_ > 0 ? kHeightSteps * (surface_[i] - lowest_) / relief_ : 0;
        sums[static_cast<std::size_t>(std::lround(step))] += glm::dvec3(cover_[i], 1);
    }
    mean_covers_.clear();
    for (const glm::dvec3& sum : sums)
        mean_covers_.push_back(sum.z > 0 ? glm::dvec2(sum) / sum.z : mean_covers_.back());
}

glm::dvec2 Surroundings::mean_cover(double z) const {
    const double step = relief_ > 0 ? std::clamp((z - lowest_) / relief_, 0.0, 1.0) * kHeightSteps : 0;
    const auto below = std::min(static_cast<std::size_t>(step), std::size_t{kHeightSteps - 1});
    return glm::mix(mean_covers_[below], mean_covers_[below + 1], step - static_cast<double>(below));
}

void Surroundings::make_rough() {
    const double span = (1 + 2 * kRoughReach) * side_;
    rough_cell_ = span / (kRough - 1);
    rough_origin_ = 0.5 * size_ - 0.5 * span;
    rough_.resize(static_cast<std::size_t>(kRough) * kRough);
    for (int y = 0, i = 0; y < kRough; ++y)
        for (int x = 0; x < kRough; ++x, ++i)
            rough_[static_cast<std::size_t>(i)] =
                static_cast<float>(height(rough_origin_ + rough_cell_ * glm::dvec2(x, y)));
}

double Surroundings::on_grid(const std::vector<float>& field, glm::dvec2 at) const {
    const glm::dvec2 p = glm::clamp(at / cell_, glm::dvec2(0), glm::dvec2(nx_ - 1, ny_ - 1));
    const int x = std::min(static_cast<int>(p.x), nx_ - 2), y = std::min(static_cast<int>(p.y), ny_ - 2);
    const glm::dvec2 across = p - glm::dvec2(x, y);
    const float* south = &field[index(x, y)];
    const float* north = &field[index(x, y + 1)];
    return glm::mix(glm::mix<double>(south[0], south[1], across.x),
                    glm::mix<double>(north[0], north[1], across.x), across.y);
}

double Surroundings::away(glm::dvec2 at) const {
    return glm::length(at - glm::clamp(at, glm::dvec2(0), size_));
}

glm::dvec2 Surroundings::source(glm::dvec2 at) const {
    const double bend = 0.22 * side_ * ramp(0, 0.9, away(at) / side_);
    const glm::dvec2 bent =
        at + bend * glm::dvec2(noise(2.2 / side_ * at, 5), 0.6 * noise(2.2 / side_ * at + 60.0, 6));
    return {folded(bent.x, size_.x), folded(bent.y, size_.y)};
}

// What a mirrored slope lacks: a slope that meets the border turns back there and makes a crease. It carries
// on, and fades within a fifteenth of a side.
double Surroundings::carried_on(glm::dvec2 at, double away) const {
    const glm::dvec2 border = glm::clamp(at, glm::dvec2(0), size_), out = at - border;
    const double reach = 3 * cell_, edge = on_grid(smooth_, border);
    double rise = 0;
    for (const int axis : {0, 1}) {
        if (out[axis] == 0) continue;
        glm::dvec2 within = border;
        within[axis] -= std::copysign(std::min(reach, size_[axis]), out[axis]);
        rise += 2 * (edge - on_grid(smooth_, within)) / std::min(reach, size_[axis]) * std::abs(out[axis]);
    }
    return rise * std::exp(-away / (0.07 * side_));
}

// Averaged over the distance between vertices, or crests between them would become needles.
double Surroundings::mirrored(glm::dvec2 at, double spacing) const {
    const glm::dvec2 from = source(at);
    const double reach = 0.6 * spacing * ramp(0, 0.04, away(at) / side_);  // none at the border
    double sum = 0;
    for (const glm::dvec2 aside :
         {glm::dvec2(1, 0.4), glm::dvec2(-0.4, 1), glm::dvec2(-1, -0.4), glm::dvec2(0.4, -1)}) {
        const glm::dvec2 beside = from + reach * aside;
        sum += on_grid(smooth_, {folded(beside.x, size_.x), folded(beside.y, size_.y)});
    }
    return sum / 4;
}

double Surroundings::height(glm::dvec2 at) const {
    const double out = away(at);
    if (out == 0) return on_grid(surface_, at);
    const double sides = out / side_, spacing = side_ / 80 + 0.1 * out;
    double z = mirrored(at, spacing) + carried_on(at, out);
    z += 0.30 * relief_ * (ridges(at, 0.67 * side_, spacing, 50) - 0.45) * ramp(0.05, 0.7, sides);
    const double far = ramp(0.8, 3.2, sides);
    z += relief_ * far * (0.95 * ridges(at, 2.6 * side_, spacing, 70) - 0.15);
    // The limit is a soft one, and 0 above the border at the border, or a step would show.
    const double lift = 0.02 * relief_ * ramp(0, 0.05, sides);
    const double limit = on_grid(smooth_, at) + lift + 0.16 * out + far * relief_;
    const double soft = lift + 0.08 * out, over = z - (limit - soft);
    if (over > 0) z = limit - soft + soft * (1 - std::exp(-over / soft));
    return std::min(z + crags_at(at, spacing), highest());
}

double Surroundings::rough_height(glm::dvec2 at) const {
    if (away(at) == 0) return on_grid(surface_, at);
    const glm::dvec2 p = glm::clamp((at - rough_origin_) / rough_cell_, 0.0, kRough - 1.0);
    const int x = std::min(static_cast<int>(p.x), kRough - 2),
              y = std::min(static_cast<int>(p.y), kRough - 2);
    const glm::dvec2 across = p - glm::dvec2(x, y);
    const float* south = &rough_[static_cast<std::size_t>(y) * kRough + static_cast<std::size_t>(x)];
    const float* north = south + kRough;
    return glm::mix(glm::mix<double>(south[0], south[1], across.x),
                    glm::mix<double>(north[0], north[1], across.x), across.y);
}

glm::dvec2 Surroundings::cover_by_height(glm::dvec2 at) const {
    return mean_cover(height(at)) - mean_cover(on_grid(surface_, source(at)));
}

std::optional<double> Surroundings::meet(glm::dvec3 from, glm::dvec3 along) const {
    if (empty()) return std::nullopt;
    const double most = glm::distance(from, glm::dvec3(0.5 * size_, lowest_)) + (kReach + 1) * side_;
    const auto below = [&](double t) {
        const glm::dvec3 p = from + t * along;
        return away(p) > 0 && p.z < height(p);
    };
    double before = 0;
    while (before < most) {
        // Steps as long as the ground is far below, and never longer than a ridge is wide.
        const glm::dvec3 p = from + before * along;
        const double step = std::max(0.3 * cell_, 0.4 * std::max(0.0, p.z - rough_height(p)));
        double t = std::min(before + step, most);
        if (!below(t)) {
            before = t;
            continue;
        }
        for (int i = 0; i < 30; ++i) {
            const double middle = 0.5 * (before + t);
            (below(middle) ? t : before) = middle;
        }
        return t;
    }
    return std::nullopt;
}

}  // namespace render
