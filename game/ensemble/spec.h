#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/base/outcome.h"
#include "game/ensemble/distribution.h"
#include "game/scene/scene.h"

namespace game {

// A number that differs from member to member.
struct Variable {
    enum class Of : std::uint8_t {
        kParameter,  // of the (upper) material
        kRelease,    // thickness of the release, as a multiple of its file's
        kDensity,    // of the (upper) material, kg/m³, for pressures
    };
    Of of = Of::kParameter;
    const sim::ParamInfo* param = nullptr;  // of kParameter
    Distribution distribution;

    std::string_view name() const;  // "friction", "release", "density"
    std::string_view unit() const;  // "m/s2", "1"
};

// What a member does to a place, and is mapped.
enum class Mapped : std::uint8_t {
    kThickness,  // m normal to the slope, the greatest
    kSpeed,      // m/s along the slope, the greatest
    kPressure,   // kPa, the greatest
    kArrival,    // s after which the flow was first visible
};
struct MappedInfo {
    Mapped of;
    std::string_view name, unit;  // "thickness", "m"
    double most;                  // of a threshold
};
const MappedInfo& info_of(Mapped mapped);

// A probability to map: that of a peak at a place being at least so much.
struct Threshold {
    Mapped of = Mapped::kThickness;  // not kArrival
    double least = 0;
    bool operator==(const Threshold&) const = default;
};

// A value to map: what this share of all members does not exceed.
struct Percentile {
    Mapped of = Mapped::kThickness;
    double share = 50;  // %, above 0 and below 100
    bool operator==(const Percentile&) const = default;
};

struct Maps {
    static constexpr std::size_t kMostThresholds = 16, kMostPercentiles = 16;
    std::vector<Threshold> thresholds;
    std::vector<Percentile> percentiles;
    // By which the member that was hardest to a place is found: of members that release different polygons.
    std::optional<Mapped> hardest = std::nullopt;

    // The quantities that have percentiles, each once.
    std::vector<Mapped> spread() const;
};

// Many runs of one world with other numbers, as docs/ensembles.md describes them.
struct EnsembleSpec {
    static constexpr std::int64_t kMostMembers = 100'000;

    std::filesystem::path file;
    std::string title;
    std::int64_t members = 0;  // numbered from 1
    std::int64_t seed = 1;
    double seconds = 3600;  // of the world, after which a member ends at the latest
    std::vector<Variable> variables;
    Maps maps;
    Scene scene;  // of a member whose numbers are those of the files
    // Identifies all of this and the ground, but not the number of members, nor which percentiles of a quantity are
    // mapped: 16 hexadecimal digits.
    std::string identity;

    // The values of a member's variables. They follow from the seed and its number alone.
    std::vector<double> sample(std::int64_t member) const;
    // The polygon of the release that a member releases, from 1, if each releases one in turn.
    std::optional<std::size_t> patch_of(std::int64_t member) const;
    // The world of a member. Errors: its parameters do not go together, or its release is too thick or beside the ground.
    Outcome<Scenario> scenario_of(std::int64_t member) const;
};

// Errors: those of load_scene() and scene_of_terrain(); damage, with file and line.
Outcome<EnsembleSpec> read_ensemble_spec(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace game
