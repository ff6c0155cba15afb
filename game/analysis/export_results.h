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

// Names of what export_results() writes, with * for any characters.
inline const std::vector<std::string> kExportedNames{"deposit.*",        "peak_depth.*",   "peak_speed.*",
                                                     "lower_material.*", "extent.geojson", "summary.json"};

// What an avalanche left, for a GIS: deposit, peak depth and peak speed, in a world of two materials how much
// of the lower one was moved, as GeoTIFF and ESRI ASCII, the extent's outline as GeoJSON, and summary.json.
// Errors: a file cannot be written (status 3).
Outcome<void> export_results(const std::filesystem::path& folder, const Scenario& scenario,
                             const Session& session, const Summary& summary);

// What has come to lie on the first ground, m, grid.size() values; negative where it was eroded.
std::vector<float> deposit_of(const Scenario& scenario, const sim::State& state);

// Two maps with north up: map_extent shows all that the rolling layer ever covered, map_end the world as it
// is.
void draw_results(Gallery& gallery, const Session& session);

// The start's ground as terrains knows it, to place other files on it.
terrains::Terrain ground_of(const Scenario& scenario);

}  // namespace game
