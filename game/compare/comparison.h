#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/analysis/headless.h"
#include "game/analysis/measures.h"
#include "game/base/outcome.h"
#include "game/recording/divergence.h"
#include "game/recording/reader.h"
#include "game/scene/memory.h"
#include "game/session/session.h"

namespace game {

// Names of the maps that tell() writes.
inline const std::vector<std::string> kMapNames{"difference.tif", "peak_difference.tif", "difference.png",
                                                "peak_difference.png", "desync.png"};

// A recording, and what to call it.
struct Named {
    std::string name;
    std::filesystem::path path;
    Recording recording;
};
// Reads what find_asset() knows under this name, or a file; its name is the file's, without extension. Says
// on standard error what is to be said of it: where it was cut off, that it is of another version of the
// physics.
Outcome<Named> open_recording(const std::string& name_or_path, const Memory& memory);

// One of them, played to where both are compared.
struct Played {
    const Named& of;
    Session session;
    Measures measures;
    bool at_rest = false;
};
// `recorder`: none, or where this run is recorded; it is closed.
Outcome<Played> played(const Named& of, const Until& until, const sim::StepOptions& options,
                       std::optional<Recorder> recorder);

// Two worlds on one ground. All differences are the second less the first.
struct Comparison {
    const Played& a;
    const Played& b;
    std::vector<std::string> said = {};  // what was told them differently: starts, commands
    std::vector<float> deposit = {};     // m, of what has come to lie, grid.size()
    std::vector<float> peak_depth = {};  // m, of the rolling layer
    double more = 0, less = 0;           // m³ of deposit where there is more, and where less
    std::optional<double> overlap = {};  // of both extents, intersection over union; none where nothing moved
    std::int64_t followed = 0;           // ticks that were gone through side by side, at most
    std::optional<Divergence> parted = {};
};
// Errors: they are not on one ground (status 2, says what differs).
Outcome<void> check_ground(const Named& a, const Named& b);
// Plays both once more, side by side, until they part. Shows that on standard error as it goes on.
Comparison comparison_of(const Played& a, const Played& b, const sim::StepOptions& options);

std::string to_text(const Comparison& comparison);
Json to_json(const Comparison& comparison);

// difference.tif and peak_difference.tif, float32 in metres; difference.png and peak_difference.png; where
// they part, desync.png. Errors: a file cannot be written (status 3).
Outcome<void> write_maps(const std::filesystem::path& folder, const Comparison& comparison);

// Writes the maps where somebody wants them, and prints the comparison. Errors: status 3.
Outcome<void> tell(const Comparison& comparison, const std::optional<std::filesystem::path>& maps, bool json);

}  // namespace game
