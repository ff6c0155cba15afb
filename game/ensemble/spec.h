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

// A probability to map: that of a peak at a place being at least so much.
struct Threshold {
    enum class Of : std::uint8_t {
        kThickness,
        kSpeed,
        kPressure
    };  // m normal to the slope, m/s along it, kPa
    Of of = Of::kThickness;
    double least = 0;

    std::string_view name() const;  // "thickness"
    std::string_view unit() const;  // "m"
    bool operator==(const Threshold&) const = default;
};

// Many runs of one world with other numbers, as docs/ensembles.md describes them.
struct EnsembleSpec {
    static constexpr std::int64_t kMostMembers = 100'000;
    static constexpr std::size_t kMostThresholds = 16;

    std::filesystem::path file;
    std::string title;
    std::int64_t members = 0;  // numbered from 1
    std::int64_t seed = 1;
    double seconds = 3600;  // of the world, after which a member ends at the latest
    std::vector<Variable> variables;
    std::vector<Threshold> thresholds;
    Scene scene;  // of a member whose numbers are those of the files
    // Identifies all of this but the number of members, and the ground: 16 hexadecimal digits.
    std::string identity;

    // The values of a member's variables. They follow from the seed and its number alone.
    std::vector<double> sample(std::int64_t member) const;
    // The world of a member. Errors: its parameters do not go together, or its release is too thick.
    Outcome<Scenario> scenario_of(const std::vector<double>& sample) const;
};

// Errors: those of load_scene() and scene_of_terrain(); damage, with file and line.
Outcome<EnsembleSpec> read_ensemble_spec(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace game
