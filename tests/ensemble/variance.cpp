// How much of a variance is due to which variable, of functions whose answer is known.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "game/ensemble/sobol.h"
#include "game/ensemble/variance.h"

namespace game::test {
namespace {

using Samples = std::vector<std::vector<double>>;

// So many members, whose variables are even between 0 and 1.
Samples samples_of(std::size_t members, int variables, std::uint64_t seed = 1) {
    Samples samples(members);
    for (std::size_t i = 0; i < members; ++i)
        for (int v = 0; v < variables; ++v)
            samples[i].push_back(sobol(seed, v, static_cast<std::uint32_t>(i)));
    return samples;
}

template <class Function>
std::vector<double> values_of(const Samples& samples, const Function& function) {
    std::vector<double> values;
    for (const std::vector<double>& sample : samples) values.push_back(function(sample));
    return values;
}

void expect_share(const VarianceShare& found, double wanted, double tolerance, const char* what) {
    EXPECT_NEAR(found.share, wanted, std::max(3 * found.error, tolerance)) << what;
}

// Sobol's function g: a product, whose shares of first order are (1/3) / (1 + a)² of the whole.
TEST(Variance, of_sobols_function_is_shared_as_its_formula_says) {
    const std::vector<double> a{0, 1, 4.5, 9};
    double all = 1;
    for (const double each : a) all *= 1 + 1 / (3 * (1 + each) * (1 + each));
    all -= 1;
    for (const std::size_t members : {200u, 1000u, 5000u}) {
        const Samples samples = samples_of(members, 4);
        const auto shares = variance_shares(samples, values_of(samples, [&](const std::vector<double>& x) {
                                                double product = 1;
                                                for (std::size_t i = 0; i < a.size(); ++i)
                                                    product *= (std::fabs(4 * x[i] - 2) + a[i]) / (1 + a[i]);
                                                return product;
                                            }));
        ASSERT_TRUE(shares);
        double together = 1;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double wanted = 1 / (3 * (1 + a[i]) * (1 + a[i])) / all;
            expect_share(shares->of[i], wanted, 0.03, "by itself");
            EXPECT_LT(shares->of[i].error, members < 1000 ? 0.1 : 0.03);
            together -= wanted;
        }
        expect_share(shares->together, together, 0.03, "together");
    }
}

TEST(Variance, of_a_sum_is_shared_without_a_rest_even_among_few_members) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u})
        for (const std::size_t members : {70u, 100u, 128u, 1000u}) {
            const Samples samples = samples_of(members, 3, seed);
            const auto shares = variance_shares(samples, values_of(samples, [](const std::vector<double>& x) {
                                                    return 1e6 + 2 * x[0] + x[2];
                                                }));
            ASSERT_TRUE(shares);
            EXPECT_NEAR(shares->of[0].share, 0.8, 0.03) << members;
            EXPECT_NEAR(shares->of[1].share, 0, 1e-6) << members;
            EXPECT_NEAR(shares->of[2].share, 0.2, 0.03) << members;
            EXPECT_NEAR(shares->together.share, 0, 0.05) << members;
        }
}

TEST(Variance, of_a_product_about_zero_is_shared_by_no_variable_alone) {
    const Samples samples = samples_of(1000, 2);
    const auto shares = variance_shares(samples, values_of(samples, [](const std::vector<double>& x) {
                                            return (x[0] - 0.5) * (x[1] - 0.5);
                                        }));
    ASSERT_TRUE(shares);
    EXPECT_NEAR(shares->together.share, 1, 0.02);
}

// Sixteen variables, of which one has two values and decides alone.
TEST(Variance, is_found_among_many_variables_and_of_a_list) {
    Samples samples = samples_of(256, 16);
    for (std::vector<double>& sample : samples) sample[5] = sample[5] < 0.5 ? 20 : 30;
    const auto shares =
        variance_shares(samples, values_of(samples, [](const std::vector<double>& x) { return x[5]; }));
    ASSERT_TRUE(shares);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(shares->of[i].share, i == 5 ? 1 : 0, 1e-6) << i;
}

TEST(Variance, is_not_told_of_too_few_or_of_none) {
    const Samples some = samples_of(least_for_variance(2), 2), few = samples_of(least_for_variance(2) - 1, 2);
    const auto first = [](const std::vector<double>& x) { return x[0]; };
    EXPECT_TRUE(variance_shares(some, values_of(some, first)));
    EXPECT_FALSE(variance_shares(few, values_of(few, first)));
    EXPECT_FALSE(variance_shares(some, values_of(some, [](const auto&) { return 3.0; })));
    EXPECT_FALSE(variance_shares({}, {}));
    // A variable that never changes explains nothing.
    Samples still = some;
    for (std::vector<double>& sample : still) sample[1] = 7;
    const auto shares = variance_shares(still, values_of(still, first));
    ASSERT_TRUE(shares);
    EXPECT_NEAR(shares->of[0].share, 1, 1e-6);
    EXPECT_EQ(shares->of[1].share, 0);
}

}  // namespace
}  // namespace game::test
