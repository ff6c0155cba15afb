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
enum class Part : std::uint8_t { kUpper, kLower };   // which of the two materials (mixture.h)
enum class Profile : std::uint8_t { kDisc, kCone };  // uniform depth within the radius; highest in the centre

// One action of the user on the world, in world units. kCommands lists the members that each kind uses; the
// others keep their defaults. Nothing else changes a world.
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

// Each running command may visit the whole grid in every tick. A brush stroke issues up to 16 per tick.
inline constexpr std::size_t kMostCommandsPerTick = 256;
inline constexpr std::size_t kMostRunningCommands = 1024;  // at the same time

inline constexpr CommandNumber kPourNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, the nearest vertex receives all"},
    {"rate", "m3/s", &Command::rate, 0, 1e8, "volume added per second"},
    {"duration", "s", &Command::duration, 0, 1e5, "rounded to whole ticks, at least one"},
};
inline constexpr CommandNumber kDigNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is dug"},
    {"rate", "m/s", &Command::rate, 0, 100, "depth removed per second: rolling layer first, never bedrock"},
    {"duration", "s", &Command::duration, 0, 1e5, "rounded to whole ticks, at least one"},
};
inline constexpr CommandNumber kBlastNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is released"},
    {"depth", "m", &Command::depth, 0, 100, "greatest erodible depth that becomes rolling layer"},
};

inline constexpr CommandNumber kSettleNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex settles"},
};
inline constexpr CommandNumber kSetNumbers[] = {
    {"value", "the parameter's", &Command::value, -1e6, 1e6,
     "new value; must also be within the parameter's own range"},
};

// The manifest that generates the readers and writers of recordings and scenes, and their tests.
struct CommandInfo {
    CommandKind kind;
    std::string_view name;
    std::span<const CommandNumber> numbers;
    bool has_layer;    // "as": "rolling" or "standing"
    bool has_profile;  // "profile": "disc" or "cone"
    bool has_part;     // "of": "upper", or "lower" in a world with two materials
    bool has_param;    // "param": name in kParams of one that is not fixed
    std::string_view meaning;
};

inline constexpr CommandInfo kCommands[] = {
    {CommandKind::kPour, "pour", kPourNumbers, true, true, true, false,
     "adds material at rest for a duration"},
    {CommandKind::kDig, "dig", kDigNumbers, false, false, false, false, "removes material for a duration"},
    {CommandKind::kBlast, "blast", kBlastNumbers, false, false, false, false,
     "releases the erodible layer as rolling layer, at once"},
    {CommandKind::kSettle, "settle", kSettleNumbers, false, false, false, false,
     "deposits the rolling layer, at once"},
    {CommandKind::kSet, "set", kSetNumbers, false, false, false, true, "sets a parameter of the physics"},
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

// What is wrong with a command: a number out of range, a material that the world lacks, or a member that its
// kind does not use and that is not bit-identical to its default (the state hash covers it).
std::optional<std::string> fault_of(const Command& command, bool has_lower = true);
// Applies a kSet command.
void set_number(Params& params, const Command& set);
// What would be wrong with the parameters after these commands: the thresholds must keep their order.
std::optional<std::string> fault_after(const Params& params, std::span<const Command> commands);
// Whether a tick has too many commands. `running` includes those given in this tick.
std::optional<std::string> fault_of_counts(std::size_t given, std::size_t running);
// Number of ticks for which a command runs, at least one.
std::int64_t ticks_of(const Command& command, float tick_s);

// Starts these commands at the state's tick and applies this tick's share of all running ones. Reads grid,
// site, tick; writes params, depth, rolling, velocity (material is added and eroded at rest), sources,
// ledger. A vertex whose layer has reached half of kDeepest receives no more. Material outside the grid or on
// no-data never enters the world. The ledger counts what does.
void apply_commands(State& state, std::span<const Command> commands);

}  // namespace sim
