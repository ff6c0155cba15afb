#include "game/share/puff_paths.h"

#include <algorithm>
#include <array>
#include <string>

namespace game {
namespace {

// Where a puff is at another age, as fast as now.
glm::vec3 place_at(const sim::powder::Puff& puff, float age_s) {
    return puff.at + (age_s - puff.age_s) * puff.velocity;
}

}  // namespace

void PuffPaths::see(std::span<const sim::powder::Puff> cloud, std::int64_t tick, double tick_s) {
    std::unordered_map<std::uint32_t, std::size_t> in_air;
    for (const sim::powder::Puff& puff : cloud) {
        const float half = 0.5f * puff.life_s;
        const auto known = in_air_.find(puff.seed);
        std::size_t number = paths_.size();
        if (known == in_air_.end()) {
            paths_.push_back({puff, static_cast<double>(tick) - static_cast<double>(puff.age_s) / tick_s,
                              place_at(puff, 0), place_at(puff, half)});
        } else {
            number = known->second;
            Path& path = paths_[number];
            path.puff = puff;
            if (puff.age_s <= half) path.middle = place_at(puff, half);
        }
        in_air.emplace(puff.seed, number);
    }
    in_air_ = std::move(in_air);
}

void PuffPaths::pack(PackedStream& into) {
    std::stable_sort(paths_.begin(), paths_.end(),
                     [](const Path& a, const Path& b) { return a.born < b.born; });
    std::vector<double> column(paths_.size());
    const auto add = [&](const std::string& name, double least_step, int planes, Packing::Predict predict,
                         auto&& value) {
        std::transform(paths_.begin(), paths_.end(), column.begin(), value);
        into.add("puffs." + name, column, {least_step, planes, predict});
    };
    using enum Packing::Predict;
    add("born", 1, 2, kLast, [](const Path& p) { return std::max(p.born, 0.0); });
    add("life", 0.05, 1, kNone, [](const Path& p) { return p.puff.life_s; });
    add("radius", 0.02, 1, kNone, [](const Path& p) { return p.puff.first_radius; });
    add("density", 1.0 / 255, 1, kNone, [](const Path& p) { return p.puff.density; });
    add("lower", 1.0 / 255, 1, kNone, [](const Path& p) { return p.puff.lower; });
    add("seed", 1, 1, kNone, [](const Path& p) { return p.puff.seed >> 24; });
    // Later places are written as the way from the one before, whose numbers are small.
    constexpr double kQuantum = 0.25;  // m
    constexpr std::array kAxes{'x', 'y', 'z'};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name(1, kAxes[static_cast<std::size_t>(axis)]);
        add(name, kQuantum, 2, kLast, [&](const Path& p) { return p.first[axis]; });
        add(name + "_half", kQuantum, 2, kNone,
            [&](const Path& p) { return p.middle[axis] - p.first[axis]; });
        add(name + "_end", kQuantum, 2, kNone,
            [&](const Path& p) { return place_at(p.puff, p.puff.life_s)[axis] - p.middle[axis]; });
    }
    paths_.clear();
    in_air_.clear();
}

}  // namespace game
