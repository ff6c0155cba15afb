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

enum class CommandKind : std::uint8_t {
    kPour,
    kDig,
    kBlast,
    kSettle,
    kSet,
    // Of things (things.h).
    kSculpt,
    kSmooth,
    kLevel,
    kPlant,
    kFell,
    kHouse,
    kLift,
    kNet,
    kRoad,
    kTurn,
    kRemove,
    // Of the water in the soil (things.h).
    kWet,
    kDrain,
    // Of the weather (weather.h).
    kStorm,
    kWind,
    kTemperature,
    kCancel,
};
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
    double to_x = 0, to_y = 0;                            // where a line ends
    double rise = 0, level = 0;                           // of earth
    double stems = 0, diameter = 0;                       // of a forest
    double length = 0, width = 0, height = 0;             // of a building; height of trees and nets too
    double turn = 0, strength = 0;                        // of a building; strength of nets too
    double least_slope = kNoLeast, most_slope = kNoMost;  // of the ground; vertices outside are left alone
    double at = 0, hours = 0, event = 0;  // of weather: its first hour and how many; its number
    double precipitation = 0, wind_from = 0, wind_speed = 0, warmer = 0, cloud = 0;

    static constexpr double kNoLeast = 0, kNoMost = 90;  // degrees
    bool operator==(const Command&) const = default;
};

struct CommandNumber {
    std::string_view name, unit;
    double Command::*value;
    double least, most;
    std::string_view meaning;
    double usual = 0;    // where a table of things leaves it out and where a tool begins; 0: none
    bool whole = false;  // a whole number
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

inline constexpr double kHighestEarth = 30;   // m above or below natural ground
inline constexpr double kLongestLine = 5000;  // m, of a lift, a net or a road in one command
inline constexpr double kShortestLift = 60;   // m

inline constexpr CommandNumber kSculptNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is changed"},
    {"rise", "m", &Command::rise, -kHighestEarth, kHighestEarth,
     "height added to the ground, or taken if negative; flanks stay at most 1 : 1.25"},
};
inline constexpr CommandNumber kSmoothNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is changed"},
    {"rise", "m", &Command::rise, 0, kHighestEarth, "greatest change of height"},
};
inline constexpr CommandNumber kLevelNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is changed"},
    {"rise", "m", &Command::rise, 0, kHighestEarth, "greatest change of height"},
    {"level", "m", &Command::level, -2e4, 2e4,
     "height above the terrain's zero that the ground changes toward"},
};
inline constexpr CommandNumber kPlantNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is planted"},
    {"stems", "1/ha", &Command::stems, 1, 2000, "stems per hectare", 400},
    {"diameter", "m", &Command::diameter, 0.1, 0.6, "of a stem", 0.3},
    {"height", "m", &Command::height, 5, 35, "of a tree", 22},
};
inline constexpr CommandNumber kFellNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is felled"},
};
inline constexpr CommandNumber kHouseNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "middle, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "middle, north of the south-west vertex"},
    {"turn", "deg", &Command::turn, -360, 360, "direction of its front: 0 north, 90 east"},
    {"length", "m", &Command::length, 3, 200, "along its front's direction", 11},
    {"width", "m", &Command::width, 3, 200, "across it", 9},
    {"height", "m", &Command::height, 2, 30, "of its roof", 7.5},
    {"strength", "kPa", &Command::strength, 0.5, 1000,
     "load that destroys it: glass 1, wood 5, brick 10, concrete 30", 5},
};
inline constexpr CommandNumber kLiftNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "valley station, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "valley station, north of the south-west vertex"},
    {"to_x", "m", &Command::to_x, -kFarthest, kFarthest, "mountain station, east of the south-west vertex"},
    {"to_y", "m", &Command::to_y, -kFarthest, kFarthest, "mountain station, north of the south-west vertex"},
};
inline constexpr CommandNumber kNetNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "one end, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "one end, north of the south-west vertex"},
    {"to_x", "m", &Command::to_x, -kFarthest, kFarthest, "other end, east of the south-west vertex"},
    {"to_y", "m", &Command::to_y, -kFarthest, kFarthest, "other end, north of the south-west vertex"},
    {"height", "m", &Command::height, 2, 6, "of the nets", 3},
    {"strength", "kPa", &Command::strength, 0.5, 1000, "load that destroys a piece of one cell", 30},
};
inline constexpr CommandNumber kRoadNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "one end, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "one end, north of the south-west vertex"},
    {"to_x", "m", &Command::to_x, -kFarthest, kFarthest, "other end, east of the south-west vertex"},
    {"to_y", "m", &Command::to_y, -kFarthest, kFarthest, "other end, north of the south-west vertex"},
    {"width", "m", &Command::width, 2, 30, "of the road", 6},
};
inline constexpr CommandNumber kTurnNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "a place on the house, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "a place on the house, north of the south-west vertex"},
    {"turn", "deg", &Command::turn, -360, 360, "new direction of its front: 0 north, 90 east"},
};
inline constexpr CommandNumber kRemoveNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; all objects that reach into it go, a lift, net or road as it was placed"},
};
inline constexpr double kMostRain = 0.1;  // m/s of water
inline constexpr CommandNumber kWetNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is wetted"},
    {"rate", "m/s", &Command::rate, 0, kMostRain,
     "depth of water added per second; what the soil cannot take runs off"},
    {"duration", "s", &Command::duration, 0, 1e5, "rounded to whole ticks, at least one"},
};
inline constexpr CommandNumber kDrainNumbers[] = {
    {"x", "m", &Command::x, -kFarthest, kFarthest, "centre, east of the south-west vertex"},
    {"y", "m", &Command::y, -kFarthest, kFarthest, "centre, north of the south-west vertex"},
    {"radius", "m", &Command::radius, 0, 1e5,
     "radius of the disc; if below one cell, only the nearest vertex is drained"},
    {"rate", "m/s", &Command::rate, 0, kMostRain, "depth of water taken per second, as far as there is any"},
    {"duration", "s", &Command::duration, 0, 1e5, "rounded to whole ticks, at least one"},
};

inline constexpr double kMostStorm = 50;  // mm/h
inline constexpr CommandNumber kStormNumbers[] = {
    {"at", "h", &Command::at, 0, 8783, "first hour, of the calendar", 0, true},
    {"hours", "h", &Command::hours, 1, 8784, "how long it lasts", 0, true},
    {"precipitation", "mm", &Command::precipitation, 0, 1000,
     "water that falls in all, at the height of reference; at most 50 mm in an hour"},
    {"wind_from", "deg", &Command::wind_from, -360, 360, "where the wind comes from: 0 north, 90 east"},
    {"wind_speed", "m/s", &Command::wind_speed, 0, 60, "of the wind, high above the ground"},
    {"warmer", "K", &Command::warmer, -30, 30, "how much warmer it is than usual; colder if negative"},
};
inline constexpr CommandNumber kWindNumbers[] = {
    {"at", "h", &Command::at, 0, 8783, "first hour, of the calendar", 0, true},
    {"hours", "h", &Command::hours, 1, 8784, "how long it lasts", 0, true},
    {"wind_from", "deg", &Command::wind_from, -360, 360, "where the wind comes from: 0 north, 90 east"},
    {"wind_speed", "m/s", &Command::wind_speed, 0, 60, "of the wind, high above the ground"},
};
inline constexpr CommandNumber kTemperatureNumbers[] = {
    {"at", "h", &Command::at, 0, 8783, "first hour, of the calendar", 0, true},
    {"hours", "h", &Command::hours, 1, 8784, "how long it lasts", 0, true},
    {"warmer", "K", &Command::warmer, -30, 30, "how much warmer it is than usual; colder if negative"},
    {"cloud", "1", &Command::cloud, 0, 1, "share of the sky that clouds cover; usual are 0.2"},
};
inline constexpr CommandNumber kCancelNumbers[] = {
    {"event", "1", &Command::event, 1, 1000, "number of the storm, wind or temperature, as they were given",
     0, true},
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
    bool has_slope;  // "slope": [least, most], degrees, of the ground that it acts on; all, if it is left out
    std::string_view meaning;
};

inline constexpr CommandInfo kCommands[] = {
    {CommandKind::kPour, "pour", kPourNumbers, true, true, true, false, true,
     "adds material at rest for a duration"},
    {CommandKind::kDig, "dig", kDigNumbers, false, false, false, false, true,
     "removes material for a duration"},
    {CommandKind::kBlast, "blast", kBlastNumbers, false, false, false, false, true,
     "releases the erodible layer as rolling layer, at once"},
    {CommandKind::kSettle, "settle", kSettleNumbers, false, false, false, false, true,
     "deposits the rolling layer, at once"},
    {CommandKind::kSet, "set", kSetNumbers, false, false, false, true, false,
     "sets a parameter of the physics"},
    {CommandKind::kSculpt, "sculpt", kSculptNumbers, false, true, false, false, true,
     "raises or lowers bedrock within the budget of earth, at once"},
    {CommandKind::kSmooth, "smooth", kSmoothNumbers, false, false, false, false, true,
     "changes bedrock toward the mean of its neighbours, at once"},
    {CommandKind::kLevel, "level", kLevelNumbers, false, false, false, false, true,
     "changes bedrock toward a height, at once"},
    {CommandKind::kPlant, "plant", kPlantNumbers, false, false, false, false, true,
     "plants a forest, at once"},
    {CommandKind::kFell, "fell", kFellNumbers, false, false, false, false, true,
     "removes a forest with its broken trees, at once"},
    {CommandKind::kHouse, "house", kHouseNumbers, false, false, false, false, false, "builds a house"},
    {CommandKind::kLift, "lift", kLiftNumbers, false, false, false, false, false,
     "builds a chairlift with its pylons"},
    {CommandKind::kNet, "net", kNetNumbers, false, false, false, false, false, "builds a row of snow nets"},
    {CommandKind::kRoad, "road", kRoadNumbers, false, false, false, false, false,
     "builds a straight piece of road"},
    {CommandKind::kTurn, "turn", kTurnNumbers, false, false, false, false, false, "turns a house"},
    {CommandKind::kRemove, "remove", kRemoveNumbers, false, false, false, false, false,
     "removes houses, lifts, nets and roads"},
    {CommandKind::kWet, "wet", kWetNumbers, false, true, false, false, true,
     "adds water to the soil for a duration"},
    {CommandKind::kDrain, "drain", kDrainNumbers, false, true, false, false, true,
     "takes water from the soil for a duration"},
    {CommandKind::kStorm, "storm", kStormNumbers, false, false, false, false, false,
     "lets it snow, or rain where it is warm, in hours of the calendar"},
    {CommandKind::kWind, "wind", kWindNumbers, false, false, false, false, false,
     "lets a wind blow in hours of the calendar"},
    {CommandKind::kTemperature, "temperature", kTemperatureNumbers, false, false, false, false, false,
     "makes hours of the calendar warmer or colder"},
    {CommandKind::kCancel, "cancel", kCancelNumbers, false, false, false, false, false,
     "ends a storm, wind or temperature, or takes it back"},
};

const CommandInfo& info_of(CommandKind kind);
// What a number of a command usually is; 0 if there is nothing usual.
constexpr double usual_of(CommandKind kind, double Command::*value) {
    for (const CommandNumber& number : kCommands[static_cast<std::size_t>(kind)].numbers)
        if (number.value == value) return number.usual;
    return 0;
}
// A command whose numbers are the usual ones, at no place yet.
Command usual_command(CommandKind kind);
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
// site, tick; writes params, depth, rolling, velocity (material is added and eroded at rest), things, sources,
// ledger. A vertex whose layer has reached half of kDeepest receives no more. Material outside the grid or on
// no-data never enters the world. The ledger counts what does.
void apply_commands(State& state, std::span<const Command> commands);

}  // namespace sim
