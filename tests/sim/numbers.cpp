#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/number_text.h"
#include "sim/simd/exponential.h"
#include "sim/world/params.h"
#include "sim/world/quanta.h"

namespace {

TEST(Exponential, has_a_relative_error_below_3e_7) {
    for (double x = -80; x <= 80; x += 0.00737) {
        const auto argument = static_cast<float>(x);
        const double exact = std::exp(static_cast<double>(argument));
        ASSERT_NEAR(static_cast<double>(sim::exp(argument)) / exact, 1, 3e-7) << x;
    }
    EXPECT_EQ(sim::exp(0.f), 1);
    EXPECT_EQ(sim::exp(-1e30f), sim::exp(-80.f));
}

TEST(Exponential, minus_one_is_precise_for_small_arguments) {
    for (int i = -1000; i <= 1000; ++i) {
        const double x = i * sim::kExpm1Small / 1000;
        const double expm1 = static_cast<double>(sim::expm1_small(static_cast<float>(x)));
        ASSERT_LE(std::fabs(expm1 - std::expm1(static_cast<float>(x))), 2.2e-6 * std::fabs(x)) << x;
    }
}

TEST(Angle, of_a_slope_is_that_of_atan2_within_two_ulps) {
    for (double rise = -1000; rise <= 1000; rise += 0.731)
        for (const double run : {1e-3, 0.7, 20.0, 2680.0}) {
            const double exact = std::atan2(rise, run) * (180 / 3.14159265358979323846);
            ASSERT_NEAR(sim::degrees_of_slope(rise, run), exact, 8e-16 * std::fabs(exact))
                << rise << " " << run;
        }
    EXPECT_EQ(sim::degrees_of_slope(0, 5), 0);
}

TEST(Minmod, follows_its_definition_and_lanes_are_bit_identical_to_scalars) {
    using Lanes = sim::stdx::native_simd<float>;
    constexpr float kTiny = std::numeric_limits<float>::denorm_min();
    const auto same = [](float one, const Lanes& many) {
        return std::bit_cast<std::uint32_t>(one) == std::bit_cast<std::uint32_t>(float{many[0]});
    };
    for (const float a : {0.f, -0.f, kTiny, -kTiny, 1.f, -1.f, 1.5f, -1.5f, 7.f, -7.f, 1e30f, -1e30f})
        for (const float b : {0.f, -0.f, kTiny, -kTiny, 1.f, -1.f, 1.5f, -1.5f, 7.f, -7.f, 1e30f, -1e30f}) {
            const float sign = a > 0 && b > 0 ? 1 : a < 0 && b < 0 ? -1 : 0;
            const float least = std::min(std::fabs(a), std::fabs(b));
            ASSERT_EQ(sim::minmod(a, b), sign * least) << a << ' ' << b;
            ASSERT_TRUE(same(sim::minmod(a, b), sim::minmod(Lanes(a), Lanes(b)))) << a << ' ' << b;
        }
}

TEST(Quanta, round_without_bias_and_symmetrically) {
    const auto rounded = [](float metres, float dither) {
        return sim::with_its_sign(metres, [&](float size) { return sim::in_quanta<float>(size, dither); });
    };
    const float amount = 3.3f * sim::kQuantum;
    double sum = 0;
    constexpr int kSubsteps = 10000;
    for (int k = 0; k < kSubsteps; ++k) {
        const float dither = sim::dither_of(k);
        ASSERT_GT(dither, 0);
        ASSERT_LT(dither, 1);
        ASSERT_EQ(rounded(-amount, dither), -rounded(amount, dither));
        sum += static_cast<double>(rounded(amount, dither));
        ASSERT_EQ(rounded(0, dither), 0);
        for (const int whole : {1, 5, 131071, 131072 * 31}) {
            const float metres = static_cast<float>(whole) * sim::kQuantum;
            ASSERT_LE(std::fabs(rounded(metres, dither) - metres), sim::kQuantum) << whole;
        }
    }
    EXPECT_NEAR(sum / kSubsteps / static_cast<double>(sim::kQuantum), 3.3, 1e-3);
}

TEST(Params, defaults_are_valid_and_every_number_out_of_range_is_named) {
    ASSERT_FALSE(sim::fault_of(sim::Params{}));
    for (const sim::ParamInfo& info : sim::kParams)
        for (const float bad :
             {info.least - 1, info.most * 1.01f + 1, std::numeric_limits<float>::quiet_NaN()}) {
            sim::Params params;
            params.*info.value = bad;
            const auto fault = sim::fault_of(params);
            ASSERT_TRUE(fault) << info.name;
            EXPECT_NE(fault->find(info.name), std::string::npos) << *fault;
        }
}

TEST(NumberText, has_as_few_digits_as_give_it_back_in_groups_of_three) {
    using sim::number_text;
    EXPECT_EQ(number_text(0.0), "0");
    EXPECT_EQ(number_text(0.1f), "0.1");
    EXPECT_EQ(number_text(-0.5), "-0.5");
    EXPECT_EQ(number_text(1000.0), "1000");
    EXPECT_EQ(number_text(20000.0), "20 000");
    EXPECT_EQ(number_text(-1e7), "-10 000 000");
    EXPECT_EQ(number_text(123456.75), "123 456.75");
    EXPECT_EQ(number_text(1e300), "1e+300");
    EXPECT_EQ(number_text(1e-9), "1e-09");
    EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(number_text(20000.0, "m"), "20 000 m");
    EXPECT_EQ(number_text(0.5f, "1"), "0.5");
    EXPECT_EQ(number_text(0.5, ""), "0.5");
}

// "1" says that a number has no dimension; nobody is to read it as a number.
TEST(Params, out_of_range_are_named_without_the_unit_of_what_has_none) {
    for (const sim::ParamInfo& info : sim::kParams) {
        sim::Params params;
        params.*info.value = std::numeric_limits<float>::quiet_NaN();
        const auto fault = sim::fault_of(params);
        ASSERT_TRUE(fault) << info.name;
        const std::string unit = info.unit == "1" ? std::string() : std::string(" ").append(info.unit);
        EXPECT_NE(fault->find(std::string(info.name) + " is nan" + unit + ", outside "), std::string::npos)
            << *fault;
    }
}

TEST(Params, thresholds_must_keep_their_order) {
    sim::Params params;
    params.friction = params.friction_thin + 0.01f;
    EXPECT_TRUE(sim::fault_of(params));
    params = {};
    params.start_depth = 2 * params.erosion_depth;
    EXPECT_TRUE(sim::fault_of(params));
    params = {};
    params.loose_slope = params.friction;  // what starts would stop at once
    EXPECT_TRUE(sim::fault_of(params));
    params.model = sim::Model::kVoellmy;  // nothing starts there
    EXPECT_FALSE(sim::fault_of(params));
    params = {};
    params.model = sim::Model::kBcre;
    params.start_slope = params.stop_slope - 0.1f;
    EXPECT_TRUE(sim::fault_of(params));
}

TEST(Params, substeps_respect_the_courant_number) {
    for (const float dx : {0.5f, 2.f, 12.5f, 100.f}) {
        sim::Params params;
        params.model = sim::Model::kBcre;
        params.law = sim::Law::kSlope;
        params.max_speed = 45;
        const sim::Substeps substeps = sim::substeps_of(params, dx);
        EXPECT_LE(45 * substeps.dt, params.courant * dx * 1.0001f);
        EXPECT_NEAR(substeps.dt * static_cast<float>(substeps.count), params.tick_s, 1e-7f);
    }
}

TEST(Params, names_round_trip) {
    for (const auto model : sim::kEveryModel) EXPECT_EQ(sim::model_from(sim::to_string(model)), model);
    for (const auto scheme :
         {sim::Scheme::kLaxFriedrichs, sim::Scheme::kLocalLaxFriedrichs, sim::Scheme::kMuscl})
        EXPECT_EQ(sim::scheme_from(sim::to_string(scheme)), scheme);
    for (const auto law : {sim::Law::kConstant, sim::Law::kSlope, sim::Law::kShear})
        EXPECT_EQ(sim::law_from(sim::to_string(law)), law);
    for (const auto border : {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink})
        EXPECT_EQ(sim::border_from(sim::to_string(border)), border);
    EXPECT_FALSE(sim::model_from("newton"));
}

}  // namespace
