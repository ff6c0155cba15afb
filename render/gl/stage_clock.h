#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "render/gl/draw_times.h"
#include "render/gl/gl_handle.h"

namespace render {

// Measures the passes of successive frames. Does nothing with Timing::kNone. Needs the context throughout its
// lifetime.
class StageClock {
  public:
    StageClock() = default;
    explicit StageClock(Timing timing);

    // Begins a frame.
    void begin();
    // Counts everything since the last call toward `pass`. A pass may be marked more than once.
    void mark(Pass pass);
    // Times of the last frame; waits for it. Empty if it was not timed.
    std::optional<DrawTimes> times() const;

  private:
    static constexpr std::size_t kMostStamps = 24;
    static_assert(kMostStamps > kPassCount + 3);  // the beginning, each pass, and three that are marked twice

    void stamp();

    Timing timing_ = Timing::kNone;
    std::size_t count_ = 0;                 // stamps of this frame
    std::array<Pass, kMostStamps> pass_{};  // which ended with a stamp; not of the first
    std::array<double, kMostStamps> at_ms_{};
    std::array<Query, kMostStamps> query_;
};

}  // namespace render
