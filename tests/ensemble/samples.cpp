// What an ensemble draws: distributions, Sobol's points, and files that say what varies.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/ensemble/distribution.h"
#include "game/ensemble/sobol.h"
#include "game/ensemble/spec.h"
#include "game/files/text_file.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using Kind = Distribution::Kind;

// The mean of many values, evenly drawn.
double mean_of(const Distribution& distribution) {
    constexpr int kMany = 2000;
    double sum = 0;
    for (int i = 0; i < kMany; ++i) sum += value_at(distribution, (i + 0.5) / kMany);
    return sum / kMany;
}

TEST(Distribution, has_the_values_of_its_function) {
    EXPECT_EQ(value_at({Kind::kUniform, {2, 6}}, 0.25), 3);
    EXPECT_EQ(value_at({Kind::kList, {5, 1, 7, 9}}, 0.26), 1);
    EXPECT_EQ(value_at({Kind::kList, {5, 1, 7, 9}}, 0.999), 9);
    const Distribution triangular{Kind::kTriangular, {0, 3, 4}};
    EXPECT_NEAR(value_at(triangular, 0.75), 3, 1e-5);
    EXPECT_NEAR(value_at(triangular, 0.1875), 1.5, 1e-5);
    EXPECT_NEAR(mean_of(triangular), 7.0 / 3, 1e-3);
    // The mean of a PERT distribution counts its most likely value four times.
    EXPECT_NEAR(mean_of({Kind::kPert, {0.1, 0.2, 0.6}}), (0.1 + 4 * 0.2 + 0.6) / 6, 1e-4);
    EXPECT_NEAR(value_at({Kind::kPert, {1, 2, 3}}, 0.5), 2, 1e-4);
    const Distribution normal{Kind::kNormal, {10, 2, -1000, 1000}};
    EXPECT_NEAR(value_at(normal, 0.5), 10, 1e-4);
    EXPECT_NEAR(value_at(normal, 0.975), 10 + 2 * 1.959964, 1e-4);  // a table of the normal distribution
    EXPECT_NEAR(value_at(normal, 0.001), 10 - 2 * 3.090232, 1e-4);
}

TEST(Distribution, keeps_within_its_bounds_and_rises_with_the_share) {
    for (const Distribution& each :
         {Distribution{Kind::kUniform, {0.15, 0.3}}, Distribution{Kind::kTriangular, {0.15, 0.15, 0.3}},
          Distribution{Kind::kPert, {0.15, 0.3, 0.3}}, Distribution{Kind::kNormal, {0.2, 0.1, 0.15, 0.3}}}) {
        double last = 0.15;
        for (const double share : {1e-9, 0.001, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999, 1 - 1e-9}) {
            const double value = value_at(each, share);
            EXPECT_GE(value, last) << share;
            EXPECT_LE(value, 0.3) << share;
            last = value;
        }
        EXPECT_NEAR(last, 0.3, 1e-3);
    }
}

TEST(Distribution, has_six_digits) {
    EXPECT_EQ(value_at({Kind::kUniform, {0, 1}}, 0.123456789), 0.123457);
    EXPECT_EQ(value_at({Kind::kUniform, {0, 1e4}}, 0.123456789), 1234.57);
}

TEST(Sobol, points_are_one_in_each_part_of_every_axis) {
    constexpr std::uint32_t kMany = 256;
    for (int dimension = 0; dimension < kMostSobolDimensions; ++dimension) {
        std::set<int> parts;
        for (std::uint32_t i = 0; i < kMany; ++i)
            parts.insert(static_cast<int>(kMany * sobol(7, dimension, i)));
        EXPECT_EQ(parts.size(), kMany) << dimension;
        EXPECT_EQ(*parts.rbegin(), static_cast<int>(kMany) - 1) << dimension;
    }
}

// What Joe and Kuo chose their numbers for: pairs of axes are covered evenly too.
TEST(Sobol, points_cover_pairs_of_axes_evenly) {
    constexpr std::uint32_t kMany = 2048;
    constexpr int kSide = 8;
    for (int one = 0; one < kMostSobolDimensions; ++one)
        for (int other = 0; other < one; ++other) {
            std::array<int, kSide * kSide> counts{};
            for (std::uint32_t i = 0; i < kMany; ++i)
                ++counts.at(static_cast<std::size_t>(kSide * sobol(1, one, i)) * kSide +
                            static_cast<std::size_t>(kSide * sobol(1, other, i)));
            EXPECT_EQ(*std::ranges::min_element(counts), 32) << one << " " << other;
            EXPECT_EQ(*std::ranges::max_element(counts), 32) << one << " " << other;
        }
}

TEST(Sobol, points_follow_from_seed_axis_and_number) {
    EXPECT_EQ(sobol(3, 2, 17), sobol(3, 2, 17));
    EXPECT_NE(sobol(3, 2, 17), sobol(4, 2, 17));
    EXPECT_NE(sobol(3, 2, 17), sobol(3, 3, 17));
    EXPECT_GT(sobol(0, 0, 0), 0);
}

// Reads a file with these lines after the world's.
class SpecFile : public testing::Test {
  protected:
    Outcome<EnsembleSpec> read(const std::string& lines) {
        EXPECT_TRUE(write_text(file_, "scene = \"landslide\"\ngrid = 20\n" + lines));
        return read_ensemble_spec(file_, {});
    }
    std::string refused(const std::string& lines) {
        const auto spec = read(lines);
        if (spec) return "read";
        EXPECT_EQ(spec.error().status, Failure::kUnusable);
        const std::string begin = file_.string() + ":";
        EXPECT_TRUE(spec.error().sentence.starts_with(begin)) << spec.error().sentence;
        return spec.error().sentence.substr(begin.size());
    }

    support::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "spec.toml";
};

constexpr const char* kFriction = "[[variable]]\nof = \"friction\"\nuniform = [0.2, 0.3]\n";

TEST_F(SpecFile, gives_a_member_the_same_sample_whatever_their_number) {
    const auto few = read(fmt::format("members = 5\n{}", kFriction)),
               many = read(fmt::format("members = 5000\n{}", kFriction)),
               other = read(fmt::format("members = 5\nseed = 2\n{}", kFriction));
    ASSERT_TRUE(few && many && other);
    EXPECT_EQ(few->identity, many->identity);
    EXPECT_NE(few->identity, other->identity);
    for (int member = 1; member <= 5; ++member) EXPECT_EQ(few->sample(member), many->sample(member));
    EXPECT_NE(few->sample(3), other->sample(3));
    const auto world = few->scenario_of(3);
    ASSERT_TRUE(world);
    EXPECT_EQ(world->params.friction, static_cast<float>(few->sample(3)[0]));
}

TEST_F(SpecFile, has_an_identity_that_changes_with_all_that_changes_results) {
    std::set<std::string> identities;
    const std::vector<std::string> all{"",
                                       "seconds = 100\n",
                                       "model = \"voellmy\"\n",
                                       "material = \"mud\"\n",
                                       "[[map]]\nof = \"thickness\"\nover = [2]\n",
                                       "[[variable]]\nof = \"drag\"\nuniform = [500, 600]\n"};
    for (const std::string& more : all) {
        const bool is_table = more.starts_with("[");
        const auto spec = read("members = 5\n" + (is_table ? kFriction + more : more + kFriction));
        ASSERT_TRUE(spec) << spec.error().sentence;
        identities.insert(spec->identity);
    }
    EXPECT_EQ(identities.size(), all.size());
}

TEST_F(SpecFile, is_refused_with_line_and_fact) {
    const std::string five = "members = 5\n";
    EXPECT_EQ(refused(kFriction), "1: needs `members`: how many runs");
    EXPECT_EQ(refused("members = 1000000000\n"), "3: members is 1000000000, outside 1 to 100000");
    EXPECT_EQ(refused(five), "1: needs at least one [[variable]], or polygons released one at a time");
    EXPECT_EQ(refused(five + kFriction + kFriction), "8: variable.of is friction a second time");
    EXPECT_EQ(refused(five + "sed = 3\n" + kFriction), "4: sed is not a known key");
    EXPECT_EQ(refused(five + "terrain = \"hill.tif\"\n" + kFriction), "1: needs either `scene` or `terrain`");
    EXPECT_EQ(refused(five + "release = \"release.geojson\"\n" + kFriction),
              "4: release applies to a `terrain` alone");
    EXPECT_EQ(refused(five + "polygons = \"one at a time\"\n" + kFriction),
              "4: polygons applies to a `terrain` alone");
    const auto variable = [&](const std::string& lines) { return refused(five + "[[variable]]\n" + lines); };
    EXPECT_EQ(variable("of = \"colour\"\nuniform = [0, 1]\n"),
              "5: variable.of is neither release, density nor a parameter that can be set");
    EXPECT_EQ(variable("of = \"release\"\nuniform = [0, 1]\n"),
              "5: variable.of is release, and the world has none");
    EXPECT_EQ(variable("of = \"tick_s\"\nuniform = [0.01, 0.02]\n"),
              "5: variable.of is neither release, density nor a parameter that can be set");
    EXPECT_EQ(variable("of = \"rolling_speed\"\nuniform = [1, 2]\n"),
              "5: variable.of is not a parameter of the model bcre-inertial");
    const auto spread = [&](const std::string& line) {
        return variable("of = \"friction\"\n" + line + "\n");
    };
    EXPECT_EQ(spread(""), "4: variable needs exactly one of uniform, triangular, pert, normal, list");
    EXPECT_EQ(spread("uniform = [-0.1, 0.2]"), "6: variable.uniform yields -0.1, which is not from 0 to 2");
    EXPECT_EQ(spread("uniform = [0.3, 0.2]"),
              "6: variable.uniform has a least value that is not below the greatest");
    EXPECT_EQ(spread("uniform = 0.3"), "6: variable.uniform is not a list of 2 numbers");
    EXPECT_EQ(spread("list = []"), "6: variable.list is not a list of 1 to 1000 numbers");
    EXPECT_EQ(spread("pert = [0.1, 0.5, 0.4]"),
              "6: variable.pert has a most likely value beyond its least or greatest");
    EXPECT_EQ(spread("normal = [0.2, 0, 0.1, 0.3]"),
              "6: variable.normal has a deviation that is not above 0");
    EXPECT_EQ(spread("normal = [0.2, 0.1, -0.1, 0.3]"),
              "6: variable.normal yields -0.1, which is not from 0 to 2");
    EXPECT_EQ(
        spread("normal = [1.9, 0.1, 0.1, 0.3]"),
        "6: variable.normal has a mean that lies more than five deviations outside its least or greatest");
    const auto map = [&](const std::string& lines) {
        return refused(five + kFriction + "[[map]]\n" + lines);
    };
    EXPECT_EQ(map("of = \"snow\"\nover = [1]\n"),
              "8: map.of is not one of thickness, speed, pressure, arrival");
    EXPECT_EQ(map("of = \"speed\"\n"),
              "7: map needs `over`, a list of numbers in m/s, or `percentiles`, one in %");
    EXPECT_EQ(map("of = \"speed\"\nover = 3\n"), "9: map.over is not a list of 1 to 16 numbers");
    EXPECT_EQ(map("of = \"arrival\"\nover = [3]\n"),
              "9: map.over does not apply to arrival, which has percentiles alone");
    EXPECT_EQ(map("of = \"speed\"\npercentiles = [100]\n"),
              "9: map.percentiles has 100, which is not above 0 and below 100");
    EXPECT_EQ(map("of = \"speed\"\npercentiles = [5, 5]\n"), "9: map.percentiles has 5 twice");
    EXPECT_EQ(map("of = \"speed\"\nover = [0]\n"),
              "9: map.over has 0, which is not above 0 and at most 1000 m/s");
    EXPECT_EQ(map("of = \"speed\"\nover = [1, 1]\n"), "9: map.over has 1 m/s twice");
}

TEST_F(SpecFile, reaches_no_file_outside_its_folder) {
    ASSERT_TRUE(write_text(file_, "terrain = \"../hill.tif\"\nrelease = \"r.geojson\"\nmembers = 2\n"));
    const auto spec = read_ensemble_spec(file_, {});
    ASSERT_FALSE(spec);
    EXPECT_EQ(spec.error().sentence,
              file_.string() +
                  ":1: terrain lies outside the folder of this file; add --allow-references if you trust it");
}

}  // namespace
}  // namespace game::test
