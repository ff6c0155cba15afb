#include <cstring>

#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "sim/world/state_hash.h"

// A session whose fronts are followed: seen, and never felt.
namespace game::test {
namespace {

using sim::front::TextureLayers;

class Fronts : public testing::Test {
  protected:
    Session begin(bool followed, int threads = 1) const {
        auto session =
            Session::begin(scene.scenario, sim::StepOptions{.threads = threads}, std::nullopt).value();
        if (followed) session.follow_fronts(scene.scenario);
        return session;
    }
    // From the tick at which it stands.
    void run(Session& session, std::int64_t until) const {
        const auto ended =
            play_headless(session, scene.commands, Until::after(until), {}, scene.scenario.title);
        ASSERT_EQ(ended.value(), Ended::kTick);
    }
    static bool same(const TextureLayers::Memory& a, const TextureLayers::Memory& b) {
        const auto equal = [](const auto& x, const auto& y) {
            return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
        };
        return a.time == b.time && equal(a.offset, b.offset) && equal(a.mix, b.mix) &&
               equal(a.deformation, b.deformation) && equal(a.beside, b.beside) &&
               equal(a.gradient, b.gradient);
    }
    static std::vector<float> places(const Session& session) {
        std::vector<float> at;
        for (const auto& point : session.fronts()->tracker().points())
            at.insert(at.end(), {static_cast<float>(point.edge), point.f});
        return at;
    }

    static Scene coarse_landslide() {
        Overrides overrides;
        overrides.squares = 40;
        return load_scene("landslide", overrides).value();
    }
    const Scene scene = coarse_landslide();
    static constexpr std::int64_t kSliding = 500;  // ticks
};

TEST_F(Fronts, change_nothing_of_the_world_that_they_are_seen_in) {
    Session alone = begin(false), watched = begin(true);
    run(alone, kSliding);
    run(watched, kSliding);
    EXPECT_EQ(alone.state_line().hash, watched.state_line().hash);
    EXPECT_EQ(alone.fronts(), nullptr);
    ASSERT_NE(watched.fronts(), nullptr);
    EXPECT_GT(watched.fronts()->tracker().points().size(), 20u);
}

TEST_F(Fronts, lie_around_what_is_seen_to_roll) {
    Session session = begin(true);
    run(session, kSliding);
    const sim::View world = session.view();
    const float visible = scene.scenario.look.rolling_visible_m;
    const auto& tracker = session.fronts()->tracker();
    for (const auto& point : tracker.points()) {
        const auto [a, b] = tracker.mesh().edge[static_cast<std::size_t>(point.edge)];
        const auto rolling = [&](int v) { return world.rolling(v % world.grid.nx, v / world.grid.nx); };
        EXPECT_NEAR(rolling(a) + point.f * (rolling(b) - rolling(a)), visible, 1e-4f);
    }
}

TEST_F(Fronts, carry_textures_with_the_rolling_layer_and_leave_the_ground_alone) {
    Session session = begin(true);
    run(session, kSliding);
    const sim::View world = session.view();
    int carried = 0;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x) {
            const auto& offset =
                session.fronts()->layers().offsets()[static_cast<std::size_t>(y * world.grid.nx + x)];
            if (session.peaks().depth[static_cast<std::size_t>(y * world.grid.nx + x)] == 0)
                for (const glm::vec2& o : offset) EXPECT_EQ(o, glm::vec2(0, 0));
            // What flows north has its texture from the south: places are added to less and less.
            else
                carried += offset.back().y > 1 || offset.back().y < -1;
        }
    EXPECT_GT(carried, 30);
}

TEST_F(Fronts, are_the_same_bits_for_any_number_of_threads) {
    Session one = begin(true), three = begin(true, 3);
    run(one, kSliding);
    run(three, kSliding);
    EXPECT_EQ(places(one), places(three));
    EXPECT_TRUE(same(one.fronts()->layers().memory(), three.fronts()->layers().memory()));
}

TEST_F(Fronts, go_back_with_the_world_and_come_again_to_the_bit) {
    Session session = begin(true);
    run(session, kSliding);
    const Session::Checkpoint then = session.moment();
    const auto textures_then = session.fronts()->layers().memory();
    const auto places_then = places(session);
    run(session, kSliding + 60);
    const auto later = session.fronts()->layers().memory();
    const auto places_later = places(session);
    EXPECT_FALSE(same(later, textures_then));

    ASSERT_TRUE(session.rewind(then));
    EXPECT_TRUE(same(session.fronts()->layers().memory(), textures_then));
    EXPECT_EQ(places(session), places_then);
    run(session, kSliding + 60);
    EXPECT_TRUE(same(session.fronts()->layers().memory(), later));
    EXPECT_EQ(places(session), places_later);
}

TEST_F(Fronts, of_a_material_that_carries_nothing_are_not_followed) {
    Session session = begin(false);
    Scenario plain = scene.scenario;
    plain.look.flow.reset();
    session.follow_fronts(plain);
    EXPECT_EQ(session.fronts(), nullptr);
}

}  // namespace
}  // namespace game::test
