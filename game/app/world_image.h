#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "game/base/outcome.h"
#include "game/controls/display.h"
#include "game/controls/frame_times.h"
#include "game/controls/image_size.h"
#include "game/controls/notices.h"
#include "game/controls/photo_parts.h"
#include "game/controls/resolution_control.h"
#include "game/controls/screen.h"
#include "game/controls/tier_trial.h"
#include "game/session/sandbox.h"
#include "render/frame.h"
#include "render/gl/kept_image.h"

namespace game {

// The image of the world on a screen: its size and quality, and when it is drawn again. What moves is drawn as the tier and
// the time of a frame allow; an image that stands still is finished, once. A driver that cannot draw an image gets a
// smaller one, and a notice says so.
class WorldImage {
  public:
    // What an image shows. If it is unchanged, the image is not drawn again until it is finished.
    struct Seen {
        std::int64_t epoch = -1, changed_at = -1;
        render::Camera camera;
        Display display;
        render::Marks marks;
        ScreenSize screen{0, 0};
        std::optional<render::Lens> lens = {};  // of a photo
        bool operator==(const Seen&) const = default;
    };
    // What it is drawn from.
    struct Subject {
        const Sandbox& sandbox;
        const render::Surroundings& surroundings;
        const render::Land& land;
        const render::Woods& woods;
        std::span<const std::uint8_t> extent;  // of the best run, or empty
        std::span<const float> probability;    // of the runs that are shown, or empty
    };
    // When it is drawn.
    struct Moment {
        double now_s = 0;          // on the screen's clock
        const FrameTime& frame;    // until now
        const FrameTimes& before;  // of the frames before
    };

    // Both outlive the image.
    WorldImage(Screen& screen, Notices& notices, render::Renderer renderer);

    // Another world, which leaves its images `frame_memory` bytes.
    void begin_world(std::uint64_t frame_memory);
    // What a look needs, before it is drawn. Errors: its images or shaders are missing or damaged.
    Outcome<void> load(const Scenario& scenario);

    // Measures in the next frames which tier suits the machine.
    void begin_trial(double target_ms) { trial_.emplace(target_ms); }
    // The user has chosen one, knows better, and may have made room.
    void end_trial();

    // Draws what is due, and shows it on the screen.
    void draw(const Seen& seen, const Subject& subject, const Moment& moment);
    // The image that is shown, as it is.
    render::Picture shown() const { return renderer_.read_back(); }
    // The image that was drawn last as finely as one that stands still, without ring and ghost. Errors: as failure().
    Outcome<render::Picture> picture(const Subject& subject);

    // Begins a photo of what was drawn last, `times` as wide and high as the screen. Each draw() from now on draws a part of
    // it, and shows the image as it was; the world, the camera and the display must not change. Errors: it is too large for
    // the memory or the device, and may be taken smaller.
    Outcome<void> begin_photo(int times);
    std::optional<double> photo_progress() const;  // 0 to 1; nothing unless one is being drawn
    void drop_photo();
    // The photo, once it is drawn. Errors: as begin_photo(), unless failure() says more.
    std::optional<Outcome<render::Picture>> photo_result() {
        return std::exchange(photo_result_, std::nullopt);
    }

    const ImageSize& size() const { return drawn_; }  // as last drawn
    // For the next image: as seen last, unless the trial or the driver asked for another.
    Tier tier() const { return tier_; }
    // Why no more can be drawn.
    const std::optional<Failure>& failure() const { return failure_; }

  private:
    ImageSize best_size() const { return image_for(screen_.size(), 1, true, bounds_); }
    ImageSize moving_size(const Moment& moment, bool camera_moved);
    bool follows_ring(const Seen& seen);
    double rest_ms(const Moment& moment) const;
    void draw_image(const Subject& subject, ImageSize image);
    void draw_once(const Subject& subject, const ImageSize& image,
                   const std::optional<render::WholeImage>& whole = std::nullopt);
    void draw_part(const Subject& subject);
    void finish_trial(double draw_ms);
    void tell_bounds();
    void lower_bounds(DeviceFault fault);
    void fail(std::string sentence) { failure_ = Failure{Failure::kMachine, std::move(sentence)}; }
    void fail_lost();

    void tell(std::string sentence) { notices_.tell(Notice::Kind::kInfo, std::move(sentence), now_s_); }
    void warn(std::string sentence) { notices_.tell(Notice::Kind::kWarning, std::move(sentence), now_s_); }

    Screen& screen_;
    Notices& notices_;
    render::Renderer renderer_;
    bool waits_for_gl_;   // software rendering; waiting charges its time to the draw stage
    ImageBounds bounds_;  // what the device has shown that it can draw; another world leaves another room
    std::uint64_t frame_memory_ = 0;  // bytes that --max-memory leaves for the buffers of an image

    Seen seen_;
    double now_s_ = 0, still_since_ = 0;  // s; the latter when seen_ last changed
    bool on_its_way_ = false;             // the camera, in the last image
    bool ring_in_time_ = true;            // it can follow the cursor on a finished image
    ImageSize drawn_, best_;              // the last image; what one that stands still has
    ResolutionControl resolution_;
    std::optional<TierTrial> trial_;  // in the first frames
    Tier tier_ = Tier::kFast;         // for the next frame
    std::optional<Failure> failure_;

    // A photo while it is drawn.
    struct Photo {
        PhotoParts plan;
        render::Picture picture;
        int part;                 // the next one
        render::KeptImage shown;  // meanwhile
    };
    std::optional<Photo> photo_;
    std::optional<Outcome<render::Picture>> photo_result_;
};

}  // namespace game
