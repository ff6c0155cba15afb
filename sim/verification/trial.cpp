#include "sim/verification/trial.h"
#include "sim/initial_state.h"

#include <cmath>

#include "sim/step.h"
#include "sim/world/quanta.h"

namespace sim::verification {
namespace {

Layers<double> begun(const Grid& grid, const Params& params, const Trial::Begin& begin) {
    std::vector<std::uint8_t> has_data;
    const double dx = grid.dx;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) has_data.push_back(begin.has_data(x * dx, y * dx) != 0);
    auto layers = make_layers<double>(grid, params, has_data);
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            layers.bedrock(x, y) = begin.bedrock(x * dx, y * dx);
            if (layers.site(x, y) != Site::kGround) continue;
            layers.depth(x, y) = begin.depth(x * dx, y * dx);
            layers.rolling(x, y) = begin.rolling(x * dx, y * dx);
        }
    enclose(layers, params);
    return layers;
}

}  // namespace

Params bare_params(Model model, Scheme scheme) {
    Params params;
    params.model = model;
    params.scheme = scheme;
    params.start_slope = 1e6f;
    params.freeze_depth = 0;
    return params;
}

Trial::Trial(const Grid& grid, const Params& with, const Begin& begin)
    : params(with), layers(begun(grid, with, begin)), scratch(layers, with.model) {}

void Trial::run_in(int substeps, double seconds, const Source& source) {
    const double dt = seconds / substeps;
    for (int i = 0; i < substeps; ++i) {
        if (source) source((i + 0.25) * dt, dt / 2);
        substep(layers, params, scratch, workers, Substep<double>{dt, 0});
        if (source) source((i + 0.75) * dt, dt / 2);
    }
}

void Trial::run(double seconds, const Source& source) {
    run_in(static_cast<int>(std::ceil(seconds / (0.25 * layers.grid.dx))), seconds, source);
}

std::vector<Series> of_each_scheme(const std::vector<int>& squares,
                                   const std::array<Bounds, 3>& lax_friedrichs_local_muscl,
                                   const std::function<double(Scheme, int)>& error) {
    constexpr std::array kSchemes{Scheme::kLaxFriedrichs, Scheme::kLocalLaxFriedrichs, Scheme::kMuscl};
    std::vector<Series> table;
    for (std::size_t i = 0; i < kSchemes.size(); ++i) {
        const Bounds& bounds = lax_friedrichs_local_muscl[i];
        Series series{to_string(kSchemes[i]), "R, L1", bounds.most, bounds.least_order, squares};
        for (const int n : squares) series.errors.push_back(error(kSchemes[i], n));
        table.push_back(std::move(series));
    }
    return table;
}

double relative_l1(const Field<double>& field, const Grid& grid, Window in_x, Window in_y,
                   const Function& exact) {
    const double dx = grid.dx;
    double wrong = 0, all = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const double at_x = x * dx, at_y = y * dx;
            if (at_x < in_x.from || at_x > in_x.to || at_y < in_y.from || at_y > in_y.to) continue;
            const double value = exact(at_x, at_y);
            wrong += std::fabs(field(x, y) - value);
            all += std::fabs(value);
        }
    return wrong / all;
}

Grid column(int squares, double side) {
    return {squares + 1, 3, static_cast<float>(side / squares)};
}

void wall_sides(Params& params) {
    params.borders[kSouth] = params.borders[kNorth] = Border::kWall;
}

}  // namespace sim::verification
