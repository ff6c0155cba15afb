#pragma once

#include "sim/bcre/exchange.h"
#include "sim/bcre/giving.h"
#include "sim/bcre/giving_lax_friedrichs.h"
#include "sim/bcre/giving_local_lax_friedrichs.h"
#include "sim/bcre/slope.h"
#include "sim/bcre/velocity.h"
#include "sim/bcre/yield.h"
#include "sim/sweep/sweep.h"

// The sweep, for lanes of any number. A pipeline over the rows of a job: each stage runs as soon as the rows
// that it reads are done, so that a row is still in the nearest cache when the next stage wants it.
//
//     drops (t)  ─►  gives (t)  ─►  R, d (t − 1)
//
// A row is overwritten after the last stage that reads what it was.

namespace sim::sweep {

template <class Lanes, Scheme scheme>
class Kernel {
  public:
    Kernel(const Ground& ground, const Job& job, float* work, std::uint8_t* active = nullptr)
        : g_(ground), job_(job), c_(ground.constants), work_(work), active_(active), stride_(ground.stride) {}

    std::int64_t substep() {
        find_drops(job_.y0 - 2);
        for (int t = job_.y0 - 1; t <= job_.y1; ++t) {
            find_drops(t);
            find_gives(t);
            if (t > job_.y0) finish(t - 1);
            if (t > job_.y0 && (t % g_.tile_height == 0 || t == job_.y1)) tell_active(t - 1);
        }
        return drained_;
    }

    // For who looks on, at the end of a tick.
    void find_velocity() {
        for (int y = job_.y0; y < job_.y1; ++y) find_velocity(y);
    }

  private:
    using Toward = bcre::Toward<Lanes>;
    static constexpr int kLanes = static_cast<int>(Lanes::size());

    using Vector [[gnu::vector_size(sizeof(Lanes))]] = float;
    using Unaligned [[gnu::vector_size(sizeof(Lanes)), gnu::aligned(4), gnu::may_alias]] = float;
    static Lanes load(const float* from) {
        return Lanes(static_cast<Vector>(*reinterpret_cast<const Unaligned*>(from)));
    }

    // The lanes of a row's last vertices that lie beyond it are not stored: the halo is not this row's.
    static void store_within(int end, const Lanes& value, float* to, int x) {
        if (x + kLanes <= end) {
            put(value, to + x);
        } else {
            float lanes[kLanes];
            put(value, lanes);
            for (int i = 0; x + i < end; ++i) to[x + i] = lanes[i];
        }
    }

    // Layers of before the sub-step.
    const float* bedrock(int y) const { return g_.bedrock + y * g_.stride; }
    const float* depth(int y) const {
        if (y < job_.y0 && job_.y0 > 0) return job_.depth_below + (y - (job_.y0 - kApron)) * stride_;
        if (y >= job_.y1 && job_.y1 < g_.ny) return job_.depth_above + (y - job_.y1) * stride_;
        return g_.depth + y * g_.stride;
    }
    const float* rolling(int y) const {
        if (y < job_.y0 && job_.y0 > 0) return job_.rolling_below + (y - (job_.y0 - kApron)) * stride_;
        if (y >= job_.y1 && job_.y1 < g_.ny) return job_.rolling_above + (y - job_.y1) * stride_;
        return g_.rolling + y * g_.stride;
    }

    // What is given east and west, as rows: the next vertex reads it.
    float* east(int y) const { return work_ + (y & 1) * stride_; }
    float* west(int y) const { return work_ + (2 + (y & 1)) * stride_; }

    // h less that of the next vertex east and north.
    float* drop_east(int y) const { return work_ + (4 + (y & 1)) * stride_; }
    float* drop_north(int y) const { return work_ + (6 + (y & 1)) * stride_; }

    // The rest only goes to the same lanes of this row or another, so it lies together, lanes by lanes.
    enum Part { kNorth, kSouth, kKept, kFall, kGrowth, kPace, kParts };
    static_assert(8 + 4 * kParts <= kWorkRows);
    float* parts(int y) const { return work_ + (8 + (y & 3) * kParts) * stride_ + kParts * kLanes; }
    static float* part(float* parts, Part which, int x) { return parts + kParts * x + which * kLanes; }

    bool in_grid(int y) const { return y >= 0 && y < g_.ny; }

    static void put(const Lanes& value, float* to) { value.copy_to(to, stdx::element_aligned); }
    void clear(float* parts, Part which) const {
        for (int x = job_.x0; x < job_.x1; x += kLanes) put(Lanes(0), part(parts, which, x));
    }

    // Nothing comes over the ends of a job's rows: beyond lies the border's halo or what is asleep.
    void close_ends(int y) const {
        east(y)[job_.x0 - 1] = 0;
        west(y)[job_.x1] = 0;
    }
    void close_walls(int y) const {
        if (job_.x0 == 0 && g_.wall[kWest]) west(y)[0] = 0;
        if (job_.x1 == g_.nx && g_.wall[kEast]) east(y)[g_.nx - 1] = 0;
        if (y == 0 && g_.wall[Side::kSouth]) clear(parts(y), kSouth);
        if (y == g_.ny - 1 && g_.wall[Side::kNorth]) clear(parts(y), kNorth);
    }

    [[gnu::flatten]] void find_drops(int y) {
        if (y < -1 || y >= g_.ny) return;
        const float *b = bedrock(y), *b_n = bedrock(y + 1), *d = depth(y), *d_n = depth(y + 1);
        float *to_east = drop_east(y), *to_north = drop_north(y);
        const int x0 = job_.x0, x1 = job_.x1;
        to_east[x0 - 1] = (b[x0 - 1] - b[x0]) + (d[x0 - 1] - d[x0]);
        for (int x = x0; x < x1; x += kLanes) {
            const Lanes bed = load(b + x), lying = load(d + x);
            put((bed - load(b + x + 1)) + (lying - load(d + x + 1)), to_east + x);
            put((bed - load(b_n + x)) + (lying - load(d_n + x)), to_north + x);
        }
    }

    [[gnu::flatten]] void find_gives(int y) {
        if (!in_grid(y)) {  // halo: empty
            clear(parts(y), kNorth), clear(parts(y), kSouth);
            return;
        }
        const auto c = c_;  // of its own, so that no store can touch it
        const int x0 = job_.x0, x1 = job_.x1;
        const float *r = rolling(y), *east_of = drop_east(y), *north_of = drop_north(y),
                    *north_of_south = drop_north(y - 1);
        float *to_east = east(y), *to_west = west(y), *to = part(parts(y), kNorth, x0);
        // In several short loops, so that a root or a quotient of some lanes does not hold up the others.
        const auto downward = [&](int x) {
            return bcre::downward<Lanes>(
                {load(east_of + x), -load(east_of + x - 1), load(north_of + x), -load(north_of_south + x)});
        };
        float* of = to;
        for (int x = x0; x < x1; x += kLanes, of += kParts * kLanes)
            put(bcre::fall_of(downward(x)), of + kFall * kLanes);
        of = to;
        for (int x = x0; x < x1; x += kLanes, of += kParts * kLanes) {
            const Lanes fall = load(of + kFall * kLanes);
            put(grown_little(bcre::growth_of(fall, c)), of + kGrowth * kLanes);
            put(bcre::pace_of(fall, load(r + x), c), of + kPace * kLanes);
        }
        for (int x = x0; x < x1; x += kLanes, to += kParts * kLanes) {
            const Lanes moving = load(r + x), pace = load(to + kPace * kLanes);
            const Toward down = downward(x);
            Toward gives;
            if constexpr (scheme == Scheme::kLaxFriedrichs) {
                gives = bcre::give_lax_friedrichs(moving, down, pace, c);
            } else {  // down to a wall there is no drop, so nothing has to be kept back
                gives = bcre::booked(bcre::give_local_lax_friedrichs(moving, down, pace, c), c);
                put(bcre::kept(moving, gives), to + kKept * kLanes);
            }
            put(gives.east, to_east + x);
            put(gives.west, to_west + x);
            put(gives.north, to + kNorth * kLanes);
            put(gives.south, to + kSouth * kLanes);
        }
        if constexpr (scheme == Scheme::kLaxFriedrichs) {
            close_walls(y);
            book_gives(y);
        }
        close_ends(y);
        count_drained(y);
    }

    [[gnu::flatten]] void book_gives(int y) {
        const auto c = c_;
        const float* r = rolling(y);
        for (int x = job_.x0; x < job_.x1; x += kLanes) {
            float *to_east = east(y) + x, *to_west = west(y) + x;
            float *to_north = part(parts(y), kNorth, x), *to_south = part(parts(y), kSouth, x);
            const Toward wanted{load(to_east), load(to_west), load(to_north), load(to_south)};
            const Lanes moving = load(r + x);
            const Toward gives = bcre::booked(wanted, c);
            put(gives.east, to_east), put(gives.west, to_west);
            put(gives.north, to_north), put(gives.south, to_south);
            put(bcre::kept(moving, gives), part(parts(y), kKept, x));
        }
    }

    void count_drained(int y) {
        if (y < job_.y0 || y >= job_.y1) return;
        const Outlets::View& o = g_.outlets;
        for (int i = o.first_face[y]; i < o.first_face[y + 1]; ++i) {
            const auto [x, row, way] = o.faces[i];
            if (x < job_.x0 || x >= job_.x1) continue;
            const int lane = x % kLanes;  // of its part
            const float given = way == Way::kEast    ? east(y)[x]
                                : way == Way::kWest  ? west(y)[x]
                                : way == Way::kNorth ? part(parts(y), kNorth, x - lane)[lane]
                                                     : part(parts(y), kSouth, x - lane)[lane];
            drained_ += static_cast<std::int64_t>(given / kQuantum);
        }
    }

    [[gnu::flatten]] void finish(int y) {
        const auto c = c_;
        const int x1 = job_.x1;
        float *d = g_.depth + y * g_.stride, *r = g_.rolling + y * g_.stride;
        const float *from_west = east(y) - 1, *from_east = west(y) + 1;
        const float *of = part(parts(y), kNorth, job_.x0), *south = part(parts(y - 1), kNorth, job_.x0),
                    *north = part(parts(y + 1), kNorth, job_.x0);
        for (int x = job_.x0; x < x1; x += kLanes) {
            Lanes lies = load(d + x);
            const Lanes carried =
                bcre::with_received(load(of + kKept * kLanes), load(from_west + x), load(from_east + x),
                                    load(south + kNorth * kLanes), load(north + kSouth * kLanes));
            const Lanes fall = load(of + kFall * kLanes);
            Lanes rolls = carried;
            bcre::transfer(bcre::exchanged(rolls, fall, load(of + kGrowth * kLanes), c), lies, rolls, c);
            bool active = true;
            if (any(rolls < c.freeze_depth) || x + kLanes > x1) {
                bcre::yield(fall, lies, rolls, c);
                const Lanes number([](auto lane) { return static_cast<float>(lane); });
                active = any((carried > 0.f || rolls > 0.f) && number < static_cast<float>(x1 - x));
            }
            if (active) active_[x / kLanes] = 1;
            store_within(x1, lies, d, x);
            store_within(x1, rolls, r, x);
            of += kParts * kLanes, south += kParts * kLanes, north += kParts * kLanes;
        }
        clear_drains(y, d, r);
    }

    [[gnu::flatten]] void find_velocity(int y) {
        const auto c = c_;
        const int x1 = job_.x1;
        const std::ptrdiff_t row = y * g_.stride, next = g_.stride;
        const float *b = g_.bedrock + row, *d = g_.depth + row, *r = g_.rolling + row;
        float *u = g_.velocity_x + row, *v = g_.velocity_y + row;
        for (int x = job_.x0; x < x1; x += kLanes) {
            const Lanes rolls = load(r + x), bed = load(b + x), lying = load(d + x);
            const auto drop = [&](std::ptrdiff_t to) {
                return (bed - load(b + x + to)) + (lying - load(d + x + to));
            };
            const Toward down = bcre::downward<Lanes>({drop(1), drop(-1), drop(next), drop(-next)});
            const bcre::Vector<Lanes> velocity =
                bcre::net_velocity(down, bcre::pace_of(bcre::fall_of(down), rolls, c));
            const auto moves = rolls > 0.f;
            store_within(x1, select(moves, velocity.x, 0.f), u, x);
            store_within(x1, select(moves, velocity.y, 0.f), v, x);
        }
    }

    // At the end of a row of tiles.
    void tell_active(int y) {
        std::uint8_t* tiles = g_.active + y / g_.tile_height * g_.tile_columns;
        for (int x = job_.x0; x < job_.x1; x += kLanes) {
            if (active_[x / kLanes]) tiles[x / g_.tile_width] = 1;
            active_[x / kLanes] = 0;
        }
    }

    void clear_drains(int y, float* d, float* r) const {
        const Outlets::View& o = g_.outlets;
        for (int i = o.first_drain[y]; i < o.first_drain[y + 1]; ++i) {
            const int x = o.drains[i];
            if (x >= job_.x0 && x < job_.x1) d[x] = r[x] = 0;
        }
    }

    const Ground& g_;
    const Job job_;
    const bcre::Constants<float> c_;
    float* const work_;
    std::uint8_t* const active_;  // of each run of lanes in this row of tiles
    const std::ptrdiff_t stride_;
    std::int64_t drained_ = 0;
};

template <class Lanes>
void run_velocity(const Ground& ground, const Job& job) {
    Kernel<Lanes, Scheme::kLocalLaxFriedrichs>(ground, job, nullptr).find_velocity();
}

template <class Lanes>
std::int64_t run(const Ground& ground, const Job& job, float* work, std::uint8_t* active) {
    switch (ground.scheme) {
        case Scheme::kLaxFriedrichs:
            return Kernel<Lanes, Scheme::kLaxFriedrichs>(ground, job, work, active).substep();
        case Scheme::kLocalLaxFriedrichs:
            return Kernel<Lanes, Scheme::kLocalLaxFriedrichs>(ground, job, work, active).substep();
        case Scheme::kMuscl:
            break;
    }
    return 0;
}

}  // namespace sim::sweep
