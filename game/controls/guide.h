#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "sim/world/command.h"

namespace game {

// The tutorial of a first session: a slide to watch, then one hint at a time, each until it was followed or closed.
class Guide {
  public:
    enum class Step : std::uint8_t { kWatch, kBlast, kRewind, kGoOn, kPour, kChallenge, kDone };
    static constexpr std::size_t kSteps = static_cast<std::size_t>(Step::kDone) + 1;
    static std::string_view name_of(Step step);
    static std::optional<Step> step_of(std::string_view name);

    // What is opened for the steps: a recording to watch, a mountain to play on, and a challenge.
    static constexpr const char* kSlide = "couloir-avalanche.couloir";
    static constexpr const char* kMountain = "couloir";
    static constexpr const char* kChallenge = "one-shovel";

    Guide() = default;
    explicit Guide(Step step) : step_(step) {}
    Step step() const { return step_; }

    // What is true of a world in a frame.
    struct Seen {
        double now_s = 0;
        bool may_play = false;    // the user may change it, with every tool
        bool moves = false;       // more than creep
        bool runs_back = false;   // time
        bool looks_back = false;  // at the past
    };
    void see(const Seen& seen);
    // The user did this to the world.
    void did(sim::CommandKind kind);
    // The current hint was closed, or the slide was watched.
    void next();

    // Whether the hint of the step is due.
    bool speaks() const { return speaks_; }
    // Whether nothing was done for so long that a place to click is shown.
    bool shows_place() const { return shows_place_; }

  private:
    void go_to(Step step);

    Step step_ = Step::kWatch;
    bool speaks_ = false, shows_place_ = false;
    std::optional<double> waits_since_;  // s
};

}  // namespace game
