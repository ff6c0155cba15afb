#include <algorithm>
#include <utility>

#include "sim/weather/hour.h"
#include "sim/weather/sky.h"
#include "sim/weather/slab.h"
#include "sim/weather/stream.h"
#include "sim/weather/work.h"
#include "sim/world/edit_layers.h"
#include "sim/world/state.h"

// Drift of snow, in quanta that pass from vertex to vertex in an hour. A wind of speed u carries up to
//
//     Q = u⁴/400,000 kg/(m s)     above 7 m/s
//
// It takes up soft snow until it carries that, over some 300 m, and loses what is more, over some 120 m.

namespace sim::weather {
namespace {

constexpr float kFetch = 300, kDrop = 120;                            // m
constexpr float kPerFourthPower = 4e5f;                               // m⁵/(kg s³)
constexpr float kSoftBelow = 1105, kMostTaken = 0.1f, kDryBelow = 1;  // Pa; m in an hour; mm of water
constexpr float kSheltered = 0.3f;     // share that forest or nets hold, above which no snow is taken
constexpr float kBuriesFrom = 0.001f;  // m

class Drift {
  public:
    Drift(State& s, const Sky& sky, Work& work)
        : s_(s),
          w_(*s.weather),
          sky_(sky),
          work_(work),
          stream_(s.grid, sky.wind_to),
          burial_(s, sky.event),
          takes_(stream_.cell / (stream_.cell + kFetch)),
          gives_(stream_.cell / (stream_.cell + kDrop)),
          quanta_per_flux_(3600 / (s.grid.dx * s.params.density) / kQuantum),
          above_(static_cast<float>(s.datum - s.weather->calendar.reference)) {}

    void run() {
        stream_.each_row(
            s_.grid, [&](int) { std::swap(work_.before, work_.now); }, [&](int x, int y) { pass(x, y); });
    }

  private:
    bool is_ground(int x, int y) const { return s_.site(x, y) == Site::kGround; }
    static std::size_t at(int x) { return static_cast<std::size_t>(std::int64_t{x} + 1); }

    // Quanta that the wind can carry over a vertex.
    std::int32_t capacity(int x, int y) const {
        if (s_.things->hold(x, y) > kSheltered) return 0;
        const float height = above_ + s_.bedrock(x, y) + s_.depth(x, y);
        const float wind = wind_near_ground(sky_.wind, work_.wind(x, y), height);
        if (wind <= kDriftFrom) return 0;
        const float squared = wind * wind;
        return static_cast<std::int32_t>(squared * squared * (quanta_per_flux_ / kPerFourthPower));
    }
    std::int32_t aside_of(std::int32_t quanta) const {
        return static_cast<std::int32_t>(static_cast<float>(quanta) * stream_.aside);
    }

    void pass(int x, int y) {
        std::int32_t &straight = work_.now.straight[at(x)], &aside = work_.now.aside[at(x)];
        straight = aside = 0;
        if (!is_ground(x, y)) return;
        float& d = s_.depth(x, y);
        const std::int32_t carries = capacity(x, y);
        const float slab = std::max(d - w_.base(x, y), 0.f);
        const bool soft = w_.surface(x, y) < kSoftBelow && w_.water(x, y) < kDryBelow;
        const auto loose = soft ? static_cast<std::int32_t>(std::min(slab, kMostTaken) / kQuantum) : 0;
        std::int32_t carried = arriving(x, y, loose > 0 ? carries : 0);
        if (carries > carried) {
            const auto wants = static_cast<std::int32_t>(static_cast<float>(carries - carried) * takes_);
            const std::int32_t taken = std::min(wants, loose);
            change_depth(d, w_.undisturbed(x, y), -static_cast<float>(taken) * kQuantum);
            carried += taken;
        } else if (carried > 0) {
            const auto wants = static_cast<std::int32_t>(static_cast<float>(carried - carries) * gives_);
            const float given = std::min(static_cast<float>(wants) * kQuantum, room_in(d));
            if (given > kBuriesFrom) {
                const float along_x = work_.gradient_x(x, y), along_y = work_.gradient_y(x, y);
                burial_(w_, d, along_x * along_x + along_y * along_y, x, y);
            }
            change_depth(d, w_.undisturbed(x, y), given);
            carried -= static_cast<std::int32_t>(given / kQuantum);
        }
        aside = aside_of(carried);
        straight = carried - aside;
        if (!is_ground(x + stream_.straight_x(), y + stream_.straight_y()))
            s_.ledger.out += std::exchange(straight, 0);
        if (!is_ground(x + stream_.dx, y + stream_.dy)) s_.ledger.out += std::exchange(aside, 0);
    }

    // What arrives. Beyond a border lies the same snow: from there comes as much as the wind carries here.
    std::int32_t arriving(int x, int y, std::int32_t from_beyond) {
        const int beside = x - stream_.straight_x();
        std::int32_t straight = (stream_.along_x ? work_.now : work_.before).straight[at(beside)];
        std::int32_t aside = work_.before.aside[at(x - stream_.dx)];
        const std::int32_t own_aside = aside_of(from_beyond);
        if (!is_ground(beside, y - stream_.straight_y()))
            s_.ledger.fallen += straight = from_beyond - own_aside;
        if (!is_ground(x - stream_.dx, y - stream_.dy)) s_.ledger.fallen += aside = own_aside;
        return straight + aside;
    }

    State& s_;
    Weather& w_;
    const Sky& sky_;
    Work& work_;
    const Stream stream_;
    const Burial burial_;
    const float takes_, gives_, quanta_per_flux_, above_;
};

}  // namespace

void drift(State& s, const Sky& sky, Work& work) {
    Drift(s, sky, work).run();
}

}  // namespace sim::weather
