#include <gtest/gtest.h>

#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

// Flow scenes, which show how a flow's fronts are tracked.
namespace game::test {
namespace {

class FlowScenes : public testing::TestWithParam<const char*> {};

TEST_P(FlowScenes, that_ship_play_and_are_followed) {
    const auto scene = load_scene(GetParam(), {});
    ASSERT_TRUE(scene) << scene.error().sentence;
    ASSERT_TRUE(scene->scenario.flow);
    ASSERT_TRUE(scene->scenario.look.flow);
    EXPECT_TRUE(scene->scenario.look.flow->everywhere);
    auto session = Session::begin(scene->scenario, sim::StepOptions{}, std::nullopt).value();
    session.follow_fronts(scene->scenario);
    const std::uint64_t before = session.state_line().hash;
    for (int i = 0; i < 60; ++i) ASSERT_TRUE(session.advance({}));
    EXPECT_GT(session.fronts()->tracker().points().size(), 20u);
    EXPECT_EQ(session.changed_at(), 60);  // its image changes although its world does not
    EXPECT_EQ(session.state().ledger.mass_error(), 0);
    EXPECT_NE(session.state_line().hash, before);  // ticks count
    // Speeds can change while it runs; without cuts there are no points.
    sim::fields::FlowNumbers numbers = scene->scenario.flow->numbers;
    numbers.cut = false;
    session.set_flow(numbers);
    ASSERT_TRUE(session.advance({}));
    EXPECT_TRUE(session.fronts()->tracker().points().empty());
}

INSTANTIATE_TEST_SUITE_P(All, FlowScenes,
                         testing::Values("flow-opposed", "flow-swinging", "flow-pinwheel", "flow-disc",
                                         "flow-crowd"),
                         [](const auto& test) { return std::string(test.param + 5); });

TEST(FlowScene, that_is_damaged_is_refused_with_file_and_line) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "flow.toml";
    const std::pair<const char*, const char*> faults[] = {
        {"[flow]\n", ":1: flow needs a kind"},
        {"[flow]\nkind = \"waterfall\"\n", ":2: flow.kind"},
        {"[flow]\nkind = \"disc\"\nspeed = 2\n", ":3: flow.speed"},
        {"[flow]\nkind = \"disc\"\nsource = \"level\"\n", ":3: flow.source"},
        {"[flow]\nkind = \"disc\"\ntexture = \"wood\"\n", ":3: flow.texture"},
        {"[flow]\nkind = \"disc\"\ncolour = 3\n", ":3: flow.colour"},
        {"[flow]\nkind = \"disc\"\n[cover]\nmaterial = \"sand\"\n", ":3: cover"},
    };
    for (const auto& [text, expected] : faults) {
        write_bytes(path, text);
        const auto scene = load_scene(path.string(), {});
        ASSERT_FALSE(scene) << text;
        EXPECT_EQ(scene.error().status, Failure::kUnusable);
        EXPECT_EQ(scene.error().sentence.rfind(path.string() + expected, 0), 0u) << scene.error().sentence;
    }
}

TEST(FlowScene, is_recorded_and_replayed_with_its_initial_settings) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "flow.couloir";
    const Scenario before = load_scene("flow-disc", {})->scenario;
    record(path, before, 20, {});
    const auto recording = read_recording(path);
    ASSERT_TRUE(recording) << recording.error().sentence;
    const Scenario& after = recording->header.scenario;
    ASSERT_TRUE(after.flow);
    EXPECT_EQ(after.flow->numbers, before.flow->numbers);
    EXPECT_EQ(after.flow->flow.kind, before.flow->flow.kind);
    EXPECT_EQ(after.flow->flow.through, before.flow->flow.through);
    EXPECT_EQ(after.look.flow, before.look.flow);
}

TEST(FlowScene, refuses_overrides_that_do_not_apply) {
    Overrides material, fine, well;
    material.material = "sand";
    fine.squares = 4096;
    well.squares = 40;
    for (const Overrides& overrides : {material, fine}) {
        const auto scene = load_scene("flow-disc", overrides);
        ASSERT_FALSE(scene);
        EXPECT_EQ(scene.error().status, Failure::kUnusable);
        EXPECT_NE(scene.error().sentence.find("--grid"), std::string::npos) << scene.error().sentence;
    }
    EXPECT_EQ(load_scene("flow-disc", well)->scenario.grid.nx, 41);
}

TEST(FlowScene, of_a_forged_recording_is_refused) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "flow.couloir";
    record(path, load_scene("flow-disc", {})->scenario, 3, {});
    const auto bodies = bodies_of(read_bytes(path));
    const auto accepted = [&](const char* place, const Json& value) {
        auto forged = bodies;
        Json header = json_of(forged[0]);
        header[Json::json_pointer(place)] = value;
        forged[0] = body_of(header);
        write_bytes(path, chained(forged));
        return read_recording(path).has_value();
    };
    EXPECT_TRUE(accepted("/view/flow/speed", 0.3));
    for (const auto& [place, value] :
         std::vector<std::pair<const char*, Json>>{{"/view/flow/kind", "waterfall"},
                                                   {"/view/flow/source", "level"},
                                                   {"/view/flow/speed", 2},
                                                   {"/view/flow/front_speed", -5},
                                                   {"/view/flow/smooth", 1},
                                                   {"/view/flow/repeats", 0},
                                                   {"/view/flow/angle_rad", 1e300},
                                                   {"/view/flow/through/x", 1e300},
                                                   {"/view/flow/through", Json::array({0.5, 0.5})},
                                                   {"/view/flow", 3},
                                                   {"/view/look/texture", "wood"}})
        EXPECT_FALSE(accepted(place, value)) << place;
}

TEST(FlowScene, and_all_worlds_have_tracked_fronts_up_to_a_size) {
    Scenario scenario = load_scene("flow-disc", {})->scenario;
    const auto resize = [&](int vertices) {
        scenario.flow.reset();
        scenario.grid = {vertices, vertices, 1};
        for (auto* field : {&scenario.bedrock, &scenario.depth, &scenario.rolling})
            field->assign(scenario.grid.size(), 0.f);
        scenario.has_data.assign(scenario.grid.size(), 1);
        auto session = Session::begin(scenario, sim::StepOptions{}, std::nullopt).value();
        session.follow_fronts(scenario);
        return session.fronts() != nullptr;
    };
    EXPECT_TRUE(resize(100));
    EXPECT_FALSE(resize(950));
}

}  // namespace
}  // namespace game::test
