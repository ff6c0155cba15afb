#pragma once

#include <optional>
#include <span>
#include <vector>

#include "game/app/guide_memory.h"
#include "game/base/outcome.h"
#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/guide.h"

namespace game {

// The guide of a first session, if there is one: the slide of its opening, which any key or button ends, and how far it
// has led, which is kept from one session to the next.
class Tutorial {
  public:
    // Goes on where `led` was left. At the first step the slide of the opening is shown, if the world `watches` one.
    void begin(const Remembered& led, bool watches, double now_s);

    const std::optional<Guide>& guide() const { return guide_; }
    bool shows_opening() const { return opening_since_.has_value(); }
    // Since when the slide of the opening is watched, s; nothing after it.
    std::optional<double> opening_s(double now_s) const;
    // Whether these events, or its time, end the opening.
    bool opening_ends(std::span<const Event> events, double world_s, double now_s) const;
    void end_opening();
    // The events that do more than end the opening; valid until the next call.
    std::span<const Event> without_presses(std::span<const Event> events);

    // Call once per frame. The step that begins, if one does.
    std::optional<Guide::Step> see(const Guide::Seen& seen);
    // Keeps how far it has led. Errors: the file cannot be written (3).
    Outcome<void> keep() const { return remember(*guide_); }
    void did(sim::CommandKind kind);
    void perform(const GuideWish& wish);

  private:
    std::optional<Guide> guide_;
    Guide::Step kept_step_ = Guide::Step::kWatch;  // as last seen
    std::optional<double> opening_since_;          // s, while its slide is watched
    std::vector<Event> left_;
};

}  // namespace game
