#pragma once

#include <array>
#include <cstddef>

namespace game {

// The stages of a frame, in order.
enum class Stage { kInput, kSolve, kDraw, kPanels, kPresent };
inline constexpr std::size_t kStages = 5;
inline constexpr std::array<const char*, kStages> kStageNames{"input", "solve", "draw", "panels", "present"};

constexpr std::size_t stage_index(Stage stage) {
    return static_cast<std::size_t>(stage);
}

struct FrameTime {
    std::array<float, kStages> stage_ms{};
    float frame_ms = 0;       // from the begin of one frame to the next; frames/s is computed from it
    float worst_tick_ms = 0;  // of the ticks in this frame
    int ticks = 0;
};

// Times of the last frames. What it measures is of the last second, all of it, so that no two numbers are of different
// times. Does not allocate.
class FrameTimes {
  public:
    static constexpr std::size_t kKept = 240;

    void add(const FrameTime& frame);

    std::size_t size() const { return size_; }
    const FrameTime& operator[](std::size_t i) const;  // 0 is the oldest
    double frames_per_second() const;                  // 0 below 0.1 s
    double median_ms(Stage stage) const;
    double median_rest_ms() const;  // of the frame beside its stages
    float worst_tick_ms() const;
    double ticks_per_frame() const;

  private:
    std::size_t recent() const;  // frames, the last of them, that fill a second; all if they are fewer
    template <class Value>
    double median(const Value& value) const;

    std::array<FrameTime, kKept> frames_{};
    std::size_t next_ = 0, size_ = 0;
};

}  // namespace game
