#include "game/app/sounds.h"

#include <algorithm>
#include <utility>

#include "game/words/words.h"

namespace game {
namespace {

constexpr double kAskAgain = 10;  // s until a device is looked for anew
constexpr double kAlive = 1;      // s between two looks whether it is there

}  // namespace

void Sounds::begin(double now_s) {
    wanted_ = true;
    last_s_ = now_s;
    look_for_device(now_s);
}

void Sounds::look_for_device(double now_s) {
    asked_s_ = now_s;
    const auto begun =
        opens_.begin([](const std::atomic<bool>& /*stopped*/) -> Outcome<std::unique_ptr<sound::Speaker>> {
            auto speaker = sound::open_speaker(sound::Speaker::Output::kDevice, sound::samples_of_waves);
            if (!speaker) return machine_fails(speaker.error());
            return std::move(*speaker);
        });
    if (!begun) fault_ = begun.error().sentence;
}

void Sounds::listen_to(const Session& session) {
    hearing_.emplace(session);
}

void Sounds::see(const Session& session, std::span<const sim::Command> commands) {
    if (speaker_) hearing_->see(session, commands);
}

std::optional<std::string> Sounds::play(const Session& session, const sound::Ear& ear,
                                        const sound::Volumes& volumes, double now_s) {
    if (!wanted_) return std::nullopt;
    const double elapsed_s = std::clamp(now_s - std::exchange(last_s_, now_s), 0., 1.);
    if (auto opened = opens_.result()) {
        fault_ = *opened ? "" : opened->error().sentence;
        if (*opened) speaker_ = std::move(**opened), listen_to(session);
        asked_s_ = now_s;
    }
    if (!speaker_) {
        if (!opens_.is_busy() && now_s - asked_s_ > kAskAgain) look_for_device(now_s);
        return std::nullopt;
    }
    if (now_s - asked_s_ > kAlive) {
        asked_s_ = now_s;
        if (!speaker_->lives()) {
            speaker_.reset();
            fault_ = "the sound device has gone";
            return tr("The sound device has gone. Sound continues once there is one");
        }
    }
    mixer_.mix(hearing_->look(session), hearing_->happened(), session.view(), ear, volumes, elapsed_s);
    hearing_->forget();
    speaker_->play(mixer_.loops(), mixer_.shots(), ear.ahead, ear.up);
    return std::nullopt;
}

}  // namespace game
