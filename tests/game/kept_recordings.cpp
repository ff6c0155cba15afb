// tests/recordings has a recording for each feature of the format. None is ever made again, because users' recordings
// must keep playing.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

#include "game/recording/recorder.h"
#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

struct Kept {
    const char* name;
    int commands;
    std::int64_t last_tick;
    bool whole = true;                            // has an end line
    bool (*has)(const Header& header) = nullptr;  // its feature, if that is in the header
    int minor = 0;                                // of its format
};

std::filesystem::path folder() {
    return support::source_dir() / "tests" / "recordings";
}

class KeptRecording : public testing::TestWithParam<Kept> {
  protected:
    Kept kept_ = GetParam();
    std::filesystem::path path_ = folder() / (std::string(kept_.name) + ".couloir");
    Recording recording_ = read_recording(path_).value();
};

TEST_P(KeptRecording, is_read_as_it_was_written) {
    EXPECT_EQ(recording_.header.minor, kept_.minor);
    EXPECT_EQ(recording_.commands.size(), static_cast<std::size_t>(kept_.commands));
    EXPECT_EQ(recording_.last_tick(), kept_.last_tick);
    EXPECT_EQ(recording_.end.has_value(), kept_.whole);
    EXPECT_EQ(recording_.warning.has_value(), !kept_.whole);
    if (kept_.has) {
        EXPECT_TRUE(kept_.has(recording_.header));
    }
}

TEST_P(KeptRecording, is_exact_or_not_comparable_and_never_wrong) {
    const Finished finished = couloir({"replay", path_.string(), "--verify"});
    const bool comparable = is_comparable(recording_.header);
    EXPECT_EQ(finished.status, comparable ? 0 : 1) << finished.err;
    EXPECT_NE(finished.out.find(comparable ? "exact: all" : "not comparable"), std::string::npos)
        << finished.out;
    EXPECT_EQ(finished.err.find("warning") != std::string::npos, !kept_.whole) << finished.err;
}

TEST_P(KeptRecording, normalised_is_of_the_newest_format_and_exact) {
    const support::TemporaryFolder temporary;
    const auto out = temporary.path() / "new.couloir";
    const Finished finished = couloir({"normalise", path_.string(), "--out", out.string()});
    ASSERT_EQ(finished.status, 0) << finished.err;
    const Recording made = read_recording(out).value();
    EXPECT_FALSE(made.warning);
    EXPECT_EQ(made.header.minor, kFormatMinor);
    EXPECT_EQ(made.header.physics_version, kPhysicsVersion);
    EXPECT_EQ(made.header.rewritten_from, (Origin{recording_.header.minor, recording_.header.physics_version,
                                                  recording_.header.program}));
    EXPECT_EQ(ground_hash(made.header.scenario), ground_hash(recording_.header.scenario));
    EXPECT_EQ(made.header.scenario.params, recording_.header.scenario.params);
    ASSERT_EQ(made.commands.size(), recording_.commands.size());
    for (std::size_t i = 0; i < made.commands.size(); ++i) {
        EXPECT_EQ(made.commands[i].tick, recording_.commands[i].tick);
        EXPECT_EQ(made.commands[i].command, recording_.commands[i].command);
    }
    EXPECT_EQ(made.end, kept_.last_tick);
}

// With its states, however rarely they come: the fork says so in its header, else its reader takes them for lost.
TEST_P(KeptRecording, forked_at_each_of_its_states_is_read) {
    if (!is_comparable(recording_.header)) return;  // a fork of it has other states
    for (const int rarely : {1, 7}) {
        Recording parent = recording_;
        std::erase_if(parent.states, [&](const StateLine& state) {
            return state.tick % (rarely * recording_.header.ticks_per_state) != 0 &&
                   state.tick != recording_.last_tick();
        });
        parent.header.ticks_per_state *= rarely;
        for (const StateLine& state : parent.states) {
            const auto fork = Recorder::fork(in_memory("fork"), parent, "parent", state.tick).value();
            std::istringstream text(fork.copy_ended_at(state.tick, nullptr).value());
            const auto read = read_recording(text, "fork");
            ASSERT_TRUE(read) << read.error().sentence;
            EXPECT_EQ(read->last_tick(), state.tick);
            EXPECT_EQ(read->warning, std::nullopt);
        }
    }
}

constexpr Kept kKept[] = {
    {"landslide", 2, 90},
    {"without_end", 1, 18, false},
    {"sources_under_way", 2, 30},
    {"bcre_muscl_shear", 2, 60, true,
     [](const Header& h) { return h.scenario.params.law == sim::Law::kShear; }},
    {"anchors", 2, 60},
    {"two_materials", 3, 60, true, [](const Header& h) { return h.scenario.lower.has_value(); }},
    {"flow", 0, 40, true, [](const Header& h) { return h.scenario.flow.has_value(); }},
    {"texture", 1, 60, true, [](const Header& h) { return h.scenario.look.flow.has_value(); }},
    {"torn", 1, 48, false},
    {"parent", 1, 90, true, [](const Header& h) { return h.parent.has_value(); }},
    {"things", 12, 300, true, [](const Header& h) { return !h.scenario.standing.empty(); }},
    {"goal", 7, 3600, true, [](const Header& h) { return h.scenario.goal.has_value(); }},
    {"saved_world", 1, 60, true, [](const Header& h) { return !h.scenario.lower->settled.empty(); }},
    {"water", 2, 90, true, [](const Header& h) { return !h.scenario.standing.water.empty(); }, 3},
    {"weather", 4, 180, true, [](const Header& h) { return h.scenario.weather.has_value(); }, 4},
};

INSTANTIATE_TEST_SUITE_P(Files, KeptRecording, testing::ValuesIn(kKept),
                         [](const auto& kept) { return std::string(kept.param.name); });

TEST(KeptRecordings, are_all_files_in_the_folder) {
    std::vector<std::string> known, there;
    for (const Kept& kept : kKept) known.emplace_back(kept.name);
    for (const auto& entry : std::filesystem::directory_iterator(folder()))
        if (entry.path().extension() == ".couloir") there.push_back(entry.path().stem().string());
    std::sort(known.begin(), known.end()), std::sort(there.begin(), there.end());
    EXPECT_EQ(there, known);
}

TEST(NewerRecording, is_not_normalised_because_data_would_be_lost) {
    const support::TemporaryFolder temporary;
    const auto path = temporary.path() / "small.couloir", out = temporary.path() / "new.couloir";
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
