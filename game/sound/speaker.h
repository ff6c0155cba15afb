#pragma once

#include <memory>
#include <span>
#include <string>

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

#include "game/sound/mixer.h"

namespace game::sound {

// Plays voices, by OpenAL Soft: it places them around the ear and mixes them, in a thread of its own.
class Speaker {
  public:
    enum class Output {
        kDevice,  // what the desktop plays on
        kMemory,  // render() alone
    };

    Speaker() = default;
    virtual ~Speaker() = default;
    Speaker(const Speaker&) = delete;
    Speaker& operator=(const Speaker&) = delete;

    // From now on these loops are heard, each as the mixer numbers them; the shots begin. If too many sound at once, the
    // oldest end. Directions are those of the world.
    virtual void play(std::span<const Voice> loops, std::span<const Shot> shots, const glm::dvec3& ahead,
                      const glm::dvec3& up) = 0;
    // False once the device has gone: it plays nothing any more.
    virtual bool lives() = 0;
    // The next samples, left and right in turn. Only of Output::kMemory.
    virtual void render(std::span<float> left_right) = 0;
};

// `samples`: makes those of each Wave, which takes half a second, once there is a device for them. Errors: there is none.
using MakeSamples = SamplesOfWaves (*)();
tl::expected<std::unique_ptr<Speaker>, std::string> open_speaker(Speaker::Output output, MakeSamples samples);

// What open_speaker() calls: OpenAL is in a module, because nothing but sound needs it.
struct SpeakerDoor {
    decltype(&open_speaker) open;
};

}  // namespace game::sound
