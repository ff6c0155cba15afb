#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sim/core/workers.h"
#include "sim/scratch.h"
#include "sim/verification/cases.h"
#include "sim/world/layers.h"
#include "sim/world/params.h"

namespace sim::verification {

using Function = std::function<double(double x, double y)>;  // of a place in m

// Numbers under which nothing but the equations acts: no freezing, no start, open borders.
Params bare_params(Model model, Scheme scheme);

// Layers in double on a grid, set from functions of the place, and time for them.
struct Trial {
    Params params;
    Layers<double> layers;
    Scratch<double> scratch;
    Workers workers{1};

    struct Begin {
        Function bedrock, depth, rolling;                       // m
        Function has_data = [](double, double) { return 1.; };  // 0 where there is none
    };
    Trial(const Grid& grid, const Params& with, const Begin& begin);

    // Adds what comes from without in a time dt about t, s.
    using Source = std::function<void(double t, double dt)>;

    // To `seconds`, in sub-steps all alike. A source acts half of a sub-step before it and half after it,
    // which is of second order (Strang).
    void run_in(int substeps, double seconds, const Source& source = {});
    // The same in as many as take what moves at 1 m/s a quarter of a cell at most.
    void run(double seconds, const Source& source = {});
};

struct Bounds {
    double most, least_order;
};

// A case of bcre on grids of growing fineness: a series for each scheme, with its bounds. `error` runs one
// and compares R with its answer, by relative_l1.
std::vector<Series> of_each_scheme(const std::vector<int>& squares,
                                   const std::array<Bounds, 3>& lax_friedrichs_local_muscl,
                                   const std::function<double(Scheme scheme, int squares)>& error);

// Where errors are taken: away from borders, whose influence the exact answer does not know.
struct Window {
    double from, to;
};

// Σ|value − exact| / Σ|exact| over the vertices with x and y in their windows.
double relative_l1(const Field<double>& field, const Grid& grid, Window x, Window y, const Function& exact);

// N squares of 1/N of `side` along x, two along y between walls: one dimension.
Grid column(int squares, double side);
void wall_sides(Params& params);

}  // namespace sim::verification
