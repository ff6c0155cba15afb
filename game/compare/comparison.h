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

// A recording and the name to show for it.
struct Named {
    std::string name;
    std::filesystem::path path;
    Recording recording;
};
// Reads a recording by a name that find_asset() knows, or by its path; its name is the file's, without
// extension. Warns on standard error if it was cut off or is of another version of the physics.
Outcome<Named> open_recording(const std::string& name_or_path, const Memory& memory);

// One of the recordings, played to the compared tick.
struct Played {
    const Named& of;
    Session session;
    Measures measures;
    bool at_rest = false;
};
// `recorder`: null, or records this run; it is closed.
Outcome<Played> played(const Named& of, const Until& until, const sim::StepOptions& options,
                       std::optional<Recorder> recorder);

// Two worlds on one ground. All differences are the second minus the first.
struct Comparison {
    const Played& a;
    const Played& b;
    std::vector<std::string> said = {};  // how their scenarios and commands differ
    std::vector<float> deposit = {};     // m, of the net deposit, grid.size()
    std::vector<float> peak_depth = {};  // m, of the rolling layer
    double more = 0, less = 0;           // m³ of deposit gained and lost
    std::optional<double> overlap = {};  // of both extents, intersection over union; none if nothing moved
    std::int64_t followed = 0;           // ticks played side by side, at most
    std::optional<Divergence> parted = {};
};
// Errors: they are not on one ground (status 2, with the differences).
Outcome<void> check_ground(const Named& a, const Named& b);
// Plays both again, side by side, until they part. Shows progress on standard error.
Comparison comparison_of(const Played& a, const Played& b, const sim::StepOptions& options);

std::string to_text(const Comparison& comparison);
Json to_json(const Comparison& comparison);

// Writes difference.tif and peak_difference.tif, float32 in metres; difference.png and peak_difference.png;
// if the runs part, desync.png. Errors: a file cannot be written (status 3).
Outcome<void> write_maps(const std::filesystem::path& folder, const Comparison& comparison);

// Writes the maps if requested, and prints the comparison. Errors: status 3.
Outcome<void> tell(const Comparison& comparison, const std::optional<std::filesystem::path>& maps, bool json);

}  // namespace game
