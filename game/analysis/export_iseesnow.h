#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "game/analysis/summary.h"
#include "game/base/outcome.h"

namespace game {

// Names of the files that export_iseesnow() writes, with * for any characters.
inline const std::vector<std::string> kIseesnowNames{"*_null_couloir_pft.asc", "*_null_couloir_pfv.asc",
                                                     "*_null_couloir_ppr.asc", "*_null_couloir.txt",
                                                     "simulationResultTable.csv"};

// The first two parts of ISeeSnow's file names, "releaseName_simulationID", from the names of two files. Parts
// lose their underscores, because these separate the parts.
std::string iseesnow_name(const std::filesystem::path& release, const std::filesystem::path& terrain);
// Whether it is two parts of letters, digits, '-' and '.', separated by one underscore.
bool is_iseesnow_name(std::string_view name);

// Writes a run as ISeeSnow's participants submit it (github.com/avaframe/ISeeSnow), one pixel per vertex:
//   NAME_null_couloir_pft.asc   peak flow thickness, m, normal to the slope of the first ground
//   NAME_null_couloir_pfv.asc   peak flow velocity, m/s, along the slope, where the flow was 1 cm deep or more
//   NAME_null_couloir_ppr.asc   peak pressure, kPa; only if the density is known
//   NAME_null_couloir.txt       model, parameters, numerics, input and result, for Python's configparser
//   simulationResultTable.csv   one line: time of computation and of the flow, volumes, cell
// No data is nan. `release`: the file that was released. Errors: a file cannot be written (status 3).
Outcome<void> export_iseesnow(const std::filesystem::path& folder, const std::string& name,
                              const std::filesystem::path& release, const Summary& summary);

}  // namespace game
