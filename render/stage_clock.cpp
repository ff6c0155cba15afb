#include "render/stage_clock.h"

#include <chrono>

#include "render/context.h"
#include "sim/core/check.h"

namespace render {

std::string_view to_string(Timing timing) {
    switch (timing) {
        case Timing::kFinish:
            return "wall time around glFinish";
        case Timing::kQueries:
            return "GL timer queries";
        case Timing::kNone:
            break;
    }
    return "not timed";
}

Timing suitable_timing() {
    return is_software_renderer() ? Timing::kFinish : Timing::kQueries;
}

StageClock::StageClock(Timing timing) : timing_(timing) {
    if (timing == Timing::kQueries)
        for (Query& stamp : stamp_) stamp = make_time_stamp();
}

void StageClock::mark() {
    if (timing_ == Timing::kNone) return;
    CHECK(count_ < kMarks);
    if (timing_ == Timing::kQueries) {
        glQueryCounter(stamp_[count_].name(), GL_TIMESTAMP);
    } else {
        glFinish();
        const std::chrono::duration<double, std::milli> now =
            std::chrono::steady_clock::now().time_since_epoch();
        finished_ms_[count_] = now.count();
    }
    ++count_;
}

std::optional<DrawTimes> StageClock::times() const {
    if (count_ < kMarks) return std::nullopt;
    std::array<double, kMarks> at = finished_ms_;
    if (timing_ == Timing::kQueries)
        for (std::size_t i = 0; i < kMarks; ++i) {
            GLuint64 ns = 0;
            glGetQueryObjectui64v(stamp_[i].name(), GL_QUERY_RESULT, &ns);
            at[i] = static_cast<double>(ns) * 1e-6;
        }
    return DrawTimes{at[1] - at[0], at[2] - at[1], at[3] - at[2]};
}

}  // namespace render
