#pragma once

#include <span>
#include <string>

#include "game/bench/report.h"

namespace game {

// A report as one HTML page that needs nothing from elsewhere: no script, no file, no letter. `tables`: those
// of the report, and what else is to be told.
std::string page_of(const BenchReport& report, std::span<const Table> tables);

}  // namespace game
