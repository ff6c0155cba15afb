#include "sim/weather/release.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/core/workers.h"
#include "sim/weather/hour.h"
#include "sim/weather/slab.h"
#include "sim/weather/work.h"
#include "sim/world/edit_layers.h"
#include "sim/world/state.h"

namespace sim::weather {
namespace {

constexpr float kBegins = 1, kRuns = 1.35f;                         // index of stability
constexpr float kBeginsFrom = 0.57735027f, kRunsFrom = 0.5317094f;  // tangents of 30° and 28°
constexpr float kTurn = 0.7f;                                       // squared cosine of 33°
constexpr float kReach = 200;                                       // m that a crack runs
constexpr double kLeastArea = 2500;                                 // m²
constexpr float kReleased = 1500, kBedSurface = 850;                // Pa, of what is left

enum Crack : std::uint8_t { kWhole, kMayRun, kCracked, kInPiece };

class Release {
  public:
    Release(State& s, Work& work) : s_(s), w_(*s.weather), work_(work), nx_(s.grid.nx) {}

    // Rows first … last-1.
    void find_stability(int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < nx_; ++x) {
                const bool ground = s_.site(x, y) == Site::kGround;
                const float index = ground ? stability_of(w_, *s_.things, s_.params.density, s_.depth(x, y),
                                                          squared(x, y), x, y)
                                           : kStable;
                work_.stability(x, y) = index;
                crack(x + y * nx_) =
                    index < kRuns && squared(x, y) > kRunsFrom * kRunsFrom ? kMayRun : kWhole;
            }
    }

    // Cracks, ring by ring from where they begin.
    void run() {
        std::vector<std::int32_t>& cracked = work_.cracked;
        cracked.clear();
        for (int y = 0; y < s_.grid.ny; ++y)
            for (int x = 0; x < nx_; ++x)
                if (work_.stability(x, y) < kBegins && squared(x, y) > kBeginsFrom * kBeginsFrom)
                    cracked.push_back(x + y * nx_), crack(x + y * nx_) = kCracked;
        std::size_t begin = 0;
        for (int ring = static_cast<int>(kReach / s_.grid.dx); ring > 0 && begin < cracked.size(); --ring) {
            const std::size_t end = cracked.size();
            for (; begin < end; ++begin) spread(cracked[begin], kMayRun, kCracked, cracked);
        }
    }

    // Lets go of each connected piece that is large enough. Returns whether any was.
    bool let_go() {
        std::vector<std::int32_t>& piece = work_.piece;
        bool any = false;
        for (const std::int32_t first : work_.cracked) {
            if (crack(first) != kCracked) continue;
            piece.assign(1, first);
            crack(first) = kInPiece;
            for (std::size_t i = 0; i < piece.size(); ++i) spread(piece[i], kCracked, kInPiece, piece);
            if (static_cast<double>(piece.size()) * s_.grid.cell_area() < kLeastArea) continue;
            for (const std::int32_t i : piece) let_go(i % nx_, i / nx_);
            any = true;
        }
        return any;
    }

  private:
    float squared(int x, int y) const {
        const float along_x = work_.gradient_x(x, y), along_y = work_.gradient_y(x, y);
        return along_x * along_x + along_y * along_y;
    }
    std::uint8_t& crack(std::int32_t vertex) { return work_.crack[static_cast<std::size_t>(vertex)]; }

    // The surfaces of two vertices face nearly the same way, in plan.
    bool face_alike(int x, int y, int u, int v) const {
        const float dot =
            work_.gradient_x(x, y) * work_.gradient_x(u, v) + work_.gradient_y(x, y) * work_.gradient_y(u, v);
        return dot > 0 && dot * dot > kTurn * (squared(x, y) * squared(u, v));
    }

    // From a vertex to those beside it that are `from`; they become `to` and are added to a list.
    void spread(std::int32_t vertex, Crack from, Crack to, std::vector<std::int32_t>& list) {
        const int x = vertex % nx_, y = vertex / nx_;
        constexpr int kBeside[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
        for (const auto& [right, up] : kBeside) {
            const int u = x + right, v = y + up;
            if (u < 0 || v < 0 || u >= nx_ || v >= s_.grid.ny) continue;
            const std::int32_t beside = u + v * nx_;
            if (crack(beside) != from || !face_alike(x, y, u, v)) continue;
            crack(beside) = to;
            list.push_back(beside);
        }
    }

    void let_go(int x, int y) {
        start_at(s_, x, y,
                 std::min(std::max(s_.depth(x, y) - w_.base(x, y), 0.f), room_in(s_.rolling(x, y))));
        w_.base(x, y) = s_.depth(x, y);
        w_.strength(x, y) = kReleased;
        w_.surface(x, y) = kBedSurface;
        w_.water(x, y) = 0;
        s_.tiles.wake(x, x, y, y);
    }

    State& s_;
    Weather& w_;
    Work& work_;
    const int nx_;
};

}  // namespace

bool release(State& s, Work& work, Workers& workers) {
    workers.each_band(s.grid.ny, [&](int first, int last) { find_gradient(s, work, first, last); });
    Release slabs(s, work);
    workers.each_band(s.grid.ny, [&](int first, int last) { slabs.find_stability(first, last); });
    slabs.run();
    if (!slabs.let_go()) return false;
    s.weather->stirred = s.tick;
    s.weather->greatest_motion = 0;
    return true;
}

}  // namespace sim::weather
