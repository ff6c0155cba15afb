// tests/recordings has a recording for each past format and for each feature of a format. None is ever
// recreated, because users' recordings must keep playing.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/session/renew.h"
#include "game/session/verifier.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

struct Old {
    const char* name;
    int minor;
    int commands;
    std::int64_t last_tick;
    bool whole;        // has an end line
    bool two = false;  // has two materials
    const char* texture = nullptr;
    bool flow = false;
    bool parent = false;
    bool things = false;
};

std::filesystem::path path_of(const Old& old) {
    return support::source_dir() / "tests" / "recordings" / (std::string(old.name) + ".couloir");
}

class OldRecording : public testing::TestWithParam<Old> {
  protected:
    Old old_ = GetParam();
    static Recording opened(const Old& old) {
        Recording recording = read_recording(path_of(old)).value();
        renew(recording);
        return recording;
    }
    Recording recording_ = opened(old_);
};

TEST_P(OldRecording, is_read_as_it_was_written) {
    const Scenario& scenario = recording_.header.scenario;
    EXPECT_EQ(recording_.header.minor, old_.minor);
    EXPECT_EQ(recording_.commands.size(), static_cast<std::size_t>(old_.commands));
    EXPECT_EQ(recording_.last_tick(), old_.last_tick);
    EXPECT_EQ(recording_.end.has_value(), old_.whole);
    EXPECT_EQ(recording_.warning.has_value(), !old_.whole || recording_.header.renewed);
    constexpr int kForcesSince = 6;
    EXPECT_EQ(recording_.header.renewed,
              scenario.params.model == sim::Model::kBcreInertial && old_.minor < kForcesSince);
    EXPECT_EQ(scenario.standing.empty(), !old_.things);
    EXPECT_LE(scenario.grid.nx, 25);
    EXPECT_LE(scenario.grid.ny, 25);
    EXPECT_EQ(scenario.lower.has_value(), old_.two);
    EXPECT_EQ(scenario.flow.has_value(), old_.flow);
    EXPECT_FALSE(scenario.model);  // none names a style
    EXPECT_EQ(recording_.header.parent.has_value(), old_.parent);
    ASSERT_EQ(scenario.look.flow.has_value(), old_.texture != nullptr);
    if (old_.texture) {
        EXPECT_EQ(to_string(scenario.look.flow->pattern), old_.texture);
    }
}

TEST_P(OldRecording, plays_to_its_end_and_is_exact_or_of_another_physics) {
    auto session = Session::begin(recording_.header.scenario, {}, std::nullopt).value();
    Verifier verifier(recording_);
    verifier.look_at(session);
    Until until;
    until.tick = recording_.last_tick();
    Watchers watchers;
    watchers.after_tick = [&](const Session& now) { verifier.look_at(now); };
    ASSERT_TRUE(play_headless(session, recording_.commands, until, watchers, ""));
    EXPECT_EQ(session.state().tick, old_.last_tick);
    EXPECT_EQ(session.state().ledger.mass_error(), 0);
    const Verdict& verdict = verifier.verdict();
    EXPECT_EQ(verdict.comparable, is_comparable(recording_.header));
    if (verdict.comparable) {
        EXPECT_FALSE(verdict.parted) << *verdict.parted;
        std::size_t recorded = 0;
        for (const StateLine& line : recording_.states) recorded += 1 + line.before.size();
        EXPECT_EQ(verdict.compared, recorded);
        EXPECT_EQ(verdict.proven_tick, recording_.states.back().tick);
    }
}

TEST_P(OldRecording, verified_by_the_program_is_exact_or_not_comparable_never_wrong) {
    const Finished finished = couloir({"replay", path_of(old_).string(), "--verify"});
    const bool comparable = is_comparable(recording_.header);
    EXPECT_EQ(finished.status, comparable ? 0 : 1) << finished.err;
    EXPECT_NE(finished.out.find(comparable ? "exact: all" : "not comparable"), std::string::npos)
        << finished.out;
    EXPECT_EQ(finished.err.find("warning") != std::string::npos, !old_.whole || recording_.header.renewed)
        << finished.err;
}

TEST_P(OldRecording, normalised_is_of_the_newest_format_and_exact) {
    const support::TemporaryFolder folder;
    const auto out = folder.path() / "new.couloir";
    const Finished finished = couloir({"normalise", path_of(old_).string(), "--out", out.string()});
    ASSERT_EQ(finished.status, 0) << finished.err;
    const bool comparable = is_comparable(recording_.header);
    EXPECT_EQ(finished.out.find("not comparable") == std::string::npos, comparable) << finished.out;

    const Recording made = read_recording(out).value();
    EXPECT_FALSE(made.warning);
    EXPECT_EQ(made.header.minor, kFormatMinor);
    EXPECT_EQ(made.header.physics_version, kPhysicsVersion);
    ASSERT_TRUE(made.header.rewritten_from);
    EXPECT_EQ(*made.header.rewritten_from,
              (Origin{old_.minor, recording_.header.physics_version, recording_.header.program}));
    EXPECT_EQ(ground_hash(made.header.scenario), ground_hash(recording_.header.scenario));
    EXPECT_EQ(made.header.scenario.params, recording_.header.scenario.params);
    ASSERT_EQ(made.commands.size(), recording_.commands.size());
    for (std::size_t i = 0; i < made.commands.size(); ++i) {
        EXPECT_EQ(made.commands[i].tick, recording_.commands[i].tick);
        EXPECT_EQ(made.commands[i].command, recording_.commands[i].command);
    }
    EXPECT_EQ(made.end, old_.last_tick);
    const Finished verified = couloir({"replay", out.string(), "--verify"});
    EXPECT_NE(verified.out.find("exact: all"), std::string::npos) << verified.out;
}

constexpr Old kOld[] = {
    {"format_1_0", 0, 2, 90, true},
    {"format_1_0_without_end", 0, 1, 24, false},
    {"format_1_0_sources_under_way", 0, 2, 30, true},
    {"format_1_1_bcre_muscl_shear", 1, 2, 60, true},
    {"format_1_2_anchors", 2, 2, 60, true},
    {"format_1_3_two_materials", 3, 3, 60, true, true, "snow"},
    {"format_1_3_flow", 3, 0, 40, true, false, "stones", true},
    {"format_1_3_texture", 3, 1, 60, true, false, "soil"},
    {"format_1_3_torn", 3, 2, 48, false, false, "soil"},
    {"format_1_4_parent", 4, 1, 90, true, false, "soil", false, true},
    {"format_1_7_things", 7, 12, 300, true, false, "snow", false, false, true},
    {"format_1_8_goal", 8, 7, 3600, true, false, "soil"},
    {"format_1_9_saved_world", 9, 1, 60, true, true, "snow", false, false, true},
};

INSTANTIATE_TEST_SUITE_P(Files, OldRecording, testing::ValuesIn(kOld),
                         [](const auto& old) { return std::string(old.param.name); });

TEST(OldRecordings, are_all_files_in_the_folder) {
    std::vector<std::string> known, there;
    for (const Old& old : kOld) known.emplace_back(old.name);
    for (const auto& entry :
         std::filesystem::directory_iterator(support::source_dir() / "tests" / "recordings"))
        if (entry.path().extension() == ".couloir") there.push_back(entry.path().stem().string());
    std::sort(known.begin(), known.end()), std::sort(there.begin(), there.end());
    EXPECT_EQ(there, known);
}

TEST(NewerRecording, is_not_normalised_because_data_would_be_lost) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "small.couloir", out = folder.path() / "new.couloir";
    record(path, small_scenario(), 6, {});
    auto bodies = bodies_of(read_bytes(path));
    Json header = json_of(bodies[0]);
    header["version"] = {kFormatMajor, kFormatMinor + 1};
    bodies[0] = body_of(header);
    write_bytes(path, chained(bodies));
    const Finished finished = couloir({"normalise", path.string(), "--out", out.string()});
    EXPECT_EQ(finished.status, 2);
    EXPECT_NE(finished.err.find("newer than this program's"), std::string::npos) << finished.err;
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace game::test
