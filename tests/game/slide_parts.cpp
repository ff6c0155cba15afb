#include "game/analysis/slide_parts.h"

#include <cmath>

#include <gtest/gtest.h>

#include "game/session/session.h"
#include "tests/support/allocations.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

using Part = SlideParts::Part;

constexpr double kPartsCell = 5, kSlopeEnds = 300;  // m
constexpr int kWide = 40, kLong = 100;              // squares

// Snow on a slope of 35° down to the south that ends on level ground.
Scenario snowy_slope() {
    Scenario scenario;
    scenario.grid = {kWide + 1, kLong + 1, static_cast<float>(kPartsCell)};
    scenario.params = support::loose_dry_snow();
    for (int y = 0; y <= kLong; ++y)
        for (int x = 0; x <= kWide; ++x)
            scenario.bedrock.push_back(
                static_cast<float>(0.7 * std::max(y * kPartsCell - (500 - kSlopeEnds), 0.0)));
    scenario.depth.assign(scenario.grid.size(), 1);
    scenario.rolling.assign(scenario.grid.size(), 0);
    scenario.has_data.assign(scenario.grid.size(), 1);
    return scenario;
}

TimedCommand act(sim::CommandKind kind, std::int64_t tick, glm::dvec2 at, double radius) {
    TimedCommand timed{tick, {}};
    timed.command.kind = kind;
    timed.command.x = at.x, timed.command.y = at.y, timed.command.radius = radius;
    if (kind == sim::CommandKind::kBlast) timed.command.depth = 1;
    if (kind == sim::CommandKind::kPour) timed.command.rate = 60000;
    return timed;
}

class PartsOfASlide : public testing::Test {
  protected:
    void play(int ticks) {
        if (!session_) session_.emplace(Session::begin(scenario_, {}, std::nullopt).value());
        for (; ticks > 0; --ticks) {
            std::vector<sim::Command> now;
            for (const TimedCommand& each : commands_at(commands_, session_->state().tick))
                now.push_back(each.command);
            ASSERT_TRUE(session_->advance(now));
        }
    }
    void find() {
        const std::array lists{std::span<const TimedCommand>(commands_)};
        parts_.find(scenario_, session_->view(), session_->peaks(), lists);
    }
    glm::dvec2 at(Part part) const {
        EXPECT_TRUE(parts_.at(part)) << static_cast<int>(part);
        return parts_.at(part).value_or(glm::dvec2(-1e9));
    }

    Scenario scenario_ = snowy_slope();
    std::vector<TimedCommand> commands_;
    std::optional<Session> session_;
    SlideParts parts_;
};

TEST_F(PartsOfASlide, are_crown_stauchwall_track_and_front_down_the_slope_while_it_moves) {
    commands_ = {act(sim::CommandKind::kBlast, 10, {100, 400}, 40)};
    play(800);
    find();
    EXPECT_NEAR(at(Part::kStauchwall).y, 360, kPartsCell) << "the lower edge of the disc";
    EXPECT_GE(at(Part::kCrown).y, 440 - kPartsCell) << "its upper edge, or what broke loose above it";
    EXPECT_LT(at(Part::kCrown).y, 500);
    for (const Part part : {Part::kCrown, Part::kStauchwall}) {
        EXPECT_NEAR(at(part).x, 100, kPartsCell) << "in the line of fall";
    }
    EXPECT_LT(at(Part::kTrack).y, at(Part::kStauchwall).y);
    EXPECT_LT(at(Part::kFront).y, at(Part::kTrack).y);
    EXPECT_FALSE(parts_.at(Part::kDeposit));
}

TEST_F(PartsOfASlide, have_a_deposit_instead_of_a_front_when_it_is_at_rest) {
    commands_ = {act(sim::CommandKind::kBlast, 10, {100, 400}, 40)};
    play(60 * 35);
    find();
    EXPECT_FALSE(parts_.at(Part::kFront));
    const glm::dvec2 deposit = at(Part::kDeposit);
    EXPECT_LT(deposit.y, at(Part::kTrack).y);
    EXPECT_LT(at(Part::kTrack).y, at(Part::kStauchwall).y);
    EXPECT_LT(at(Part::kStauchwall).y, at(Part::kCrown).y);
    // Nowhere is more new material.
    const auto raised = [&](int x, int y) {
        const sim::State& state = session_->state();
        return state.depth(x, y) + state.rolling(x, y) - 1;
    };
    const float most =
        raised(static_cast<int>(deposit.x / kPartsCell), static_cast<int>(deposit.y / kPartsCell));
    for (int y = 0; y <= kLong; ++y)
        for (int x = 0; x <= kWide; ++x) EXPECT_LE(raised(x, y), most);
}

TEST_F(PartsOfASlide, have_no_stauchwall_if_no_slab_was_released) {
    commands_ = {act(sim::CommandKind::kPour, 0, {100, 400}, 15)};
    play(200);
    find();
    EXPECT_FALSE(parts_.at(Part::kStauchwall));
    EXPECT_NEAR(at(Part::kCrown).y, 415, 3 * kPartsCell);
    EXPECT_LT(at(Part::kFront).y, at(Part::kCrown).y);
}

TEST_F(PartsOfASlide, take_a_release_that_rolls_at_first_for_a_slab) {
    for (int y = 70; y <= 80; ++y)
        for (int x = 15; x <= 25; ++x) scenario_.rolling[static_cast<std::size_t>(y * (kWide + 1) + x)] = 1;
    play(120);
    find();
    EXPECT_EQ(at(Part::kStauchwall), glm::dvec2(100, 350));
    EXPECT_GE(at(Part::kCrown).y, 400);
}

TEST_F(PartsOfASlide, are_those_of_the_largest_slide_and_none_if_there_is_no_slide) {
    commands_ = {act(sim::CommandKind::kBlast, 10, {40, 400}, 10),
                 act(sim::CommandKind::kBlast, 10, {150, 350}, 30)};
    play(5);
    find();
    for (std::size_t i = 0; i < SlideParts::kParts; ++i) {
        EXPECT_FALSE(parts_.at(static_cast<Part>(i)));
    }
    play(60);
    find();
    EXPECT_NEAR(at(Part::kStauchwall).x, 150, kPartsCell);
    EXPECT_NEAR(at(Part::kStauchwall).y, 320, kPartsCell);
}

TEST_F(PartsOfASlide, allocate_once_and_do_not_depend_on_earlier_looks) {
    commands_ = {act(sim::CommandKind::kBlast, 0, {100, 400}, 40)};
    play(20);
    find();
    play(150);
    const std::int64_t before = support::allocations();
    find();
    EXPECT_EQ(support::allocations(), before);
    const SlideParts looked = std::exchange(parts_, {});
    find();
    for (std::size_t i = 0; i < SlideParts::kParts; ++i) {
        EXPECT_EQ(parts_.at(static_cast<Part>(i)), looked.at(static_cast<Part>(i)));
    }
}

}  // namespace
}  // namespace game::test
