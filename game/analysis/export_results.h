#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/analysis/gallery.h"
#include "game/analysis/summary.h"
#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"

namespace game {

// Names of the files that export_results() writes, with * for any characters.
inline const std::vector<std::string> kExportedNames{
    "deposit.*",       "peak_depth.*",     "peak_thickness.*", "peak_speed_slope.*", "peak_speed_plan.*",
    "peak_pressure.*", "lower_material.*", "extent.geojson",   "summary.json"};

// Writes an avalanche's results for a GIS. GeoTIFF and ESRI ASCII: deposit and peak depth (vertical m), peak thickness
// (m normal to the slope), peak speed along the slope and in plan, peak impact pressure (kPa) if densities are known, and,
// if there are two materials, how much of the lower one was moved. GeoJSON: the extent's outline. Also summary.json.
// Errors: a file cannot be written (status 3).
Outcome<void> export_results(const std::filesystem::path& folder, const Scenario& scenario,
                             const Session& session, const Summary& summary);

// Net deposit on the initial ground, m, grid.size() values; negative where eroded.
std::vector<float> deposit_of(const Scenario& scenario, const sim::State& state);

// Draws two maps with north up: map_extent shows everywhere
// the rolling layer has been, map_end the world now.
void draw_results(Gallery& gallery, const Session& session);

// The scenario's ground as a terrains::Terrain, used to place other files on it.
terrains::Terrain ground_of(const Scenario& scenario);

}  // namespace game
