#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace game {

// How much of the variance of a number is due to what, 0 to 1, with one standard deviation of its error: an estimate may lie a
// little outside.
struct VarianceShare {
    double share = 0, error = 0;
};
struct VarianceShares {
    std::vector<VarianceShare> of;  // each variable by itself: Sobol's indices of first order
    VarianceShare together;         // what only several of them together explain
};

// Estimates these shares of `values`, one of each member, from the members that are there, whose `samples` have the value of
// each variable. A sum of polynomials of fifth degree, one of each variable, is fitted to the values by least squares (Sudret
// 2008, without products); the variance of a polynomial is the share of its variable. Errors by a jackknife that leaves out a
// sixteenth of the members at a time. Nothing if there are too few members for so many variables, or all have the same value.
std::optional<VarianceShares> variance_shares(const std::vector<std::vector<double>>& samples,
                                              const std::vector<double>& values);
std::size_t least_for_variance(std::size_t variables);  // members

}  // namespace game
