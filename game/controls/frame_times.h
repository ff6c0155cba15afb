#pragma once

#include <array>
#include <cstddef>

namespace game {

// Where the time of a frame goes, in the order of the frame.
enum class Stage { kInput, kSolve, kDraw, kPanels, kPresent };
inline constexpr std::size_t kStages = 5;
inline constexpr std::array<const char*, kStages> kStageNames{"input", "solve", "draw", "panels", "present"};

constexpr std::size_t stage_index(Stage stage) {
    return static_cast<std::size_t>(stage);
}

struct FrameTime {
    std::array<float, kStages> stage_ms{};
    float frame_ms = 0;       // from begin to begin: what frames/s counts
    float worst_tick_ms = 0;  // of the ticks in this frame
    int ticks = 0;
};

// The last frames' times. Does not allocate.
class FrameTimes {
  public:
    static constexpr std::size_t kKept = 240;

    void add(const FrameTime& frame);

    std::size_t size() const { return size_; }
    const FrameTime& operator[](std::size_t i) const;  // 0 is the oldest
    double frames_per_second() const;                  // over the last second, or what there is
    double median_ms(Stage stage) const;
    float worst_tick_ms() const;

  private:
    std::array<FrameTime, kKept> frames_{};
    std::size_t next_ = 0, size_ = 0;
};

}  // namespace game
