#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "terrains/georeference.h"
#include "terrains/release.h"

namespace game {

// What an avalanche did, as people in the field put it. The extent is where the rolling layer was ever at
// least kExtentDepth deep.
struct Measures {
    static constexpr float kExtentDepth = 0.1f;  // m

    double extent_area = 0;                 // m², in plan
    double peak_depth = 0, peak_speed = 0;  // m, m/s
    double eroded = 0, deposited = 0;       // m³ by which the standing layer has been lowered and raised
    // From the highest vertex at which material was released or poured to the farthest of the extent,
    // straight.
    terrains::LocalPoint top, toe;
    double run_out = 0;    // m, in plan
    double fall = 0;       // m
    double reach_deg = 0;  // ° of that line below the horizon
    // With a reference only: intersection over union of its extent and this one, or of where the surface was
    // changed by kChanged at least.
    static constexpr float kChanged = 0.3f;  // m
    std::optional<double> overlap;

    // A change of the surface: how much was raised, and how far its middle lies from that of what was
    // lowered.
    struct Change {
        double raised = 0;              // m³
        terrains::LocalPoint from, to;  // centroids by volume
        double carried = 0;             // m, in plan
    };
    struct Changes {
        Change here, observed;
        double apart = 0;  // m, between the middles of what was raised
    };
    std::optional<Changes> changes;  // with a reference that is a change
};

// `released` is where material was set loose, as release_area() gives it.
Measures measure(const Scenario& scenario, const Session& session, const std::vector<std::uint8_t>& released,
                 const terrains::Reference& reference);

// 1 at each vertex of the start's release and under each command that adds or frees material.
std::vector<std::uint8_t> release_area(const Scenario& scenario, std::span<const TimedCommand> commands);

// Intersection over union of two areas, 1 where they are; nothing of nothing.
std::optional<double> overlap_of(const std::vector<std::uint8_t>& one,
                                 const std::vector<std::uint8_t>& other);

}  // namespace game
