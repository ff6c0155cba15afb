#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/recording/reader.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

constexpr int kTicks = 20;

// A recording of 20 ticks, and the result of `replay --verify` after a change to it.
class Verdicts : public testing::Test {
  protected:
    Verdicts() {
        record(path_, small_scenario(), kTicks, some_commands());
        bodies_ = bodies_of(read_bytes(path_));
    }

    // Expects this exit status of the program, `outcome` in the summary, and this last verified tick.
    void expect(int status, const std::string& outcome, std::int64_t proven,
                const std::vector<std::string>& options = {}) const {
        write_bytes(path_, chained(bodies_));
        std::vector<std::string> arguments{"replay", path_.string(), "--verify", "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, status) << finished.err;
        const Json verified = Json::parse(finished.out)["verified"];
        EXPECT_EQ(verified["outcome"], outcome);
        EXPECT_EQ(verified["proven_tick"], proven);
        EXPECT_EQ(verified["exact"], status == 0);
    }
    // Changes one member of this tick's state line.
    void set(std::int64_t tick, const char* key, const Json& value) {
        for (std::string& body : bodies_) {
            Json json = json_of(body);
            if (!json.contains("hash") || json["tick"] != tick) continue;
            json[key] = value;
            body = body_of(json);
        }
    }
    void set_physics_version(int version) {
        Json header = json_of(bodies_[0]);
        header["physics_version"] = version;
        bodies_[0] = body_of(header);
    }

    support::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "small.couloir";
    std::vector<std::string> bodies_;
};

TEST_F(Verdicts, is_0_if_every_recorded_state_is_equal) {
    expect(0, "exact", kTicks);
    expect(0, "exact", 7, {"--until", "7"});
    expect(0, "exact", 0, {"--until", "0"});
}

TEST_F(Verdicts, of_a_recording_cut_after_any_line_is_0_only_if_a_state_is_left) {
    const auto whole = bodies_;
    for (std::size_t lines = 1; lines < whole.size(); ++lines) {
        SCOPED_TRACE(lines);
        bodies_.assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(lines));
        std::int64_t last_state = -1;
        for (const std::string& body : bodies_)
            if (const Json json = json_of(body); json.contains("hash")) last_state = json["tick"];
        expect(last_state < 0 ? 1 : 0, last_state < 0 ? "nothing proven" : "exact", last_state);
    }
}

TEST_F(Verdicts, is_1_if_no_state_was_recorded) {
    std::vector<std::string> kept{bodies_[0]};
    for (const std::string& body : bodies_)
        if (const Json json = json_of(body); json.contains("pour") || json.contains("blast"))
            kept.push_back(body);
    bodies_ = kept;
    ASSERT_GE(bodies_.size(), 2u);
    expect(1, "nothing proven", -1);
}

TEST_F(Verdicts, is_1_if_the_recording_is_of_another_physics_whatever_its_states) {
    for (const int version : {kPhysicsVersion + 1, kPhysicsVersion - 1, 1 << 20}) {
        set_physics_version(version);
        expect(1, "not comparable", -1);
    }
    set(12, "hash", "0123456789abcdef");
    expect(1, "not comparable", -1);
}

TEST_F(Verdicts, is_1_from_the_first_tick_on_that_differs) {
    set(12, "hash", "0123456789abcdef");
    expect(0, "exact", 11, {"--until", "11"});
    expect(1, "differs", 11, {"--until", "12"});
    expect(1, "differs", 11);
}

TEST_F(Verdicts, is_1_if_one_of_two_lines_about_a_tick_is_wrong) {
    // The line of tick 12 also reports the states of 7 to
    // 11, and could go back further than the line of tick 6.
    Json before = Json::array();
    for (int tick = 5; tick < 12; ++tick) before.push_back("0123456789abcdef");
    set(12, "before", before);
    expect(1, "differs", 4);
}

}  // namespace
}  // namespace game::test
