#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "render/draw_times.h"
#include "render/gl_handle.h"

namespace render {

// Takes the time between the stages of one frame after the other. Needs the context for as long as it lives.
class StageClock {
  public:
    StageClock() = default;
    explicit StageClock(Timing timing);

    // At the beginning of a frame; then after uploads, after cutting, and at its end.
    void begin() { count_ = 0, mark(); }
    void mark();
    // Of the last frame, for which it waits. Nothing where none was timed.
    std::optional<DrawTimes> times() const;

  private:
    static constexpr std::size_t kMarks = 4;

    Timing timing_ = Timing::kNone;
    std::size_t count_ = 0;
    std::array<double, kMarks> finished_ms_{};
    std::array<Query, kMarks> stamp_;
};

}  // namespace render
