#pragma once

#include <span>
#include <string>

#include "game/analysis/gallery.h"
#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "render/pictures/picture.h"
#include "render/view/camera.h"

namespace game {

// A page in the proportions of A3, 2480 by 1754 px: the world of a session as its scene's camera sees it, with labels on the
// parts of the slide; a map with north, scale and key; and the numbers of its card.
class Poster {
  public:
    static constexpr PictureSize kPicture{1580, 1060};  // of the world

    // `recording`: its name. `commands`: those of the session until now and later.
    struct Subject {
        const Scenario& scenario;
        const Session& session;
        std::span<const TimedCommand> commands;
        std::string recording;
    };
    // Draws the world with OpenGL. `gl` as in Gallery::open(). Errors: those of that.
    static Outcome<render::Picture> draw(const Subject& subject, const std::string& gl);
};

}  // namespace game
