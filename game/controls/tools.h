#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "game/controls/events.h"
#include "sim/world/command.h"
#include "sim/world/state.h"

namespace game {

struct Scenario;

// What the left button can do to the world. A new tool is a name here and a row in tools.cpp; its button, key,
// help, hint, sliders, ring and commands follow from them.
enum class Tool : std::uint8_t {
    kPour,
    kDig,
    kBlast,
    kSculpt,
    kSmooth,
    kLevel,
    kWater,
    kDrain,
    kPlant,
    kHouse,
    kNet,
    kRoad,
    kLift,
};
inline constexpr std::size_t kTools = static_cast<std::size_t>(Tool::kLift) + 1;

enum class ToolGroup : std::uint8_t { kSnow, kGround, kThings };

// When a stroke gives commands.
enum class Acts : std::uint8_t {
    kAllTheTime,  // in every tick, along the path
    kByDistance,  // at the press, and again after each radius of movement
    kAtPress,     // once
    kAndTurns,    // once; dragging turns what was placed
    kByPieces,    // a line that follows the path, in straight pieces
    kAtRelease,   // a straight line from press to release
};

// How the first number of a tool gets into a command.
enum class Amount : std::uint8_t {
    kAsItIs,
    kPerSecond,        // depth; shared by the discs of a tick
    kVolumePerSecond,  // the same times the area of the disc
    kPerTick,          // the share of a tick, shared by its discs
    kTakenPerTick,     // the same, negative
};

// A part of an icon, in a square from −1 to 1 with y down.
struct IconPart {
    enum class Shape : std::uint8_t { kLine, kTriangle, kBox, kDot, kRing, kRays };
    Shape shape;
    // Line and box: two points. Triangle: three. Dot and ring: centre, radius. Rays: from and to, as distances from
    // the middle, and their number.
    std::array<float, 6> numbers;
};

// One thing that a tool does.
struct Deed {
    sim::CommandKind kind;  // of its commands; info_of() says which members they take
    const char* label;      // of its button: "Pour"
    const char* purpose;    // "Hold the left button on the terrain to …"
    Acts acts;
    Amount amount;
    glm::vec3 ring;  // linear light, 0 to 1
    std::span<const IconPart> icon;
};

// A number of a tool. The first one is its strength.
struct ToolNumber {
    const char* label;
    const char* format;  // printf, with name and unit
    const char* tooltip;
    double sim::Command::*member;
    double least, most, usual;
    double scale = 1;  // of what is shown: 1000 for mm of a number in m
};
inline constexpr std::size_t kMostToolNumbers = 4;

struct ToolInfo {
    Tool tool;
    ToolGroup group;
    Key key;
    const char* tooltip;
    // Alone, with Ctrl and with Shift.
    const Deed *plain, *control, *shift;
    std::span<const ToolNumber> numbers;  // at most kMostToolNumbers
};

std::span<const ToolInfo> tool_infos();  // in the order of Tool, kTools of them
const ToolInfo& info_of(Tool tool);
// What a tool does while these modifiers are held.
const Deed& deed_of(Tool tool, Modifiers with = {});

// Whether a person has a tool in this world: a challenge must have it, and water must act there.
bool is_offered(const ToolInfo& info, const Scenario& scenario, const sim::State& state);
// Whether commands of this kind take a member.
bool takes(sim::CommandKind kind, double sim::Command::*member);

}  // namespace game
