#include "sim/scratch.h"

#include <algorithm>
#include <numeric>

#include "sim/stages/stages.h"

namespace sim {

template <class Number>
Scratch<Number>::Scratch(const Layers<Number>& layers, Model model)
    : limited(static_cast<std::size_t>(layers.grid.ny)), context{Outlets(layers.grid, layers.site)} {
    context.limited_in_row = limited.data();
    if (has_momentum(model)) fields.template emplace<Momentum>();
    std::visit([&](auto& of_model) { allocate(of_model, layers.grid); }, fields);
}

template <class Number>
typename Scratch<Number>::Fluxes Scratch<Number>::fluxes() {
    if (std::holds_alternative<Bcre>(fields)) return {bcre().flux_x, bcre().flux_y};
    return {momentum().flux_x, momentum().flux_y};
}

std::int64_t take_limited(Scratch<float>& scratch) {
    const std::int64_t count =
        std::accumulate(scratch.limited.begin(), scratch.limited.end(), std::int64_t{0});
    std::fill(scratch.limited.begin(), scratch.limited.end(), 0);
    return count;
}

std::int64_t drained(Scratch<float>& scratch) {
    const auto [x, y] = scratch.fluxes();
    const struct { Rows<float> flux_x, flux_y; } through{Rows<float>(x), Rows<float>(y)};
    const Outlets::View outlets = scratch.context.outlets.view();
    std::int64_t quanta = 0;
    for (int row = 0; row < x.ny(); ++row) quanta += drained<float>(through, outlets, row, {0, x.nx()});
    return quanta;
}

template struct Scratch<float>;
template struct Scratch<double>;

}  // namespace sim
