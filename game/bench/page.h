#pragma once

#include <span>
#include <string>

#include "game/bench/report.h"

namespace game {

// A report as one self-contained HTML page: no scripts, files
// or fonts. `tables`: the report's, and any others to show.
std::string page_of(const BenchReport& report, std::span<const Table> tables);

}  // namespace game
