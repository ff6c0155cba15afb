#pragma once

#include <cstddef>
#include <optional>

#include "game/controls/tier.h"

namespace game {

// Chooses the tier of a machine from the first frames of a window: it draws the cheapest images first, and
// dearer ones only as long as the target allows. Takes about half a second at most, without the first frame,
// which loads the scene.
class TierTrial {
  public:
    struct Image {
        double scale = 0.5;  // drawn pixels per screen pixel along each axis
        bool fine = false;   // two by two samples per pixel
    };

    explicit TierTrial(double target_ms) : target_ms_(target_ms) {}

    // The image to draw next. Call it while there is no result.
    Image image() const;
    // Reports how long drawing it took.
    void drew(double ms);
    // The tier, once it is known.
    std::optional<Tier> result() const { return result_; }

  private:
    double allowed_ms() const;
    void finish_image();

    double target_ms_;
    std::size_t image_ = 0;
    int draws_ = 0;                       // of this image
    bool warm_ = false;                   // the frame that loads has been drawn
    double least_ms_ = 0, spent_ms_ = 0;  // of this image; of all
    std::optional<Tier> result_;
};

}  // namespace game
