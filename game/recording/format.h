#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "game/scene/memory.h"
#include "game/scene/scenario.h"
#include "sim/world/ledger.h"

namespace game {

// A recording is JSON Lines: a header that holds the whole start, then one line per command and one every few
// ticks with the state's hash and the mass ledger, last an end line. Every line closes with "chain": the hash
// of the line before and of itself, so that damage shows where it is. README.md has an example.

using Json = nlohmann::ordered_json;

inline constexpr int kFormatMajor = 1;  // a reader refuses a greater one
inline constexpr int kFormatMinor = 4;  // a greater one may hold fields that this reader leaves alone
inline constexpr int kPhysicsVersion =
    5;  // of the physics and its hash: recordings of another one play, but are not comparable
inline constexpr int kTicksPerState = 6;  // between two state lines

// The state after `tick` ticks.
struct StateLine {
    std::int64_t tick = 0;
    std::uint64_t hash = 0;
    std::vector<std::uint64_t> before;  // hashes of the ticks that came before it, the oldest first
    sim::Ledger ledger;                 // initial is not written: it follows from the others
    bool operator==(const StateLine&) const = default;
};

struct EndLine {
    std::int64_t tick = 0;  // ticks that were done
};

// What a recording was forked from.
struct Parent {
    std::string name;         // of its file, without extension
    std::int64_t tick = 0;    // from which on this one goes its own way
    std::string change = {};  // what was changed there, for people; empty where somebody played on
    bool operator==(const Parent&) const = default;
};

// What a recording was, before it was rewritten in a newer format.
struct Origin {
    int minor = 0;  // of its format
    int physics_version = 0;
    std::string program;
    bool operator==(const Origin&) const = default;
};

struct Header {
    Scenario scenario;
    int minor = kFormatMinor;  // as it was read; it is written as kFormatMinor
    int physics_version = kPhysicsVersion;
    int ticks_per_state = kTicksPerState;
    std::string program;  // that wrote it, with its version
    std::optional<Parent> parent;
    std::optional<Origin> rewritten_from;
};

// Readers' errors are a fact without file and line, which the caller knows.
Json to_json(const Header& header);
// Its terrain is unpacked only if `memory` allows such a world.
tl::expected<Header, std::string> header_from(const Json& json, const Memory& memory = {});
// Whether this is a header of a format that this program reads. To be asked first, of the chain too: nothing
// else need be the same in another format.
tl::expected<void, std::string> check_format(const Json& json);

// Appended to `line`, without a line break; allocates only where the string must grow.
void write(const TimedCommand& command, std::string& line);
void write(const StateLine& state, std::string& line);
void write(const EndLine& end, std::string& line);
using Line = std::variant<TimedCommand, StateLine, EndLine>;
tl::expected<Line, std::string> line_from(const Json& json);

// The double whose shortest text is also the float's.
double shortest(float value);
std::string hex(std::uint64_t value);  // 16 digits
// For people and scripts: indented, with a line break. What is not UTF-8, as a file's name may be, becomes
// U+FFFD.
std::string printed(const Json& json);
std::optional<std::uint64_t> from_hex(std::string_view text);

}  // namespace game
