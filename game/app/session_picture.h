#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "game/base/outcome.h"
#include "render/pictures/picture.h"

namespace game {

// The small picture that is kept beside the recording of a session: of the moment at which most moved.
class SessionPicture {
  public:
    static constexpr int kWidth = 288, kHeight = 162;  // px

    // Whether the image that is shown now is to be taken: more moves than in the last one, and that was a while ago.
    bool wants(std::int64_t moving, double now_s) const;
    void take(const render::Picture& image, std::int64_t moving, double now_s);
    // Writes it beside the recording; nothing if none was taken. Errors: it cannot be written (3).
    Outcome<void> write(const std::filesystem::path& recording) const;

  private:
    std::optional<render::Picture> picture_;
    std::int64_t moving_ = 0;  // quanta, when it was taken
    double taken_s_ = 0;
};

}  // namespace game
