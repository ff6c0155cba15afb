#include "sim/scratch.h"

namespace sim {

template <class Number>
Scratch<Number>::Scratch(const Layers<Number>& s) {
    const Field<Number> empty(s.grid);
    flux_x = flux_y = rolling = velocity_x = velocity_y = slope = slope_spread = empty;
    fall = pace = exchanged = first_exchanged = depth = empty;
    momentum_x = momentum_y = {empty, empty};
    first_flux_x = first_flux_y = empty;
    down = given = first_given = {empty, empty, empty, empty};
    outlets = Outlets(s.grid, s.site);
}

template struct Scratch<float>;
template struct Scratch<double>;

}  // namespace sim
