#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "render/draw_times.h"
#include "render/gl_handle.h"

namespace render {

// Measures the stages of successive frames. Needs the context throughout its lifetime.
class StageClock {
  public:
    StageClock() = default;
    explicit StageClock(Timing timing);

    // Call at the beginning of a frame, then mark() after uploads, after cutting, and at its end.
    void begin() { count_ = 0, mark(); }
    void mark();
    // Times of the last frame; waits for it. Empty if it was not timed.
    std::optional<DrawTimes> times() const;

  private:
    static constexpr std::size_t kMarks = 4;

    Timing timing_ = Timing::kNone;
    std::size_t count_ = 0;
    std::array<double, kMarks> finished_ms_{};
    std::array<Query, kMarks> stamp_;
};

}  // namespace render
