#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "files/whole_file.h"
#include "game/base/outcome.h"
#include "game/sound/speaker.h"
#include "render/view/camera.h"

namespace game::sound {

// The sound of a session as a WAV file, as long as its time: 16 bits, left and right, kRate.
class SoundFile {
  public:
    // Of `ticks` ticks from now on, as heard at `camera`; nothing: until close(), which then writes the length into the file.
    // Errors: it would be longer than a WAV file can be, 4 GiB (2); it cannot be written, or OpenAL here is another than
    // OpenAL Soft (3).
    static Outcome<SoundFile> open(const std::filesystem::path& path, const Session& session,
                                   std::optional<std::int64_t> ticks, const render::Camera& camera);

    // From now on heard there.
    void hear_at(const render::Camera& camera) { camera_ = camera; }
    // Call after each tick, with the commands at its start. Errors: it cannot be written (3).
    Outcome<void> see(const Session& session, std::span<const sim::Command> commands);
    // After the last. Errors: as see(); it is longer than a WAV file can be (2).
    Outcome<void> close();

  private:
    SoundFile(files::WholeFile file, std::unique_ptr<Speaker> speaker, const Session& session,
              const render::Camera& camera);

    files::WholeFile file_;
    std::unique_ptr<Speaker> speaker_;
    Hearing hearing_;
    Mixer mixer_;
    render::Camera camera_;
    std::optional<std::filesystem::path> endless_ = {};  // its file, if its length was not known
    std::int64_t first_ = 0;                             // tick it begins at
    std::int64_t written_ = 0;                           // samples
    std::vector<float> left_right_;
};

}  // namespace game::sound
