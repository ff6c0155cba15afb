#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/grid.h"

// What stands on a mountain and acts on a flow, as the flow acts on it: forest, buildings, nets and sculpted earth.
// Rules with equations and sources: docs/things.md.
//
// A world has things only once there is one. Forest is a field. Earth raises or lowers bedrock, and so does a
// building that is at least two cells wide. The rest is a list of objects. From these the fields that the stages
// of a step read are derived; they are never a part of the state.

namespace sim {

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
    double turn = 0;                           // degrees clockwise from north, of its front
    double length = 0, width = 0, height = 0;  // m; length along the front's direction
    double strength = 0;                       // kPa
    std::int64_t group = 0;                    // the same for what one command placed; ascending

    // What became of it.
    std::int64_t load = 0;    // Pa, the greatest so far
    std::int64_t buried = 0;  // mm, the greatest depth so far of what came to lie on it
    bool operator==(const Thing&) const = default;

    double share() const { return static_cast<double>(load) / (1000 * strength); }  // of its strength
    bool damaged() const { return kind != ThingKind::kRoad && share() >= 0.5; }
    bool destroyed() const { return kind != ThingKind::kRoad && share() >= 1; }
    bool under() const { return kind != ThingKind::kRoad && buried >= 1000 * height; }  // nothing looks out
};

inline constexpr std::size_t kMostThings = 2000;  // pieces of nets and roads count one each

// Sizes and strengths of what is placed without them.
inline constexpr double kStationLength = 9, kStationWidth = 7, kStationHeight = 7, kStationStrength = 10;
inline constexpr double kPylonWidth = 1.2, kPylonHeight = 14,
                        kPylonStrength = 100;  // 50, twice for a narrow body
inline constexpr double kPylonsApart = 80;     // m, about

struct Things {
    explicit Things(const Grid& grid);

    // State.
    Field<float> earth;  // m that bedrock was raised by, whole quanta; negative: lowered
    Field<Stems> forest;
    std::vector<Thing> list;
    std::int64_t next_group = 0;
    std::int64_t budget = -1;  // of earth, quanta times cells; −1: no limit

    // Known from the state; see rebuild_things().
    Field<float> natural;    // m above datum, bedrock without earth and buildings
    Field<float> drag;       // A, 1/m: frontal area per volume of flow
    Field<float> detrain;    // K, Pa
    Field<float> hold;       // H, 0 to 1, of forest
    Field<float> net_depth;  // m, greatest depth of the standing layer that nets hold there; 0: no net
    // Rise of bedrock through a face, m, to the east and to the north, where it is a wall (momentum/walls.h); else 0.
    Field<float> wall_x, wall_y;
    struct Cells {
        std::uint32_t first = 0, count = 0;  // in `cells`
    };
    std::vector<Cells> cells_of;       // of each of `list`: the vertices whose flow loads it
    std::vector<std::int32_t> cells;   // vertex numbers, row by row from the south
    std::vector<std::int32_t> wooded;  // vertices with standing stems
    std::int64_t changed = 0;          // counts changes of earth, forest or list, and what was destroyed
    bool unhashed = true;              // changed since the hash of the fields was last found
    std::uint64_t hash = 0;            // of the fields
};

// Makes place for things, if there is none yet.
Things& things_of(State& state);

// Quanta times cells of earth that are in use: the larger of what was cut and what was filled.
std::int64_t earth_used(const Things& things, const Grid& grid);

// Whether a building is part of the bedrock on this grid: at least two cells wide, and it stands.
bool is_solid(const Thing& thing, const Grid& grid);

// Finds all that is known from the state of things: derived fields, bedrock, walls, and S₀ where bedrock has changed.
// Call after a change of the list, the forest or the earth.
void rebuild_things(State& state);

// A name for the user: "house", "net".
std::string_view to_string(ThingKind kind);

// Square metres of a forest per stem count and the like, as the stages take them (docs/things.md).
float drag_of(const Stems& stems);     // A, 1/m
float detrain_of(const Stems& stems);  // K, Pa
float hold_of(const Stems& stems);     // H, 0 to 1
// M, N m: the bending moment that breaks or uproots one stem.
double strength_of(const Stems& stems);

// The unit vector toward `degrees` clockwise from north; the same bits on every machine.
struct Direction {
    double x, y;
};
Direction direction_of(double degrees);

}  // namespace sim
