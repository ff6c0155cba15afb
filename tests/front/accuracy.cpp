#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "sim/fields/front_score.h"

// Accuracy of each point source against known fronts: the paper's scenes as we read them, and other
// conditions that a tracker meets. Errors are root mean squares in cells.

namespace {

using sim::fields::FrontScore;
using sim::fields::score;
using sim::fields::TestFlow;
using sim::fields::Trial;
using sim::front::Mesh;
using sim::front::mesh_of;
using sim::front::PointSource;

FrontScore score_on(int squares, PointSource source, const TestFlow& flow, Trial trial = {}) {
    trial.cell = 1.0 / squares;
    const auto cell = static_cast<float>(trial.cell);
    const Mesh mesh = mesh_of(sim::Grid{squares + 1, squares + 1, cell});
    // With noise, a jump that noise hardly reaches.
    return score(mesh, sim::front::gradient_rule(trial.noise > 0 ? 0.15f : 0.05f, cell), source, flow, trial);
}

struct Case {
    const char* name;
    TestFlow flow;
    int squares;
    double half, paper, fit;  // as measured; `fit` has a margin of a hundredth of a cell
};

class Scene : public testing::TestWithParam<Case> {};

TEST_P(Scene, is_met_as_well_as_is_known) {
    const Case& scene = GetParam();
    const auto rms = [&](PointSource source) {
        const FrontScore got = score_on(scene.squares, source, scene.flow);
        EXPECT_LE(got.missed, 0.006);
        EXPECT_EQ(got.false_cuts, 0);
        return got.rms;
    };
    EXPECT_NEAR(rms(PointSource::kHalf), scene.half, 0.03 * scene.half);
    EXPECT_NEAR(rms(PointSource::kPaper), scene.paper, 0.1 * scene.paper);
    EXPECT_LE(rms(PointSource::kFit), scene.fit);
}

INSTANTIATE_TEST_SUITE_P(
    OfThePaper, Scene,
    testing::Values(Case{"line_at_45_degrees_10", sim::fields::swinging(45), 10, .194, .203, .112},
                    Case{"line_at_30_degrees_10", sim::fields::swinging(30), 10, .202, .220, .050},
                    Case{"pinwheel_10", sim::fields::pinwheel(), 10, .279, .162, .086},
                    Case{"disc_10", sim::fields::disc(), 10, .269, .376, .197},
                    Case{"line_at_45_degrees_30", sim::fields::swinging(45), 30, .200, .177, .072},
                    Case{"line_at_30_degrees_30", sim::fields::swinging(30), 30, .200, .170, .032},
                    Case{"pinwheel_30", sim::fields::pinwheel(), 30, .280, .102, .062},
                    Case{"disc_30", sim::fields::disc(), 30, .277, .282, .063}),
    [](const auto& scene) { return scene.param.name; });

Trial briefly() {
    return {.seconds = 8};
}

// Velocities only tell that a line at rest is between two vertices, so no source can do better or may do
// worse.
TEST(PointSource, places_a_line_at_rest_no_better_than_velocities_allow) {
    for (const int squares : {10, 20, 30})
        for (const PointSource source : {PointSource::kPaper, PointSource::kFit}) {
            const auto at_a_fifth = sim::fields::opposed(1.0 / squares, 0.2);
            const FrontScore got = score_on(squares, source, at_a_fifth, {.seconds = 4, .unscored = 0});
            EXPECT_NEAR(got.rms, 0.3, 0.02);
            EXPECT_NEAR(got.p95, 0.3, 0.02);
            EXPECT_EQ(got.missed + got.false_cuts + got.jumps, 0);
        }
}

// Held points do not jump but are late: half the jumps, at the cost of edges that are wrong meanwhile.
TEST(PaperSource, with_hold_jumps_less_and_is_later) {
    for (const int squares : {10, 20, 30})
        for (const auto& flow : {sim::fields::swinging(45), sim::fields::swinging(30),
                                 sim::fields::pinwheel(), sim::fields::disc(), sim::fields::crowd()}) {
            Trial trial = briefly();
            const FrontScore loose = score_on(squares, PointSource::kPaper, flow, trial);
            trial.hold = true;
            const FrontScore held = score_on(squares, PointSource::kPaper, flow, trial);
            EXPECT_EQ(loose.missed + loose.false_cuts, 0);
            EXPECT_LT(held.jumps, 0.75 * loose.jumps);
            EXPECT_LT(held.rms, 1.08 * loose.rms);
            EXPECT_LT(std::max(held.missed, held.false_cuts), 0.1);
            EXPECT_GT(std::min(held.missed, held.false_cuts), 0.005);
        }
}

// Conditions that the source was not tuned on: how the flow lies on the mesh, and the rate of steps.
TEST(FitSource, is_as_good_at_any_rate_on_a_mesh_that_is_turned_and_shifted) {
    constexpr int kSquares = 20;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> shift(-0.5 / kSquares, 0.5 / kSquares);
    struct {
        TestFlow flow;
        double slowly;  // factor allowed at 30 steps/s on a turned mesh, of the error at 60
    } cases[] = {
        {sim::fields::swinging(45), 1.2},
        // A step of 1/30 s is a tenth of a cell, which is most of the error of a straight line.
        {sim::fields::swinging(30), 1.3},
        {sim::fields::pinwheel(), 1.2},
        {sim::fields::disc(), 1.2},
    };
    for (const auto& [flow, slowly] : cases) {
        const double base = score_on(kSquares, PointSource::kFit, flow, briefly()).rms;
        for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
            Trial trial = briefly();
            trial.steps_per_second = rate;
            EXPECT_LE(score_on(kSquares, PointSource::kFit, flow, trial).rms, 1.2 * base) << rate;
            trial.turn = 17 * std::numbers::pi / 180;
            for (int i = 0; i < 3; ++i) {
                trial.shift = {shift(random), shift(random)};
                EXPECT_LE(score_on(kSquares, PointSource::kFit, flow, trial).rms,
                          (rate < 60 ? slowly : 1.2) * base)
                    << rate << " steps/s, shifted by " << trial.shift.x << ' ' << trial.shift.y;
            }
        }
    }
}

TEST(FitSource, bears_noise_of_a_twentieth_of_the_jump) {
    for (const auto& flow : {sim::fields::swinging(30), sim::fields::pinwheel(), sim::fields::disc()}) {
        Trial trial = briefly();
        trial.noise = 0.02;
        const FrontScore got = score_on(20, PointSource::kFit, flow, trial);
        EXPECT_LE(got.rms, 1.3 * score_on(20, PointSource::kFit, flow, briefly()).rms);
        EXPECT_LE(got.missed, 0.02);  // for the disc, whose jump falls to 0.143 m/s on one side
        EXPECT_LE(got.false_cuts, 1e-4);
    }
}

// In each step one vertex of a thousand is wrong. Its edges are cut or uncut for that step; the other edges
// may show little of it.
TEST(FitSource, bears_vertices_that_are_wrong_for_a_step) {
    struct {
        TestFlow flow;
        double allowed;
    } cases[] = {{sim::fields::swinging(45), 0.17},
                 {sim::fields::swinging(30), 0.065},
                 {sim::fields::pinwheel(), 0.065},
                 {sim::fields::disc(), 0.095}};
    for (const int squares : {20, 30})
        for (const auto& [flow, allowed] : cases) {
            const FrontScore got = score_on(squares, PointSource::kFit, flow, {.salt = 1e-3});
            EXPECT_LE(got.rms, allowed);
            EXPECT_LE(got.missed, 0.004);    // two of a thousand edges have such an end
            EXPECT_LE(got.false_cuts, 0.1);  // six edges of every such vertex
        }
}

// A fading front ends within the flow. It is followed until the remaining jump cuts no edge, as well as a
// front without an end.
TEST(FitSource, follows_a_front_to_its_open_end) {
    struct {
        double degrees, allowed;
    } cases[] = {{30, 0.03}, {45, 0.075}, {0, 0.15}};
    for (const int squares : {20, 30})
        for (const auto& [degrees, allowed] : cases) {
            const FrontScore got =
                score_on(squares, PointSource::kFit, sim::fields::rift(degrees), briefly());
            EXPECT_LE(got.rms, allowed) << degrees;
            EXPECT_LE(
                got.rms,
                1.2 * score_on(squares, PointSource::kFit, sim::fields::swinging(degrees), briefly()).rms);
            EXPECT_EQ(got.missed + got.false_cuts, 0);
        }
}

// The source depends on where velocities jump, which a smooth field does not change.
TEST(FitSource, bears_a_smooth_field_on_top) {
    for (auto flow : {sim::fields::swinging(30), sim::fields::pinwheel(), sim::fields::disc()}) {
        const double base = score_on(20, PointSource::kFit, flow, briefly()).rms;
        flow.smooth = 0.03;
        const FrontScore got = score_on(20, PointSource::kFit, flow, briefly());
        EXPECT_LE(got.rms, 1.05 * base);
        EXPECT_LE(got.missed, 0.006);
        EXPECT_EQ(got.false_cuts, 0);
    }
}

TEST(FitSource, follows_fronts_that_merge_and_part) {
    for (const int squares : {20, 80}) {
        const FrontScore fit = score_on(squares, PointSource::kFit, sim::fields::drops());
        EXPECT_LE(fit.rms, 0.65 * score_on(squares, PointSource::kHalf, sim::fields::drops()).rms);
        EXPECT_EQ(fit.missed + fit.false_cuts, 0);
    }
}

TEST(FitSource, bears_any_triangles) {
    constexpr int kSquares = 20;
    Mesh mesh = mesh_of(sim::Grid{kSquares + 1, kSquares + 1, 1.f / kSquares});
    std::mt19937 random(3);
    std::uniform_real_distribution<float> shift(-0.2f / kSquares, 0.2f / kSquares);
    auto position = mesh.position;
    for (glm::vec2& at : position)
        if (at.x > 0 && at.y > 0 && at.x < 0.999f && at.y < 0.999f)
            at += glm::vec2(shift(random), shift(random));
    mesh = std::get<Mesh>(mesh_of(position, mesh.triangle));
    Trial trial = briefly();
    trial.cell = 1.0 / kSquares;
    const auto rule = sim::front::gradient_rule(0.05f, 1.f / kSquares);
    for (const auto& flow : {sim::fields::swinging(30), sim::fields::pinwheel(), sim::fields::disc()}) {
        const double fit = score(mesh, rule, PointSource::kFit, flow, trial).rms;
        EXPECT_LE(fit, 0.12);
        EXPECT_LE(fit, 0.5 * score(mesh, rule, PointSource::kHalf, flow, trial).rms);
    }
}

// Checks the score itself: a score that could not tell right from wrong would pass all tests above.
TEST(FrontScore, reports_missed_edges_and_jumps) {
    const int squares = 10;
    const Mesh mesh = mesh_of(sim::Grid{squares + 1, squares + 1, 0.1f});
    const auto rule = sim::front::gradient_rule(0.5f, 0.1f);  // more than any jump in the flow
    Trial trial = briefly();
    trial.cell = 0.1;
    EXPECT_EQ(score(mesh, rule, PointSource::kFit, sim::fields::swinging(30), trial).missed, 1);
    EXPECT_GT(score_on(10, PointSource::kHalf, sim::fields::swinging(30)).jumps, 30);
}

}  // namespace
