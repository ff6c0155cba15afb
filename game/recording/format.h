#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "game/recording/json_values.h"
#include "game/scene/memory.h"
#include "game/scene/scenario.h"
#include "sim/world/ledger.h"

namespace game {

// A recording is JSON Lines: a header with the whole scenario, then one line per command and, every few
// ticks, one with the state's hash and the mass ledger, then an end line. Every line ends with "chain", the
// hash of the previous line and of itself, so that damage can be located. docs/recording.md has an example.

inline constexpr int kFormatMajor = 1;  // a reader refuses a greater one
inline constexpr int kFormatMinor = 4;  // a greater one may have fields that this reader ignores
inline constexpr int kPhysicsVersion =
    6;  // of the physics and its hash: recordings of another one play, but are not comparable
inline constexpr int kTicksPerState = 6;  // between two state lines

// The state after `tick` ticks.
struct StateLine {
    std::int64_t tick = 0;
    std::uint64_t hash = 0;
    std::vector<std::uint64_t> before;  // hashes of the ticks before it, oldest first
    sim::Ledger ledger;                 // initial is not written: it follows from the others
    bool operator==(const StateLine&) const = default;
};

struct EndLine {
    std::int64_t tick = 0;  // ticks done
};

// What a try at the scenario's goal claims to have scored, at the tick at which it ended. Only a replay proves it.
struct ClaimLine {
    std::int64_t tick = 0;
    std::int64_t score = 0;
    int medal = 0;  // 0 none, 1 bronze, 2 silver, 3 gold
    bool operator==(const ClaimLine&) const = default;
};

// The recording that this one was forked from.
struct Parent {
    std::string name;         // of its file, without extension
    std::int64_t tick = 0;    // first tick that is this recording's own
    std::string change = {};  // what was changed there, for display; empty if the user continued from there
    bool operator==(const Parent&) const = default;
};

// The original of a recording that was rewritten in a newer format.
struct Origin {
    int minor = 0;  // of its format
    int physics_version = 0;
    std::string program;
    bool operator==(const Origin&) const = default;
};

struct Header {
    Scenario scenario;
    int minor = kFormatMinor;  // as read; written as kFormatMinor
    int physics_version = kPhysicsVersion;
    int ticks_per_state = kTicksPerState;
    std::string program;  // program and version that wrote it
    std::optional<Parent> parent;
    std::optional<Origin> rewritten_from;
};

// Takes all numbers that may change while a world exists.
void take_numbers(const sim::Params& from, sim::Params& to);
// Whether its states are those that this program computes.
bool is_comparable(const Header& header);

// Readers return errors as a fact without file and line, because the caller knows those.
Json to_json(const Header& header);
// Unpacks the terrain only if `memory` allows such a world.
tl::expected<Header, std::string> header_from(const Json& json, const Memory& memory = {});
// The fact that is wrong with a recording. If its format is newer than this program's, the format is named too,
// because what looks like damage may be new.
std::string noting_newer(std::string fact, int minor);
// Checks that this is a header of a format that this program reads. Call it first, even before checking the
// chain: other formats need not share anything else.
tl::expected<void, std::string> check_format(const Json& json);

// Appended to `line`, without a line break. Allocates only if the string must grow.
void write(const TimedCommand& command, std::string& line);
void write(const StateLine& state, std::string& line);
void write(const ClaimLine& claim, std::string& line);
void write(const EndLine& end, std::string& line);
using Line = std::variant<TimedCommand, StateLine, ClaimLine, EndLine>;
tl::expected<Line, std::string> line_from(const Json& json);

std::string hex(std::uint64_t value);  // 16 digits
// For people and scripts: indented, with a line break. Invalid
// UTF-8, which a file name may contain, becomes U+FFFD.
std::string printed(const Json& json);
std::optional<std::uint64_t> from_hex(std::string_view text);

}  // namespace game
