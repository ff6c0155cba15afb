#include "terrains/massif.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "terrains/massif/mountain.h"

namespace terrains {
namespace {

using massif::Level;
using massif::Values;

// Ranges that depend on another number.
tl::expected<void, std::string> check_proportions(const Massif& r) {
    const auto within = [](const char* name, double value, double lowest, double highest,
                           const char* of) -> tl::expected<void, std::string> {
        if (value >= lowest && value <= highest) return {};
        return tl::unexpected(fmt::format("'{}' is {} m; with this {} it must be {:.4g} to {:.4g} m", name,
                                          value, of, lowest, highest));
    };
    if (auto right = within("relief", r.relief, 1, 0.45 * r.length, "length"); !right) return right;
    if (auto right = within("valley", r.valley, 0.03 * r.length, 0.2 * r.length, "length"); !right)
        return right;
    return within("bed_thickness", r.bed_thickness, 0.1, 0.3 * r.relief, "relief");
}

// Averages a level to a coarser or equal grid with a tent, or interpolates it to a finer one with `sample`.
template <class Sample>
Values fitted(const Values& values, const Level& g, int squares, Sample sample) {
    const int side = squares + 1;
    const double ratio = static_cast<double>(g.squares) / squares;
    Values result(std::size_t(side) * side), rows(std::size_t(side) * g.side);
    if (ratio < 1) {
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                result[std::size_t(j) * side + i] = sample(values, g.side, i * ratio, j * ratio);
        return result;
    }
    const auto average = [&](int k, auto value) {
        const double at = k * ratio;
        double sum = 0, weights = 0;
        const int first = std::max(0, static_cast<int>(std::floor(at - ratio)) + 1);
        for (int m = first; m < at + ratio && m < g.side; ++m) {
            // Mirrored weights at the border, so that slopes there are kept.
            const double reach = std::min({ratio, std::max(at, 1e-9), std::max(g.squares - at, 1e-9)});
            const double weight = std::max(0.0, 1 - std::abs(m - at) / std::min(ratio, std::max(reach, 1.0)));
            sum += weight * value(m);
            weights += weight;
        }
        return sum / weights;
    };
    for (int j = 0; j < g.side; ++j)
        for (int i = 0; i < side; ++i)
            rows[std::size_t(j) * side + i] =
                average(i, [&](int m) { return values[std::size_t(j) * g.side + m]; });
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            result[std::size_t(j) * side + i] =
                average(j, [&](int m) { return rows[std::size_t(m) * side + i]; });
    return result;
}

std::vector<float> rounded(const Values& values) {
    std::vector<float> result(values.size());
    for (std::size_t a = 0; a < values.size(); ++a)
        result[a] = static_cast<float>(std::floor(values[a] * 1024 + 0.5) / 1024);
    return result;
}

}  // namespace

tl::expected<MassifGround, std::string> generate_massif(const Massif& recipe, std::uint64_t seed,
                                                        const GridChoice& choice) {
    if (auto right = check_numbers(recipe, kMassifNumbers); !right) return tl::unexpected(right.error());
    if (auto right = check_proportions(recipe); !right) return tl::unexpected(right.error());
    const auto grid = grid_over(recipe.length, recipe.length, choice);
    if (!grid) return tl::unexpected(grid.error());
    massif::Mountain mountain(recipe, seed);
    const Level g = mountain.make(choice.squares);
    Values hardness(g.size);
    const Values snow = mountain.snow(g);
    for (std::size_t a = 0; a < g.size; ++a) hardness[a] = mountain.hardness(g, a, g.height[a]);
    MassifGround ground;
    ground.terrain.name = "massif";
    ground.terrain.licence = "MIT, made by Couloir";
    ground.terrain.grid = *grid;
    ground.terrain.surface = rounded(fitted(g.height, g, choice.squares, massif::smoothly_sampled));
    ground.terrain.cover = rounded(fitted(snow, g, choice.squares, massif::sampled));
    ground.terrain.has_data.assign(grid->size(), 1);
    ground.hardness = rounded(fitted(hardness, g, choice.squares, massif::sampled));
    ground.talus = rounded(fitted(g.talus, g, choice.squares, massif::sampled));
    ground.drainage = rounded(fitted(g.drainage, g, choice.squares, massif::sampled));
    return ground;
}

}  // namespace terrains
