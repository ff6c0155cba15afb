#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sim {

struct Params;
struct State;

enum class CommandKind : std::uint8_t { kPour, kDig, kBlast, kSettle, kSet };
enum class Layer : std::uint8_t { kRolling, kStanding };
enum class Part : std::uint8_t { kUpper, kLower };   // which of two materials (mixture.h)
enum class Profile : std::uint8_t { kDisc, kCone };  // equal depth within the radius; highest in the middle

// One thing a person does to the world, in world units. Which members a kind uses is in kCommands; the others
// keep their defaults. Nothing else changes a world.
struct Command {
    CommandKind kind = CommandKind::kPour;
    double x = 0, y = 0;
    double radius = 10;
    double rate = 0;
    double duration = 0;
    double depth = 0;
    Layer layer = Layer::kRolling;
    Profile profile = Profile::kDisc;
    Part of = Part::kUpper;
    std::size_t param = 0;  // index in kParams
    double value = 0;

    bool operator==(const Command&) const = default;
};

struct CommandNumber {
    std::string_view name, unit;
    double Command::*value;
    double least, most;
    std::string_view meaning;
};

inline constexpr double kFarthest = 1e7;  // m, any coordinate

// Each command that runs costs a tick up to the whole grid: a stroke of the brush gives 16 in a tick.
inline constexpr std::size_t kMostCommandsPerTick = 256;
inline constexpr std::size_t kMostRunningCommands = 1024;  // that run at once

inline constexpr CommandNumber kPourNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5, "of the disc; below a cell, the nearest vertex takes all"},
    {"rate", "m3/s", &Command::rate, 0, 1e8, "volume added per second"},
    {"duration", "s", &Command::duration, 0, 1e5, "rounded to whole ticks, at least one"},
};
inline constexpr CommandNumber kDigNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5, "of the disc; below a cell, the nearest vertex gives"},
    {"rate", "m/s", &Command::rate, 0, 100, "depth taken per second, rolling layer first, never bedrock"},
    {"duration", "s", &Command::duration, 0, 1e5, "rounded to whole ticks, at least one"},
};
inline constexpr CommandNumber kBlastNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5, "of the disc; below a cell, the nearest vertex goes"},
    {"depth", "m", &Command::depth, 0, 100, "erodible depth that becomes rolling layer, at most"},
};

inline constexpr CommandNumber kSettleNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5, "of the disc; below a cell, the nearest vertex settles"},
};
inline constexpr CommandNumber kSetNumbers[] = {
    {"value", "the parameter's", &Command::value, -1e6, 1e6, "from now on; its own range holds too"},
};

// The manifest: from it come the recording's writer and reader, the scene's, --help, and the tests of all.
struct CommandInfo {
    CommandKind kind;
    std::string_view name;
    std::span<const CommandNumber> numbers;
    bool has_layer;    // "as": "rolling" or "standing"
    bool has_profile;  // "profile": "disc" or "cone"
    bool has_part;     // "of": "upper", or in a world of two materials "lower"
    bool has_param;    // "param": a name of kParams that is not fixed
    std::string_view meaning;
};

inline constexpr CommandInfo kCommands[] = {
    {CommandKind::kPour, "pour", kPourNumbers, true, true, true, false,
     "adds material, at rest, for a while"},
    {CommandKind::kDig, "dig", kDigNumbers, false, false, false, false, "takes material away, for a while"},
    {CommandKind::kBlast, "blast", kBlastNumbers, false, false, false, false,
     "makes the erodible layer roll, at once"},
    {CommandKind::kSettle, "settle", kSettleNumbers, false, false, false, false,
     "makes the rolling layer lie, at once"},
    {CommandKind::kSet, "set", kSetNumbers, false, false, false, true,
     "gives a parameter of the physics another value"},
};

const CommandInfo& info_of(CommandKind kind);
std::optional<CommandInfo> command_from(std::string_view name);
std::string_view to_string(Layer layer);
std::string_view to_string(Profile profile);
std::string_view to_string(Part part);
std::optional<Layer> layer_from(std::string_view name);
std::optional<Profile> profile_from(std::string_view name);
std::optional<Part> part_from(std::string_view name);
std::optional<std::size_t> param_from(std::string_view name);  // index in kParams; none for a fixed one

// What is wrong with a command: a number out of range, a material that the world, where it is known, lacks,
// or a member that its kind does not use and that is not its default, to the bit: the state hash covers it.
std::optional<std::string> fault_of(const Command& command, bool has_lower = true);
// Does what a kSet says.
void set_number(Params& params, const Command& set);
// What would be wrong with the parameters once these commands have set theirs: thresholds must keep their
// order.
std::optional<std::string> fault_after(const Params& params, std::span<const Command> commands);
// Whether a tick has too many commands: those given in it, and those that run in it, the given ones included.
std::optional<std::string> fault_of_counts(std::size_t given, std::size_t running);
// How many ticks a command runs for, at least one.
std::int64_t ticks_of(const Command& command, float tick_s);

// Begins these commands at the state's tick and does this tick's share of all that run. Reads grid, site,
// tick; writes params, depth, rolling, velocity (material is added and eroded at rest), sources, ledger. A
// vertex whose layer has reached half of kDeepest takes no more, and what falls beside the grid or on no-data
// never enters the world: the ledger counts what did.
void apply_commands(State& state, std::span<const Command> commands);

}  // namespace sim
