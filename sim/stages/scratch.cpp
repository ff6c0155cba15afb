#include "sim/stages/scratch.h"

#include "sim/stages/stages.h"

namespace sim {

template <class Number>
Scratch<Number>::Scratch(const Layers<Number>& s, Model model) : outlets(s.grid, s.site) {
    const Field<Number> empty(s.grid);
    const auto set = [&](auto&... fields) { ((fields = empty), ...); };
    if (model == Model::kBcre) {
        for (auto* f : {&now, &then})
            set(f->depth, f->rolling, f->drop_x, f->drop_y, f->curvature_x, f->curvature_y, f->slope_dx,
                f->velocity_x, f->velocity_y);
        set(outflow, flux_x, flux_y, exchanged, share);
    } else {
        for (auto* f : {&flow_now, &flow_then})
            set(f->depth, f->rolling, f->velocity_x, f->velocity_y, f->drop_x, f->drop_y, f->curvature_x,
                f->curvature_y, f->exchanged, f->rolling_x, f->u_x, f->v_x, f->rolling_y, f->u_y, f->v_y,
                f->flux_x, f->flux_y, f->momentum_xu, f->momentum_xv, f->momentum_yu, f->momentum_yv);
    }
}

std::int64_t drained(Scratch<float>& scratch, Model model) {
    const auto [x, y] = scratch.fluxes(model);
    const struct { Rows<float> flux_x, flux_y; } through{Rows<float>(x), Rows<float>(y)};
    const Outlets::View outlets = scratch.outlets.view();
    std::int64_t quanta = 0;
    for (int row = 0; row < x.ny(); ++row) quanta += drained<float>(through, outlets, row, {0, x.nx()});
    return quanta;
}

template struct Scratch<float>;
template struct Scratch<double>;

}  // namespace sim
