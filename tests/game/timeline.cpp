// Time as something to go along: keyframes, the way back and forth, and where a session is forked.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/session/keyframes.h"
#include "game/session/sandbox.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

constexpr std::int64_t kPlayed = 150;

bool always() {
    return true;
}

sim::Command pour(double rate) {
    const sim::Grid grid = small_scenario().grid;
    sim::Command pour;
    pour.x = 0.5 * grid.nx * static_cast<double>(grid.dx);
    pour.y = 0.7 * grid.ny * static_cast<double>(grid.dx);
    pour.radius = 5;
    pour.rate = rate;
    pour.duration = 0.4;
    return pour;
}

LoadedWorld loaded() {
    LoadedWorld loaded;
    loaded.scene.scenario = small_scenario();
    loaded.scene.commands = some_commands();
    return loaded;
}

// One tick, with a hand that pours now and then.
void play_on(Sandbox& sandbox) {
    const std::int64_t tick = sandbox.session().state().tick;
    const sim::Command given = pour(100.0 + static_cast<double>(tick));
    const bool pours = tick % 50 == 20;
    if (pours) sandbox.begin_action("pour");
    ASSERT_TRUE(sandbox.tick(pours ? std::span(&given, 1) : std::span<const sim::Command>()));
}

std::vector<std::uint64_t> hashes_of(Sandbox& sandbox, std::int64_t ticks) {
    std::vector<std::uint64_t> hashes{sandbox.session().state_line().hash};
    while (sandbox.session().state().tick < ticks) {
        play_on(sandbox);
        hashes.push_back(sandbox.session().state_line().hash);
    }
    return hashes;
}

Sandbox begun(const std::filesystem::path& path) {
    auto recorder = record_into(path, loaded().scene.scenario);
    return Sandbox::begin(loaded(), sim::StepOptions{}, std::move(*recorder)).value();
}

Sandbox watching(const std::filesystem::path& path) {
    LoadedWorld loaded = open_anything(path.string(), {}).value();
    return Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::nullopt).value();
}

// What a recording proves of itself when it is played again.
Verdict verdict_on(const std::filesystem::path& path) {
    Sandbox sandbox = watching(path);
    while (sandbox.looks_back()) EXPECT_TRUE(sandbox.tick({}));
    return *sandbox.verdict();
}

void go(Sandbox& sandbox, std::int64_t tick) {
    const auto there = sandbox.go_toward(tick, always);
    ASSERT_TRUE(there) << there.error().sentence;
    ASSERT_TRUE(*there);
    ASSERT_EQ(sandbox.session().state().tick, tick);
}

TEST(Timeline, goes_back_tick_by_tick_over_the_hashes_that_it_came_by) {
    Sandbox sandbox = Sandbox::begin(loaded(), sim::StepOptions{}, std::nullopt).value();
    const auto hashes = hashes_of(sandbox, kPlayed);
    EXPECT_NE(hashes.front(), hashes.back());
    for (std::int64_t tick = kPlayed; tick >= 0; --tick) {
        go(sandbox, tick);
        ASSERT_EQ(sandbox.session().state_line().hash, hashes[static_cast<std::size_t>(tick)]) << tick;
    }
    EXPECT_EQ(sandbox.known_until(), kPlayed);
    // And forth, by itself, what the hand did included.
    for (std::int64_t tick = 1; tick <= kPlayed; ++tick) {
        ASSERT_TRUE(sandbox.tick({}));
        ASSERT_EQ(sandbox.session().state_line().hash, hashes[static_cast<std::size_t>(tick)]) << tick;
    }
    EXPECT_FALSE(sandbox.looks_back());
}

TEST(Timeline, shows_at_a_tick_what_is_seen_there_without_a_seek) {
    const auto path = find_asset(AssetKind::kRecording, "landslide").value();
    Sandbox straight = watching(path), bent = watching(path);
    go(straight, 500);
    go(bent, 700);
    go(bent, 100);
    go(bent, 500);
    EXPECT_EQ(bent.session().state_line().hash, straight.session().state_line().hash);
    EXPECT_EQ(bent.session().peaks().depth, straight.session().peaks().depth);
    EXPECT_EQ(bent.session().peaks().speed_plan, straight.session().peaks().speed_plan);
    EXPECT_EQ(bent.session().peaks().speed_slope, straight.session().peaks().speed_slope);
    EXPECT_EQ(bent.session().active_cells(), straight.session().active_cells());
    ASSERT_TRUE(straight.session().fronts());
    const auto &there = straight.session().fronts()->layers().memory(),
               &again = bent.session().fronts()->layers().memory();
    EXPECT_EQ(again.time, there.time);
    EXPECT_TRUE(again.offset == there.offset);
    EXPECT_TRUE(std::equal(
        again.mix.begin(), again.mix.end(), there.mix.begin(), there.mix.end(),
        [](const auto& a, const auto& b) { return a.second == b.second && a.latency == b.latency; }));
    EXPECT_TRUE(again.deformation == there.deformation);
}

TEST(Timeline, goes_no_farther_than_it_may_in_one_go) {
    Sandbox sandbox = Sandbox::begin(loaded(), sim::StepOptions{}, std::nullopt).value();
    const auto hashes = hashes_of(sandbox, 40);
    int left = 3;
    const auto a_little = [&] { return left-- > 0; };
    EXPECT_FALSE(sandbox.go_toward(15, a_little).value());
    EXPECT_EQ(sandbox.session().state().tick, 3);
    left = 100;
    EXPECT_TRUE(sandbox.go_toward(15, a_little).value());
    EXPECT_EQ(sandbox.session().state_line().hash, hashes[15]);
    EXPECT_TRUE(sandbox.go_toward(1000, a_little).value()) << "as far as it is known";
    EXPECT_EQ(sandbox.session().state().tick, 40);
}

TEST(Timeline, records_nothing_twice) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "back.couloir";
    Sandbox sandbox = begun(path);
    hashes_of(sandbox, 100);
    go(sandbox, 31);
    go(sandbox, 99);
    go(sandbox, 7);
    while (sandbox.looks_back()) ASSERT_TRUE(sandbox.tick({}));
    hashes_of(sandbox, kPlayed);
    go(sandbox, 12);
    ASSERT_TRUE(sandbox.finish()) << "from the past";
    const Recording recording = read_recording(path).value();
    EXPECT_FALSE(recording.warning);
    EXPECT_EQ(recording.end, kPlayed);
    EXPECT_EQ(recording.commands.size(), some_commands().size() + 3);
    EXPECT_EQ(verdict_on(path).proven_tick, kPlayed);
}

TEST(Timeline, forks_a_session_where_its_past_is_taken_over) {
    const support::TemporaryFolder folder;
    const auto first = folder.path() / "first.couloir", second = folder.path() / "second.couloir";
    Sandbox sandbox = begun(first);
    const auto hashes = hashes_of(sandbox, 100);
    go(sandbox, 45);
    EXPECT_EQ(sandbox.undo().error().status, Failure::kUnusable) << "in the past";
    ASSERT_TRUE(sandbox.take_over(into_file(second)));
    EXPECT_FALSE(sandbox.looks_back());
    EXPECT_EQ(sandbox.actions(), 1u) << "what began before the branch can be undone in it";
    sandbox.begin_action("pour");
    const sim::Command given = pour(900);
    ASSERT_TRUE(sandbox.tick({&given, 1}));
    for (int i = 0; i < 54; ++i) ASSERT_TRUE(sandbox.tick({}));
    EXPECT_NE(sandbox.session().state_line().hash, hashes[100]);
    ASSERT_TRUE(sandbox.finish());

    const Verdict whole = verdict_on(first);
    EXPECT_FALSE(whole.parted);
    EXPECT_EQ(whole.proven_tick, 100) << "what was given up is still there";
    const Recording fork = read_recording(second).value();
    EXPECT_EQ(fork.header.parent, (Parent{"first", 45}));
    const Verdict forked = verdict_on(second);
    EXPECT_FALSE(forked.parted) << *forked.parted;
    EXPECT_EQ(forked.proven_tick, 100);
}

TEST(Timeline, forks_a_recording_where_it_is_taken_over_in_the_middle) {
    const support::TemporaryFolder folder;
    const auto first = folder.path() / "first.couloir", second = folder.path() / "second.couloir";
    std::vector<std::uint64_t> hashes;
    {
        Sandbox sandbox = begun(first);
        hashes = hashes_of(sandbox, 100);
        ASSERT_TRUE(sandbox.finish());
    }
    Sandbox sandbox = watching(first);
    EXPECT_TRUE(sandbox.watches());
    go(sandbox, 65);
    ASSERT_TRUE(sandbox.take_over(into_file(second)));
    EXPECT_FALSE(sandbox.watches());
    for (int i = 0; i < 35; ++i) ASSERT_TRUE(sandbox.tick({}));
    EXPECT_NE(sandbox.session().state_line().hash, hashes[100]) << "what it poured at 70 is given up";
    go(sandbox, 64);
    EXPECT_EQ(sandbox.session().state_line().hash, hashes[64]);
    ASSERT_TRUE(sandbox.finish());
    const Recording fork = read_recording(second).value();
    EXPECT_EQ(fork.header.parent, (Parent{"first", 65}));
    EXPECT_EQ(fork.commands.back().tick, 20);
    const Verdict verdict = verdict_on(second);
    EXPECT_FALSE(verdict.parted) << *verdict.parted;
    EXPECT_EQ(verdict.proven_tick, 100);
}

TEST(Timeline, goes_on_unrecorded_where_a_fork_cannot_be_written) {
    const support::TemporaryFolder folder;
    Sandbox sandbox = begun(folder.path() / "first.couloir");
    hashes_of(sandbox, 40);
    go(sandbox, 10);
    const auto taken = sandbox.take_over(into_file(folder.path() / "first.couloir" / "no.couloir"));
    ASSERT_FALSE(taken);
    EXPECT_NE(taken.error().sentence.find("no.couloir"), std::string::npos) << taken.error().sentence;
    EXPECT_FALSE(sandbox.looks_back());
    EXPECT_FALSE(sandbox.session().recorder());
    EXPECT_TRUE(sandbox.tick({}));
}

TEST(Keyframes, stay_within_their_budget_by_keeping_every_other_one) {
    auto session = Session::begin(small_scenario(), sim::StepOptions{}, std::nullopt).value();
    // Ten of those at rest; they need no more later.
    const std::size_t budget = 10 * bytes_of(session.moment()) + 1000;
    Keyframes keyframes(budget);
    keyframes.pass(session);
    std::int64_t spacing = keyframes.spacing();
    const std::int64_t finest = spacing;
    for (int i = 0; i < 40 * finest; ++i) {
        ASSERT_TRUE(session.advance({}));
        keyframes.pass(session);
        ASSERT_LE(keyframes.count(), 10u);
        ASSERT_LE(keyframes.bytes(), budget);
        if (keyframes.spacing() != spacing) {
            EXPECT_EQ(keyframes.spacing(), 2 * spacing);
            spacing = keyframes.spacing();
        }
        const std::int64_t tick = session.state().tick;
        for (const std::int64_t wanted : {tick, tick / 2, tick / 3, std::int64_t{0}}) {
            const std::int64_t found = keyframes.before(wanted).world.tick;
            ASSERT_LE(found, wanted);
            ASSERT_LT(wanted - found, spacing);
        }
    }
    EXPECT_EQ(spacing, 8 * finest);
    keyframes.forget_after(5 * spacing / 2);
    EXPECT_EQ(keyframes.count(), 3u);
}

// What a moment holds is what it was made of, with the room between the rows of its fields.
TEST(Keyframes, count_what_each_holds) {
    Scenario scenario = small_scenario();
    const auto moment_of = [](const Scenario& of, const std::function<void(Session&)>& follow) {
        auto session = Session::begin(of, sim::StepOptions{}, std::nullopt).value();
        follow(session);
        return session.moment();
    };
    const auto nothing = [](Session&) {};
    const std::size_t plain = bytes_of(moment_of(scenario, nothing));
    const sim::Field<float> field(scenario.grid);
    const std::size_t one_field =
        sizeof(float) * static_cast<std::size_t>(field.stride()) * static_cast<std::size_t>(field.ny() + 2);
    EXPECT_GE(plain, 5 * one_field + 3 * sizeof(float) * scenario.grid.size());
    EXPECT_LE(plain, 7 * one_field + 5 * sizeof(float) * scenario.grid.size() + 4096);
    const std::size_t followed =
        bytes_of(moment_of(scenario, [&](Session& s) { s.follow_fronts(scenario); }));
    EXPECT_GE(followed,
              plain + scenario.grid.size() * sim::front::TextureLayers::Memory::kBytesPerVertex / 2);
    scenario.standing.earth_budget = 100;
    EXPECT_GE(bytes_of(moment_of(scenario, nothing)), plain + 2 * one_field);
}

TEST(Keyframes, are_two_at_least_however_small_the_budget) {
    auto session = Session::begin(small_scenario(), sim::StepOptions{}, std::nullopt).value();
    Keyframes keyframes(10);
    for (int i = 0; i < 200; ++i) {
        keyframes.pass(session);
        ASSERT_TRUE(session.advance({}));
        EXPECT_LE(keyframes.count(), 2u);
        EXPECT_EQ(keyframes.before(0).world.tick, 0);
    }
}

}  // namespace
}  // namespace game::test
