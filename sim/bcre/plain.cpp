#include "sim/bcre/plain.h"

#include "sim/bcre/drops.h"
#include "sim/bcre/exchange.h"
#include "sim/bcre/giving.h"
#include "sim/bcre/giving_lax_friedrichs.h"
#include "sim/bcre/giving_local_lax_friedrichs.h"
#include "sim/bcre/giving_muscl.h"
#include "sim/bcre/runge_kutta.h"
#include "sim/bcre/velocity.h"
#include "sim/bcre/yield.h"
#include "sim/scratch.h"

namespace sim::bcre {
namespace {

template <class Number>
Toward<Number> at(const Directions<Number>& field, int x, int y) {
    return {field.east(x, y), field.west(x, y), field.north(x, y), field.south(x, y)};
}

template <class Number>
Number after_transport(Number rolling, const Directions<Number>& given, int x, int y) {
    return with_received(kept(rolling, at(given, x, y)), given.east(x - 1, y), given.west(x + 1, y),
                         given.north(x, y - 1), given.south(x, y + 1));
}

template <class Number>
void store(const Toward<Number>& values, Directions<Number>& field, int x, int y) {
    field.east(x, y) = values.east;
    field.west(x, y) = values.west;
    field.north(x, y) = values.north;
    field.south(x, y) = values.south;
}

}  // namespace

template <class Number>
void find_slope(const Layers<Number>& s, Scratch<Number>& scratch, Scheme scheme, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Toward<Number> drop = drops(s, x, y);
            const Toward<Number> down =
                downward(scheme == Scheme::kMuscl ? limited_drops(s, drop, x, y) : drop);
            store(down, scratch.down, x, y);
            scratch.fall(x, y) = fall_of(down);
        }
}

template <class Number>
void find_pace(const Layers<Number>& s, Scratch<Number>& scratch, const Constants<Number>& c, int first,
               int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x)
            scratch.pace(x, y) = pace_of(scratch.fall(x, y), s.rolling(x, y), c);
}

template <class Number>
void find_central_velocity(const Layers<Number>& s, Scratch<Number>& scratch, const Constants<Number>& c,
                           int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Vector<Number> v = central_velocity(rise(s, x - 1, y, x + 1, y),
                                                      rise(s, x, y - 1, x, y + 1), s.rolling(x, y), c);
            scratch.velocity_x(x, y) = v.x;
            scratch.velocity_y(x, y) = v.y;
        }
}

template <class Number>
void continue_velocity(Scratch<Number>& scratch) {
    Field<Number>&u = scratch.velocity_x, &v = scratch.velocity_y;
    const int nx = u.nx(), ny = u.ny();
    for (int y = 0; y < ny; ++y) u(-1, y) = u(0, y), u(nx, y) = u(nx - 1, y);
    for (int x = 0; x < nx; ++x) v(x, -1) = v(x, 0), v(x, ny) = v(x, ny - 1);
}

template <class Number>
void find_gives(const Layers<Number>& s, Scratch<Number>& scratch, Scheme scheme, const Constants<Number>& c,
                int first, int last) {
    const auto wanted = [&](int x, int y) -> Toward<Number> {
        const Field<Number>&r = s.rolling, &u = scratch.velocity_x, &v = scratch.velocity_y;
        if (scheme == Scheme::kMuscl) {
            const auto [east, west] = give_muscl<Number>({r(x - 1, y), r(x, y), r(x + 1, y)},
                                                         {u(x - 1, y), u(x, y), u(x + 1, y)}, c);
            const auto [north, south] = give_muscl<Number>({r(x, y - 1), r(x, y), r(x, y + 1)},
                                                           {v(x, y - 1), v(x, y), v(x, y + 1)}, c);
            return {east, west, north, south};
        }
        const Toward<Number> down = at(scratch.down, x, y);
        return scheme == Scheme::kLaxFriedrichs
                   ? give_lax_friedrichs(r(x, y), down, scratch.pace(x, y), c)
                   : give_local_lax_friedrichs(r(x, y), down, scratch.pace(x, y), c);
    };
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            Toward<Number> gives = wanted(x, y);
            if (s.site(x + 1, y) == Site::kWall) gives.east = 0;
            if (s.site(x - 1, y) == Site::kWall) gives.west = 0;
            if (s.site(x, y + 1) == Site::kWall) gives.north = 0;
            if (s.site(x, y - 1) == Site::kWall) gives.south = 0;
            store(gives, scratch.given, x, y);
        }
}

template <class Number>
void book_gives(const Layers<Number>& s, Scratch<Number>& scratch, Scheme scheme, const Constants<Number>& c,
                int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Toward<Number> wanted = at(scratch.given, x, y);
            store(booked(scheme == Scheme::kMuscl ? limited(wanted, s.rolling(x, y)) : wanted, c),
                  scratch.given, x, y);
        }
}

template <class Number>
void carry_gives(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    const Directions<Number>& given = scratch.given;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x)
            scratch.rolling(x, y) = after_transport(s.rolling(x, y), given, x, y);
}

template <class Number>
void find_exchange(const Layers<Number>& s, Scratch<Number>& scratch, Scheme scheme,
                   const Constants<Number>& c, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number growth = growth_of(scratch.fall(x, y), c);
            scratch.exchanged(x, y) =
                scheme == Scheme::kMuscl
                    ? exchanged_at_rate(s.rolling(x, y), s.depth(x, y), growth, c)
                    : exchanged(s.rolling(x, y), scratch.fall(x, y), grown_little(growth), c);
        }
}

template <class Number>
void predict(const Layers<Number>& s, Scratch<Number>& scratch, int first, int last) {
    const Directions<Number>& given = scratch.given;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Number carried = after_transport(s.rolling(x, y), given, x, y);
            scratch.rolling(x, y) = predicted_rolling(carried, scratch.exchanged(x, y));
            scratch.depth(x, y) = s.depth(x, y) - scratch.exchanged(x, y);
        }
}

template <class Number>
void take_means(Scratch<Number>& scratch, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < scratch.exchanged.nx(); ++x) {
            store(mean(at(scratch.first_given, x, y), at(scratch.given, x, y)), scratch.given, x, y);
            scratch.exchanged(x, y) = mean(scratch.first_exchanged(x, y), scratch.exchanged(x, y));
        }
}

template <class Number>
void settle(Layers<Number>& s, const Scratch<Number>& scratch, const Constants<Number>& c, int first,
            int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            Number &d = s.depth(x, y), &r = s.rolling(x, y);
            transfer(scratch.exchanged(x, y), d, r, c);
            yield(scratch.fall(x, y), d, r, c);
        }
}

template <class Number>
void find_velocity(Layers<Number>& s, const Constants<Number>& c, int first, int last) {
    for (int y = first; y < last; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const Toward<Number> down = downward(drops(s, x, y));
            const Number r = s.rolling(x, y);
            const Vector<Number> v = net_velocity(down, pace_of(fall_of(down), r, c));
            s.velocity_x(x, y) = r > 0 ? v.x : Number{0};
            s.velocity_y(x, y) = r > 0 ? v.y : Number{0};
        }
}

#define INSTANTIATE(Number)                                                                                  \
    template void find_slope(const Layers<Number>&, Scratch<Number>&, Scheme, int, int);                     \
    template void find_pace(const Layers<Number>&, Scratch<Number>&, const Constants<Number>&, int, int);    \
    template void find_central_velocity(const Layers<Number>&, Scratch<Number>&, const Constants<Number>&,   \
                                        int, int);                                                           \
    template void continue_velocity(Scratch<Number>&);                                                       \
    template void find_gives(const Layers<Number>&, Scratch<Number>&, Scheme, const Constants<Number>&, int, \
                             int);                                                                           \
    template void book_gives(const Layers<Number>&, Scratch<Number>&, Scheme, const Constants<Number>&, int, \
                             int);                                                                           \
    template void carry_gives(const Layers<Number>&, Scratch<Number>&, int, int);                            \
    template void find_exchange(const Layers<Number>&, Scratch<Number>&, Scheme, const Constants<Number>&,   \
                                int, int);                                                                   \
    template void predict(const Layers<Number>&, Scratch<Number>&, int, int);                                \
    template void take_means(Scratch<Number>&, int, int);                                                    \
    template void settle(Layers<Number>&, const Scratch<Number>&, const Constants<Number>&, int, int);       \
    template void find_velocity(Layers<Number>&, const Constants<Number>&, int, int);
INSTANTIATE(float)
INSTANTIATE(double)
#undef INSTANTIATE

}  // namespace sim::bcre
