#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/base/limits.h"
#include "game/recording/recording_file.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// A short recording, and damaged versions of the same file.
class DamagedRecording : public testing::Test {
  protected:
    DamagedRecording() : path_(folder_.path() / "small.couloir") {
        record(path_, small_scenario(), 40, some_commands());
        whole_ = read_bytes(path_);
        header_end_ = whole_.find('\n');
    }

    Outcome<Recording> read(const std::string& bytes) {
        write_bytes(path_, bytes);
        return read_recording(path_);
    }

    // Expects an error with the file, this line and a description; returns the sentence.
    std::string refused_at(std::size_t line, const Outcome<Recording>& outcome) {
        if (outcome) {
            ADD_FAILURE() << "accepted, warning: " << outcome->warning.value_or("none");
            return {};
        }
        const std::string& sentence = outcome.error().sentence;
        EXPECT_EQ(outcome.error().status, Failure::kUnusable) << sentence;
        EXPECT_EQ(sentence.rfind(path_.string() + ":" + std::to_string(line) + ": ", 0), 0u) << sentence;
        EXPECT_EQ(sentence.find("exception"), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        return sentence;
    }

    static std::size_t lines_in(std::string_view text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    // Truncated to `length` bytes: an error within the header, else a warning and all whole lines.
    void expect_cut(std::size_t length) {
        SCOPED_TRACE("cut to " + std::to_string(length) + " of " + std::to_string(whole_.size()) + " bytes");
        const std::string prefix = whole_.substr(0, length);
        const auto outcome = read(prefix);
        if (length == 0) {
            ASSERT_FALSE(outcome);
            EXPECT_EQ(outcome.error().sentence, path_.string() + ": empty");
        } else if (length <= header_end_) {
            refused_at(1, outcome);
        } else {
            ASSERT_TRUE(outcome) << outcome.error().sentence;
            EXPECT_EQ(1 + outcome->commands.size() + outcome->states.size() + (outcome->end ? 1 : 0),
                      lines_in(prefix));
            EXPECT_EQ(outcome->warning.has_value(), length < whole_.size());
        }
    }

    support::TemporaryFolder folder_;
    std::filesystem::path path_;
    std::string whole_;
    std::size_t header_end_ = 0;
};

TEST_F(DamagedRecording, is_accepted_undamaged) {
    const auto recording = read(whole_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_FALSE(recording->warning);
    EXPECT_EQ(recording->end, 40);
    EXPECT_EQ(recording->last_tick(), 40);
    EXPECT_EQ(recording->states.size(), 8u);  // 0, 6, ..., 36, 40
    const auto commands = some_commands();
    ASSERT_EQ(recording->commands.size(), commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i) {
        EXPECT_EQ(recording->commands[i].tick, commands[i].tick);
        EXPECT_EQ(recording->commands[i].command, commands[i].command);
    }
}

TEST_F(DamagedRecording, cut_anywhere_near_its_end_keeps_its_whole_lines) {
    for (std::size_t length = whole_.size() - 1024; length <= whole_.size(); ++length) expect_cut(length);
}

TEST_F(DamagedRecording, cut_anywhere_else_keeps_its_whole_lines_or_names_the_header) {
    std::mt19937 random(1);
    for (std::size_t length = 0; length < 20; ++length) expect_cut(length);
    for (std::size_t around = header_end_ - 20; around < header_end_ + 20; ++around) expect_cut(around);
    for (int i = 0; i < 300; ++i) expect_cut(random() % whole_.size());
}

TEST_F(DamagedRecording, with_any_one_byte_changed_names_the_line) {
    std::mt19937 random(2);
    for (int i = 0; i < 600; ++i) {
        // The header is most of the file: every other flip is behind it.
        const std::size_t from = i % 2 == 0 ? 0 : header_end_;
        const std::size_t at = from + random() % (whole_.size() - from);
        std::string flipped = whole_;
        flipped[at] = static_cast<char>(static_cast<unsigned char>(flipped[at]) ^ (1 + random() % 255));
        SCOPED_TRACE("byte " + std::to_string(at) + " of " + std::to_string(whole_.size()));
        if (at + 1 < whole_.size())
            refused_at(1 + lines_in(std::string_view(whole_).substr(0, at)), read(flipped));
    }
}

TEST_F(DamagedRecording, with_its_last_line_break_changed_is_torn) {
    std::string flipped = whole_;
    flipped.back() = ' ';
    const auto recording = read(flipped);
    ASSERT_TRUE(recording) << recording.error().sentence;
    ASSERT_TRUE(recording->warning);
    EXPECT_NE(recording->warning->find("cut off"), std::string::npos) << *recording->warning;
    EXPECT_FALSE(recording->end);
}

TEST_F(DamagedRecording, with_lines_dropped_doubled_or_swapped_names_the_line) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < whole_.size();) {
        const std::size_t next = whole_.find('\n', at) + 1;
        lines.push_back(whole_.substr(at, next - at));
        at = next;
    }
    const auto joined = [](const std::vector<std::string>& parts) {
        std::string text;
        for (const std::string& part : parts) text += part;
        return text;
    };
    for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
        auto dropped = lines, doubled = lines, swapped = lines;
        dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(i));
        doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
        std::swap(swapped[i], swapped[i + 1]);
        refused_at(i + 1, read(joined(dropped)));
        refused_at(i + 2, read(joined(doubled)));
        refused_at(i + 1, read(joined(swapped)));
    }
    lines.push_back(lines.back());
    EXPECT_NE(refused_at(lines.size(), read(joined(lines))).find("after the end line"), std::string::npos);
}

// From here on the lines are rechained, as by a forger: the hashes match, but the content is inconsistent.

TEST_F(DamagedRecording, that_goes_back_in_time_is_refused) {
    auto bodies = bodies_of(whole_);
    bodies.insert(bodies.end() - 1, bodies[bodies.size() - 3]);
    EXPECT_NE(refused_at(bodies.size() - 1, read(chained(bodies))).find("goes back to tick 36 from 40"),
              std::string::npos);
    bodies = bodies_of(whole_);
    bodies.back() = "{\"end\":39";
    EXPECT_NE(refused_at(bodies.size(), read(chained(bodies))).find("ends at tick 39"), std::string::npos);
    bodies = bodies_of(whole_);
    bodies.push_back(bodies[bodies.size() - 2]);
    EXPECT_NE(refused_at(bodies.size(), read(chained(bodies))).find("after the end line"), std::string::npos);
}

TEST_F(DamagedRecording, without_the_state_lines_that_lead_to_a_tick_is_refused) {
    const auto whole = bodies_of(whole_);
    const auto is_state = [](const std::string& body) {
        return body.find("\"hash\":\"") != std::string::npos;
    };
    // After removing any state line but the first, some tick is more than ticks_per_state from a state,
    // unless the next line is the end's.
    for (std::size_t i = 2; i < whole.size(); ++i) {
        if (!is_state(whole[i]) || !is_state(whole[i - 1])) continue;
        auto bodies = whole;
        bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(i));
        if (i + 2 == whole.size())
            EXPECT_TRUE(read(chained(bodies))) << i;
        else
            refused_at(i + 1, read(chained(bodies)));
    }
    for (const char* end : {"{\"end\":47", "{\"end\":1099511627776"}) {
        auto bodies = whole;
        bodies.back() = end;
        refused_at(bodies.size(), read(chained(bodies)));
        refused_at(2, read(chained({whole[0], end})));
    }
    Json forked = json_of(whole[0]);
    forked["parent"] = {{"name", "it"}, {"tick", 1000}};
    EXPECT_TRUE(read(chained({body_of(forked), "{\"end\":1006"})));
    refused_at(2, read(chained({body_of(forked), "{\"end\":1007"})));
    // However late a fork begins, its reader does not compute more ticks than this without a state line.
    for (const std::int64_t late :
         {kMostTicksOfParent + kMostTicksPerState, std::int64_t{9'999'999}, std::int64_t{1} << 40}) {
        forked["parent"]["tick"] = late;
        refused_at(2, read(chained({body_of(forked), fmt::format("{{\"end\":{}", late)})));
    }
}

TEST_F(DamagedRecording, with_too_many_commands_in_a_tick_is_refused) {
    const auto whole = bodies_of(whole_);
    const auto with = [&](std::size_t count, std::int64_t apart, const sim::Command& command) {
        std::vector<std::string> bodies{whole[0]};
        std::string line;
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t tick = static_cast<std::int64_t>(i) * apart / 256;
            if (i == 0 || (apart > 0 && i % (256 * 6) == 0)) {
                StateLine state;
                state.tick = tick;
                write(state, line);
                line.pop_back();
                bodies.push_back(std::exchange(line, {}));
            }
            write(TimedCommand{tick, command}, line);
            line.pop_back();
            bodies.push_back(std::exchange(line, {}));
        }
        return read(chained(bodies));
    };
    const sim::Command settle{.kind = sim::CommandKind::kSettle, .radius = 1e5};
    EXPECT_TRUE(with(sim::kMostCommandsPerTick, 0, settle));
    EXPECT_FALSE(with(sim::kMostCommandsPerTick + 1, 0, settle));
    EXPECT_TRUE(with(20 * sim::kMostCommandsPerTick, 1, settle));
    sim::Command pour = some_commands()[0].command;
    pour.duration = 1000;
    EXPECT_TRUE(with(sim::kMostRunningCommands, 1, pour));
    EXPECT_FALSE(with(sim::kMostRunningCommands + 1, 1, pour));
    pour.duration = 0;
    EXPECT_TRUE(with(2 * sim::kMostRunningCommands, 1, pour));
}

TEST_F(DamagedRecording, with_lines_of_nonsense_is_refused) {
    for (const char* nonsense :
         {"{\"snow\":1", "[1", "{\"tick\":1,\"pour\":{}", "{\"tick\":1e999,\"end\":1e999", "{\"end\":-1",
          "{\"end\":1.5", "{\"end\":99999999999999999999", "{\"end\":null",
          "{\"tick\":40,\"hash\":\"0\",\"mass\":{}", "{\"tick\":40,\"hash\":\"0123456789abcdef\",\"mass\":[]",
          "{\"tick\":40,\"pour\":null", "", "\"\xff"}) {
        SCOPED_TRACE(nonsense);
        auto bodies = bodies_of(whole_);
        bodies.back() = nonsense;
        refused_at(bodies.size(), read(chained(bodies)));
    }
}

// What counts must not depend on which of two a reader takes.
TEST_F(DamagedRecording, with_a_key_twice_in_any_object_is_refused_with_the_key) {
    const auto bodies = bodies_of(whole_);
    const auto expect_refused = [&](std::size_t line, const std::string& part, const std::string& more,
                                    const std::string& key) {
        auto changed = bodies;
        const auto at = changed[line].find(part);
        ASSERT_NE(at, std::string::npos) << part;
        changed[line].insert(at + part.size(), more);
        const std::string sentence = refused_at(line + 1, read(chained(changed)));
        EXPECT_NE(sentence.find("the key '" + key + "' twice"), std::string::npos) << sentence;
    };
    expect_refused(0, R"("format":"couloir",)", R"("format":"couloir",)", "format");
    expect_refused(0, R"("physics":{)", R"("tick_s":1,)", "tick_s");
    expect_refused(1, "{", R"("hash":"0",)", "hash");
    const auto command = std::ranges::find_if(
        bodies, [](const std::string& body) { return body.find("\"pour\":{") != std::string::npos; });
    ASSERT_NE(command, bodies.end());
    expect_refused(static_cast<std::size_t>(command - bodies.begin()), R"("pour":{)", R"("radius":1,)",
                   "radius");
}

TEST_F(DamagedRecording, nested_deeper_than_any_recording_is_refused) {
    std::string nested = R"({"format":"couloir","a":)";
    for (int depth = 0; depth < 10000; ++depth) nested += "{\"a\":";
    nested += "1" + std::string(10000, '}');
    auto bodies = bodies_of(whole_);
    bodies.back() = nested;
    EXPECT_NE(refused_at(bodies.size(), read(chained(bodies))).find("nested"), std::string::npos);
    EXPECT_NE(refused_at(1, read(chained({nested}))).find("nested"), std::string::npos);
}

// The address sanitizer keeps freed memory, so there the memory use means nothing.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kMemoryIsOurs = false;
#else
constexpr bool kMemoryIsOurs = true;
#endif

// Peak resident size so far, bytes.
std::size_t most_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

TEST_F(DamagedRecording, with_an_endless_line_is_refused_before_it_is_read) {
    write_bytes(path_, whole_);
    std::filesystem::resize_file(path_,
                                 whole_.size() + (100u << 20));  // zeros without a line break
    const std::size_t before = most_memory();
    EXPECT_NE(refused_at(lines_in(whole_) + 1, read_recording(path_)).find("longer than"), std::string::npos);
    if (kMemoryIsOurs) {
        EXPECT_LT(most_memory() - before, 16u << 20);
    }
}

TEST_F(DamagedRecording, that_begins_with_a_line_of_a_gigabyte_takes_no_memory) {
    for (const std::string beginning : {"", "[[[[[[[[", R"({"format":"couloir","a":")"}) {
        write_bytes(path_, beginning);
        std::filesystem::resize_file(path_, 1u << 30);  // zeros without a line break
        const std::size_t before = most_memory();
        refused_at(1, read_recording(path_));
        if (kMemoryIsOurs) {
            EXPECT_LT(most_memory() - before, 4u << 20) << beginning;
        }
    }
}

TEST_F(DamagedRecording, of_a_small_file_that_claims_a_vast_ground_takes_no_memory) {
    auto bodies = bodies_of(whole_);
    Json header = json_of(bodies[0]);
    header["terrain"]["nx"] = header["terrain"]["ny"] = 4097;
    bodies[0] = body_of(header);
    const std::size_t before = most_memory();
    refused_at(1, read(chained(bodies)));
    if (kMemoryIsOurs) {
        EXPECT_LT(most_memory() - before, 16u << 20);
    }
}

TEST_F(DamagedRecording, that_is_empty_missing_or_a_folder_is_reported_as_such) {
    const auto empty = read("");
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().sentence, path_.string() + ": empty");
    for (const auto& place : {folder_.path(), folder_.path() / "nothing.couloir"}) {
        const auto outcome = read_recording(place);
        ASSERT_FALSE(outcome);
        EXPECT_EQ(outcome.error().status, Failure::kUnusable);
        EXPECT_EQ(outcome.error().sentence.rfind(place.string() + ": ", 0), 0u) << outcome.error().sentence;
    }
}

}  // namespace
}  // namespace game::test
