#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "game/base/job.h"
#include "game/sound/hearing.h"
#include "game/sound/mixer.h"
#include "game/sound/speaker.h"

namespace game {

// The sound of a window: of its world and of what is told. A view, which never affects the world. Silent where there is no
// device; the device is opened in the background, because a desktop may take seconds for that.
class Sounds {
  public:
    // Starts to open the device.
    void begin(double now_s);
    // Of another world from now on.
    void listen_to(const Session& session);

    // Call after each tick, with the commands at its start.
    void see(const Session& session, std::span<const sim::Command> commands);
    // A note for the person.
    void note(sound::Wave wave) {
        if (speaker_) mixer_.note(wave);
    }
    // Once a frame. Returns a sentence if the device has gone; sound goes on once there is one again.
    std::optional<std::string> play(const Session& session, const sound::Ear& ear,
                                    const sound::Volumes& volumes, double now_s);

    // Why nothing is heard: "there is no sound device". Empty if something is, or if it is not known yet.
    const std::string& fault() const { return fault_; }

  private:
    void look_for_device(double now_s);

    std::optional<sound::Hearing> hearing_;
    sound::Mixer mixer_;
    std::unique_ptr<sound::Speaker> speaker_;
    std::string fault_;
    bool wanted_ = false;
    double last_s_ = 0, asked_s_ = 0;  // of the last frame; when a device was looked for, or found alive
    Job<std::unique_ptr<sound::Speaker>> opens_;
};

}  // namespace game
