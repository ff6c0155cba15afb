#include "game/live/live_world.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "game/analysis/headless.h"
#include "game/live/picture.h"
#include "game/recording/command_source.h"
#include "game/recording/recorder.h"
#include "game/scene/scene.h"
#include "game/session/verifier.h"

// A world that a page plays, without a page: what its hand does is a recording that proves itself, and a challenge's rules hold.
namespace game::test {
namespace {

constexpr int kSquaresOfLive = 40;

// A recording of a scene without a hand.
std::string recording_of(const std::string& scene, std::int64_t ticks, int squares = kSquaresOfLive) {
    Overrides overrides;
    overrides.squares = squares;
    const Scene loaded = load_scene(scene, overrides).value();
    Header header;
    header.scenario = loaded.scenario;
    auto session =
        Session::begin(loaded.scenario, {}, Recorder::create(in_memory(scene), header).value()).value();
    CommandSource source;
    for (std::int64_t tick = 0; tick < ticks; ++tick)
        EXPECT_TRUE(session.advance(source.due(session.state(), loaded.commands)));
    return session.recorded_so_far().value();
}

Recording read(const std::string& text) {
    std::istringstream stream(text);
    return read_recording(stream, "mine").value();
}

// What a replay says of a recording: how its states compare, and what a try scores.
struct LiveProof {
    Verdict::Kind verdict;
    std::int64_t ticks;
    std::uint64_t hash;
    Outcome<Score> score;
};
LiveProof live_proof(const Recording& recording) {
    const Scenario& scenario = recording.header.scenario;
    auto session = Session::begin(scenario, {}, std::nullopt).value();
    Verifier verifier(recording);
    Referee referee(scenario, recording.commands);
    CommandSource source;
    verifier.look_at(session);
    while (session.state().tick < recording.last_tick()) {
        EXPECT_TRUE(session.advance(source.due(session.state(), recording.commands)));
        verifier.look_at(session);
        if (scenario.goal) referee.see(session);
    }
    return {verifier.verdict().kind(), session.state().tick, session.state_line().hash,
            scenario.goal ? referee.decide() : unusable("no goal")};
}

struct LiveDice {
    std::mt19937 bits;
    int below(int n) { return std::uniform_int_distribution(0, n - 1)(bits); }
    double real(double least, double most) { return std::uniform_real_distribution(least, most)(bits); }
};

glm::dvec2 somewhere(LiveDice& dice, const LiveWorld& world) {
    const sim::Grid& grid = world.state().grid;
    const double extent = (grid.nx - 1) * static_cast<double>(grid.dx);
    return {dice.real(0, extent), dice.real(0, extent)};
}

// A stroke by a random tool.
void act(LiveDice& dice, LiveWorld& world) {
    const Json tools = world.facts()["tools"];
    if (tools.empty()) return;
    const Json& tool = tools[static_cast<std::size_t>(dice.below(static_cast<int>(tools.size())))];
    EXPECT_TRUE(world.set_brush({{"tool", tool["name"]}}));
    world.press({.shift = dice.below(5) == 0, .control = dice.below(4) == 0}, somewhere(dice, world));
    for (int i = dice.below(4); i >= 0; --i) {
        static_cast<void>(world.advance(dice.below(6)));
        world.move_to(dice.below(6) == 0 ? std::nullopt : std::optional(somewhere(dice, world)));
    }
    world.release();
    static_cast<void>(world.advance(1 + dice.below(40)));
}

void do_something(LiveDice& dice, LiveWorld& world) {
    switch (dice.below(9)) {
        case 0:
            static_cast<void>(world.undo());
            break;
        case 1:
            if (world.redo()) {
                EXPECT_TRUE(world.seek(world.sandbox().known_until(), 100000).value());
            }
            break;
        case 2:
            EXPECT_TRUE(
                world.seek(dice.below(static_cast<int>(world.sandbox().known_until()) + 1), 100000).value());
            if (dice.below(2) == 0) {
                EXPECT_TRUE(world.take_over());
            } else {
                EXPECT_TRUE(world.seek(world.sandbox().known_until(), 100000).value());
            }
            break;
        case 3:
            static_cast<void>(world.advance(dice.below(120)));
            break;
        default:
            act(dice, world);
    }
}

// The triangles that a page draws are whole, wherever the world went.
void check_flow(LivePicture& picture, const LiveWorld& world) {
    const render::FlowMesh* const flow = picture.flow(world);
    ASSERT_NE(flow, nullptr);
    for (const std::uint32_t index : flow->indices()) ASSERT_LT(index, flow->vertices().size());
    for (const render::FlowMeshVertex& vertex : flow->vertices())
        for (const glm::vec2& offset : vertex.offset)
            ASSERT_TRUE(std::isfinite(offset.x) && std::isfinite(offset.y))
                << vertex.at.x << ", " << vertex.at.y;
}

TEST(LiveWorld, carries_the_texture_of_debris_from_where_it_was_taken_over) {
    auto world = LiveWorld::open(recording_of("landslide", 300), "slide").value();
    LivePicture picture;
    ASSERT_EQ(world.advance(200).ticks, 200);
    EXPECT_EQ(picture.flow(world), nullptr) << "while the slide is proven, nobody draws it";
    ASSERT_TRUE(world.take_over());
    const auto farthest = [&] {
        float most = 0;
        for (const render::FlowMeshVertex& vertex : picture.flow(world)->vertices())
            most = std::max(most, glm::length(vertex.offset[0]));
        return most;
    };
    check_flow(picture, world);
    EXPECT_GT(picture.flow(world)->indices().size(), 100u);
    ASSERT_EQ(world.advance(30).ticks, 30);
    EXPECT_GT(farthest(), 0.5f) << "m, in half a second";
    // At a moment from before, no texture had moved.
    ASSERT_TRUE(world.seek(160, 1000).value());
    check_flow(picture, world);
    ASSERT_TRUE(world.seek(230, 1000).value());
    check_flow(picture, world);
    EXPECT_GT(farthest(), 0.5f);
}

TEST(LiveWorld, shows_what_is_planted_and_felled) {
    auto world = LiveWorld::open(recording_of("protection", 20), "slide").value();
    LivePicture picture;
    EXPECT_TRUE(picture.plant(world)) << "looked at for the first time";
    EXPECT_TRUE(picture.planted().empty()) << "the page has the forest of tick 0";
    const std::vector<std::uint8_t> before = picture.stands(world);
    ASSERT_TRUE(world.take_over());
    ASSERT_TRUE(world.set_brush({{"tool", "plant"}, {"radius", 20}}));
    world.press({}, {300, 300});
    ASSERT_EQ(world.advance(5).ticks, 5);
    world.release();
    ASSERT_EQ(world.advance(5).ticks, 5);
    ASSERT_TRUE(picture.plant(world));
    EXPECT_FALSE(picture.plant(world)) << "nothing has changed since";
    constexpr double kArea = 3.14 * 20 * 20 / 1e4;  // ha
    EXPECT_NEAR(static_cast<double>(picture.planted().size()), 400 * kArea, 200 * kArea);
    std::size_t counted = 0;
    for (const std::uint32_t count : picture.planted_counts()) counted += count;
    EXPECT_EQ(counted, picture.planted().size());
    for (const LivePicture::Planted& tree : picture.planted()) {
        EXPECT_LT(std::hypot(tree.foot.x - 300, tree.foot.y - 300), 20 + 2 * world.state().grid.dx);
        EXPECT_EQ(tree.lies, 0);
    }
    ASSERT_TRUE(world.undo());
    ASSERT_TRUE(picture.plant(world));
    EXPECT_TRUE(picture.planted().empty());

    world.press({.control = true}, {128, 270});  // in its western forest
    ASSERT_EQ(world.advance(5).ticks, 5);
    world.release();
    ASSERT_EQ(world.advance(5).ticks, 5);
    ASSERT_TRUE(picture.plant(world));
    EXPECT_TRUE(picture.planted().empty());
    const std::vector<std::uint8_t>& after = picture.stands(world);
    EXPECT_LT(std::ranges::count(after, 1), std::ranges::count(before, 1));
    EXPECT_EQ(std::ranges::count(after, 2), 0) << "felled, not broken";
}

TEST(LiveWorld, records_random_sessions_that_a_replay_proves) {
    int acted = 0;
    for (const char* scene : {"landslide", "winter-avalanche", "snow-on-soil", "protection"}) {
        const std::string text = recording_of(scene, 130);
        for (unsigned seed = 0; seed < 12; ++seed) {
            LiveDice dice{std::mt19937(seed)};
            auto world = LiveWorld::open(text, "slide").value();
            static_cast<void>(world.advance(dice.below(130)));
            ASSERT_TRUE(world.take_over());
            LivePicture picture;
            for (int i = 0; i < 8; ++i) {
                do_something(dice, world);
                check_flow(picture, world);
                picture.plant(world);
            }
            ASSERT_TRUE(world.seek(world.sandbox().known_until(), 100000).value());
            const Recording mine = read(world.recorded().value());
            EXPECT_FALSE(mine.warning) << *mine.warning;
            const LiveProof proof = live_proof(mine);
            EXPECT_EQ(proof.verdict, Verdict::Kind::kExact) << scene << ", " << seed;
            EXPECT_EQ(proof.ticks, world.state().tick) << scene << ", " << seed;
            EXPECT_EQ(proof.hash, world.sandbox().session().state_line().hash) << scene << ", " << seed;
            acted += !mine.commands.empty();
        }
    }
    EXPECT_GT(acted, 36) << "of 48";
}

TEST(LiveWorld, keeps_to_the_tools_and_limits_of_a_challenge_and_claims_what_a_replay_scores) {
    int ended = 0;
    for (const char* scene : {"one-shovel", "three-charges"}) {
        const std::string text = recording_of(scene, 0);
        for (unsigned seed = 0; seed < 4; ++seed) {
            LiveDice dice{std::mt19937(seed)};
            auto world = LiveWorld::open(text, scene).value();
            ASSERT_TRUE(world.take_over());
            for (int i = 0; i < 12; ++i) {
                EXPECT_TRUE(world.set_brush({{"radius", radius_range(world.state().grid).most}}))
                    << "the widest there is";
                act(dice, world);
            }
            for (int i = 0; i < 400 && !world.score(); ++i) static_cast<void>(world.advance(60));
            ASSERT_NE(world.score(), nullptr) << scene << ", " << seed;
            const Recording mine = read(world.recorded().value());
            ASSERT_TRUE(mine.claim);
            EXPECT_EQ(*mine.claim, world.score()->claim());
            const LiveProof proof = live_proof(mine);
            EXPECT_EQ(proof.verdict, Verdict::Kind::kExact);
            ASSERT_TRUE(proof.score) << scene << ", " << seed << ": " << proof.score.error().sentence;
            EXPECT_EQ(proof.score->claim(), *mine.claim) << scene << ", " << seed;
            EXPECT_EQ(world.status()["card"]["points"], mine.claim->score);
            ended += !mine.commands.empty();
        }
    }
    EXPECT_GT(ended, 4) << "of 8";
}

TEST(LiveWorld, is_not_taken_over_where_the_replay_differs) {
    Recording forged = read(recording_of("landslide", 60));
    forged.states[5].hash ^= 1;
    Header header;
    header.scenario = forged.header.scenario;
    auto recorder = Recorder::create(in_memory("forged"), header).value();
    for (const StateLine& state : forged.states) ASSERT_TRUE(recorder.state(state));
    auto world = LiveWorld::open(recorder.copy_ended_at(60, nullptr).value(), "forged").value();
    static_cast<void>(world.advance(60));
    const auto taken = world.take_over();
    ASSERT_FALSE(taken);
    EXPECT_NE(taken.error().sentence.find("computes another slide: at tick 30"), std::string::npos)
        << taken.error().sentence;
}

TEST(LiveWorld, refuses_damaged_recordings_as_any_reader_does) {
    const std::string text = recording_of("landslide", 30);
    for (const std::size_t cut : {std::size_t{0}, std::size_t{40}, text.find('\n') / 2}) {
        const auto opened = LiveWorld::open(text.substr(0, cut), "cut");
        ASSERT_FALSE(opened) << cut;
        EXPECT_EQ(opened.error().status, Failure::kUnusable);
        EXPECT_TRUE(opened.error().sentence.starts_with("cut:")) << opened.error().sentence;
    }
}

TEST(LiveWorld, takes_no_brush_that_the_table_of_tools_does_not_have) {
    auto world = LiveWorld::open(recording_of("landslide", 6), "slide").value();
    const Brush before = world.hand().brush();
    for (const char* text :
         {R"({"tool":"nuke"})", R"({"tool":1})", R"({"radius":1e9})", R"({"radius":"wide"})",
          R"({"radius":null})", R"({"numbers":[1,2,3]})", R"({"numbers":[-1]})", R"({"numbers":7})",
          R"({"standing":1})", R"({"slope":[50,20]})", R"({"slope":[0]})", "[]", "3"})
        EXPECT_FALSE(world.set_brush(Json::parse(text))) << text;
    EXPECT_EQ(world.hand().brush(), before);
    EXPECT_TRUE(
        world.set_brush(Json::parse(R"({"tool":"blast","radius":25,"numbers":[2.5],"slope":[30,45]})")));
    EXPECT_EQ(world.hand().brush().tool, Tool::kBlast);
    EXPECT_EQ(world.hand().brush().least_slope, 30);
}

TEST(LiveWorld, has_no_flow_demo) {
    const auto opened = LiveWorld::open(recording_of("flow-disc", 0, 60), "flow");
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().sentence.find("flow demo"), std::string::npos);
}

}  // namespace
}  // namespace game::test
