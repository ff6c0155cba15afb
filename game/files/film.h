#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "game/base/outcome.h"
#include "render/pictures/picture.h"

namespace game {

// A film that is written image by image, through the program ffmpeg: .mp4 is H.264 with AAC, .webm VP9 with Opus, .mkv AV1
// with Opus. It is written beside its file and takes its place when it is done; the destructor deletes an unfinished one.
// Images are encoded while the next are drawn. Use it from one thread.
class Film {
  public:
    struct Format {
        int width = 1280, height = 720;  // pixels, even, because colour has half the resolution
        int fps = 60;                    // images per second, 1 to 120
    };
    // Errors (status 2): the name has another ending, or a side is odd.
    static Outcome<void> check(const std::filesystem::path& path, const Format& format);

    // Errors: as check(); there is no ffmpeg, it lacks an encoder, or the file cannot be written (3).
    static Outcome<Film> open(const std::filesystem::path& path, const Format& format);
    ~Film();
    Film(Film&&) noexcept;
    Film& operator=(Film&&) noexcept;

    // Adds an image of the format's size. Waits while kWaiting are not encoded yet. Errors: ffmpeg failed (3), which may
    // be an image before.
    Outcome<void> add(render::Picture picture);
    static constexpr std::size_t kWaiting = 3;  // images
    std::int64_t frames() const;

    // Ends the film, with the sound of a WAV file if one is given. Add nothing afterwards. Errors: it has no image (2);
    // ffmpeg failed, or the file cannot be written (3).
    Outcome<void> close(const std::optional<std::filesystem::path>& wav = std::nullopt);

  private:
    struct Parts;
    explicit Film(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace game
