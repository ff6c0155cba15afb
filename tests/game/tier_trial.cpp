#include "game/controls/tier_trial.h"

#include <gtest/gtest.h>

namespace game::test {
namespace {

struct Trial {
    Tier tier;
    int draws;
    double spent_ms;  // without the first
};

// A machine that takes `fixed` ms for any image and `sample` more for one sample per pixel of the whole screen.
Trial try_machine(double fixed, double sample, double target_ms = 33) {
    TierTrial trial(target_ms);
    Trial result{};
    while (!trial.result()) {
        const auto image = trial.image();
        const double ms = fixed + sample * image.scale * image.scale * (image.fine ? 4 : 1);
        if (result.draws++ > 0) result.spent_ms += ms;
        trial.drew(result.draws == 1 ? ms + 2000 : ms);  // the first frame loads
    }
    result.tier = *trial.result();
    return result;
}

TEST(TierTrial, finds_the_best_tier_that_is_in_time) {
    EXPECT_EQ(try_machine(2, 1).tier, Tier::kFull);
    EXPECT_EQ(try_machine(2, 30).tier, Tier::kBalanced);
    EXPECT_EQ(try_machine(5, 70).tier, Tier::kFast);
    EXPECT_EQ(try_machine(5, 2000).tier, Tier::kFast);
    EXPECT_EQ(try_machine(5, 20, 200).tier, Tier::kFull);
}

TEST(TierTrial, takes_half_a_second_at_most_unless_one_frame_takes_longer) {
    for (double sample = 0.1; sample < 1500; sample *= 1.3)
        for (const double target_ms : {8., 33., 200.}) {
            const Trial trial = try_machine(3, sample, target_ms);
            EXPECT_LE(trial.spent_ms, 500) << sample << " " << target_ms;
            EXPECT_LE(trial.draws, 7);
        }
    EXPECT_EQ(try_machine(5, 4000).draws, 2);
}

TEST(TierTrial, counts_the_faster_of_two_draws) {
    TierTrial trial(33);
    trial.drew(1500);  // loads
    trial.drew(90);    // something else ran
    trial.drew(10);
    EXPECT_FALSE(trial.result());
    EXPECT_EQ(trial.image().scale, 0.75);
}

TEST(Tier, has_names_and_an_order) {
    for (const TierInfo& info : kTiers) EXPECT_EQ(info_of(*tier_from(info.name)).name, info.name);
    EXPECT_FALSE(tier_from("fine"));
    EXPECT_EQ(below(Tier::kFull), Tier::kBalanced);
    EXPECT_EQ(below(Tier::kBalanced), Tier::kFast);
    EXPECT_FALSE(below(Tier::kFast));
}

}  // namespace
}  // namespace game::test
