#pragma once

#include <optional>
#include <span>
#include <vector>

namespace game {

// A power law: cost ≈ constant · Π factor^exponent, by least squares of logarithms.
struct PowerLaw {
    std::vector<double> exponents;  // one per factor
    double r2 = 0;                  // share of the logarithm's variance that the law explains, 0 to 1
};
// `factors`: of each factor, one value per observation. Observations with a
// cost or a factor that is not above 0 are skipped. Returns nothing if the
// rest do not determine the exponents: too few, or factors that grow together.
std::optional<PowerLaw> fit_power_law(std::span<const double> costs,
                                      std::span<const std::vector<double>> factors);

}  // namespace game
