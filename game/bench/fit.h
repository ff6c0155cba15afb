#pragma once

#include <optional>
#include <span>
#include <vector>

namespace game {

// cost ≈ constant · Π factor^exponent, by least squares of logarithms.
struct PowerLaw {
    std::vector<double> exponents;  // one for each factor
    double r2 = 0;                  // share of the logarithm's variance that it explains, 0 to 1
};
// `factors`: of each observation its value, as many as there are costs. Observations with a cost or a factor
// that is not above 0 are left out. Nothing where those left do not tell the exponents: too few, or factors
// that grow together.
std::optional<PowerLaw> fit_power_law(std::span<const double> costs,
                                      std::span<const std::vector<double>> factors);

}  // namespace game
