#include "terrains/generators.h"

#include <algorithm>
#include <utility>

#include "terrains/generate.h"
#include "terrains/massif.h"

namespace terrains {
namespace {

// Of a recipe: its numbers, and `make` as a function of their values.
template <class Recipe, class Numbers, class Make>
Generator generator(const char* name, const char* meaning, int squares, bool seeded, const Numbers& numbers,
                    Make make) {
    Generator made{name, meaning, squares, seeded, {}, {}};
    for (const auto& each : numbers)
        made.numbers.push_back(
            {each.name, each.lowest, each.highest, Recipe().*each.value, each.unit, each.meaning});
    made.make = [&numbers, make](std::span<const double> values, std::uint64_t seed,
                                 const GridChoice& choice) {
        Recipe recipe;
        for (std::size_t i = 0; i < values.size(); ++i) recipe.*numbers[i].value = values[i];
        return make(recipe, seed, choice);
    };
    return made;
}

using Made = tl::expected<Generated, std::string>;

Made without_layers(tl::expected<Terrain, std::string> terrain) {
    if (!terrain) return tl::unexpected(terrain.error());
    return Generated{std::move(*terrain), {}};
}

Made massif_with_layers(const Massif& recipe, std::uint64_t seed, const GridChoice& choice) {
    auto ground = generate_massif(recipe, seed, choice);
    if (!ground) return tl::unexpected(ground.error());
    return Generated{
        std::move(ground->terrain),
        {{"hardness", "", "hardness of the rock at the surface, 0 to 1", std::move(ground->hardness)},
         {"talus", "m", "loose debris", std::move(ground->talus)},
         {"drainage", "m²", "area that drains through a place", std::move(ground->drainage)}}};
}

}  // namespace

std::span<const Generator> generators() {
    static const std::vector<Generator> kGenerators{
        generator<Massif>("massif", "a mountain side made by erosion, with a couloir", kMassifSquares, true,
                          kMassifNumbers, massif_with_layers),
        generator<AlpineValley>("alpine-valley", "two sides of a valley", kAlpineValleySquares, false,
                                kAlpineValleyNumbers,
                                [](const AlpineValley& recipe, std::uint64_t, const GridChoice& choice) {
                                    return without_layers(generate_alpine_valley(recipe, choice));
                                }),
        generator<SoilSlope>("slope-of-soil", "a slope that eases into flat ground", kSoilSlopeSquares, false,
                             kSoilSlopeNumbers,
                             [](const SoilSlope& recipe, std::uint64_t, const GridChoice& choice) {
                                 return without_layers(generate_soil_slope(recipe, choice));
                             })};
    return kGenerators;
}

std::string generator_names() {
    std::string names;
    for (const Generator& each : generators()) names += (names.empty() ? "" : ", ") + std::string(each.name);
    return names;
}

const Generator* find_generator(std::string_view name) {
    const auto found = std::ranges::find(generators(), name, &Generator::name);
    return found == generators().end() ? nullptr : &*found;
}

}  // namespace terrains
