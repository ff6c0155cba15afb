#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace sim::verification {

// The errors of a case on successively finer grids: one line of the table.
struct Series {
    std::string_view scheme;       // "muscl"
    std::string_view measure;      // "R, L1": the quantity compared, relative unless stated otherwise
    double most = 0;               // largest error allowed on the finest grid
    double least_order = 0;        // least order allowed between the last two grids; 0: unchecked
    std::vector<int> squares{};    // along a side
    std::vector<double> errors{};  // on each

    double order() const;  // log(e₁/e₂) / log(n₂/n₁) of the last two; 0 for a single grid
    bool holds() const;    // false for a NaN
};

// A problem with a known answer. It runs in double without quantisation, through the same stages as a world
// (layers.h). If the answer is about bits, it runs in the world's own float.
struct Case {
    std::string_view name;
    std::string_view answer;  // the exact answer, or the condition that must hold
    std::vector<Series> (*run)();
};

// All cases, in the order in which `couloir verify-physics` prints them.
std::span<const Case> cases();

}  // namespace sim::verification
