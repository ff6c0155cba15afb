#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "game/base/outcome.h"
#include "render/pictures/picture.h"

namespace game {

// The small picture that is kept beside a recording.
render::Picture small_picture(const render::Picture& image);
// Errors: it cannot be written (3).
Outcome<void> write_beside(const std::filesystem::path& recording, const render::Picture& small);

// That of a session: of the moment at which most moved.
class SessionPicture {
  public:
    // Sees what moves in a frame, quanta. True if the image that is shown now is to be taken: most has just moved.
    bool see(std::int64_t moving);
    // Whether more has moved since than when the image was taken; what moves may still be growing.
    bool is_late() const { return peak_ > taken_ + taken_ / 4; }
    void take(const render::Picture& image);
    const std::optional<render::Picture>& picture() const { return picture_; }

  private:
    std::optional<render::Picture> picture_;
    std::int64_t peak_ = 0, taken_ = 0;  // of what moved, quanta: until now, and when the image was taken
};

}  // namespace game
