#include "game/base/number.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/base/outcome.h"
#include "game/command_line.h"
#include "game/compare/edit.h"
#include "sim/world/command.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"

namespace game::test {
namespace {

TEST(Number, is_the_whole_text_and_nothing_that_wraps) {
    EXPECT_EQ(number_from<int>("-12"), -12);
    EXPECT_EQ(number_from<int>("2147483647"), 2147483647);
    EXPECT_EQ(number_from<int>("007"), 7);
    for (const char* text : {"",    " ",   "-",    "2147483648", "4294967304", "18446744073709551624",
                             "8x",  "x8",  "0x10", " 8",         "8 ",         "8\n",
                             "+8",  "8.0", "1e3",  "1_000",      "8ul",        "8,000",
                             "nan", "inf"})
        EXPECT_FALSE(number_from<int>(text)) << "'" << text << "'";
    EXPECT_EQ(number_from<double>("-1.5e3"), -1500);
    EXPECT_EQ(number_from<double>(".5"), 0.5);
    for (const char* text : {"", ".", "e3", "1e400", "-1e400", "1e-400", "nan", "-nan", "NaN(1)", "inf",
                             "-Infinity", "1.5 ", " 1.5", "+1.5", "0x1p3", "1,5", "1.5m", "1.5.2"})
        EXPECT_FALSE(number_from<double>(text)) << "'" << text << "'";
}

TEST(Number, in_a_range_holds_both_ends_and_tells_unit_and_range) {
    constexpr Range<int> kSquares{8, 4096, "squares"};
    EXPECT_EQ(number_from("8", kSquares), 8);
    EXPECT_EQ(number_from("4096", kSquares), 4096);
    for (const char* text : {"7", "4097", "-8", "4294967304", "many"}) {
        const auto number = number_from(text, kSquares);
        ASSERT_FALSE(number) << text;
        EXPECT_NE(number.error().find(text), std::string::npos);
        EXPECT_NE(number.error().find("8 to 4096 squares"), std::string::npos) << number.error();
    }
    EXPECT_FALSE(number_from("0", Range<double>{1e-9, 1}));
}

TEST(Number, with_a_decimal_comma_is_refused_with_the_point_that_it_needs) {
    const auto error = [](const char* text) { return number_from(text, Range<double>{0, 9, "s"}).error(); };
    EXPECT_NE(error("0,5").find("0.5"), std::string::npos) << error("0,5");
    EXPECT_NE(error("-1,5e3").find("-1.5e3"), std::string::npos) << error("-1,5e3");
    for (const char* text : {"1,2,3", "half", ",", "1.5,2", "77"})
        EXPECT_EQ(error(text).find("point"), std::string::npos) << error(text);
    EXPECT_EQ(number_from("8,5", Range<int>{0, 9}).error().find("point"), std::string::npos);
}

TEST(Number, without_a_unit_has_none_in_its_range) {
    EXPECT_EQ(to_text(Range<double>{0, 2, "1"}), "0 to 2");
    EXPECT_EQ(to_text(Range<double>{0, 2, ""}), "0 to 2");
    EXPECT_EQ(to_text(Range<double>{0, 2, "m"}), "0 to 2 m");
}

// An option of the program as --help describes it.
struct Option {
    std::string subcommand, name, type, help;
};

// Every option of every subcommand.
std::vector<Option> options() {
    const std::regex subcommand(R"(  ([a-z-]+) .*)"), option(R"( +(--[a-z-]+)(?: ([^ ]+))?.*)");
    std::vector<Option> all;
    std::istringstream lines(couloir({"--help"}).out);
    bool begun = false;
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        begun = begun || line == "Subcommands:";
        if (!begun || !std::regex_match(line, found, subcommand)) continue;
        const std::string name = found[1];
        std::istringstream help(couloir({name, "--help"}).out);
        for (std::string text; std::getline(help, text);)
            if (std::regex_match(text, found, option))
                all.push_back({name, found[1], found[2], text});
            else if (!all.empty())
                all.back().help += " " + text;
    }
    return all;
}

// How a text of this type holds a number, with {} in its place; nothing for what is no number. A type that is
// not here fails: say what it holds.
const std::map<std::string, std::vector<std::string>> kTypes{
    {"N", {"{}"}},
    {"TICK", {"{}"}},
    {"TICKS", {"{}"}},
    {"FRAMES", {"{}"}},
    {"K", {"{}"}},
    {"S", {"{}"}},
    {"NUMBER", {"{}"}},
    {"WxH", {"{}x64", "64x{}"}},
    {"LEAST:MOST", {"{}:50", "20:{}"}},
    {"WAY", {"device:{}"}},
    {"EAST,NORTH", {"{},5", "5,{}"}},
    {"", {}},
    {"FILE.geojson", {}},
    {"FILE.png", {}},
    {"FILE.toml", {}},
    {"NAME=VALUE,...", {}},  // Number.of_a_command_is_in_the_range_of_the_manifest, Number.of_a_parameter_…
    {"NAME", {}},
    {"FROM", {}},
    {"SYSTEM", {}},
    {"RELEASE_ID", {}},
    {"DIRECTION", {}},
    {"BYTES", {}},  // has a unit: Memory.is_read_from_the_text_of_an_option
    {"LIST", {}},
    {"EAST,NORTH,AZIMUTH,ELEVATION,DISTANCE", {}},  // five ranges: Viewpoint.is_five_numbers_in_their_ranges
    {"FILE", {}},
    {"LESSON", {}},
    {"WORLD", {}},
    {"DIR", {}},
    {"DEM", {}},
    {"FILE.couloir", {}},
    {"NEW.couloir", {}},
    {"FILE.csv", {}},
    {"FILE.json", {}},
    {"FILE.html", {}},
    {"FILE.wav", {}},
    {"FILE.mp4", {}},
    {"R.npy", {}}};

bool is_whole(const std::string& type) {
    return type != "S" && type != "NUMBER" && type != "EAST,NORTH" && type != "LEAST:MOST";
}

// What no option takes, and for one of whole numbers and such a range.
std::vector<std::string> wrong_numbers(const Option& option, const std::string& least,
                                       const std::string& most) {
    std::vector<std::string> all{"",       "8x",  "0x10", " 8",    "8 ",     "+8",  "1e400",
                                 "-1e400", "nan", "-nan", "inf",   "-inf",   "8ul", "1_0",
                                 "8;",     "--",  "ten",  "8,5,3", "1e-400", "8\n", "0b1"};
    const double low = *number_from<double>(least), high = *number_from<double>(most);
    if (is_whole(option.type)) {
        const auto from = *number_from<std::int64_t>(least), to = *number_from<std::int64_t>(most);
        for (const std::int64_t each : {from - 1, to + 1, from + (std::int64_t{1} << 32)})
            all.push_back(std::to_string(each));
        // 2^64 + 8, and what else a loose parser takes.
        all.insert(all.end(), {"18446744073709551624", "8.5", "1e1", "-0x1"});
    } else {
        all.push_back(fmt::format("{}", std::nextafter(low, -1e300)));
        all.push_back(fmt::format("{}", std::nextafter(high, 1e300)));
    }
    return all;
}

// Such a command line up to its options, of files that do not exist, so that no run begins whatever is
// accepted.
std::vector<std::string> beginning(const std::string& subcommand) {
    static const std::map<std::string, std::vector<std::string>> kOperands{
        {"play", {"no.toml"}},
        {"run", {"no.toml", "--until-rest"}},
        {"replay", {"no.couloir"}},
        {"compare", {"no.couloir", "no.couloir"}},
        {"edit", {"no.couloir", "--out", "no/new.couloir"}},
        {"normalise", {"no.couloir", "--out", "no/new.couloir"}},
        {"share", {"no.couloir", "--out", "no/new.html"}},
        {"site", {"no.couloir", "--out", "/dev/null/no"}},
        {"bench", {"no.couloir"}},
        {"release", {"no.tif"}},
        {"track", {"no.obj", "no.npy"}},
        {"figures", {"--out", "/dev/null/no"}},
        {"gallery", {"--out", "/dev/null/no"}}};
    std::vector<std::string> arguments{"couloir", subcommand};
    if (const auto found = kOperands.find(subcommand); found != kOperands.end())
        arguments.insert(arguments.end(), found->second.begin(), found->second.end());
    return arguments;
}

Failure failure_of(const Option& option, const std::string& value) {
    std::vector<std::string> arguments = beginning(option.subcommand);
    arguments.insert(arguments.end(), {option.name, value});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    const Outcome<int> outcome = run_command_line(static_cast<int>(argv.size()), argv.data());
    return outcome ? Failure{Failure::kBadAnswer, "ran"} : outcome.error();
}

std::string with(std::string pattern, const std::string& number) {
    return pattern.replace(pattern.find("{}"), 2, number);
}

TEST(Number, of_every_option_of_every_subcommand_is_refused_unless_it_is_one_in_the_range_that_help_tells) {
    const std::regex told(R"(([-+.0-9e]+) to ([-+.0-9e]+))");
    int numbers = 0;
    for (const Option& option : options()) {
        SCOPED_TRACE(option.subcommand + " " + option.name + " " + option.type);
        ASSERT_TRUE(kTypes.contains(option.type)) << option.help;
        if (kTypes.at(option.type).empty()) continue;
        std::smatch range;
        ASSERT_TRUE(std::regex_search(option.help, range, told)) << option.help;
        const std::string least = range[1], most = range[2];
        ++numbers;
        if (option.type == "S" || option.type == "NUMBER") {
            const std::string told_so = failure_of(option, "0,5").sentence;
            EXPECT_NE(told_so.find("decimal point: 0.5"), std::string::npos) << told_so;
        }
        for (const std::string& pattern : kTypes.at(option.type)) {
            for (const std::string& number : wrong_numbers(option, least, most)) {
                const Failure failure = failure_of(option, with(pattern, number));
                EXPECT_EQ(failure.status, Failure::kUnusable) << "'" << number << "'";
                EXPECT_EQ(failure.sentence.rfind(option.name + ": ", 0), 0u)
                    << "'" << number << "': " << failure.sentence;
            }
            for (const std::string& number : {least, most})
                EXPECT_NE(failure_of(option, with(pattern, number)).sentence.rfind(option.name + ": ", 0), 0u)
                    << "'" << number << "'";
        }
    }
    EXPECT_GE(numbers, 30);
}

TEST(Number, of_a_command_is_refused_unless_it_is_in_the_range_of_the_manifest) {
    Recording recording;
    recording.header.scenario = small_scenario();
    recording.commands = some_commands();
    std::map<std::int64_t, int> which;  // of those in a tick
    for (const TimedCommand& timed : recording.commands) {
        const auto failure_of = [&, place = ++which[timed.tick]](std::string_view name,
                                                                 const std::string& value) {
            const auto set =
                edited(recording, {timed.tick, place, Edit::Set{fmt::format("{}={}", name, value)}});
            return set ? Failure{Failure::kBadAnswer, "taken"} : set.error();
        };
        for (const sim::CommandNumber& number : sim::info_of(timed.command.kind).numbers) {
            const std::string below = fmt::format("{}", std::nextafter(number.least, -1e300));
            const std::string above = fmt::format("{}", std::nextafter(number.most, 1e300));
            for (const std::string& value :
                 {below, above, std::string(), std::string("nan"), std::string("inf"), std::string("1e400"),
                  std::string("8x"), std::string("0x10"), std::string(" 8"), std::string("8 "),
                  std::string("+8")})
                EXPECT_EQ(failure_of(number.name, value).status, Failure::kUnusable)
                    << number.name << "='" << value << "'";
            if (timed.command.kind == sim::CommandKind::kSet) continue;  // its parameter has a narrower range
            for (const double end : {number.least, number.most})
                EXPECT_EQ(failure_of(number.name, fmt::format("{}", end)).status, Failure::kBadAnswer)
                    << number.name;
        }
    }
}

}  // namespace
}  // namespace game::test
