#include "terrains/massif.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "terrains/generators.h"

namespace terrains {
namespace {

MassifGround massif(std::uint64_t seed, int squares, const Massif& recipe = {}) {
    auto made = generate_massif(recipe, seed, squares);
    EXPECT_TRUE(made) << made.error();
    return made ? std::move(*made) : MassifGround{};
}

// FNV-1a over the bits of all fields.
std::uint64_t hash_of(const MassifGround& ground) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto* field :
         {&ground.terrain.surface, &ground.terrain.cover, &ground.hardness, &ground.talus, &ground.drainage})
        for (const float value : *field) {
            std::uint32_t bits = 0;
            static_assert(sizeof bits == sizeof value);
            std::copy_n(reinterpret_cast<const unsigned char*>(&value), sizeof bits,
                        reinterpret_cast<unsigned char*>(&bits));
            hash = (hash ^ bits) * 0x100000001b3u;
        }
    return hash;
}

// Tangents of the slope at inner vertices.
std::vector<double> slopes_of(const Terrain& terrain) {
    std::vector<double> slopes;
    const auto nx = static_cast<std::size_t>(terrain.grid.nx), ny = static_cast<std::size_t>(terrain.grid.ny);
    const double run = 2.0 * static_cast<double>(terrain.grid.dx);
    for (std::size_t y = 1; y + 1 < ny; ++y)
        for (std::size_t x = 1; x + 1 < nx; ++x) {
            const float* at = &terrain.surface[y * nx + x];
            const auto difference = [&](std::size_t step) {
                return static_cast<double>(at[step]) - static_cast<double>(*(at - step));
            };
            slopes.push_back(std::hypot(difference(1), difference(nx)) / run);
        }
    return slopes;
}

double share_between(const std::vector<double>& slopes, double from_deg, double to_deg) {
    const auto tangent = [](double degrees) { return std::tan(degrees * 3.14159265358979 / 180); };
    const auto inside = [&](double slope) { return slope >= tangent(from_deg) && slope < tangent(to_deg); };
    return static_cast<double>(std::ranges::count_if(slopes, inside)) / static_cast<double>(slopes.size());
}

TEST(Massif, is_the_same_bits_everywhere) {
    EXPECT_EQ(hash_of(massif(7, 80)), 11876962130261584833u);
    EXPECT_EQ(hash_of(massif(7, 300)), 13379332626264713206u);
}

TEST(Massif, is_steep_enough_for_slabs_and_has_cliffs_and_gentle_ground) {
    for (const std::uint64_t seed : {1u, 4u, 7u, 8u}) {
        const auto slopes = slopes_of(massif(seed, 256).terrain);
        EXPECT_GT(share_between(slopes, 30, 45), 0.25) << seed;
        EXPECT_LT(share_between(slopes, 30, 45), 0.40) << seed;
        EXPECT_GT(share_between(slopes, 60, 90), 0.005) << seed;
        EXPECT_GT(share_between(slopes, 0, 15), 0.10) << seed;
    }
}

TEST(Massif, is_the_same_mountain_on_every_grid) {
    const MassifGround coarse = massif(3, 80), fine = massif(3, 640);
    double sum = 0, mean_coarse = 0, mean_fine = 0, cc = 0, ff = 0, cf = 0;
    const std::size_t side = 81, step = 8, fine_side = 641;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            const double a = static_cast<double>(coarse.terrain.surface[y * side + x]),
                         b = static_cast<double>(fine.terrain.surface[step * y * fine_side + step * x]);
            sum += (a - b) * (a - b);
            mean_coarse += a, mean_fine += b, cc += a * a, ff += b * b, cf += a * b;
        }
    const double n = side * side;
    const double covariance = cf / n - mean_coarse * mean_fine / (n * n);
    const double correlation = covariance / std::sqrt((cc / n - mean_coarse * mean_coarse / (n * n)) *
                                                      (ff / n - mean_fine * mean_fine / (n * n)));
    EXPECT_LT(std::sqrt(sum / n), 0.02 * Massif().relief);
    EXPECT_GT(correlation, 0.998);
}

TEST(Massif, drains_to_its_valley_and_has_snow_in_hollows_and_none_on_cliffs) {
    const MassifGround ground = massif(5, 256);
    const auto side = static_cast<std::size_t>(ground.terrain.grid.nx);
    double most = 0, of_hollows = 0, of_ribs = 0;
    std::size_t hollows = 0, ribs = 0;
    for (std::size_t i = 0; i < ground.drainage.size(); ++i) {
        const std::size_t x = i % side, y = i / side;
        EXPECT_GE(ground.talus[i], 0);
        EXPECT_TRUE(ground.hardness[i] >= 0 && ground.hardness[i] <= 1);
        if (y > 0) most = std::max(most, static_cast<double>(ground.drainage[i]));
        if (x < 4 || y < side / 3 || x + 4 >= side || y + 4 >= side) continue;
        const auto& z = ground.terrain.surface;
        const double bowl =
            static_cast<double>(z[i - 3] + z[i + 3] + z[i - 3 * side] + z[i + 3 * side] - 4 * z[i]);
        const double gx = static_cast<double>(z[i + 1] - z[i - 1]),
                     gy = static_cast<double>(z[i + side] - z[i - side]);
        const double slope = std::hypot(gx, gy) / (2 * static_cast<double>(ground.terrain.grid.dx));
        const auto snow = static_cast<double>(ground.terrain.cover[i]);
        if (slope > 2.2) {
            EXPECT_LT(snow, 0.35) << "on a cliff of 65 degrees";
        }
        if (bowl > 20) of_hollows += snow, ++hollows;
        if (bowl < -20) of_ribs += snow, ++ribs;
    }
    EXPECT_GT(most, 1e5) << "streams gather";
    ASSERT_TRUE(hollows > 100 && ribs > 100);
    EXPECT_GT(of_hollows / static_cast<double>(hollows), 2 * of_ribs / static_cast<double>(ribs));
}

TEST(Massif, is_finite_at_the_ends_of_its_ranges) {
    std::mt19937 random(52);
    const auto within = [&](double lowest, double highest) {
        const double t = static_cast<double>(random() % 5) / 4;
        return lowest + (highest - lowest) * t;
    };
    for (int i = 0; i < 12; ++i) {
        Massif recipe;
        for (const auto& number : kMassifNumbers)
            recipe.*number.value = within(number.lowest, number.highest);
        recipe.relief = std::max(1.0, within(0.001, 0.45) * recipe.length * 0.999);
        recipe.relief = std::min(recipe.relief, 5000.0);
        recipe.valley = within(0.031, 0.199) * recipe.length;
        recipe.bed_thickness = std::min(within(0.1, 0.3) * recipe.relief, 1000.0);
        const std::uint64_t seed = i % 2 ? 0 : std::numeric_limits<std::uint64_t>::max();
        const auto made = generate_massif(recipe, seed, i % 3 ? 8 : 70);
        ASSERT_TRUE(made) << made.error();
        for (const float height : made->terrain.surface) {
            ASSERT_TRUE(std::isfinite(height));
            ASSERT_NEAR(static_cast<double>(height), recipe.lowest + 0.5 * recipe.relief,
                        1.3 * recipe.relief + 60);
        }
        for (const float snow : made->terrain.cover) ASSERT_TRUE(snow >= 0 && snow <= 8);
    }
}

TEST(Massif, refuses_what_makes_no_mountain_with_the_number_and_its_range) {
    const auto refused = [](double Massif::*number, double value) {
        Massif recipe;
        recipe.*number = value;
        const auto made = generate_massif(recipe, 1, 16);
        return made ? std::string() : made.error();
    };
    EXPECT_EQ(refused(&Massif::relief, 2000), "'relief' is 2000 m; with this length it must be 1 to 1350 m");
    EXPECT_EQ(refused(&Massif::valley, 20), "'valley' is 20 m; with this length it must be 90 to 600 m");
    EXPECT_EQ(refused(&Massif::bed_thickness, 500),
              "'bed_thickness' is 500 m; with this relief it must be 0.1 to 255 m");
    EXPECT_EQ(refused(&Massif::ice, 2), "'ice' is 2; it must be 0 to 1");
    EXPECT_NE(refused(&Massif::snow, std::nan("")), "");
}

TEST(GeneratorList, makes_what_its_names_say_and_knows_the_usual_numbers) {
    for (const Generator& generator : generators()) {
        std::vector<double> values;
        for (const GeneratorNumber& number : generator.numbers) values.push_back(number.usual);
        const auto made = generator.make(values, 1, 16);
        ASSERT_TRUE(made) << made.error();
        EXPECT_EQ(made->terrain.name, generator.name);
        for (const GroundLayer& layer : made->layers)
            EXPECT_EQ(layer.values.size(), made->terrain.grid.size());
        EXPECT_EQ(find_generator(generator.name), &generator);
        values[0] = generator.numbers[0].highest + 1;
        EXPECT_FALSE(generator.make(values, 1, 16));
    }
    EXPECT_EQ(find_generator("moon"), nullptr);
}

}  // namespace
}  // namespace terrains
