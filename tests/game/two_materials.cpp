#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

// A world of two materials from its scene to its recording and back.

namespace game::test {
namespace {

constexpr const char* kSnowOnSoil = R"(title = "Snow on soil"
[terrain]
generator = "slope-of-soil"
grid = 24
[cover]
material = "snow-wet"
depth = 0.5
[under]
material = "soil"
depth = 0.25
start_angle = 48
[physics]
model = "bcre-inertial"
borders = "open"
[[command]]
at = 0.1
pour = { x = 80, y = 138, radius = 9, rate = 38, duration = 1 }
[[command]]
at = 0.2
pour = { x = 80, y = 120, radius = 9, rate = 20, duration = 1, of = "lower" }
)";

class SnowOnSoil : public testing::Test {
  protected:
    Outcome<Scene> load(std::string text, const std::string& old_text = "",
                        const std::string& new_text = "") {
        const auto at = text.find(old_text);
        EXPECT_NE(at, std::string::npos) << old_text;
        write_bytes(scene_, text.replace(at, old_text.size(), new_text));
        return load_scene(scene_.string(), {});
    }
    Scene loaded() {
        auto scene = load(kSnowOnSoil);
        if (!scene) throw std::runtime_error(scene.error().sentence);
        return std::move(*scene);
    }

    support::TemporaryFolder folder_;
    std::filesystem::path scene_ = folder_.path() / "trial.toml", path_ = folder_.path() / "trial.couloir";
};

TEST_F(SnowOnSoil, is_read_with_both_materials) {
    const Scene scene = loaded();
    const Scenario& scenario = scene.scenario;
    ASSERT_TRUE(scenario.lower);
    EXPECT_EQ(scenario.material, "snow-wet");
    EXPECT_EQ(scenario.lower->material, "soil");
    EXPECT_NEAR(scenario.lower->params.start_slope, 1.1106, 1e-4);  // the scene's own
    EXPECT_EQ(scenario.lower->params.drag, 500);                    // soil's
    EXPECT_EQ(scenario.params.drag, 1000);                          // wet snow's
    EXPECT_EQ(scenario.lower->params.borders, scenario.params.borders);
    EXPECT_NE(scenario.look.lower_standing, scenario.look.standing);
    EXPECT_TRUE(scenario.look.lower_turf);
    EXPECT_FALSE(scenario.look.turf);
    const std::size_t middle = scenario.grid.size() / 2;
    EXPECT_EQ(scenario.depth[middle], 0.75f);
    EXPECT_EQ(scenario.lower->depth[middle], 0.25f);
    ASSERT_EQ(scene.commands.size(), 2u);
    EXPECT_EQ(scene.commands[0].command.of, sim::Part::kUpper);
    EXPECT_EQ(scene.commands[1].command.of, sim::Part::kLower);
}

TEST_F(SnowOnSoil, with_a_fault_is_refused_with_line_and_fact) {
    const struct {
        const char *old_text, *new_text;
        int line;
        const char* fact;
    } faults[] = {{"material = \"soil\"\n", "", 8, "under needs a material"},
                  {"depth = 0.25\n", "", 8, "under needs a depth"},
                  {"\"soil\"\ndepth", "\"cheese\"\ndepth", 9, "under.material cannot be used"},
                  {"start_angle = 48", "colour = 3", 11, "under.colour"},
                  {"start_angle = 48", "friction = 1.5", 8, "under friction is above friction_thin"},
                  {"\"lower\"", "\"middle\"", 20, "pour.of"},
                  {"[under]\nmaterial = \"soil\"\ndepth = 0.25\nstart_angle = 48\n", "", 16, "pour.of"},
                  {"depth = 0.25", "depth = 51", 10, "under.depth"}};
    for (const auto& fault : faults) {
        SCOPED_TRACE(fault.new_text);
        const auto scene = load(kSnowOnSoil, fault.old_text, fault.new_text);
        ASSERT_FALSE(scene);
        EXPECT_EQ(scene.error().status, Failure::kUnusable);
        const std::string scenario = scene_.string() + ":" + std::to_string(fault.line) + ": " + fault.fact;
        EXPECT_EQ(scene.error().sentence.rfind(scenario, 0), 0u) << scene.error().sentence;
    }
    // Each may have the greatest depth, but not both together.
    std::string deep = kSnowOnSoil;
    deep.replace(deep.find("depth = 0.5"), 11, "depth = 40 ");
    const auto scene = load(deep, "depth = 0.25", "depth = 40");
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().sentence.find("80 m deep"), std::string::npos) << scene.error().sentence;
}

TEST_F(SnowOnSoil, replays_bit_identically_from_its_recording) {
    const Scene scene = loaded();
    const StateLine last = record(path_, scene.scenario, 90, scene.commands);
    const auto recording = read_recording(path_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    const Scenario& scenario = recording->header.scenario;
    ASSERT_TRUE(scenario.lower);
    EXPECT_EQ(scenario.lower->material, "soil");
    EXPECT_EQ(scenario.lower->params, scene.scenario.lower->params);
    EXPECT_EQ(scenario.lower->depth, scene.scenario.lower->depth);
    EXPECT_EQ(scenario.look.lower_rolling, scene.scenario.look.lower_rolling);
    EXPECT_EQ(scenario.look.lower_turf, scene.scenario.look.lower_turf);
    EXPECT_EQ(recording->states.back().hash, last.hash);

    const Finished verified = couloir({"replay", path_.string(), "--verify", "--threads", "2"});
    EXPECT_EQ(verified.status, 0) << verified.err;
    EXPECT_NE(verified.out.find("proven up to tick 90"), std::string::npos) << verified.out;
    EXPECT_NE(verified.out.find("snow-wet on soil"), std::string::npos) << verified.out;
    EXPECT_NE(verified.out.find("mass of soil: standing"), std::string::npos) << verified.out;
    const Json summary = Json::parse(couloir({"replay", path_.string(), "--json"}).out);
    EXPECT_EQ(summary["lower"]["material"], "soil");
    EXPECT_EQ(summary["lower"]["mass"]["error_quanta"], 0);
    EXPECT_NEAR(summary["lower"]["mass"]["poured_m3"].get<double>(), 20, 0.5);
}

TEST_F(SnowOnSoil, recorded_with_other_soil_is_refused) {
    const Scene scene = loaded();
    record(path_, scene.scenario, 12, {});
    std::vector<std::string> bodies = bodies_of(read_bytes(path_));
    const auto refused = [&](const Json& header) {
        bodies[0] = body_of(header);
        write_bytes(path_, chained(bodies));
        const auto outcome = read_recording(path_);
        return outcome ? "accepted" : outcome.error().sentence;
    };
    const Json whole = json_of(bodies[0]);
    Json header = whole;
    header["lower"]["physics"].erase("stop_slope");
    EXPECT_NE(refused(header).find(":1: has no stop_slope"), std::string::npos) << refused(header);
    header = whole;
    header["lower"]["physics"]["friction"] = 1.5;
    EXPECT_NE(refused(header).find(":1: friction is above friction_thin"), std::string::npos);
    header = whole;
    header["lower"] = 7;
    EXPECT_NE(refused(header).find(":1: has no "), std::string::npos) << refused(header);
    header = whole;
    header.erase("lower");  // then the ground data are too long
    EXPECT_NE(refused(header).find(":1: terrain data"), std::string::npos) << refused(header);
}

TEST_F(SnowOnSoil, is_required_to_pour_the_lower_material) {
    TimedCommand pour{3, sim::Command{}};
    pour.command.of = sim::Part::kLower;
    auto session = Session::begin(small_scenario(), {}, std::nullopt);
    ASSERT_TRUE(session);
    const auto refused = session->advance({&pour.command, 1});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find("this world has one material"), std::string::npos);

    record(path_, small_scenario(), 12, some_commands());
    std::vector<std::string> bodies = bodies_of(read_bytes(path_));
    std::string line;
    write(pour, line);
    bodies.insert(bodies.begin() + 1, line.substr(0, line.size() - 1));
    write_bytes(path_, chained(bodies));
    const auto recording = read_recording(path_);
    ASSERT_FALSE(recording);
    EXPECT_NE(recording.error().sentence.find(":2: pour is of the lower material"), std::string::npos)
        << recording.error().sentence;
}

}  // namespace
}  // namespace game::test
