#include "game/share/packed_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace game {
namespace {

constexpr float kMostQuanta = 65535;

}  // namespace

PackedMotion::PackedMotion(std::string name, int nx, int ny, double step)
    : name_(std::move(name)),
      nx_(nx),
      ny_(ny),
      tiles_x_((nx + kTile - 1) / kTile),
      tiles_y_((ny + kTile - 1) / kTile),
      step_(step),
      now_(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny)),
      next_(now_) {}

tl::expected<void, std::string> PackedMotion::take(std::span<const float> values) {
    const auto per_unit = static_cast<float>(1 / step_);
    bool fits = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float quanta = values[i] * per_unit + 0.5f;
        const bool keeps = quanta >= 0 && quanta <= kMostQuanta;
        fits &= keeps;
        next_[i] = static_cast<std::int32_t>(keeps ? quanta : 0.f);
    }
    if (!fits) {
        const auto beyond = std::find_if(values.begin(), values.end(), [&](float value) {
            return !(value * per_unit + 0.5f >= 0 && value * per_unit + 0.5f <= kMostQuanta);
        });
        return tl::unexpected(
            fmt::format("{:g}; a page keeps 0 to {:g}", *beyond, static_cast<double>(kMostQuanta) * step_));
    }
    return {};
}

tl::expected<void, std::string> PackedMotion::begin_with(std::span<const float> values) {
    auto taken = take(values);
    if (taken) now_ = next_;
    return taken;
}

tl::expected<void, std::string> PackedMotion::add(std::span<const float> values) {
    if (auto taken = take(values); !taken) return taken;
    const auto across = static_cast<std::size_t>(tiles_x_);
    const std::size_t map = map_.size(), tiles = across * static_cast<std::size_t>(tiles_y_);
    map_.resize(map + (tiles + 7) / 8);
    std::size_t tile = 0;
    for (int y = 0; y < ny_; y += kTile)
        for (int x = 0; x < nx_; x += kTile, ++tile) {
            const int wide = std::min(kTile, nx_ - x);
            bool same = true;
            for (int row = y; same && row < std::min(y + kTile, ny_); ++row) {
                const auto first = static_cast<std::ptrdiff_t>(row) * nx_ + x;
                same = std::equal(now_.begin() + first, now_.begin() + first + wide, next_.begin() + first);
            }
            if (same) continue;
            map_[map + tile / 8] |= static_cast<std::uint8_t>(1u << tile % 8);
            add_tile(x, y);
        }
    std::swap(now_, next_);
    return {};
}

void PackedMotion::add_tile(int left, int bottom) {
    for (int y = bottom; y < bottom + kTile; ++y)
        for (int x = left; x < left + kTile; ++x) {
            std::uint32_t change = 0;
            if (x < nx_ && y < ny_) {
                const auto i =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x);
                change = zigzag(static_cast<std::uint32_t>(next_[i] - now_[i]), 2);
            }
            low_.push_back(static_cast<std::uint8_t>(change));
            high_.push_back(static_cast<std::uint8_t>(change >> 8));
        }
}

void PackedMotion::flush(PackedStream& into) {
    into.add(name_ + ".map", map_);
    into.add(name_ + ".0", low_);
    into.add(name_ + ".1", high_);
    map_.clear();
    low_.clear();
    high_.clear();
}

}  // namespace game
