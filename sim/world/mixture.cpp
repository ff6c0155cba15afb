#include "sim/world/mixture.h"

#include <algorithm>

#include "sim/core/workers.h"
#include "sim/world/blend.h"
#include "sim/world/outlets.h"
#include "sim/world/quanta.h"
#include "sim/world/state.h"

namespace sim {
namespace {

using Quanta = std::int64_t;

Quanta quanta_of(float metres) {
    return static_cast<Quanta>(metres * (1 / kQuantum));
}
float metres_of(Quanta quanta) {
    return static_cast<float>(quanta) * kQuantum;
}

// Returns how many of the first `amount` quanta are the lower material, if `part` of `whole` are. Rounds up
// if the fraction exceeds 1 - dither. The difference for two amounts is never more than the difference of the
// amounts. So parts add up, and neither material can become negative.
Quanta lower_in_first(Quanta amount, Quanta part, Quanta whole, float dither) {
    if (part == 0 || amount == 0) return 0;
    CHECK(amount <= whole && part <= whole);
    const auto up = static_cast<Quanta>(static_cast<double>(dither) * static_cast<double>(whole));
    return (part * amount + up) / whole;
}

constexpr float kNearest = 0.5f;  // dither of amounts that are rounded once

// Take `amount` from the rolling or the standing layer and return the lower material in it. `whole`: the
// depth of the layer.
Quanta take_rolling(Mixture& m, int x, int y, Quanta amount, Quanta whole, float dither) {
    const Quanta part = quanta_of(m.rolling(x, y));
    const Quanta taken = lower_in_first(amount, part, whole, dither);
    m.rolling(x, y) = metres_of(part - taken);
    return taken;
}
Quanta take_standing(Mixture& m, int x, int y, Quanta amount, Quanta whole, float dither) {
    const Quanta untouched = quanta_of(m.untouched(x, y)), part = quanta_of(m.settled(x, y));
    const Quanta above = whole - untouched, from_above = std::min(amount, above);
    const Quanta taken = lower_in_first(from_above, part, above, dither);
    m.settled(x, y) = metres_of(part - taken);
    m.untouched(x, y) = metres_of(untouched - (amount - from_above));
    return taken + (amount - from_above);
}

void add(Field<float>& field, int x, int y, Quanta amount) {
    field(x, y) = metres_of(quanta_of(field(x, y)) + amount);
}

// Outflow of a vertex through each face, in rounding order.
struct Leaving {
    Quanta east, west, north, south;

    Leaving(const Field<float>& flux_x, const Field<float>& flux_y, int x, int y)
        : east(quanta_of(std::max(flux_x(x + 1, y), 0.f))),
          west(quanta_of(std::max(-flux_x(x, y), 0.f))),
          north(quanta_of(std::max(flux_y(x, y + 1), 0.f))),
          south(quanta_of(std::max(-flux_y(x, y), 0.f))) {}
};

// Returns the lower material in the outflow of a vertex from quantum `before` to `until`.
float lower_given(const Mixture& m, const Mixing& mixing, int x, int y, Quanta before, Quanta until,
                  float dither) {
    const Quanta part = quanta_of(m.rolling(x, y)), whole = quanta_of(mixing.rolling(x, y));
    return metres_of(lower_in_first(until, part, whole, dither) -
                     lower_in_first(before, part, whole, dither));
}

void find_lower_fluxes(const Mixture& m, Mixing& mixing, const Field<float>& flux_x,
                       const Field<float>& flux_y, float dither, int y) {
    const int nx = flux_x.nx(), ny = flux_x.ny();
    for (int x = 0; x <= nx; ++x) {
        float through = 0;
        if (y < ny && flux_x(x, y) > 0) {
            const Leaving from(flux_x, flux_y, x - 1, y);
            through = lower_given(m, mixing, x - 1, y, 0, from.east, dither);
        } else if (y < ny && flux_x(x, y) < 0) {
            const Leaving from(flux_x, flux_y, x, y);
            through = -lower_given(m, mixing, x, y, from.east, from.east + from.west, dither);
        }
        mixing.lower_x(x, y) = through;

        through = 0;
        if (x < nx && flux_y(x, y) > 0) {
            const Leaving from(flux_x, flux_y, x, y - 1);
            const Quanta before = from.east + from.west;
            through = lower_given(m, mixing, x, y - 1, before, before + from.north, dither);
        } else if (x < nx && flux_y(x, y) < 0) {
            const Leaving from(flux_x, flux_y, x, y);
            const Quanta before = from.east + from.west + from.north;
            through = -lower_given(m, mixing, x, y, before, before + from.south, dither);
        }
        mixing.lower_y(x, y) = through;
    }
}

// Applies the fluxes through the faces of a vertex, then the exchange.
void take_along(State& s, Mixture& m, const Mixing& mixing, const Field<float>& flux_x,
                const Field<float>& flux_y, float dither, int x, int y) {
    if (s.site(x, y) != Site::kGround) {
        m.rolling(x, y) = 0;  // has left the world
        return;
    }
    const auto came = [&](const Field<float>& in_x, const Field<float>& in_y) {
        return (quanta_of(in_x(x, y)) - quanta_of(in_x(x + 1, y))) +
               (quanta_of(in_y(x, y)) - quanta_of(in_y(x, y + 1)));
    };
    add(m.rolling, x, y, came(mixing.lower_x, mixing.lower_y));
    const Quanta carried = quanta_of(mixing.rolling(x, y)) + came(flux_x, flux_y);
    const Quanta stood = quanta_of(mixing.depth(x, y)), stands = quanta_of(s.depth(x, y));
    if (stood > stands)
        add(m.rolling, x, y, take_standing(m, x, y, stood - stands, stood, dither));
    else if (stood < stands)
        add(m.settled, x, y, take_rolling(m, x, y, stands - stood, carried, dither));
}

// Returns the lower material that left the world.
Quanta lower_out(const Mixing& mixing, const Outlets& outlets) {
    Quanta out = 0;
    for (const Outlets::Face& face : outlets.faces) {
        const int x = face.x, y = face.y;
        out += face.way == Way::kEast    ? quanta_of(mixing.lower_x(x + 1, y))
               : face.way == Way::kWest  ? -quanta_of(mixing.lower_x(x, y))
               : face.way == Way::kNorth ? quanta_of(mixing.lower_y(x, y + 1))
                                         : -quanta_of(mixing.lower_y(x, y));
    }
    return out;
}

}  // namespace

float share_in_rolling(const View& s, int x, int y) {
    return s.rolling(x, y) > 0 ? s.mixture->rolling(x, y) / s.rolling(x, y) : 0.f;
}

float share_at_surface(const View& s, int x, int y) {
    const Mixture& m = *s.mixture;
    const float untouched = m.untouched(x, y), above = s.depth(x, y) - untouched;
    const float skin = std::min(kSkin, s.depth(x, y));
    if (skin == 0) return 0;
    return above >= skin ? m.settled(x, y) / above : (m.settled(x, y) + (skin - above)) / skin;
}

Mixture make_mixture(const State& s, const Params& lower, const LowerAmounts& amounts) {
    CHECK(amounts.untouched.size() == s.grid.size());
    CHECK(amounts.settled.empty() || amounts.settled.size() == s.grid.size());
    CHECK(amounts.rolling.empty() || amounts.rolling.size() == s.grid.size());
    Mixture m{lower, Field<float>(s.grid), Field<float>(s.grid), Field<float>(s.grid), {}};
    take_choices(s.params, m.lower);
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(s.grid.nx) +
                           static_cast<std::size_t>(x);
            m.untouched(x, y) = std::min(nearest_quanta(amounts.untouched[i]), s.depth(x, y));
            if (!amounts.settled.empty())
                m.settled(x, y) =
                    std::min(nearest_quanta(amounts.settled[i]), s.depth(x, y) - m.untouched(x, y));
            if (!amounts.rolling.empty())
                m.rolling(x, y) = std::min(nearest_quanta(amounts.rolling[i]), s.rolling(x, y));
        }
    return m;
}

void take_choices(const Params& world, Params& lower) {
    lower.model = world.model;
    lower.scheme = world.scheme;
    lower.law = world.law;
    lower.borders = world.borders;
    lower.tick_s = world.tick_s;
    lower.courant = world.courant;
}

void pour_lower(State& s, int x, int y, bool rolling, float amount) {
    add(rolling ? s.mixture->rolling : s.mixture->settled, x, y, quanta_of(amount));
    s.mixture->ledger.poured += quanta_of(amount);
}

void dig_mixture(State& s, int x, int y, float from_rolling, float from_standing) {
    if (!s.mixture) return;
    Mixture& m = *s.mixture;
    m.ledger.dug += take_rolling(m, x, y, quanta_of(from_rolling), quanta_of(s.rolling(x, y)), kNearest) +
                    take_standing(m, x, y, quanta_of(from_standing), quanta_of(s.depth(x, y)), kNearest);
}

void start_mixture(State& s, int x, int y, float amount) {
    if (!s.mixture) return;
    Mixture& m = *s.mixture;
    add(m.rolling, x, y, take_standing(m, x, y, quanta_of(amount), quanta_of(s.depth(x, y)), kNearest));
}

void stop_mixture(State& s, int x, int y, float amount) {
    if (!s.mixture) return;
    Mixture& m = *s.mixture;
    add(m.settled, x, y, take_rolling(m, x, y, quanta_of(amount), quanta_of(s.rolling(x, y)), kNearest));
}

Mixing::Mixing(const State& s)
    : flow(s.grid), bed(s.grid), depth(s.grid), rolling(s.grid), lower_x(s.grid), lower_y(s.grid) {}

void begin_mixing(const State& state, Mixing& mixing, Workers& workers) {
    const View s = view(state);
    workers.each_band(s.grid.ny, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < s.grid.nx; ++x) {
                const float rolls = share_in_rolling(s, x, y), lies = share_at_surface(s, x, y);
                const bool any_rolls = s.rolling(x, y) > 0, any_lies = s.depth(x, y) > 0;
                const float bed = any_rolls && any_lies ? 0.5f * (rolls + lies) : any_rolls ? rolls : lies;
                mixing.flow(x, y) = static_cast<std::uint8_t>(nearest_blend(any_rolls ? rolls : lies));
                mixing.bed(x, y) = static_cast<std::uint8_t>(nearest_blend(bed));
                mixing.depth(x, y) = s.depth(x, y);
                mixing.rolling(x, y) = s.rolling(x, y);
            }
    });
}

void mix_exchange(State& s, Mixing& mixing, const Field<float>& exchanged, float dither, Workers& workers) {
    Mixture& m = *s.mixture;
    workers.each_band(s.grid.ny, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < s.grid.nx; ++x) {
                const Quanta eroded = quanta_of(exchanged(x, y));
                if (eroded == 0) continue;
                const Quanta stood = quanta_of(mixing.depth(x, y)), rolled = quanta_of(mixing.rolling(x, y));
                if (eroded > 0)
                    add(m.rolling, x, y, take_standing(m, x, y, eroded, stood, dither));
                else
                    add(m.settled, x, y, take_rolling(m, x, y, -eroded, rolled, dither));
                mixing.depth(x, y) = metres_of(stood - eroded);
                mixing.rolling(x, y) = metres_of(rolled + eroded);
            }
    });
}

void finish_mixing(State& s, Mixing& mixing, const Field<float>& flux_x, const Field<float>& flux_y,
                   const Outlets& outlets, float dither, Workers& workers) {
    Mixture& m = *s.mixture;
    workers.each_band(s.grid.ny + 1, [&](int first, int last) {
        for (int y = first; y < last; ++y) find_lower_fluxes(m, mixing, flux_x, flux_y, dither, y);
    });
    workers.each_band(s.grid.ny, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < s.grid.nx; ++x) take_along(s, m, mixing, flux_x, flux_y, dither, x, y);
    });
    m.ledger.out += lower_out(mixing, outlets);
}

}  // namespace sim
