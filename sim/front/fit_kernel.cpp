#include "sim/front/fit_lanes.h"
#include "sim/simd/numbers.h"

// Row operations of a fit, for any number of lanes that divides kLanes.

namespace sim::front::fit {

template <class Lanes>
struct Fit {
    static constexpr int kWidth = static_cast<int>(Lanes::size());
    static_assert(kLanes % kWidth == 0);
    using SumsOfLanes = MovingQuadratic::Sums<Lanes>;

    [[gnu::always_inline]] static Lanes load(const double* from) {
        return Lanes(from, stdx::element_aligned);
    }
    [[gnu::always_inline]] static void store(const Lanes& what, double* to) {
        what.copy_to(to, stdx::element_aligned);
    }
    [[gnu::always_inline]] static Lanes weight_at(const Lanes& s, double reach2) {
        const Lanes share = stdx::max(Lanes(0), 1 - s * s * (1 / reach2));
        return share * share * share;
    }

    [[gnu::flatten]] static void find_order(const int* key, int count, int* less) {
        for (int i = 0; i < count; ++i) {
            const int own = key[i];
            int number = 0;
            for (int j = 0; j < count; ++j) number += key[j] < own;
            less[i] = number;
        }
    }

    [[gnu::flatten]] static void place_flips(const LocalFrame& frame, const Weighing& by,
                                             const Flipped& flips, int count, const FlipRows& rows) {
        const Lanes per_way = 1 / (by.surely - by.one_way);
        for (int i = 0; i < filled_up(count); i += kWidth) {
            const Lanes dx = load(flips.x + i) - frame.x0, dy = load(flips.y + i) - frame.y0;
            const Lanes s = frame.u * dy - frame.v * dx;
            const Lanes cosine = by.east * load(flips.east + i) + by.north * load(flips.north + i);
            const Lanes way = stdx::min(stdx::max((cosine - by.one_way) * per_way, Lanes(0)), Lanes(1));
            store(s, rows.s + i), store(frame.u * dx + frame.v * dy, rows.D + i);
            store(weight_at(s, by.reach2) * way, rows.weight + i);
            store(load(flips.age + i), rows.age + i);
        }
    }

    // Adds up the rows of lanes `first` and following.
    template <class Add>
    [[gnu::always_inline]] static void add_up(int first, LaneSums& lanes, const Add& add) {
        SumsOfLanes sums;
        for (int k = 0; k < SumsOfLanes::kAll; ++k) sums.of[k] = load(&lanes[k][first]);
        add(sums);
        for (int k = 0; k < SumsOfLanes::kAll; ++k) store(sums.of[k], &lanes[k][first]);
    }

    [[gnu::flatten]] static void add_flips(const Deviation& deviation, const FlipRows& rows, int count,
                                           LaneSums& lanes) {
        const Lanes per_window = 1 / deviation.window;
        for (int first = 0; first < kLanes; first += kWidth)
            add_up(first, lanes, [&](SumsOfLanes& sums) {
                for (int i = first; i < filled_up(count); i += kLanes) {
                    const Lanes z = load(rows.age + i) * per_window, off = deviation.model * z * z * z;
                    const auto is_old = z > deviation.end;
                    if (stdx::all_of(is_old)) break;
                    Lanes weight = load(rows.weight + i) / (deviation.all + off * off);
                    where(is_old, weight) = 0;
                    sums.add(load(rows.s + i), -z, load(rows.D + i), weight);
                }
            });
    }

    [[gnu::flatten]] static void place_crossings(const LocalFrame& frame, const Nearness& near,
                                                 const Crossed& crossings, int count,
                                                 const CrossingRows& rows, LaneSums& lanes) {
        for (int first = 0; first < kLanes; first += kWidth)
            add_up(first, lanes, [&](SumsOfLanes& sums) {
                for (int i = first; i < filled_up(count); i += kLanes) {
                    const Lanes ax = load(crossings.x + i) - frame.x0, ay = load(crossings.y + i) - frame.y0;
                    const Lanes bx = load(crossings.beyond_x + i) - frame.x0,
                                by = load(crossings.beyond_y + i) - frame.y0;
                    const Lanes sa = frame.u * ay - frame.v * ax, Da = frame.u * ax + frame.v * ay;
                    const Lanes sb = frame.u * by - frame.v * bx, Db = frame.u * bx + frame.v * by;
                    const Lanes s = (sa + sb) * 0.5, D = (Da + Db) * 0.5, across = Db - Da;
                    Lanes counts = load(rows.counts + i);
                    where(s * s + D * D > near.near2 || across < near.across, counts) = 0;
                    const Lanes deviation = stdx::max(across, Lanes(near.deviating));
                    sums.add_now(s, D, counts * weight_at(s, near.reach2) / (deviation * deviation));
                    store(sa, rows.s + i), store(Da, rows.D + i);
                    store(sb, rows.beyond_s + i), store(Db, rows.beyond_D + i);
                    store(counts, rows.counts + i);
                }
            });
    }

    [[gnu::flatten]] static double find_wrong(const double (&c)[3], const CrossingRows& rows, int count,
                                              double* here, double* beyond) {
        Lanes most = 0;
        for (int i = 0; i < filled_up(count); i += kWidth) {
            const Lanes s = load(rows.s + i), t = load(rows.beyond_s + i), counts = load(rows.counts + i);
            const Lanes below = counts * (load(rows.D + i) - (c[0] + s * (c[1] + s * 0.5 * c[2])));
            const Lanes above = counts * ((c[0] + t * (c[1] + t * 0.5 * c[2])) - load(rows.beyond_D + i));
            store(below, here + i), store(above, beyond + i);
            most = stdx::max(most, stdx::max(below, above));
        }
        double greatest = 0;
        for (int lane = 0; lane < kWidth; ++lane)
            if (const double one = most[lane]; one > greatest) greatest = one;
        return greatest;
    }

    static constexpr Kernels kAll{find_order, place_flips, add_flips, place_crossings, find_wrong};
};

constexpr InstructionSet kSet = InstructionSet::COULOIR_SET;
constexpr int kDoubleLanes = float_lanes(kSet) / 2;

template <>
const Kernels& kernels<kSet>() {
    return Fit<stdx::simd<double, stdx::simd_abi::deduce_t<double, kDoubleLanes>>>::kAll;
}

}  // namespace sim::front::fit
