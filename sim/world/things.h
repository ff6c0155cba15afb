#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/grid.h"

// What stands on a mountain and acts on a flow, as the flow acts on it: forest, buildings, nets and sculpted earth;
// and the water in the soil.
// Rules with equations and sources: docs/things.md.
//
// A world has things only once there is one. Forest and water are fields. Earth raises or lowers bedrock, and so does a
// building that is at least two cells wide. The rest is a list of objects. From these the other fields that the stages
// of a step read are derived; they are never a part of the state.

namespace sim {

struct Command;
struct State;

// Stems of a forest at a vertex. All 0: there is none.
struct Stems {
    std::uint16_t standing = 0;    // per hectare, 0 to kMostStems
    std::uint16_t lying = 0;       // broken by a flow, per hectare
    std::uint8_t diameter_cm = 0;  // of both
    std::uint8_t height_m = 0;     // of both
    bool operator==(const Stems&) const = default;
};
inline constexpr int kMostStems = 2000;  // per hectare
// Where there are any: from dwarf pine to the tallest trees.
inline constexpr int kLeastStemCm = 10, kMostStemCm = 60, kLeastTreeM = 1, kMostTreeM = 35;

enum class ThingKind : std::uint8_t {
    kHouse,
    kStation,  // of a lift, at either end
    kPylon,    // of a lift
    kNet,      // a piece of a row of snow nets, at most a cell long
    kRoad,     // a straight piece of road
};
inline constexpr std::size_t kThingKinds = 5;

// An object. Places are metres from vertex (0, 0).
struct Thing {
    ThingKind kind = ThingKind::kHouse;
    double x = 0, y = 0;                       // its middle; of a net or a road one end
    double to_x = 0, to_y = 0;                 // the other end of a net or a road
    double front_x = 0, front_y = 1;           // unit vector along its length, out of its front
    double length = 0, width = 0, height = 0;  // m; length along the front's direction
    double strength = 0;                       // kPa
    std::int64_t group = 0;                    // the same for what one command built; ascending in the list

    // What became of it.
    std::int64_t load = 0;    // Pa, the greatest so far
    std::int64_t buried = 0;  // mm, the greatest depth so far of what came to lie on it
    bool operator==(const Thing&) const = default;

    // A net or a road: drawn from one end to the other, not a rectangle on the ground.
    bool is_line() const { return kind == ThingKind::kNet || kind == ThingKind::kRoad; }
    double share() const { return static_cast<double>(load) / (1000 * strength); }  // of its strength
    bool damaged() const { return kind != ThingKind::kRoad && share() >= 0.5; }
    bool destroyed() const { return kind != ThingKind::kRoad && share() >= 1; }
    double turn() const;  // degrees clockwise from north, of its front; for views
    bool under() const { return kind != ThingKind::kRoad && buried >= 1000 * height; }  // nothing looks out
};

inline constexpr std::size_t kMostThings = 2000;  // pieces of nets and roads count one each

// Sizes and strengths of what is placed without them.
inline constexpr double kStationLength = 9, kStationWidth = 7, kStationHeight = 7, kStationStrength = 10;
inline constexpr double kPylonWidth = 1.2, kPylonHeight = 14,
                        kPylonStrength = 100;  // 50, twice for a narrow body
inline constexpr double kPylonsApart = 80;     // m, about

// A vertex whose flow loads an object: in any direction, or only toward a wall of it.
struct LoadedVertex {
    std::int32_t vertex;     // its number, row by row from the south
    std::int8_t to_x, to_y;  // 0, 0: any direction
};

// Water in the soil is m, the share of the standing layer's depth that is saturated, 0 to 1. It changes only by commands,
// in whole quanta, so that slow rain loses nothing to rounding.
inline constexpr float kWaterQuantum = 0x1p-24f;
// n, the share of soil that is pores, which water fills: the beds of Iverson et al. (2011) hold about .4.
inline constexpr double kPorosity = 0.4;

// Vertices, x1 and y1 included. None if x1 < x0.
struct VertexBox {
    int x0 = 0, x1 = -1, y0 = 0, y1 = -1;
    bool empty() const { return x1 < x0; }
    void add(int x, int y);
};

// Earth that is filled and cut, quanta times cells.
struct EarthMoved {
    std::int64_t filled = 0, cut = 0;
    std::int64_t used() const { return std::max(filled, cut); }
    void add(std::int64_t quanta, std::int64_t times = 1) {
        (quanta > 0 ? filled : cut) += times * std::abs(quanta);
    }
};
EarthMoved moved_in(const Field<float>& earth);

struct Things {
    explicit Things(const Grid& grid);

    // State.
    Field<float> earth;  // m that bedrock was raised by, whole quanta; negative: lowered
    Field<Stems> forest;
    Field<float> water;  // m, 0 to 1: share of the standing layer that is saturated
    std::vector<Thing> list;
    std::int64_t budget = -1;  // of earth, quanta times cells; −1: no limit. A constant of the world.

    // Constants of the world: bedrock (m above datum) and S₀ without earth and buildings.
    Field<float> natural, natural_slope;
    Field<float> no_floor;  // one row of zeros: of a world without weather a flow may erode all

    // Known from the state; see rebuild_objects() and renew_ground().
    Field<float> built;       // m of bedrock that is a building, or its rubble
    Field<float> built_drag;  // 1/m, of objects
    Field<float> drag;        // A, 1/m: frontal area per volume of flow, of objects and stems
    Field<float> detrain;     // K, Pa
    Field<float> hold;        // H, 0 to 1, of forest
    Field<float> net_depth;   // m, greatest depth of the standing layer that nets hold there; 0: no net
    // Rise of bedrock through a face to the west, or the south, of its vertex, m, where it is a wall
    // (momentum/walls.h); else 0.
    Field<float> wall_x, wall_y;
    struct Range {
        std::uint32_t first = 0, count = 0;
    };
    std::vector<Range> loaded_of;  // of each of `list`, in `loaded`
    std::vector<LoadedVertex> loaded;
    std::vector<std::int32_t> wooded;  // where stems stand, or stood until they broke; ascending
    EarthMoved earth_moved;            // of all of `earth`
    VertexBox stale;                   // where bedrock has changed since renew_ground()
    // Counts changes of earth, forest or list, and what was destroyed; not changes of water.
    std::int64_t changed = 0;
    bool unhashed = true;               // changed since the hash of the fields was last found
    std::optional<std::uint64_t> hash;  // of the fields; none if empty()

    // No vertex holds water.
    bool dry() const;
    // Nothing stands, nothing was sculpted and all is dry: the world is as one without things.
    bool empty() const;
};

// Makes place for things, if there is none yet.
Things& things_of(State& state);

// Quanta times cells of earth that are in use: the larger of what was cut and what was filled.
inline std::int64_t earth_used(const Things& things) {
    return things.earth_moved.used();
}

// Whether a building is part of the bedrock on this grid: at least two cells wide.
bool is_solid(const Thing& thing, const Grid& grid);

// Its vertices: those on its footprint, or the one that is nearest to its middle.
std::vector<std::int32_t> footprint_of(const Thing& thing, const Grid& grid);

// The shortest distance of a place from the line or the rectangle of an object, m, in plan; 0 on it.
double distance_from(const Thing& thing, double x, double y);

// Finds what is known from the list, and bedrock with it. Call after a change of the list, or if something was destroyed.
void rebuild_objects(State& state);
// Finds what is known from the forest at a vertex, and `wooded`.
void rebuild_forest(State& state, int x, int y);
void rebuild_wooded(Things& things);
// Sets bedrock of a vertex to natural ground, earth and building.
void set_bedrock(State& state, int x, int y);

// Finds the walls at the faces of these vertices.
void find_walls(State& state, const VertexBox& box);

// What a command does to things. Every vertex of a disc that is bare of flow takes part.
void sculpt(State& state, const Command& command);  // kSculpt, kSmooth, kLevel
void plant(State& state, const Command& command);   // kPlant, kFell; rebuild_wooded() after the last
void build(State& state,
           const Command& command);  // kHouse, kLift, kNet, kRoad; rebuild_objects() after the last
void rearrange(State& state, const Command& command);  // kTurn, kRemove

// What is wrong with the commands of things in this state, such as "the house at (10, 20) stands on house 1"; nothing if
// each can be done, one after another. `command`: the first that cannot.
struct ThingFault {
    std::size_t command = 0;
    std::string fact;
};
std::optional<ThingFault> fault_of_things(const State& state, std::span<const Command> commands);

std::string_view to_string(ThingKind kind);  // "house"

// What a forest does, as the stages take it (docs/things.md).
float drag_of(const Stems& stems);     // A, 1/m
float detrain_of(const Stems& stems);  // K, Pa
float hold_of(const Stems& stems);     // H, 0 to 1
// What forest and nets hold of a standing layer of this depth, m: 0 nothing to 1 all.
float held_share(const Things& things, int x, int y, float depth);
double moment_of(const Stems& stems);  // M, N m: the bending moment that breaks or uproots a stem

}  // namespace sim
