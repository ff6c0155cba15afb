#include "render/gl/stage_clock.h"

#include <chrono>
#include <ctime>

#include "render/gl/context.h"
#include "sim/core/check.h"

namespace render {
namespace {

double wall_ms() {
    const std::chrono::duration<double, std::milli> now = std::chrono::steady_clock::now().time_since_epoch();
    return now.count();
}

double processor_ms() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

}  // namespace

std::string_view to_string(Timing timing) {
    switch (timing) {
        case Timing::kFinish:
            return "wall time around glFinish";
        case Timing::kProcessor:
            return "processor time around glFinish";
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

Timing comparable_timing() {
    return is_software_renderer() ? Timing::kProcessor : Timing::kQueries;
}

StageClock::StageClock(Timing timing) : timing_(timing) {
    if (timing == Timing::kQueries)
        for (Query& query : query_) query = make_time_stamp();
}

void StageClock::begin() {
    if (timing_ == Timing::kNone) return;
    count_ = 0;
    stamp();
}

void StageClock::mark(Pass pass) {
    if (timing_ == Timing::kNone) return;
    CHECK(count_ > 0 && count_ < kMostStamps);
    pass_[count_] = pass;
    stamp();
}

void StageClock::stamp() {
    if (timing_ == Timing::kQueries) {
        glQueryCounter(query_[count_].name(), GL_TIMESTAMP);
    } else {
        glFinish();
        at_ms_[count_] = timing_ == Timing::kProcessor ? processor_ms() : wall_ms();
    }
    ++count_;
}

std::optional<DrawTimes> StageClock::times() const {
    if (count_ == 0) return std::nullopt;
    std::array<double, kMostStamps> at = at_ms_;
    if (timing_ == Timing::kQueries)
        for (std::size_t i = 0; i < count_; ++i) {
            GLuint64 ns = 0;
            glGetQueryObjectui64v(query_[i].name(), GL_QUERY_RESULT, &ns);
            at[i] = static_cast<double>(ns) * 1e-6;
        }
    DrawTimes times;
    for (std::size_t i = 1; i < count_; ++i) times(pass_[i]) += at[i] - at[i - 1];
    return times;
}

}  // namespace render
