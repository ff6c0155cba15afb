#include <algorithm>

#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/scene/scene.h"
#include "game/session/session.h"

// A session whose powder is followed: seen, and never felt.
namespace game::test {
namespace {

class FollowedPowder : public testing::Test {
  protected:
    Session begin(bool followed, int threads = 1) const {
        auto session =
            Session::begin(scene.scenario, sim::StepOptions{.threads = threads}, std::nullopt).value();
        if (followed) session.follow_powder(scene.scenario);
        return session;
    }
    // From the tick at which it stands.
    void run(Session& session, std::int64_t until) const {
        const auto ended =
            play_headless(session, scene.commands, Until::after(until), {}, scene.scenario.title);
        ASSERT_EQ(ended.value(), Ended::kTick);
    }
    static std::vector<sim::powder::Puff> puffs(const Session& session) {
        return {session.powder().begin(), session.powder().end()};
    }

    static Scene coarse(const char* name) {
        Overrides overrides;
        overrides.squares = 60;
        return load_scene(name, overrides).value();
    }
    const Scene scene = coarse("winter-avalanche");
    static constexpr std::int64_t kFast = 1000;  // ticks
};

TEST_F(FollowedPowder, changes_nothing_of_the_world) {
    Session alone = begin(false), watched = begin(true);
    run(alone, kFast);
    run(watched, kFast);
    EXPECT_EQ(alone.state_line().hash, watched.state_line().hash);
    EXPECT_TRUE(alone.powder().empty());
    EXPECT_GT(watched.powder().size(), 20u);
}

TEST_F(FollowedPowder, is_the_same_bits_for_any_number_of_threads) {
    Session one = begin(true), three = begin(true, 3);
    run(one, kFast);
    run(three, kFast);
    EXPECT_EQ(puffs(one), puffs(three));
}

TEST_F(FollowedPowder, is_the_same_bits_if_no_tile_sleeps) {
    Session sleepy = begin(true);
    Session awake =
        Session::begin(scene.scenario, sim::StepOptions{.tiles_may_sleep = false}, std::nullopt).value();
    awake.follow_powder(scene.scenario);
    run(sleepy, kFast);
    run(awake, kFast);
    const auto& tiles = sleepy.state().tiles.awake;
    EXPECT_TRUE(std::count(tiles.begin(), tiles.end(), 0) > 0);
    EXPECT_EQ(puffs(sleepy), puffs(awake));
}

TEST_F(FollowedPowder, goes_back_with_the_world_and_comes_again_to_the_bit) {
    Session session = begin(true);
    run(session, kFast);
    const Session::Checkpoint then = session.moment();
    const auto puffs_then = puffs(session);
    run(session, kFast + 90);
    const auto later = puffs(session);
    EXPECT_NE(later, puffs_then);
    ASSERT_TRUE(session.rewind(then));
    EXPECT_EQ(puffs(session), puffs_then);
    run(session, kFast + 90);
    EXPECT_EQ(puffs(session), later);
}

TEST_F(FollowedPowder, of_mud_or_of_a_model_is_none) {
    Scenario model = scene.scenario;
    model.model = true;
    Session session = begin(false);
    session.follow_powder(model);
    run(session, kFast);
    EXPECT_TRUE(session.powder().empty());
    Overrides overrides;
    overrides.material = "mud";
    EXPECT_EQ(load_scene("landslide", overrides).value().scenario.look.powder.strength, 0);
}

TEST_F(FollowedPowder, settles_after_the_world_and_changes_frames_until_then) {
    Session session = begin(true);
    sim::Command blast;
    blast.kind = sim::CommandKind::kBlast;
    blast.x = 1000, blast.y = 300, blast.radius = 5;
    blast.depth = 1e-3;
    ASSERT_TRUE(session.advance(std::vector{blast}));
    const std::size_t thrown = session.powder().size();
    EXPECT_GT(thrown, 10u);
    for (int i = 0; i < 600 && !session.powder().empty(); ++i) {
        EXPECT_EQ(session.changed_at(), session.state().tick);
        ASSERT_TRUE(session.advance({}));
    }
    EXPECT_TRUE(session.powder().empty());
}

}  // namespace
}  // namespace game::test
