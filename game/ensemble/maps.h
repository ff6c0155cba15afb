#pragma once

#include <string>
#include <vector>

#include "game/ensemble/ensemble.h"
#include "render/pictures/picture.h"

namespace game {

// A field that an ensemble came to, to be written and drawn.
struct EnsembleMap {
    std::string name;           // "probability_pressure_over_10", of its files
    std::string title;          // "Probability of pressure of 10 kPa and more"
    std::vector<float> values;  // NaN where there is none
    enum class Kind : std::uint8_t {
        kProbability,
        kPeak,
        kArrival,
        kAreas,
        kPolygon
    } kind = Kind::kProbability;
    std::string_view unit;  // of the values
};
// One of each threshold and percentile of the spec.
std::vector<EnsembleMap> maps_of(const EnsembleSpec& spec, const EnsembleResult& result);

// The field over the relief, with a legend, what was varied, scale and north.
render::Picture picture_of(const EnsembleMap& map, const EnsembleSpec& spec, const EnsembleResult& result);

}  // namespace game
