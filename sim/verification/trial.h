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

using Function = std::function<double(double x, double y)>;  // of a place, m

// Parameters under which only the equations act: no freezing, no start, open borders.
Params bare_params(Model model, Scheme scheme);

// Layers in double on a grid, initialised from functions of the place, and the means to advance them.
struct Trial {
    Params params;
    Layers<double> layers;
    Scratch<double> scratch;
    Workers workers{1};

    struct Begin {
        Function bedrock, depth, rolling;                       // m
        Function has_data = [](double, double) { return 1.; };  // 0 without data
    };
    Trial(const Grid& grid, const Params& with, const Begin& begin);

    // Adds a source term over a time dt around t, s.
    using Source = std::function<void(double t, double dt)>;

    // Runs to `seconds` in equal sub-steps. A source acts for half a sub-step before and half after each,
    // which is second order (Strang).
    void run_in(int substeps, double seconds, const Source& source = {});
    // The same, in enough sub-steps that speed 1 m/s moves at most a quarter of a cell.
    void run(double seconds, const Source& source = {});
};

struct Bounds {
    double most, least_order;
};

// Runs a bcre case on successively finer grids and returns a series for each scheme, with its bounds. `error`
// runs one grid and compares R with its answer, by relative_l1.
std::vector<Series> of_each_scheme(const std::vector<int>& squares,
                                   const std::array<Bounds, 3>& lax_friedrichs_local_muscl,
                                   const std::function<double(Scheme scheme, int squares)>& error);

// Where errors are measured: away from borders, whose influence the exact answer leaves out.
struct Window {
    double from, to;
};

// Σ|value − exact| / Σ|exact| over the vertices with x and y in their windows.
double relative_l1(const Field<double>& field, const Grid& grid, Window x, Window y, const Function& exact);

// A one-dimensional grid: `squares` squares of side/squares along x, two along y, between walls.
Grid column(int squares, double side);
void wall_sides(Params& params);

}  // namespace sim::verification
