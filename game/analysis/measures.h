#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "terrains/georeference.h"
#include "terrains/release.h"

namespace game {

// Of a vertex, in values of a whole grid, row by row from the south.
std::size_t index_of(const sim::Grid& grid, int x, int y);

// An avalanche's measures, in the field's terms. The extent is the area where the rolling layer was ever at least
// kExtentDepth deep. Scores are made of them, so no function of a mathematics library may differ in them: arithmetic and
// square roots alone.
struct Measures {
    static constexpr float kExtentDepth = 0.1f;  // m

    double extent_area = 0;                            // m², in plan
    double peak_depth = 0;                             // m, vertical
    double peak_thickness = 0;                         // m, normal to the slope: see peak_thickness_of()
    double peak_speed_slope = 0, peak_speed_plan = 0;  // m/s, along the slope and in plan
    std::optional<double> peak_pressure;               // kPa; nothing if a density is unknown
    double eroded = 0, deposited = 0;  // m³ by which the standing layer was lowered and raised
    // Depth, and what a flow erodes, depend on the grid where it is less than kLeastWidth wide.
    static constexpr int kLeastWidth = 4;  // cells
    bool narrow_release = false;           // nowhere in the release area such a square fits
    bool narrow_flow = false;  // nor around the deepest place of the flow, where it was half as deep
    // Along a straight line from the highest vertex at which material
    // was released or added, or of the extent if none was, to the farthest vertex of the extent.
    terrains::LocalPoint top, toe;
    double run_out = 0;    // m, in plan
    double fall = 0;       // m
    double reach_deg = 0;  // ° of that line below the horizon
    // With a reference only: intersection over union of its extent and this one, or of the areas where the
    // surface changed by at least kChanged.
    static constexpr float kChanged = 0.3f;  // m
    std::optional<double> overlap;

    // A change of the surface: the volume raised, and the distance
    // from the middle of the lowered volume to that of the raised one.
    struct Change {
        double raised = 0;              // m³
        terrains::LocalPoint from, to;  // centroids by volume
        double carried = 0;             // m, in plan
    };
    struct Changes {
        Change here, observed;
        double apart = 0;  // m, between the middles of the raised volumes
    };
    std::optional<Changes> changes;  // if the reference is a change of the surface
};

// `released`: the area from release_area().
Measures measure(const Scenario& scenario, const Session& session, const std::vector<std::uint8_t>& released,
                 const terrains::Reference& reference);

// The greatest thickness of the rolling layer at each vertex so far, m, normal to the slope of the ground as it was at
// tick 0: the unit of AvaFrame, RAMMS and ISeeSnow.
std::vector<float> peak_thickness_of(const Scenario& scenario, const Peaks& peaks);

// 1 at each vertex of the scenario's release and under each command that adds or releases material. A command that
// chooses slopes is taken on those of tick 0.
std::vector<std::uint8_t> release_area(const Scenario& scenario, std::span<const TimedCommand> commands);

// Intersection over union of two areas, given as 1 inside; no value if both are empty.
std::optional<double> overlap_of(const std::vector<std::uint8_t>& one,
                                 const std::vector<std::uint8_t>& other);

}  // namespace game
