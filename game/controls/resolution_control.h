#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace game {

// Scales that the control chooses from: drawn pixels per screen pixel along each axis.
inline constexpr std::array<double, 5> kScales{1, 0.75, 0.5, 0.375, 0.25};

// Chooses the resolution of moving images, so that a frame takes no longer than a target. It keeps one scale
// for frames in which the camera moves, where every pixel is new, and one for frames in which only the world
// changes, which may cost much less. It lowers a scale if most of the last frames were too slow, and raises it
// if for longer the next larger scale would have been in time. It learns from each change what a step costs,
// and does not lower a scale that saves next to nothing.
// Knows no clock and no GL: times are passed in.
class ResolutionControl {
  public:
    struct Limits {
        double target_ms = 33;          // of a whole frame
        double least = 0.25, most = 1;  // scales allowed; `least` ≤ `most`
        double least_of_world = 0.25;   // instead of `least` while the camera stands still
        bool operator==(const Limits&) const = default;
    };
    struct Frame {
        double now_s = 0;
        bool camera_moved = false;
        double screen_pixels = 0;  // of the whole screen
    };

    // Returns the scale of an image that is to be drawn now.
    double scale_for(const Frame& frame, const Limits& limits);
    // Reports that this image was drawn, in `draw_ms`; the rest of the frame took `other_ms`.
    void drew(double draw_ms, double other_ms);
    // Reports that an image of another kind was drawn instead, such as one that stands still.
    void drew_another() { drawn_scale_ = 0; }

    // As last chosen for either case.
    double camera_scale() const { return kScales[camera_.step]; }
    double world_scale() const { return kScales[world_.step]; }

  private:
    static constexpr std::size_t kKept = 30;  // frames
    static constexpr double kWorth = 1.2;     // times faster must the next smaller scale be

    // Drawing time of each step over that of the next smaller one.
    using Ratios = std::array<double, kScales.size() - 1>;
    static Ratios first_ratio();

    struct Case {
        Case(std::size_t falls_after, std::size_t rises_after, double least)
            : haste(falls_after), patience(rises_after), least_ratio(least) {}

        std::size_t haste, patience;               // frames until the scale may fall, and may rise
        double least_ratio;                        // that may be learned
        std::size_t step = 2;                      // index in kScales
        std::array<double, kKept> draw{}, rest{};  // ms of the last frames at this step, a ring
        std::size_t size = 0, next = 0;
        std::optional<std::size_t> from;  // step before the last change
        double from_ms = 0;               // median drawing time there
        Ratios ratio = first_ratio();
        int late = 0;  // frames that no smaller scale would have made fast enough

        void clear() { size = next = 0; }
        void add(double draw_ms, double rest_ms);
        double median(const std::array<double, kKept>& values, std::size_t last) const;
        // Expected time of a frame at another step, from the last frames.
        double expected_ms(std::size_t other, std::size_t last, double target_ms) const;
        void change_to(std::size_t other);
        void learn();
        void choose(const Limits& limits);
    };

    void fit_screen(double pixels);

    // Three frames outvote one that was slow for another reason, such as loading. Where only the world
    // changes, a change of size costs one whole image, so it is rarer. How much of the image changes varies
    // there, so that a step that seemed to save nothing may save much in the next second.
    Case camera_{3, 12, 1.01}, world_{5, 30, kWorth};
    Limits limits_;
    double screen_pixels_ = 0;
    double moved_s_ = -1e9;       // when the camera last moved
    bool world_drawn_ = false;    // world_.step is its own, not yet the camera's
    std::optional<bool> counts_;  // the case of the frame now drawn, if its time says something
    double drawn_scale_ = 0;
    bool drawn_camera_ = false;
};

}  // namespace game
