#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace sim::verification {

// How a case came out on grids of growing fineness: a line of the table.
struct Series {
    std::string_view scheme;       // "muscl"
    std::string_view measure;      // "R, L1": what is compared, relative unless it says otherwise
    double most = 0;               // bound of the error on the finest grid
    double least_order = 0;        // bound of the order between the last two grids; 0: none is asked for
    std::vector<int> squares{};    // along a side
    std::vector<double> errors{};  // on each

    double order() const;  // log(e₁/e₂) / log(n₂/n₁) of the last two; 0 for a single grid
    bool holds() const;    // a NaN does not
};

// One problem with a known answer. Runs in double without quanta, through the same stages as a world
// (layers.h), or in the world's own float where the answer is about bits.
struct Case {
    std::string_view name;
    std::string_view answer;  // the exact answer, or what must hold
    std::vector<Series> (*run)();
};

// All of them, in the order of the table in which `couloir verify-physics` prints them.
std::span<const Case> cases();

}  // namespace sim::verification
