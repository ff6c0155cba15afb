#pragma once

// The stages of `bcre`, one loop each, in call order: the step as it reads, beside the sweep that does the
// same at once (sweep/). Each works on the rows first … last-1, writes nothing else, and reads of other rows
// only what an earlier stage finished; so rows may be shared out among threads. The formulas are in
// velocity.h, giving.h and its schemes, slope.h, exchange.h and yield.h.

namespace sim {

enum class Scheme;
template <class Number>
struct Layers;
template <class Number>
struct Scratch;

namespace bcre {

template <class Scalar>
struct Constants;

// Reads b, d; writes down and fall; for muscl to second order.
template <class Number>
void find_slope(const Layers<Number>& layers, Scratch<Number>& scratch, Scheme scheme, int first, int last);

// Reads R, fall; writes pace.
template <class Number>
void find_pace(const Layers<Number>& layers, Scratch<Number>& scratch, const Constants<Number>& c, int first,
               int last);

// For muscl instead: reads b, d, R; writes scratch's velocity.
template <class Number>
void find_central_velocity(const Layers<Number>& layers, Scratch<Number>& scratch, const Constants<Number>& c,
                           int first, int last);
// Beyond the border it is that of the border.
template <class Number>
void continue_velocity(Scratch<Number>& scratch);

// Reads R, down, pace or scratch's velocity, site; writes given, as much as the scheme wants.
template <class Number>
void find_gives(const Layers<Number>& layers, Scratch<Number>& scratch, Scheme scheme,
                const Constants<Number>& c, int first, int last);

// In whole quanta, of muscl no more than there is. Reads R; writes given.
template <class Number>
void book_gives(const Layers<Number>& layers, Scratch<Number>& scratch, Scheme scheme,
                const Constants<Number>& c, int first, int last);

// Reads R, given; writes scratch's rolling.
template <class Number>
void carry_gives(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// Reads d, R, fall; writes exchanged: in closed form, or for muscl at the rate of this moment.
template <class Number>
void find_exchange(const Layers<Number>& layers, Scratch<Number>& scratch, Scheme scheme,
                   const Constants<Number>& c, int first, int last);

// Where the wanted gives and exchange lead, unrounded, and never stored: it only serves to find rates. Reads
// d, R, given, exchanged; writes scratch's depth and rolling.
template <class Number>
void predict(const Layers<Number>& layers, Scratch<Number>& scratch, int first, int last);

// Gives and exchange as the means of the first ones and the present ones.
template <class Number>
void take_means(Scratch<Number>& scratch, int first, int last);

// Books the exchange, then starts what is too steep to lie and stops what is too thin to roll. Reads
// exchanged, fall; writes d, R.
template <class Number>
void settle(Layers<Number>& layers, const Scratch<Number>& scratch, const Constants<Number>& c, int first,
            int last);

// For who looks on: the velocity at the end of a tick, 0 where nothing rolls. Reads b, d, R; writes velocity.
template <class Number>
void find_velocity(Layers<Number>& layers, const Constants<Number>& c, int first, int last);

}  // namespace bcre
}  // namespace sim
