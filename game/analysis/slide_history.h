#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "game/scene/pressure.h"
#include "game/session/peak_watch.h"
#include "sim/world/state.h"

namespace game {

// What moves in a world over its time, in samples at equal distances: run-out, volume, speed, and pressure at houses. If
// there is no room for another one, every second is dropped, and they are twice as far apart. A view, which never
// affects the world. Allocates at its first sample only.
class SlideHistory {
  public:
    static constexpr std::int64_t kStep = 6;  // ticks between samples at first
    static constexpr std::size_t kMostSamples = 1024, kMostHouses = 32;
    static constexpr double kMoves = 0.5;    // m/s in plan; what is slower counts as standing still
    static constexpr double kPause = 5;      // s in which nothing moves, after which another slide begins
    static constexpr float kReached = 0.1f;  // m, of the rolling layer: as for the run-out

    struct Sample {
        std::int64_t tick = 0;
        double run_out =
            0;  // m in plan, from where the slide broke loose to the farthest place that it has reached
        double volume = 0;                          // m³, of the rolling layer where it moves
        double speed = 0;                           // m/s along the slope, the largest
        std::array<float, kMostHouses> pressure{};  // kPa, at each house, the largest
        // The slide whose run-out it is.
        glm::dvec2 top{0};  // m, its highest place when it broke loose
        std::optional<std::int64_t> moved_at =
            {};  // tick, when it moved last; nothing: there was no slide yet
    };
    // A house that stands in the world at some time.
    struct House {
        glm::dvec2 at{0};                       // m, its middle
        std::optional<std::size_t> thing = {};  // its place in sim::Things::list at the last sample
    };

    // Begins with the houses of this world, if it has not begun.
    void begin(const sim::View& world);
    // Looks at a world after a tick; begins if it has not. At a time that was seen before it changes nothing, unless that is the present, from
    // which on time is another. `densities`: without them there is no pressure.
    void see(const sim::View& world, const Peaks& peaks, const std::optional<Densities>& densities,
             double tick_s, std::int64_t known_until);
    void forget_after(std::int64_t tick);

    // The tick at which it began to look; nothing: it never did.
    const std::optional<std::int64_t>& since() const { return since_; }
    std::int64_t step() const { return step_; }                   // ticks between samples
    std::span<const Sample> samples() const { return samples_; }  // by rising time
    std::span<const House> houses() const { return houses_; }  // in the order in which they were first seen
    bool lacks_houses() const { return lacks_houses_; }        // there are more than kMostHouses

  private:
    Sample sample_of(const sim::View& world, const Peaks& peaks, const std::optional<Densities>& densities,
                     double tick_s, const Sample* before);
    void find_houses(const sim::View& world);
    void drop_every_second();

    std::optional<std::int64_t> since_;
    std::int64_t step_ = kStep;
    std::vector<Sample> samples_;
    std::vector<House> houses_;
    bool lacks_houses_ = false;
};

}  // namespace game
