#include "sim/verification/cases.h"

#include <string>

#include <gtest/gtest.h>

// Every case in the table that `couloir verify-physics` prints.

namespace {

using sim::verification::Case;
using sim::verification::Series;

class ExactAnswer : public testing::TestWithParam<Case> {};

TEST_P(ExactAnswer, is_within_its_bounds) {
    for (const Series& series : GetParam().run()) {
        const std::string line = std::string(series.scheme) + ", " + std::string(series.measure);
        EXPECT_LE(series.errors.back(), series.most) << line;
        if (series.least_order > 0) {
            EXPECT_GE(series.order(), series.least_order) << line;
        }
        EXPECT_TRUE(series.holds()) << line;
    }
}

INSTANTIATE_TEST_SUITE_P(Verification, ExactAnswer, testing::ValuesIn(sim::verification::cases()),
                         [](const auto& instance) {
                             std::string name;
                             for (const char c : instance.param.name)
                                 if (std::isalnum(static_cast<unsigned char>(c)))
                                     name += c;
                                 else if (!name.empty() && name.back() != '_')
                                     name += '_';
                             return name;
                         });

// Checks the table's own arithmetic, so that it cannot pass everything.
TEST(Series, fails_by_error_by_order_and_by_nan) {
    const Series good{"", "", 1e-2, 1.8, {10, 20, 40}, {0.16, 0.04, 0.01}};
    EXPECT_DOUBLE_EQ(good.order(), 2);
    EXPECT_TRUE(good.holds());
    Series bad = good;
    bad.most = 0.009;
    EXPECT_FALSE(bad.holds());
    bad = good;
    bad.least_order = 2.1;
    EXPECT_FALSE(bad.holds());
    bad = good;
    bad.errors.back() = 0. / 0.;
    EXPECT_FALSE(bad.holds());
}

}  // namespace
