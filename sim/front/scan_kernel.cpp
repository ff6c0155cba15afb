#include "sim/front/scan.h"
#include "sim/simd/numbers.h"

// The scan, for any number of lanes. In a jump at least one component is 1/√2 of it or more, so components
// can be tested separately. Jumps are rare: several vectors are tested together, and separately only if one
// of them may jump.

namespace sim::front::scan {

template <class Lanes>
struct Scan {
    static constexpr int kLanes = static_cast<int>(Lanes::size());
    static constexpr int kTogether = 32, kVectors = kTogether / kLanes;  // numbers, and vectors of them
    static constexpr Word kGroup = (Word{1} << kTogether / 2) - 1;       // bits of their vertices
    static constexpr float kComponent = 0.707f;                          // < 1/√2, by more than rounding
    using Mask = typename Lanes::mask_type;
    static_assert(2 * kWord % kTogether == 0);

    [[gnu::always_inline]] static Lanes load(const float* from) { return Lanes(from, stdx::element_aligned); }
    [[gnu::always_inline]] static int least_of(int a, int b) { return a < b ? a : b; }

    [[gnu::always_inline]] static bool any_of(const Mask (&masks)[kVectors]) {
        Mask any = masks[0];
        for (int k = 1; k < kVectors; ++k) any = any || masks[k];
        return stdx::any_of(any);
    }

    // Lane i becomes bit i. The sum is exact in any order.
    [[gnu::always_inline]] static Word bits_of(const Mask& mask) {
        Lanes share([](auto lane) { return static_cast<float>(1 << lane); });
        where(!mask, share) = 0;
        return static_cast<Word>(stdx::reduce(share));
    }
    // One bit for each pair of lanes.
    [[gnu::always_inline]] static Word pairs_of(const Mask& mask) {
        static_assert(kLanes <= 16);
        Word bits = bits_of(mask);
        bits = (bits | bits >> 1) & 0x5555;
        bits = (bits | bits >> 1) & 0x3333;
        bits = (bits | bits >> 2) & 0x0f0f;
        return (bits | bits >> 4) & 0x00ff;
    }

    // Whether velocities may differ by `least` between a vertex, the next one, and the two above them.
    [[gnu::always_inline]] static Mask lie_apart(const float* at, const float* above, float least) {
        const Lanes a = load(at), b = load(at + 2), c = load(above), d = load(above + 2);
        return stdx::max(stdx::max(a, b), stdx::max(c, d)) - stdx::min(stdx::min(a, b), stdx::min(c, d)) >=
               least;
    }

    [[gnu::flatten]] static void find_jumps(const float* row, const float* above, int count, int with_next,
                                            float least, const Word* changed, Word* jumps) {
        least *= kComponent;
        for (int first = 0; first < count; first += kWord, ++changed, ++jumps) {
            const float *at = row + 2 * first, *up = above + 2 * first;
            const int numbers = 2 * least_of(with_next - first, kWord),
                      whole = numbers / kTogether * kTogether;
            Word word = 0, kept = 0;
            for (int i = 0; i < whole; i += kTogether) {
                if (const Word those = kGroup << i / 2; !(*changed & those)) {
                    kept |= those;
                    continue;
                }
                Mask mask[kVectors];
                for (int k = 0; k < kVectors; ++k)
                    mask[k] = lie_apart(at + i + k * kLanes, up + i + k * kLanes, least);
                if (!any_of(mask)) continue;
                for (int k = 0; k < kVectors; ++k) word |= pairs_of(mask[k]) << (i + k * kLanes) / 2;
            }
            int i = whole;
            for (; i + kLanes <= numbers; i += kLanes)
                if (const Mask mask = lie_apart(at + i, up + i, least); stdx::any_of(mask))
                    word |= pairs_of(mask) << i / 2;
            for (; i < numbers; ++i) {
                const float d = at[i + 2] - at[i], e = up[i] - at[i], f = up[i + 2] - at[i];
                word |=
                    Word{d >= least || -d >= least || e >= least || -e >= least || f >= least || -f >= least}
                    << i / 2;
            }
            if (with_next < count && count - first <= kWord) {  // the last vertex has a neighbour above only
                const int last = 2 * (count - 1 - first);
                const float x = up[last] - at[last], y = up[last + 1] - at[last + 1];
                word |= Word{x >= least || -x >= least || y >= least || -y >= least} << last / 2;
            }
            *jumps = word | (*jumps & kept);
        }
    }

    [[gnu::flatten]] static void find_changes(const float* row, float* before, int count, float least,
                                              Word* other, Word* jumped) {
        least *= kComponent;
        for (int first = 0; first < count; first += kWord, ++other, ++jumped) {
            const float* at = row + 2 * first;
            float* then = before + 2 * first;
            const int numbers = 2 * least_of(count - first, kWord), whole = numbers / kTogether * kTogether;
            Word others = 0, jumps = 0;
            for (int i = 0; i < whole; i += kTogether) {
                Lanes now[kVectors], change[kVectors];
                Mask differs[kVectors];
                for (int k = 0; k < kVectors; ++k) {
                    now[k] = load(at + i + k * kLanes);
                    change[k] = now[k] - load(then + i + k * kLanes);
                    differs[k] = change[k] != 0;
                }
                if (!any_of(differs)) continue;
                others |= kGroup << i / 2;
                Mask jump[kVectors];
                for (int k = 0; k < kVectors; ++k) jump[k] = stdx::max(change[k], -change[k]) >= least;
                if (any_of(jump))
                    for (int k = 0; k < kVectors; ++k) jumps |= pairs_of(jump[k]) << (i + k * kLanes) / 2;
                else
                    for (int k = 0; k < kVectors; ++k)
                        now[k].copy_to(then + i + k * kLanes, stdx::element_aligned);
            }
            for (int i = whole; i < numbers; i += 2) {
                const float x = at[i] - then[i], y = at[i + 1] - then[i + 1];
                others |= Word{x != 0 || y != 0} << i / 2;
                if (x >= least || -x >= least || y >= least || -y >= least)
                    jumps |= Word{1} << i / 2;
                else
                    then[i] = at[i], then[i + 1] = at[i + 1];
            }
            *other = others, *jumped = jumps;
        }
    }

    [[gnu::flatten]] static void find_above(const float* scalar, int count, float level, Word* above) {
        for (int first = 0; first < count; first += kWord, ++above) {
            const float* at = scalar + first;
            const int vertices = least_of(count - first, kWord), whole = vertices / kLanes * kLanes;
            Word word = 0;
            for (int i = 0; i < whole; i += kLanes) {
                const Mask mask = load(at + i) > level;
                const Word bits = stdx::all_of(mask)    ? (Word{1} << kLanes) - 1
                                  : stdx::none_of(mask) ? 0
                                                        : bits_of(mask);
                word |= bits << i;
            }
            for (int i = whole; i < vertices; ++i) word |= Word{at[i] > level} << i;
            *above = word;
        }
    }

    static constexpr Kernels kAll{find_changes, find_jumps, find_above};
};

constexpr InstructionSet kSet = InstructionSet::COULOIR_SET;

template <>
const Kernels& kernels<kSet>() {
    return Scan<stdx::simd<float, stdx::simd_abi::deduce_t<float, float_lanes(kSet)>>>::kAll;
}

}  // namespace sim::front::scan
