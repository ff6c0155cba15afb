#include "files/module.h"
#include "game/sound/speaker.h"

namespace game::sound {

tl::expected<std::unique_ptr<Speaker>, std::string> open_speaker(Speaker::Output output,
                                                                 MakeSamples samples) {
    static const auto* door =
        static_cast<const SpeakerDoor*>(files::symbol_of_module("libcouloir_speaker.so", "couloir_speaker"));
    return door->open(output, samples);
}

}  // namespace game::sound
